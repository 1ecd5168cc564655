"""A steady maneuver, of which any quantities are given and the others found: level flight, climb, pull-up, turn.

A trim finds the throttle that holds a speed. Performance asks the other way around: what full throttle allows, which
speed goes with the largest lift, how tight a turn can be kept up. So here all quantities of a maneuver stand side by
side, and Newton's method, its Jacobian by complex step, finds those that are said to be free.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 3.4 and 3.6, for
the constraints of steady flight.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from fdes.elementary import atan2, cos, sin, sqrt
from fdes.flight.steady import CALM, FREE, slopes
from fdes.physics.attitude import quaternion
from fdes.physics.plant import SixDof, State, instant, thrust_of
from fdes.physics.signals import Surfaces
from fdes.units import Meter, MeterPerSecond, MeterPerSecond2, Newton, Number, Radian, RadianPerSecond

ENOUGH = 1e-9  # of the accelerations [m/s^2 and rad/s^2]
ITERATIONS, HALVINGS = 20, 8
ANGLES, MOST = ("gamma", "alpha", "phi"), 0.2  # rad: no step of the search is larger
SLACK = 1e-9  # rad, beyond a stop

STRAIGHT = ("alpha", "elevator", "throttle")
ACCELERATING = ("alpha", "elevator", "V_dot")
CLIMBING = ("alpha", "elevator", "gamma")
AT_THIS_LIFT = ("V", "elevator", "V_dot")
PULLING = ("pull", "elevator", "V_dot")
TURNING = ("turn", "phi", "elevator", "aileron", "rudder", "V_dot")
KEPT_TURNING = ("alpha", "phi", "turn", "elevator", "aileron", "rudder")


class Maneuver(NamedTuple):
    """A flight along a line, an arc upward (`pull`, the rate of gamma), or a circle (`turn`, the rate of the heading).

    Surfaces are absolute; there is no sideslip. V_dot: what speed gains while all else is steady.
    """

    V: MeterPerSecond
    h: Meter
    alpha: Radian = 0.0
    gamma: Radian = 0.0
    phi: Radian = 0.0
    turn: RadianPerSecond = 0.0
    pull: RadianPerSecond = 0.0
    V_dot: MeterPerSecond2 = 0.0
    elevator: Radian = 0.0
    aileron: Radian = 0.0
    rudder: Radian = 0.0
    throttle: Number = 0.0

    @property
    def surfaces(self) -> Surfaces:
        """The controls."""
        return Surfaces(self.elevator, self.aileron, self.rudder, self.throttle)


def balanced(plant: SixDof, guess: Maneuver, free: Sequence[str]) -> Maneuver | None:
    """The maneuver near `guess` in which nothing but its own acceleration is left; None where none is found.

    free: three names where the maneuver is symmetric, else six; the rest is as `guess` says.
    """
    places = [Maneuver._fields.index(name) for name in free]
    angles = [k for k, name in enumerate(free) if name in ANGLES]
    loose = plant._replace(limits=FREE, rest=Surfaces())
    z = np.array([guess[place] for place in places])
    left = np.array(_unbalanced(loose, guess, places, z.tolist()))
    for _ in range(ITERATIONS):
        if _size(left) < ENOUGH:
            return _with(guess, places, z.tolist())
        by = slopes(lambda z: _unbalanced(loose, guess, places, z), z.tolist())
        try:
            change = np.linalg.solve(by, -left)
        except np.linalg.LinAlgError:
            return None
        largest = max((abs(float(change[k])) for k in angles), default=0.0)
        change *= min(1.0, MOST / max(largest, 1e-12))
        for _ in range(HALVINGS):
            then = np.array(_unbalanced(loose, guess, places, (z + change).tolist()))
            if _size(then) < _size(left):
                break
            change *= 0.5
        else:
            return None
        z, left = z + change, then
    return None


def _with(m: Maneuver, places: Sequence[int], z: Sequence[float] | Sequence[complex]) -> Maneuver:
    values: list[float] = list(m)
    for place, value in zip(places, z, strict=True):
        values[place] = value  # type: ignore[call-overload]  # a complex one, for the Jacobian
    return Maneuver._make(values)


def _size(left: "np.ndarray[tuple[int], np.dtype[np.float64]]") -> float:
    largest = float(np.abs(left).max())
    return largest if math.isfinite(largest) else math.inf


def _unbalanced(
    plant: SixDof, m: Maneuver, places: Sequence[int], z: Sequence[float] | Sequence[complex]
) -> list[float]:
    """The accelerations that are not the maneuver's own: u, w, q, and v, p, r where it is not symmetric."""
    m = _with(m, places, z)
    rate = plant.derivative(state_of(plant, m), m.surfaces, CALM)
    own = rate.u - m.V_dot * cos(m.alpha), rate.w - m.V_dot * sin(m.alpha), rate.q
    return [*own] if len(places) == len(own) else [*own, rate.v, rate.p, rate.r]


def state_of(plant: SixDof, m: Maneuver) -> State:
    """The state in that maneuver, heading north, the engine settled. Stevens et al., sec. 3.6, rate of climb."""
    ca, sa, s = cos(m.alpha), sin(m.alpha), sin(m.gamma)
    b = cos(m.phi) * sa
    theta = atan2(ca * b + s * sqrt(ca * ca - s * s + b * b), ca * ca - s * s)
    ct, st, zero = cos(theta), sin(theta), 0.0 * (m.alpha + m.phi + m.gamma)
    rates = -m.turn * st, m.turn * sin(m.phi) * ct + m.pull, m.turn * cos(m.phi) * ct
    e = quaternion(m.phi + zero, theta, zero)
    return State(zero, zero, zero - m.h, m.V * ca, zero, m.V * sa, *e, *rates, plant.settled(plant.engine, m.throttle))


def load_factor(plant: SixDof, m: Maneuver) -> float:
    """The force across the flight path over the weight: 1 in level flight, 1/cos(phi) in a level turn."""
    g = plant.earth.g
    if m.turn:
        return math.hypot(math.cos(m.gamma), m.V * math.cos(m.gamma) * m.turn / g)
    return math.cos(m.gamma) + m.V * m.pull / g


def thrust_in(plant: SixDof, m: Maneuver) -> Newton:
    """The thrust in that maneuver, the engine settled."""
    plant = plant._replace(limits=FREE, rest=Surfaces())
    x = state_of(plant, m)
    push = thrust_of(plant, instant(plant, x, m.surfaces, CALM).flow, m.h, m.throttle, x.power)
    return math.hypot(push.X, push.Z)


def stop_of(plant: SixDof, m: Maneuver) -> str:
    """The surface that would have to go beyond its stop; empty where none would. The throttle is not asked."""
    low, high = plant.limits
    names = ("elevator", "aileron", "rudder")
    beyond = (n for n in names if not getattr(low, n) - SLACK <= getattr(m, n) <= getattr(high, n) + SLACK)
    return next(beyond, "")
