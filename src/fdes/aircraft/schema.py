"""What an aircraft file may say.

A file is laid out like the data sheet it was copied from, in the units of its source: geometry, mass, and for every
flight condition a table of derivatives. A number is written bare, or as a table that says more:

    Cl_dr = { printed = 0.107, corrected = 0.0118, confidence = "medium", reason = "repeats Cl_r; Teper has 0.0118" }

`printed` is what the block's `source` prints, `confidence` how sure it is that it prints just this, and `sources` are
other works in which the same value was found. What no source gives stands under `assumed`, with why it was chosen.
"""

from collections.abc import Callable
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, field_validator, model_validator

from fdes.aircraft.check import RULES
from fdes.errors import SpecError, nearest
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
Speed = Annotated[Number, AfterValidator(_in("m/s", positive=True))]
Density = Annotated[Number, AfterValidator(_in("kg/m^3", positive=True))]
Gravity = Annotated[Number, AfterValidator(_in("m/s^2", positive=True))]
Thrust = Annotated[Assumption, AfterValidator(_in("N", positive=True))]
Travel = Annotated[Assumption, AfterValidator(_in("rad", positive=True))]


class Geometry(Part):
    """The wing: area, span, mean chord."""

    source: str
    S: Area
    b: Length
    c: Length


class MassProperties(Part):
    """Weight as a mass, center of gravity as a fraction of the mean chord, inertias in body axes."""

    source: str
    W: Mass
    cg: Ratio | None = None
    Ix: Inertia
    Iy: Inertia
    Iz: Inertia
    Ixz: Product = Field(default_factory=lambda: Number(printed=0.0, unit="kg m^2"))


class ConsistentMass(Part):
    """The mass that belongs to the derivatives of a condition, where the book prints that of another loading.

    What is left out is as under [mass]. The `printed` variant does not use it.
    """

    reason: str = Field(min_length=1)
    confidence: Confidence | None = None
    unverified: bool = False
    sources: tuple[str, ...] = Field(default=(), strict=False)
    W: Mass
    Ix: Inertia | None = None
    Iy: Inertia | None = None
    Iz: Inertia | None = None
    Ixz: Product | None = None


class Derivatives(Part):
    """Nondimensional derivatives in stability axes, per radian unless they say otherwise, and per unit Mach.

    Rates are made nondimensional with c/(2 V) in pitch and b/(2 V) in roll and yaw. What a table leaves out is zero.
    """

    CL: Ratio
    CD: Ratio
    CL_alpha: Derivative
    CD_alpha: Derivative
    Cm_alpha: Derivative
    CL_alphadot: Derivative | None = None
    Cm_alphadot: Derivative | None = None
    CL_q: Derivative | None = None
    Cm_q: Derivative
    CL_M: Ratio | None = None
    CD_M: Ratio | None = None
    Cm_M: Ratio | None = None
    CL_de: Derivative
    CD_de: Derivative | None = None
    Cm_de: Derivative

    Cy_beta: Derivative
    Cl_beta: Derivative
    Cn_beta: Derivative
    Cy_p: Derivative | None = None
    Cl_p: Derivative
    Cn_p: Derivative
    Cy_r: Derivative | None = None
    Cl_r: Derivative
    Cn_r: Derivative
    Cy_da: Derivative | None = None
    Cl_da: Derivative
    Cn_da: Derivative
    Cy_dr: Derivative
    Cl_dr: Derivative
    Cn_dr: Derivative


class Assumed(Part):
    """What no source gives. Surface travel is counted from trim; a condition's own value goes before the file's."""

    max_thrust: Thrust | None = None
    elevator_up_limit: Travel | None = None
    elevator_down_limit: Travel | None = None
    aileron_limit: Travel | None = None
    rudder_limit: Travel | None = None
    full_stick_elevator: Travel | None = None
    full_stick_aileron: Travel | None = None
    full_pedal_rudder: Travel | None = None


