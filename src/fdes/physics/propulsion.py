"""Propulsion: thrust from throttle, airspeed and density.

Sources of stability derivatives say nothing of the engine, so its numbers are assumed: `assumed_engine` says how.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import cos, pow, sin, where
from fdes.physics.aero import Flow
from fdes.units import KilogramPerMeter3, Meter, MeterPerSecond, Newton, Number, Radian

JET_LAPSE = 0.7  # of thrust with density below the tropopause; assumed (docs/decisions/0014-thrust-with-height.md)
TROPOPAUSE: KilogramPerMeter3 = 0.36392  # the density at 11 km: U.S. Standard Atmosphere, 1976, table I
PROPELLER_LAPSE = 1.0  # of power with density, of an engine without a supercharger; assumed
SLOW = 0.5  # of the reference speed: below it, a propeller's thrust no longer grows as 1/V; assumed


class Engine(NamedTuple):
    """Thrust T_max at full throttle and reference speed and density, and how it changes with either.

    thin: a density, below which thrust is in proportion to it. tilt: of the thrust line, nose up from the body's x
    axis.
    """

    T_max: Newton = 0.0
    V_ref: MeterPerSecond = 1.0
    rho_ref: KilogramPerMeter3 = 1.0
    with_speed: Number = 0.0
    with_density: Number = 0.0
    thin: KilogramPerMeter3 = 0.0
    tilt: Radian = 0.0


class Thrust(NamedTuple):
    """Its components in body axes; its line passes through the center of gravity. power_dot: where there is a lag."""

    X: Newton
    Z: Newton
    power_dot: Annotated[float, "%/s"] = 0.0


def thrust(engine: Engine, flow: Flow, throttle: Number) -> Thrust:
    """The thrust of this instant: T_max throttle (V / V_ref)^n (rho / rho_ref)^m, m being 1 in thin air."""
    ratio = flow.V / engine.V_ref
    of_speed = pow(where(ratio.real > SLOW, ratio, SLOW), engine.with_speed)
    rho, rho_ref = flow.rho, engine.rho_ref
    dense = where(rho.real > engine.thin, rho, engine.thin)
    dense_ref = where(rho_ref > engine.thin, rho_ref, engine.thin)
    of_density = pow(dense / dense_ref, engine.with_density) * rho * dense_ref / (dense * rho_ref)
    T = engine.T_max * throttle * of_speed * of_density
    return Thrust(T * cos(engine.tilt), -T * sin(engine.tilt), 0.0)


def at_once(engine: Engine, flow: Flow, h: Meter, throttle: Number, power: Number) -> Thrust:
    """The thrust of an engine without a lag, which knows no power but its throttle."""
    return thrust(engine, flow, throttle)


class Spooling(NamedTuple):
    """An engine whose power follows the throttle as a first-order lag with the time constant `lag`."""

    engine: Engine
    lag: Annotated[float, "s"]


def spooling(engine: Spooling, flow: Flow, h: Meter, throttle: Number, power: Number) -> Thrust:
    """The thrust at that power, and how the power follows the throttle.

    B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., appendix A, PDOT.
    """
    push = thrust(engine.engine, flow, power / 100.0)
    return Thrust(push.X, push.Z, (settled_power(engine, throttle) - power) / engine.lag)


def settled_power(engine: Spooling, throttle: Number) -> Number:
    """The power at which it has settled."""
    return 100.0 * throttle


def no_power(engine: Engine, throttle: Number) -> Number:
    """The power at which an engine without a lag has settled: it has none."""
    return 0.0


def assumed_engine(
    T_max: Newton, V: MeterPerSecond, rho: KilogramPerMeter3, tilt: Radian, *, propeller: bool
) -> Engine:
    """A jet, whose thrust does not know its speed, or a propeller at constant power; T_max is that at V and rho.

    Above the tropopause the temperature stays, and by similarity the thrust of a jet at one Mach number and rotor speed
    is in proportion to the pressure, and so to the density. docs/decisions/0014-thrust-with-height.md.
    """
    if propeller:
        return Engine(T_max, V, rho, -1.0, PROPELLER_LAPSE, tilt=tilt)
    return Engine(T_max, V, rho, 0.0, JET_LAPSE, TROPOPAUSE, tilt)
