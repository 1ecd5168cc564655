"""The search for a steady flight: Newton's method on what is unknown of it, whatever the stops of the surfaces are.

Six accelerations are to vanish: six unknowns, as a rule alpha, bank, elevator, aileron, rudder and throttle. What is
asked for in place of speed, path, turn or sideslip exchanges an unknown for it, or adds one with its equation. Slopes
are by complex step (`fdes.flight.steady`), and serve as long as the search closes in fast.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 3.4 and 3.6.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fdes.analysis.trim_request import TrimSpec
from fdes.elementary import atan2, cos, sin, sqrt, tan
from fdes.flight.steady import CALM, FREE, slopes
from fdes.physics.attitude import quaternion
from fdes.physics.plant import SixDof, State
from fdes.physics.signals import Outputs, Surfaces
from fdes.units import DEG, G0

ENOUGH = 1e-10  # of the accelerations [m/s^2 and rad/s^2]
ITERATIONS, HALVINGS = 25, 6
PATIENCE = 6  # steps that bring next to nothing, before the search ends
FAST = 0.02  # of what a step leaves of the accelerations: then the slopes serve for another
OTHER_STARTS = tuple(alpha * DEG for alpha in (2.0, 7.0, 12.0, 17.0, 27.0, 37.0))  # between breakpoints of 5 deg
FARTHEST = {"alpha": 0.2, "phi": 0.2, "gamma": 0.2, "beta": 0.2}  # rad in one step
FASTER = 0.2  # of the speed in one step
SIDEWAYS = (1, 3, 5)  # of the accelerations, and of the unknowns


class Flight(NamedTuple):
    """Everything that fixes a steady flight, known or not. SI."""

    V: float
    h: float
    gamma: float
    turn: float
    beta: float
    q: float
    alpha: float
    phi: float
    elevator: float
    aileron: float
    rudder: float
    throttle: float


@dataclass(frozen=True)
class TrimPoint:
    """A steady flight that was found. surfaces: absolute. residual: the largest acceleration that is left.

    spec: of this flight, what followed from the rest filled in; asked: as it was asked for.
    plant: trimmed there: its flights begin in this state, and its face calls these surfaces zero.
    """

    spec: TrimSpec
    alpha: float
    phi: float
    theta: float
    surfaces: Surfaces
    state: State
    residual: float
    iterations: int
    plant: SixDof
    asked: TrimSpec

    def outputs(self) -> Outputs:
        """All outputs of this flight, in still air."""
        return self.plant.observe(self.state, self.plant.trim(), CALM)


class Problem(NamedTuple):
    """The equations of one request. unknown: which of `Flight` are sought; level: its sides can be left alone."""

    plant: SixDof
    spec: TrimSpec
    known: Flight
    unknown: tuple[int, ...]
    level: bool


def solve(plant: SixDof, spec: TrimSpec) -> TrimPoint:
    """The nearest to a balance that Newton's method finds, whatever the stops are.

    It begins at the angle of attack of the plant's initial flight. Where that leads nowhere, as it may across the kinks
    of tables and where lift is at its largest, it begins at others.
    """
    first = solve_briefly(plant, spec)
    if first.residual < ENOUGH:
        return first
    points = [first, *(solve_from(plant, spec, alpha) for alpha in OTHER_STARTS)]
    return min(points, key=lambda point: point.residual)


def solve_briefly(plant: SixDof, spec: TrimSpec) -> TrimPoint:
    """As `solve`, from the angle of attack of the plant's initial flight alone."""
    return solve_from(plant, spec, atan2(plant.initial.w, plant.initial.u))


