"""A plant with actuators before its surfaces: a plant like any other, whose state also says where the surfaces are.

`fly` knows nothing of it. The command is held through a frame; the surfaces follow it within the frame, integrated
together with the aircraft by the plant's own method.
"""

from functools import cache
from math import sqrt
from typing import Any, NamedTuple, Protocol, get_type_hints

from fdes.aircraft import FlightCondition
from fdes.errors import SpecError
from fdes.flight.simulation import Frame, Plant
from fdes.physics.actuators import Actuator, Actuators, Deflections, derivative, positions, settled
from fdes.physics.runge_kutta import Tableau, Vector, step
from fdes.physics.signals import Air, Outputs, Surfaces
from fdes.physics.small_perturbation import ExactHold, Limits, limited
from fdes.units import to_si

MOVED = len(Deflections._fields)
EXACT_STANDS_STILL = (
    "The exact hold needs surfaces that stand still from frame to frame, and actuators move them. "
    "Take another integrator with actuators, such as rk4."
)


class Integrated(Plant, Protocol):
    """A plant that says how its state changes, and by which method it is integrated."""

    @property
    def limits(self) -> Limits:
        """How far the surfaces can go."""
        ...

    @property
    def integrator(self) -> Tableau | ExactHold:
        """The method."""
        ...

    def derivative(self, x: Any, held: Surfaces, air: Air) -> Any:
        """dx/dt with the surfaces held."""
        ...


def actuators_of(condition: FlightCondition, damping: float = 0.0) -> Actuators:
    """The actuators that are assumed of an aircraft, the same on each surface; second order with a `damping` ratio."""
    said = {name: to_si(a["value"], a["unit"]) for name, a in condition.assumed.items()}
    one = Actuator(said["actuator_bandwidth"], damping, said["surface_rate_limit"])
    return Actuators(one, one, one)


def with_actuators(plant: Integrated, condition: FlightCondition) -> "WithActuators":
    """`plant` with the actuators that are assumed of `condition`. Raises SpecError for the exact hold."""
    if isinstance(plant.integrator, ExactHold):
        raise SpecError(EXACT_STANDS_STILL)
    return WithActuators(plant, actuators_of(condition))


class WithActuators(NamedTuple):
    """`plant` with `actuators` before its surfaces. Its state is the plant's, then the deflections.

    `with_actuators` makes one. The exact hold cannot advance it: it needs surfaces that stand still through a step.
    """

    plant: Integrated
    actuators: Actuators

    def start(self, height: float | None = None) -> Any:
        """Undisturbed flight, the surfaces at trim."""
        return self.beginning(self.plant.start(height), self.plant.trim())

    def beginning(self, x: Any, surfaces: Surfaces) -> Any:
        """The state `x` of the plant with the surfaces at rest there."""
        stops = limited(surfaces, self.plant.limits)
        kind: type = type(x)
        return state_type(kind)(*x, stops.elevator, 0.0, stops.aileron, 0.0, stops.rudder, 0.0)

    def trim(self) -> Surfaces:
        """The plant's."""
        return self.plant.trim()

    def observe(self, x: Any, held: Surfaces, air: Air) -> Outputs:
        """The plant's outputs with the surfaces where they are."""
        return self.plant.observe(self._plants(x), positions(Deflections(*x[-MOVED:]), held.throttle), air)

    def derivative(self, x: Any, held: Surfaces, air: Air) -> Any:
        """dx/dt of the aircraft and its surfaces while the command is `held`."""
        d = Deflections(*x[-MOVED:])
        command = limited(held, self.plant.limits)
        dx = self.plant.derivative(self._plants(x), positions(d, held.throttle), air)
        return type(x)(*dx, *derivative(self.actuators, d, command))

    def advance(self, x: Any, command: Surfaces, air: Air, dt: float, substeps: int = 1) -> Any:
        """The state one frame later: `substeps` steps of the plant's integrator, command and air held."""
        method = self.plant.integrator
        if isinstance(method, ExactHold):
            raise SpecError(EXACT_STANDS_STILL)
        stops, state = limited(command, self.plant.limits), type(x)

        def f(y: Vector) -> Vector:
            slope: Vector = self.derivative(state(*y), stops, air)
            return slope

        y: Vector = x
        for _ in range(substeps):
            y = step(f, y, dt / substeps, method)
            y = (*_upright(plant_type(state)(*y[:-MOVED])), *settled(self.actuators, Deflections(*y[-MOVED:]), stops))
        return state(*y)

    def _plants(self, x: Any) -> Any:
        return plant_type(type(x))(*x[:-MOVED])


def _upright(x: Any) -> Any:
    """A state of the nonlinear plant with its quaternion made a unit again, as that plant does; another as it is."""
    if "e0" not in x._fields:
        return x
    size = sqrt(x.e0 * x.e0 + x.e1 * x.e1 + x.e2 * x.e2 + x.e3 * x.e3)
    return x._replace(e0=x.e0 / size, e1=x.e1 / size, e2=x.e2 / size, e3=x.e3 / size)


def fitted(x: Any, plant: Plant, surfaces: Surfaces) -> Any:
    """The state `x` as `plant` has it, where actuators were put before the surfaces, or taken away.

    New actuators begin at rest with the `surfaces` where they are.
    """
    if isinstance(plant, WithActuators):
        return x if type(x) in _PLANT else plant.beginning(x, surfaces)
    return plant_type(type(x))(*x[:-MOVED]) if type(x) in _PLANT else x


def surfaces_left(x: Any, plant: Plant, held: Surfaces) -> Surfaces:
    """Where the surfaces are [rad] in state `x` as `plant` takes over: where its actuators, taken away, have left them.

    Else as they are `held`.
    """
    if isinstance(plant, WithActuators) or type(x) not in _PLANT:
        return held
    return positions(Deflections(*x[-MOVED:]), held.throttle)


_PLANT: dict[type, type] = {}  # of each state with actuators, the state without; filled by `state_type` alone


@cache
def state_type(plant: type) -> Any:
    """The named tuple of a plant's state followed by the deflections, units and all."""
    hints = get_type_hints(plant, include_extras=True) | get_type_hints(Deflections, include_extras=True)
    made: Any = NamedTuple(f"{plant.__name__}WithActuators", list(hints.items()))  # type: ignore[misc]  # made of two
    _PLANT[made] = plant
    return made


def plant_type(actuated: type) -> Any:
    """The plant's own state type, of one that `state_type` made."""
    return _PLANT[actuated]


def recorded_type(state: type) -> Any:
    """The state of a plant, with or without actuators, as a recording has it in which they can be switched in flight.

    That is with deflections; without actuators the surfaces are where they were observed to be, and have no rate.
    """
    return state if state in _PLANT else state_type(state)


def recorded_state(frame: Frame) -> tuple[float, ...]:
    """The state of `frame`, and where the surfaces are, in the order of `recorded_type`."""
    x: tuple[float, ...] = frame.state
    y = frame.outputs
    return x if type(x) in _PLANT else (*x, y.elevator, 0.0, y.aileron, 0.0, y.rudder, 0.0)
