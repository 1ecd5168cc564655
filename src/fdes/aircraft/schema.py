"""What an aircraft file may say.

A file is laid out like the data sheet it was copied from, in the units of its source: geometry, mass, and for every
flight condition a table of derivatives. A number is written bare, or as a table that says more:

    Cl_dr = { printed = 0.107, corrected = 0.0118, confidence = "medium", reason = "repeats Cl_r; Teper has 0.0118" }

`printed` is what the block's `source` prints, `confidence` how sure it is that it prints just this, and `sources` are
other works in which the same value was found. What no source gives stands under `assumed`, with why it was chosen.
"""

from collections.abc import Mapping
from typing import Literal, Self

from pydantic import Field, field_validator, model_validator

from fdes.aircraft.check import RULES
from fdes.aircraft.dimensional import DimensionalDerivatives
from fdes.aircraft.number import (
    Altitude,
    Angle,
    AngularRate,
    Area,
    Assumption,
    Confidence,
    Density,
    Derivative,
    Gravity,
    Inertia,
    Lag,
    Length,
    Mass,
    Number,
    Part,
    Product,
    Ratio,
    Speed,
    Thrust,
    Travel,
)
from fdes.aircraft.role import PHASES, AirplaneClass, Category
from fdes.aircraft.terms import Terms
from fdes.aircraft.turbofan import TurbofanTables
from fdes.errors import nearest


class Geometry(Part):
    """The wing: area, span, mean chord."""

    source: str
    S: Area
    b: Length
    c: Length


class MassProperties(Part):
    """Weight as a mass, center of gravity as a fraction of the mean chord, inertias in body axes.

    Only dimensional derivatives that are divided by the inertias and primed can do without them.
    """

    source: str
    W: Mass
    cg: Ratio | None = None
    Ix: Inertia | None = None
    Iy: Inertia | None = None
    Iz: Inertia | None = None
    Ixz: Product | None = None
    Ixy: Product | None = None
    Iyz: Product | None = None


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
    Ixy: Product | None = None
    Iyz: Product | None = None


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
    """What no source gives. Surface travel is counted from trim; a condition's own value goes before the file's.

    The drag is assumed only beside dimensional derivatives, which do not say it. Actuators and engine lag need not be
    mentioned.
    """

    max_thrust: Thrust | None = None
    drag: Thrust | None = None
    elevator_up_limit: Travel | None = None
    elevator_down_limit: Travel | None = None
    aileron_limit: Travel | None = None
    rudder_limit: Travel | None = None
    full_stick_elevator: Travel | None = None
    full_stick_aileron: Travel | None = None
    full_pedal_rudder: Travel | None = None
    actuator_bandwidth: AngularRate | None = None
    surface_rate_limit: AngularRate | None = None
    engine_lag: Lag | None = None


_LIKE_THE_F16 = "of the size of the F-16's, in Stevens, Lewis and Johnson, Aircraft Control and Simulation"
UNLESS_SAID = {
    "actuator_bandwidth": Assumption(value=20.0, unit="rad/s", reason=_LIKE_THE_F16),
    "surface_rate_limit": Assumption(value=60.0, unit="deg/s", reason=_LIKE_THE_F16),
}


ENGINE_LAG = {
    "jet": Assumption(
        value=1.8, unit="s", reason="14 CFR 33.73 gives turbines 5 s from 15 to 95 % of thrust, which is 5 s / ln 17"
    ),
    "propeller": Assumption(
        value=1.2,
        unit="s",
        reason="idle to full power in 3 to 4 s, three lags: Airplane Flying Handbook, FAA-H-8083-3A, chapter 15",
    ),
}


class FlyingQualities(Part):
    """What the airplane is for, in the words of MIL-F-8785C, and why. A condition's own goes before the file's."""

    airplane_class: AirplaneClass | None = None
    category: Category | None = None
    phase: str | None = None
    reason: str = Field(min_length=1)

    @model_validator(mode="after")
    def _phase_of_its_category(self) -> Self:
        if self.phase is None:
            return self
        if self.phase not in PHASES:
            raise ValueError(f"phase is {self.phase!r}, which is none of MIL-F-8785C: {', '.join(PHASES)}")
        category, name = PHASES[self.phase]
        if self.category != category:
            raise ValueError(f"phase {self.phase} ({name}) belongs to category {category!r}: say that too")
        return self


