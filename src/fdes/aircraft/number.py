"""One number of an aircraft file: as printed, as corrected and why, how sure, in the unit of its source.

A bare number is one that says no more. What no source gives is an `Assumption`, with why it was chosen.
"""

from collections.abc import Callable
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator

from fdes.errors import SpecError
from fdes.units import si_unit, to_si, units_of

Confidence = Literal["high", "medium", "low"]
CONFIDENCES: tuple[Confidence, ...] = ("high", "medium", "low")
Variant = Literal["corrected", "printed"]
VARIANTS: tuple[Variant, ...] = ("corrected", "printed")
UNSAID = frozenset({"1", "1/rad"})  # units that a number need not give


class Part(BaseModel):
    """A part of the file: frozen, finite, and without keys that nobody reads."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)


class Number(Part):
    """One number of a data sheet, as printed and, where that is known to be wrong, corrected."""

    printed: float
    corrected: float | None = None
    unit: str | None = None
    confidence: Confidence | None = None
    unverified: bool = False  # the correction is presumed: no source has it
    sources: tuple[str, ...] = Field(default=(), strict=False)
    reason: str | None = None
    note: str | None = None

    @model_validator(mode="before")
    @classmethod
    def _bare(cls, data: Any) -> Any:
        return {"printed": data} if isinstance(data, int | float) and not isinstance(data, bool) else data

    @model_validator(mode="after")
    def _reasoned(self) -> Self:
        if self.corrected is not None and not self.reason:
            raise ValueError('has a corrected value without a reason: add reason = "..."')
        return self

    def value(self, variant: Variant) -> float:
        """The number of that variant, in its own unit."""
        return self.printed if variant == "printed" or self.corrected is None else self.corrected

    def si(self, variant: Variant) -> float:
        """The number of that variant in SI."""
        return to_si(self.value(variant), self.unit or "1")


class Assumption(Part):
    """What no source gives: a value, and why this one."""

    value: float
    unit: str
    reason: str = Field(min_length=1)

    def si(self) -> float:
        """The value in SI."""
        return to_si(self.value, self.unit)


def _in(si: str, *, positive: bool = False) -> Callable[[Any], Any]:
    """A check that a number is in a unit of `si`, and greater than zero where it must be."""

    def check(number: Number | Assumption) -> Number | Assumption:
        fitting = ", ".join(repr(unit) for unit in units_of(si))
        if number.unit is None:
            if si not in UNSAID:
                raise ValueError(f"has no unit: add unit = one of {fitting}")
            number = number.model_copy(update={"unit": si})
        if _si_or_none(number.unit) != si:
            raise ValueError(f"is in {number.unit!r}, which does not fit here: use one of {fitting}")
        values = [number.value] if isinstance(number, Assumption) else [number.value(v) for v in VARIANTS]
        if positive and min(values) <= 0.0:
            raise ValueError(f"is {min(values):g} {number.unit}, and must be greater than zero")
        return number

    return check


def _si_or_none(unit: str | None) -> str | None:
    try:
        return si_unit(unit or "1")
    except SpecError:
        return None


Ratio = Annotated[Number, AfterValidator(_in("1"))]
Derivative = Annotated[Number, AfterValidator(_in("1/rad"))]
Angle = Annotated[Number, AfterValidator(_in("rad"))]
Altitude = Annotated[Number, AfterValidator(_in("m"))]
Length = Annotated[Number, AfterValidator(_in("m", positive=True))]
Area = Annotated[Number, AfterValidator(_in("m^2", positive=True))]
Mass = Annotated[Number, AfterValidator(_in("kg", positive=True))]
Inertia = Annotated[Number, AfterValidator(_in("kg m^2", positive=True))]
Product = Annotated[Number, AfterValidator(_in("kg m^2"))]
AngularMomentum = Annotated[Number, AfterValidator(_in("N m s"))]
Speed = Annotated[Number, AfterValidator(_in("m/s", positive=True))]
Density = Annotated[Number, AfterValidator(_in("kg/m^3", positive=True))]
Gravity = Annotated[Number, AfterValidator(_in("m/s^2", positive=True))]
Thrust = Annotated[Assumption, AfterValidator(_in("N", positive=True))]
Travel = Annotated[Assumption, AfterValidator(_in("rad", positive=True))]
Lag = Annotated[Assumption, AfterValidator(_in("s", positive=True))]
AngularRate = Annotated[Assumption, AfterValidator(_in("rad/s", positive=True))]
