"""The nonlinear plant, linearized: the derivative that flies, differentiated by complex step.

The states are those of the linear plant, along the stability axes of the trimmed flight, so that the two can be laid
side by side. Thrust changes with speed and height as the engine's does, unless it is asked to be held.

Reference: W. Squire, G. Trapp, SIAM Review 40 (1998) 110-112.
"""

import numpy as np

from fdes.analysis.linearize import INPUTS, STATES
from fdes.analysis.trim import CALM, FREE, TINY, TrimPoint
from fdes.control import LinearModel
from fdes.elementary import cos, sin
from fdes.physics.attitude import product, quaternion
from fdes.physics.plant import SixDof, State, instant
from fdes.physics.propulsion import thrust
from fdes.physics.signals import Surfaces, channels
from fdes.physics.small_perturbation import PerturbationState


def linearized(point: TrimPoint, *, thrust_held: bool = False) -> LinearModel:
    """A (8, 8) and B (8, 4) about a trimmed flight that does not turn; surfaces in rad, throttle from 0 to 1."""
    plant = point.plant._replace(limits=FREE)
    if thrust_held:
        engine = plant.engine._replace(with_speed=0.0, with_density=0.0)
        now = _thrust_ratio(plant, point)
        plant = plant._replace(engine=engine._replace(T_max=engine.T_max * now))
    columns = []
    for k in range(len(STATES) + len(INPUTS)):
        z = [complex(0.0, TINY if i == k else 0.0) for i in range(len(STATES) + len(INPUTS))]
        columns.append([v.imag / TINY for v in _rates(plant, point, z)])
    J = np.array(columns).T
    unit = {c.name: c.unit for c in (*channels(PerturbationState), *channels(Surfaces))}
    return LinearModel(
        A=J[:, : len(STATES)],
        B=J[:, len(STATES) :],
        states=STATES,
        inputs=INPUTS,
        units={name: unit[name] for name in (*STATES, *INPUTS)},
        point={**point.spec._asdict(), "alpha": point.alpha, "theta": point.theta, **point.surfaces._asdict()},
    )


def _thrust_ratio(plant: SixDof, point: TrimPoint) -> float:
    """The engine's largest thrust in the trimmed flight, over T_max."""
    flow = instant(plant, point.state, Surfaces(throttle=point.surfaces.throttle), CALM).flow
    now, full = (thrust(e, flow, 1.0) for e in (plant.engine, plant.engine._replace(with_speed=0.0, with_density=0.0)))
    return now.X / full.X if full.X else 1.0


def _rates(plant: SixDof, point: TrimPoint, z: list[complex]) -> list[complex]:
    """d/dt of the eight states, the trimmed flight being where all of them are zero."""
    u, w, q, theta, beta, p, r, phi, elevator, throttle, aileron, rudder = z
    V, alpha, gamma = point.spec.V, point.alpha, point.spec.gamma
    ca, sa = cos(alpha), sin(alpha)
    level = V + u
    attitude = product(quaternion(phi, gamma + theta, 0.0j), quaternion(0.0j, complex(alpha), 0.0j))  # type: ignore[arg-type]
    place = [complex(v) for v in point.state[:3]]
    motion = [level * ca - w * sa, V * beta, level * sa + w * ca]
    x = State._make([*place, *motion, *attitude, p * ca - r * sa, q, p * sa + r * ca])
    held = Surfaces(elevator, aileron, rudder, point.surfaces.throttle + throttle)  # type: ignore[arg-type]
    d = plant.derivative(x, held, CALM)
    along, across = d.u * ca + d.w * sa, d.w * ca - d.u * sa
    roll, yaw = d.p * ca + d.r * sa, d.r * ca - d.p * sa
    bank = p + r * np.tan(gamma)  # of Euler's kinematics, which are linear in p, q, r about straight flight
    return [along, across, d.q, q, d.v / V, roll, yaw, bank]