class Configuration(Part):
    """In which configuration of flaps and gear a condition is, such as ``clean``, and how that is known.

    Conditions of one configuration can be interpolated across Mach.
    """

    name: str = Field(min_length=1)
    reason: str = Field(min_length=1)


class Condition(Part):
    """One straight and level flight condition. Speed and density are the standard atmosphere's unless given.

    Its mass is the file's unless given. Its derivatives are nondimensional, or `dimensional`.
    """

    id: str = Field(min_length=1)
    name: str = Field(min_length=1)
    source: str
    mach: float = Field(gt=0.0)
    altitude: Altitude
    speed: Speed | None = None
    density: Density | None = None
    gravity: Gravity | None = None
    trim_alpha: Angle | None = None
    configuration: Configuration | None = None
    notes: tuple[str, ...] = Field(default=(), strict=False)
    mass: MassProperties | None = None
    derivatives: Derivatives | None = None
    dimensional: DimensionalDerivatives | None = None
    consistent_mass: ConsistentMass | None = None
    flying_qualities: FlyingQualities | None = None
    assumed: Assumed = Field(default_factory=Assumed)

    @model_validator(mode="after")
    def _one_kind_of_derivatives(self) -> Self:
        if (self.derivatives is None) == (self.dimensional is None):
            has = "neither" if self.derivatives is None else "both"
            raise ValueError(f"has {has} of [conditions.derivatives] and [conditions.dimensional]: give one of the two")
        if self.dimensional and self.dimensional.axes == "body" and self.trim_alpha is None:
            raise ValueError("lacks trim_alpha: without it, derivatives in body axes make no equations")
        return self

    @property
    def table(self) -> Derivatives | DimensionalDerivatives:
        """The derivatives, of whichever kind."""
        return self.derivatives or self.dimensional  # type: ignore[return-value]  # one of them is there: validated


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
    engine: Literal["jet", "propeller"] = "jet"
    aileron_sense: Literal["positive rolls right", "positive rolls left"] = "positive rolls right"
    notes: tuple[str, ...] = Field(default=(), strict=False)
    sources: dict[str, str]
    geometry: Geometry | None = None
    mass: MassProperties
    terms: Terms | None = None
    turbofan: TurbofanTables | None = None
    flying_qualities: FlyingQualities | None = None
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
                unit = getattr(getattr(condition.mass or self.mass, name, None), "unit", None)
                if isinstance(number, Number) and unit and number.unit != unit:
                    raise ValueError(
                        f"consistent_mass.{name} of condition {condition.id!r} is not in {unit}, as [mass] is"
                    )
            self._enough_for(condition)
        return self

    def _enough_for(self, condition: Condition) -> None:
        """Geometry, inertias and assumptions are there as far as the kind of derivatives needs them."""
        needed = condition.dimensional.needs if condition.dimensional else {"S", "b", "c", "Ix", "Iy", "Iz"}
        needed |= {"S", "b", "c", "cg", "Ix", "Iy", "Iz"} if self.terms else set()
        mass = condition.mass or self.mass
        for name in sorted(needed):
            block, part = ("geometry", self.geometry) if name in Geometry.model_fields else ("mass", mass)
            if getattr(part, name, None) is None:
                raise ValueError(f"{block}.{name} is missing, and condition {condition.id!r} needs it")
        assumed = set(Assumed.model_fields) - ({"drag"} if condition.derivatives else set())
        assumed -= {"engine_lag"} if self.turbofan else set()
        for name in Assumed.model_fields:
            if name in assumed and self.assumption(name, condition) is None:
                raise ValueError(f"[assumed] lacks {name!r}, and condition {condition.id!r} does not give its own")

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
        """What is assumed for `condition` under that name: its own, else the file's, else what is assumed of all."""
        own: Assumption | None = getattr(condition.assumed, name)
        general: Assumption | None = getattr(self.assumed, name)
        if name == "engine_lag" and not self.turbofan:
            return own or general or ENGINE_LAG[self.engine]
        return own or general or UNLESS_SAID.get(name)


def _cited(part: Part) -> list[str]:
    """All source keys that the part and its parts cite, in the order of the file."""
    keys = [getattr(part, "source", None), *getattr(part, "sources", ())] if not isinstance(part, AircraftFile) else []
    for _, inner in part:
        parts = inner if isinstance(inner, tuple) else inner.values() if isinstance(inner, Mapping) else (inner,)
        keys += [key for p in parts if isinstance(p, Part) for key in _cited(p)]
    return [key for key in keys if key]
