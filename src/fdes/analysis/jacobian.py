"""The nonlinear plant, linearized: the derivative that flies, differentiated by complex step.

The states are those of the linear plant, along the stability axes of the trimmed flight, so that the two can be laid
side by side. Thrust changes with speed and height as the engine's does, unless it is asked to be held. An engine with a
lag is taken as settled: its power is no state here.

Reference: W. Squire, G. Trapp, SIAM Review 40 (1998) 110-112.
"""

from collections.abc import Sequence

import numpy as np

from fdes.analysis.linearize import INPUTS, STATES
from fdes.analysis.trim import CALM, FREE, TINY, TrimPoint
from fdes.control import LinearModel
from fdes.elementary import atan2, cos, sin, sqrt, tan
from fdes.errors import SpecError
from fdes.physics.attitude import product, quaternion
from fdes.physics.plant import SixDof, State, instant, thrust_of
from fdes.physics.propulsion import Engine, Thrust, at_once, no_power
from fdes.physics.signals import Outputs, Surfaces, channels
from fdes.physics.small_perturbation import PerturbationState
from fdes.units import Number

OUTPUTS = (
    *("V", "mach", "cas", "alpha", "beta", "gamma", "phi", "theta", "p", "q", "r"),
    *("p_dot", "q_dot", "r_dot", "n_x", "n_y", "n_z", "h_dot"),
)


def linearized(point: TrimPoint, *, thrust_held: bool = False) -> LinearModel:
    """A (8, 8), B (8, 4), C (18, 8) and D (18, 4) about a trimmed flight; surfaces in rad, throttle from 0 to 1.

    Outputs are those of `Outputs` with their names, rates and load factors along body axes. Raises SpecError where the
    flight turns or sideslips, for then longitudinal and lateral motion are one.
    """
    must_be_straight(point)
    plant = point.plant._replace(limits=FREE)
    if thrust_held:
        plant = plant._replace(engine=engine_held(point), propulsion=at_once, settled=no_power)
    size, columns = len(STATES), []
    for k in range(size + len(INPUTS)):
        z = [complex(0.0, TINY if i == k else 0.0) for i in range(size + len(INPUTS))]
        columns.append([v.imag / TINY for v in _rates_and_outputs(plant, point, z)])
    J = np.array(columns).T
    unit = {c.name: c.unit for c in (*channels(PerturbationState), *channels(Surfaces), *channels(Outputs))}
    return LinearModel(
        A=J[:size, :size],
        B=J[:size, size:],
        C=J[size:, :size],
        D=J[size:, size:],
        states=STATES,
        inputs=INPUTS,
        outputs=OUTPUTS,
        units={name: unit[name] for name in (*STATES, *INPUTS, *OUTPUTS)},
        point={**point.spec.flight(), "alpha": point.alpha, "theta": point.theta, **point.surfaces._asdict()},
    )


def perturbed(point: TrimPoint, by: PerturbationState) -> State:
    """The trimmed flight with that added to it, along its stability axes; places in meters north, east, up."""
    V, alpha, gamma = point.spec.V, point.alpha, point.spec.gamma
    ca, sa = cos(alpha), sin(alpha)
    level = V + by.u
    zero = 0.0 * level
    attitude = product(quaternion(by.phi, gamma + by.theta, by.psi), quaternion(zero, zero + alpha, zero))
    place = [by.north, by.east, zero - point.spec.h - by.h]
    motion = [level * ca - by.w * sa, V * by.beta, level * sa + by.w * ca]
    rates = [by.p * ca - by.r * sa, by.q, by.p * sa + by.r * ca]
    return State._make([*place, *motion, *attitude, *rates, point.state.power])


def thrust_at(point: TrimPoint, throttle: Number) -> Thrust:
    """The thrust in the trimmed flight, once the engine has settled at `throttle`."""
    plant = point.plant
    flow = instant(plant, point.state, plant.trim(), CALM).flow
    return thrust_of(plant, flow, point.spec.h, throttle, plant.settled(plant.engine, throttle))


def engine_held(point: TrimPoint) -> Engine:
    """An engine whose thrust is that of the trimmed flight, in proportion to the throttle and to nothing else."""
    throttle = point.surfaces.throttle or 1.0
    push = thrust_at(point, throttle)
    return Engine(T_max=sqrt(push.X * push.X + push.Z * push.Z) / throttle, tilt=atan2(-push.Z, push.X))


def moved_by(plant: SixDof, point: TrimPoint, z: Sequence[complex]) -> tuple[State, Surfaces]:
    """The trimmed flight with `z` added to it: the eight states, then the inputs. The engine has settled."""
    u, w, q, theta, beta, p, r, phi, elevator, throttle, aileron, rudder = z
    zero = 0.0 * u
    by = PerturbationState(u, w, q, theta, beta, p, r, phi, zero, zero, zero, zero)  # type: ignore[arg-type]
    held = Surfaces(elevator, aileron, rudder, point.surfaces.throttle + throttle)  # type: ignore[arg-type]
    return perturbed(point, by)._replace(power=plant.settled(plant.engine, held.throttle)), held


def rates_along_stability_axes(point: TrimPoint, d: State, z: Sequence[complex]) -> list[complex]:
    """d/dt of the eight states: linear in dx/dt and in `z`, which is added to the trimmed flight."""
    _, _, q, _, _, p, r, *_ = z
    ca, sa = cos(point.alpha), sin(point.alpha)
    along, across = d.u * ca + d.w * sa, d.w * ca - d.u * sa
    roll, yaw = d.p * ca + d.r * sa, d.r * ca - d.p * sa
    bank = p + r * tan(point.spec.gamma)  # of Euler's kinematics, which are linear in p, q, r about straight flight
    return [along, across, d.q, q, d.v / point.spec.V, roll, yaw, bank]


def must_be_straight(point: TrimPoint) -> None:
    """Raises SpecError where the flight turns or sideslips, for then longitudinal and lateral motion are one."""
    if point.spec.turn or point.spec.beta or point.spec.q:
        raise SpecError(
            "Only straight flight without sideslip is linearized: leave turns, pull-ups and sideslip out of the trim."
        )


def _rates_and_outputs(plant: SixDof, point: TrimPoint, z: Sequence[complex]) -> list[complex]:
    """d/dt of the eight states, the trimmed flight being where all of them are zero; then the outputs."""
    x, held = moved_by(plant, point, z)
    rates = rates_along_stability_axes(point, plant.derivative(x, held, CALM), z)
    y = plant.observe(x, held, CALM)._asdict()
    return [*rates, *(y[name] for name in OUTPUTS)]
