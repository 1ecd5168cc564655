"""A turbofan with an afterburner, of which thrust tables are known: idle, military and maximum, over Mach and height.

The throttle commands a power from 0 (idle) over 50 (military) to 100 (maximum), which follows with a lag.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., appendix A, TGEAR, PDOT,
RTAU and THRUST, after L. T. Nguyen et al., NASA TP-1538, 1979.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import where
from fdes.physics.aero import Flow
from fdes.physics.propulsion import Thrust
from fdes.physics.tables import Axis, Row, grid_at, row_at, spot
from fdes.units import Meter, Number

MILITARY: Number = 50.0  # of the power from 0 to 100: above it, the afterburner is lit
Power = Annotated[float, "%"]


class PowerLag(NamedTuple):
    """How power follows its command.

    `slow` and `quick` [1/s] are the rates for differences of `far` and more, and of `near` and less, without the
    afterburner; `lit` the rate with it. On lighting it, power goes for `above`, on putting it out for `below`.
    """

    slow: float
    quick: float
    near: Power
    far: Power
    lit: float
    above: Power
    below: Power


class Turbofan(NamedTuple):
    """Thrust [N] over Mach and height, a row for each Mach number; the power that each throttle commands; the lag."""

    mach: Axis
    height: Axis
    idle: tuple[Row, ...]
    military: tuple[Row, ...]
    maximum: tuple[Row, ...]
    throttle: Axis
    power: Row
    lag: PowerLag


def commanded_power(engine: Turbofan, throttle: Number) -> Power:
    """The power that `throttle`, from 0 to 1, commands."""
    return row_at(engine.power, spot(engine.throttle, throttle))


def power_rate(lag: PowerLag, power: Power, commanded: Power) -> float:
    """d(power)/dt [%/s]. PDOT of Stevens, Lewis and Johnson, appendix A."""
    if commanded.real >= MILITARY:
        goal = where(power.real >= MILITARY, commanded, lag.above)
    else:
        goal = where(power.real >= MILITARY, lag.below, commanded)
    difference = goal - power
    if power.real >= MILITARY:
        rate = lag.lit
    else:
        between = (difference - lag.near) / (lag.far - lag.near)
        between = where(between.real < 0.0, 0.0, where(between.real > 1.0, 1.0, between))
        rate = lag.quick + between * (lag.slow - lag.quick)
    found: float = rate * difference
    return found


def turbofan_thrust(engine: Turbofan, mach: Number, h: Meter, power: Power) -> Thrust:
    """The thrust at that power: straight lines between idle, military and maximum, along the body's x axis."""
    row, column = spot(engine.mach, mach), spot(engine.height, h)
    military = grid_at(engine.military, row, column)
    dry = power.real < MILITARY
    other = grid_at(engine.idle if dry else engine.maximum, row, column)
    share = (MILITARY - power) / MILITARY if dry else (power - MILITARY) / MILITARY
    return Thrust(military + share * (other - military), 0.0, 0.0)


def turbofan(engine: Turbofan, flow: Flow, h: Meter, throttle: Number, power: Power) -> Thrust:
    """Its thrust at that power, and how the power follows the throttle."""
    push = turbofan_thrust(engine, flow.mach, h, power)
    return Thrust(push.X, push.Z, power_rate(engine.lag, power, commanded_power(engine, throttle)))
