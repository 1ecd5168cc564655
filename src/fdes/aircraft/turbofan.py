"""An engine of which thrust tables are known, in an aircraft file, under [turbofan]."""

from collections.abc import Mapping
from typing import Annotated, Self

from pydantic import Field, field_validator, model_validator

from fdes.aircraft.number import AngularMomentum, Part
from fdes.aircraft.terms import Row, rising
from fdes.errors import SpecError
from fdes.physics.tables import Axis
from fdes.physics.turbofan import PowerLag, Turbofan
from fdes.units import si_unit, to_si

Grid = Annotated[tuple[Row, ...], Field(strict=False)]


class Lag(Part):
    """How power follows its command: see `fdes.physics.turbofan.PowerLag`."""

    slow: float = Field(gt=0.0)
    quick: float = Field(gt=0.0)
    near: float
    far: float
    lit: float = Field(gt=0.0)
    above: float
    below: float

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        if not self.near < self.far:
            raise ValueError(f"has near = {self.near:g} and far = {self.far:g}: near must be the smaller one")
        return self


class TurbofanTables(Part):
    """Thrust at idle, military and maximum power, a row over the heights for each Mach number; and how power is set.

    power: commanded, from 0 over 50 (military) to 100, at each `throttle` from 0 to 1.
    """

    source: str
    mach: Row
    height: Row
    units: Mapping[str, str]
    idle: Grid
    military: Grid
    maximum: Grid
    throttle: Row
    power: Row
    angular_momentum: AngularMomentum
    lag: Lag

    _rising = field_validator("mach", "height", "throttle", "power")(rising)

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        if set(self.units) != {"height", "thrust"}:
            raise ValueError('needs units = { height = "ft", thrust = "lbf" }, or others like these')
        for name, si in (("height", "m"), ("thrust", "N")):
            try:
                fits = si_unit(self.units[name]) == si
            except SpecError as error:
                raise ValueError(str(error)) from None
            if not fits:
                raise ValueError(f"has a {name} in {self.units[name]!r}, which is none")
        for name in ("idle", "military", "maximum"):
            found = [len(row) for row in getattr(self, name)]
            if found != [len(self.height)] * len(self.mach):
                raise ValueError(
                    f"{name} needs a row of {len(self.height)} thrusts for each of {len(self.mach)} Mach numbers, "
                    f"and has {len(found)} rows of {', '.join(str(n) for n in sorted(set(found)))}"
                )
        if (self.throttle[0], self.throttle[-1]) != (0.0, 1.0) or len(self.throttle) != len(self.power):
            raise ValueError("needs a throttle from 0 to 1, and as many powers as throttles")
        if (self.power[0], self.power[-1]) != (0.0, 100.0):
            raise ValueError(f"has powers from {self.power[0]:g} to {self.power[-1]:g}; they are from 0 to 100")
        return self

    def engine(self) -> Turbofan:
        """What flies, in SI."""

        def newtons(grid: Grid) -> tuple[tuple[float, ...], ...]:
            return tuple(tuple(to_si(v, self.units["thrust"]) for v in row) for row in grid)

        heights = tuple(to_si(h, self.units["height"]) for h in self.height)
        return Turbofan(
            mach=Axis(self.mach),
            height=Axis(heights),
            idle=newtons(self.idle),
            military=newtons(self.military),
            maximum=newtons(self.maximum),
            throttle=Axis(self.throttle, held=False),  # so that a trim can say by how much it falls short
            power=self.power,
            lag=PowerLag(**self.lag.model_dump()),
        )