class Condition(Part):
    """One straight and level flight condition. Speed and density are the standard atmosphere's unless given."""

    id: str = Field(min_length=1)
    name: str = Field(min_length=1)
    source: str
    mach: float = Field(gt=0.0)
    altitude: Altitude
    speed: Speed | None = None
    density: Density | None = None
    gravity: Gravity | None = None
    trim_alpha: Angle | None = None
    notes: tuple[str, ...] = Field(default=(), strict=False)
    derivatives: Derivatives
    consistent_mass: ConsistentMass | None = None
    assumed: Assumed = Field(default_factory=Assumed)


class Waiver(Part):
    """A finding of `fdes check` that is known and stays: of which rule, in which condition (or all), and why."""

    rule: str
    condition: str | None = None
    reason: str = Field(min_length=1)

    @field_validator("rule")
    @classmethod
    def _known(cls, rule: str) -> str:
        if rule not in RULES:
            near = nearest(rule, RULES)
            hint = f"Did you mean {near!r}?" if near else "Take the name that fdes check shows"
            raise ValueError(f"is {rule!r}, which is no rule of fdes check. {hint}")
        return rule


class AircraftFile(Part):
    """A whole file."""

    format: Literal[1]
    id: str = Field(min_length=1)
    name: str = Field(min_length=1)
    summary: str
    aliases: tuple[str, ...] = Field(default=(), strict=False)
    aileron_sense: Literal["positive rolls right", "positive rolls left"] = "positive rolls right"
    notes: tuple[str, ...] = Field(default=(), strict=False)
    sources: dict[str, str]
    geometry: Geometry
    mass: MassProperties
    assumed: Assumed = Field(default_factory=Assumed)
    conditions: tuple[Condition, ...] = Field(strict=False)
    waivers: tuple[Waiver, ...] = Field(default=(), strict=False)

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if not self.conditions:
            raise ValueError("there is no flight condition: give at least one, under [[conditions]]")
        ids = [c.id for c in self.conditions]
        twice = sorted({i for i in ids if ids.count(i) > 1})
        if twice:
            raise ValueError(f"there are two conditions with the id {twice[0]!r}")
        for key in _cited(self):
            if key not in self.sources:
                near = nearest(key, self.sources)
                hint = f". Did you mean {near!r}?" if near else ""
                raise ValueError(f"source {key!r} is cited, but not listed under [sources]{hint}")
        for condition in self.conditions:
            for name, number in condition.consistent_mass or ():
                if isinstance(number, Number) and number.unit != getattr(self.mass, name).unit:
                    unit = getattr(self.mass, name).unit
                    raise ValueError(
                        f"consistent_mass.{name} of condition {condition.id!r} is not in {unit}, as [mass] is"
                    )
            for name in Assumed.model_fields:
                if self.assumption(name, condition) is None:
                    raise ValueError(f"[assumed] lacks {name!r}, and condition {condition.id!r} does not give its own")
        return self

    @model_validator(mode="after")
    def _waivers_have_their_conditions(self) -> Self:
        ids = [c.id for c in self.conditions]
        for waiver in self.waivers:
            if waiver.condition not in {None, *ids}:
                near = nearest(str(waiver.condition), ids)
                hint = f"Did you mean {near!r}?" if near else f"Known: {', '.join(ids)}"
                raise ValueError(f"{waiver.rule} is waived for an unknown condition {waiver.condition!r}. {hint}")
        return self

    def assumption(self, name: str, condition: Condition) -> Assumption | None:
        """What is assumed for `condition` under that name: its own, else the file's."""
        own: Assumption | None = getattr(condition.assumed, name)
        general: Assumption | None = getattr(self.assumed, name)
        return own or general


def _cited(part: Part) -> list[str]:
    """All source keys that the part and its parts cite, in the order of the file."""
    keys = [getattr(part, "source", None), *getattr(part, "sources", ())] if not isinstance(part, AircraftFile) else []
    for _, inner in part:
        parts = inner if isinstance(inner, tuple) else (inner,)
        keys += [key for p in parts if isinstance(p, Part) for key in _cited(p)]
    return [key for key in keys if key]
