"""Many aircraft at once: the nonlinear derivative that flies, compiled for a batch in lanes.

Each aircraft has its own state, surfaces, air and numbers: a Monte Carlo over any derivative or inertia is one batch.
The plain text in `fdes.physics` is what is compiled; tests/compiled holds the two together.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

from fdes.kernel import Batch, batch
from fdes.physics.aero import AirLoads, DerivativeAero, Flow, derivative_loads
from fdes.physics.atmosphere import Atmosphere, air_at
from fdes.physics.earth import FLAT, Earth
from fdes.physics.integrators.rk4 import rk4
from fdes.physics.plant import SixDof, State, air_loads, day_at, derivative, thrust_of
from fdes.physics.propulsion import Engine, Thrust, thrust
from fdes.physics.rigid_body import Inertia
from fdes.physics.runge_kutta import Tableau
from fdes.physics.signals import Air, Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.physics.wind import Wind
from fdes.units import Kelvin, Meter, Number

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping


class Given(NamedTuple):
    """What is held through a step: the surfaces as the face of the plant has them, and the air."""

    held: Surfaces
    air: Air


class Numbers(NamedTuple):
    """All numbers of an aircraft that is made of derivatives, by the names that `SixDof` has for them."""

    inertia: Inertia
    aero: DerivativeAero
    engine: Engine
    limits: Limits
    rest: Surfaces
    wind: Wind
    warmer: Kelvin


class Airframe(NamedTuple):
    """What the equations of motion ask of a plant."""

    inertia: Inertia
    aero: DerivativeAero
    engine: Engine
    limits: Limits
    rest: Surfaces
    wind: Wind
    warmer: Kelvin
    earth: Earth


def numbers_of(plant: SixDof) -> Numbers:
    """The numbers of a plant that is made of derivatives."""
    return Numbers(plant.inertia, plant.aero, plant.engine, plant.limits, plant.rest, plant.wind, plant.warmer)


def rates(x: State, given: Given, n: Numbers) -> State:
    """dx/dt over a flat Earth, which is a constant here: a choice between Earths would part the lanes."""
    craft = Airframe(n.inertia, n.aero, n.engine, n.limits, n.rest, n.wind, n.warmer, FLAT)
    return derivative(craft, x, given.held, given.air)  # type: ignore[arg-type]  # it has all that is asked for


def loads_from_derivatives(plant: Airframe, flow: Flow, feel: Surfaces) -> AirLoads:
    """The loads of an aircraft that is made of derivatives."""
    return derivative_loads(plant.aero, flow, feel)


def thrust_at_once(plant: Airframe, flow: Flow, h: Meter, throttle: Number, power: Number) -> Thrust:
    """The thrust of an engine without a lag."""
    return thrust(plant.engine, flow, throttle)


def standard_day(plant: Airframe, h: Meter) -> Atmosphere:
    """The standard atmosphere, without a branch."""
    return air_at(h, plant.warmer)


def flat_earth_batch(tableau: Tableau = rk4, lanes: int = 8) -> Batch:
    """A compiled solver for many aircraft that are made of derivatives, over a flat Earth.

    Columns are aircraft; rows of its three arrays are `states`, `inputs` and `parameters`. The quaternion is not made
    a unit again: over a flight of minutes it stays one to the order of the integrator.
    """
    instead: Mapping[Callable[..., Any], Callable[..., Any]] = {
        day_at: standard_day,
        air_loads: loads_from_derivatives,
        thrust_of: thrust_at_once,
    }
    return batch(rates, tableau, lanes, instead)