def solve_from(plant: SixDof, spec: TrimSpec, alpha: float) -> TrimPoint:
    """The nearest to a balance that Newton's method finds from that angle of attack [rad]."""
    problem = _problem(plant, spec, alpha)
    z = np.array([problem.known[k] for k in problem.unknown])
    left, iterations = _left(problem, z), 0
    sizes = [_size(left)]
    by: NDArray[np.float64] | None = None  # the unknowns: the slopes of the equations, while they serve
    chosen = list(range(len(z)))
    while sizes[-1] > ENOUGH and iterations < ITERATIONS and not _stuck(sizes):
        fresh = by is None
        if by is None:
            chosen = _worth_changing(problem, left)
            by = slopes(partial(_equations, problem), z.tolist(), chosen)
        change = np.zeros(len(z))
        change[chosen] = _solved(by[chosen], -left[chosen])
        change *= min(1.0, *(most / max(abs(d), 1e-12) for d, most in zip(change, _farthest(problem, z), strict=True)))
        then = _left(problem, z + change)
        for _ in range(HALVINGS if fresh else 0):
            if _size(then) < sizes[-1]:
                break
            change *= 0.5
            then = _left(problem, z + change)
        better = _size(then) / sizes[-1]
        if not better < FAST:
            by = None
        if better < 1.0:
            z, left, iterations = z + change, then, iterations + 1
            sizes.append(_size(left))
        elif fresh:
            break
    return _point(plant, problem, z, left, iterations)


def _stuck(sizes: Sequence[float]) -> bool:
    """Whether the last steps have brought next to nothing."""
    return len(sizes) > PATIENCE and sizes[-1] > 0.7 * sizes[-1 - PATIENCE]


def _problem(plant: SixDof, spec: TrimSpec, alpha: float) -> Problem:
    """What is sought, and where the search begins."""
    names = [
        "alpha",
        "phi",
        "elevator",
        "aileron",
        "throttle",
        "rudder",
    ]  # those of the sides where v, p, r have theirs
    g, V = plant.earth.g, spec.V
    start = {"turn": spec.turn, "beta": spec.beta, "q": spec.q, "alpha": alpha, "throttle": plant.rest.throttle}
    start["phi"] = atan2(V * cos(spec.gamma) * spec.turn, g)
    if spec.alpha is not None:
        names[0], start["alpha"] = "V", spec.alpha
    if spec.bank is not None:
        names[1], start["phi"], start["turn"] = "turn", spec.bank, g * tan(spec.bank) / V
    if spec.slip_bank is not None:
        names[1], start["phi"] = "beta", spec.slip_bank
    if spec.throttle is not None:
        names[4], start["throttle"] = "gamma", spec.throttle
    if spec.n_turn is not None:
        names.append("turn")
        across = sqrt(spec.n_turn * spec.n_turn - 1.0) * (-1.0 if spec.n_turn < 0.0 else 1.0)
        start["turn"], start["phi"] = g * across / V, atan2(across, 1.0)
    if spec.n_y is not None:
        names.append("beta")
    known = Flight(V, spec.h, spec.gamma, elevator=0.0, aileron=0.0, rudder=0.0, **start)
    day = plant.atmosphere(spec.h, plant.warmer)  # once: no unknown changes the height
    free = plant._replace(limits=FREE, rest=Surfaces(), atmosphere=lambda _h, _warmer: day)
    level = not (spec.turn or spec.beta or spec.n_y or {"turn", "beta"} & set(names))
    return Problem(free, spec, known, tuple(Flight._fields.index(name) for name in names), level)


def _worth_changing(problem: Problem, left: NDArray[np.float64]) -> list[int]:
    """Which unknowns, and with them which equations: where nothing pushes sideways, bank and side controls stay."""
    everything = range(len(problem.unknown))
    if problem.level and float(np.abs(left[list(SIDEWAYS)]).max()) < ENOUGH:
        return [k for k in everything if k not in SIDEWAYS]
    return list(everything)


def _farthest(problem: Problem, z: NDArray[np.float64]) -> list[float]:
    names = (Flight._fields[k] for k in problem.unknown)
    return [FASTER * abs(v) if name == "V" else FARTHEST.get(name, np.inf) for name, v in zip(names, z, strict=True)]


def _solved(matrix: NDArray[np.float64], right: NDArray[np.float64]) -> NDArray[np.float64]:
    try:
        return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.lstsq(matrix, right, rcond=None)[0], dtype=np.float64)


def _size(residual: NDArray[np.float64]) -> float:
    largest = float(np.abs(residual).max())
    return largest if np.isfinite(largest) else np.inf


def _left(problem: Problem, z: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.array(_equations(problem, z.tolist()))


def _equations(problem: Problem, z: Sequence[float]) -> list[float]:
    """u_dot, v_dot, w_dot [m/s^2], p_dot, q_dot, r_dot [rad/s^2]; then by how much load factors miss [m/s^2]."""
    plant, spec, known, unknown, _ = problem
    values = list(known)
    for k, v in zip(unknown, z, strict=True):
        values[k] = v
    flight = Flight._make(values)
    x, theta = _state(problem, flight)
    held = Surfaces(flight.elevator, flight.aileron, flight.rudder, flight.throttle)
    rate = plant.derivative(x._replace(power=plant.settled(plant.engine, held.throttle)), held, CALM)
    found = [rate.u, rate.v, rate.w, rate.p, rate.q, rate.r]
    # Load factors of a steady flight are kinematics: Stevens et al., eq. 1.7-18, u_dot, v_dot and w_dot being zero.
    if spec.n_turn is not None:
        weight = plant.earth.g * cos(theta) * cos(flight.phi)
        found.append(x.q * x.u - x.p * x.v + weight - G0 * abs(spec.n_turn))
    if spec.n_y is not None:
        found.append(x.r * x.u - x.p * x.w - plant.earth.g * cos(theta) * sin(flight.phi) - G0 * spec.n_y)
    return found


def _state(problem: Problem, flight: Flight) -> tuple[State, float]:
    """`state_of`, with the pitch rate of a load factor where one is asked for: there w_dot is zero."""
    x, theta = state_of(flight)
    n = problem.spec.n
    if n is None:
        return x, theta
    return x._replace(q=(G0 * n - problem.plant.earth.g * cos(theta) * cos(flight.phi)) / x.u), theta


def state_of(flight: Flight) -> tuple[State, float]:
    """The state in that flight, heading north at first, and its pitch. Stevens et al., sec. 3.6, rate of climb."""
    alpha, phi, turn = flight.alpha, flight.phi, flight.turn
    cb, sb, ca, sa = cos(flight.beta), sin(flight.beta), cos(alpha), sin(alpha)
    a, b = ca * cb, sin(phi) * sb + cos(phi) * sa * cb
    s = sin(flight.gamma)
    under = a * a - s * s + b * b
    root = sqrt(under) if under.real > 0.0 else 0.0 * under
    theta = atan2(a * b + s * root, a * a - s * s)
    ct, st = cos(theta), sin(theta)
    zero = 0.0 * alpha
    u, v, w = flight.V * ca * cb, flight.V * sb + zero, flight.V * sa * cb
    e = quaternion(phi, theta, zero)
    rates = -turn * st, turn * sin(phi) * ct + flight.q, turn * cos(phi) * ct
    return State(zero, zero, zero - flight.h, u, v, w, *e, *rates), theta


def _point(
    plant: SixDof, problem: Problem, z: NDArray[np.float64], left: NDArray[np.float64], iterations: int
) -> TrimPoint:
    values = dict(zip((Flight._fields[k] for k in problem.unknown), z.tolist(), strict=True))
    flight = problem.known._replace(**values)
    state, theta = _state(problem, flight)
    surfaces = Surfaces(flight.elevator, flight.aileron, flight.rudder, flight.throttle)
    state = state._replace(power=plant.settled(plant.engine, surfaces.throttle))
    spec = TrimSpec(
        flight.V, flight.h, flight.gamma, flight.turn, flight.beta, flight.q if problem.spec.n is None else state.q
    )
    flown = plant._replace(initial=state, rest=surfaces)
    return TrimPoint(
        spec, flight.alpha, flight.phi, theta, surfaces, state, _size(left), iterations, flown, problem.spec
    )
