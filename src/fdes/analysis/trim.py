"""Trim of the nonlinear plant: straight, climbing, turning, sideslipping flight, over a flat Earth.

Newton's method on six unknowns (alpha, bank, elevator, aileron, rudder, throttle) and the six accelerations, its
Jacobian by complex step. The stops of the surfaces are asked only of what is found: then it can be said by how much
they fall short.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 3.4 and 3.6;
W. Squire, G. Trapp, SIAM Review 40 (1998) 110-112, for the complex step.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fdes.elementary import atan2, cos, sin, sqrt
from fdes.errors import NoSuchPart, SpecError, TrimError
from fdes.physics.aero import derivative_loads
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.attitude import quaternion
from fdes.physics.plant import SixDof, State
from fdes.physics.signals import Air, Outputs, Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.units import DEG, parse

FREE = Limits(Surfaces(*[-1e9] * 4), Surfaces(*[1e9] * 4))
CALM = Air()
TINY = 1e-30  # a complex step: nothing is subtracted, so nothing is lost
ENOUGH = 1e-10  # of the accelerations [m/s^2 and rad/s^2]
ITERATIONS, HALVINGS = 25, 6
OTHER_STARTS = tuple(alpha * DEG for alpha in (2.0, 7.0, 12.0, 17.0, 27.0, 37.0))  # between breakpoints of 5 deg
TRIED = tuple(1.1 ** (s * k) for k in range(1, 13) for s in (1, -1))  # of the speed asked for: a third to three times
STEEPEST = 80.0 * DEG
HIGHEST = 80000.0  # m


class TrimSpec(NamedTuple):
    """The steady flight that is asked for. SI; `turn` is the rate of the heading, to the right."""

    V: float
    h: float
    gamma: float = 0.0
    turn: float = 0.0
    beta: float = 0.0


@dataclass(frozen=True)
class TrimPoint:
    """A steady flight that was found. surfaces: absolute. residual: the largest acceleration that is left.

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

    def outputs(self) -> Outputs:
        """All outputs of this flight, in still air."""
        return self.plant.observe(self.state, self.plant.trim(), CALM)


def spec_of(text: str, default: TrimSpec) -> TrimSpec:
    """Read a request such as ``"V=502 ft/s h=0 ft gamma=3 deg"``; what is not said is that of `default`.

    Names: V or mach, h, gamma, turn (of the heading), beta. Raises SpecError, NoSuchPart.

    >>> round(spec_of("V=100 kt gamma=3 deg", TrimSpec(V=50.0, h=1000.0)).V, 6)
    51.444444
    """
    units = {"V": "m/s", "mach": "1", "h": "m", "gamma": "rad", "turn": "rad/s", "beta": "rad"}
    said: dict[str, float] = {}
    for name, value in _assignments(text):
        if name not in units:
            raise NoSuchPart("quantity of a trim", name, units)
        if units[name] != "1" and value[-1:].isdigit():
            raise SpecError(f"{name}={value} has no unit. Write it like '{name}={value} {units[name]}'.")
        said[name] = parse(value, units[name])
    if {"V", "mach"} <= said.keys():
        raise SpecError("Both V and mach are given for the trim: give one of them.")
    h = said.get("h", default.h)
    if "mach" in said:
        said["V"] = said.pop("mach") * standard_atmosphere(h).a
    spec = default._replace(**said)
    _must_be_possible(spec)
    return spec


def _assignments(text: str) -> Iterable[tuple[str, str]]:
    """``"V=502 ft/s h=0 ft"`` in pairs: a name stands before each equals sign."""
    before, *parts = text.replace(",", " ").replace(";", " ").split("=")
    name = before.strip()
    if not parts:
        raise SpecError(f"The trim {text!r} is not understood. Write it like 'V=170 kt h=5000 ft gamma=3 deg'.")
    for k, part in enumerate(parts):
        words = part.split()
        last = k == len(parts) - 1
        value = " ".join(words if last else words[:-1])
        if not value:
            raise SpecError(f"The trim {text!r} gives no value for {name!r}. Write it like 'V=170 kt h=5000 ft'.")
        yield name, value
        name = "" if last else words[-1]


def _must_be_possible(spec: TrimSpec) -> None:
    if not spec.V > 0.0:
        raise SpecError(f"A trim at {spec.V:g} m/s is asked for; the speed must be greater than zero.")
    if not -1000.0 <= spec.h <= HIGHEST:
        raise SpecError(
            f"A trim at {spec.h:,.0f} m is asked for; the height must be from -1,000 m to {HIGHEST:,.0f} m."
        )
    for name, angle in (("flight-path angle", spec.gamma), ("sideslip", spec.beta)):
        if abs(angle) > STEEPEST:
            raise SpecError(
                f"A trim with a {name} of {angle / DEG:.3g} deg is asked for; at most {STEEPEST / DEG:.0f} deg make "
                "sense."
            )


def trim(plant: SixDof, spec: TrimSpec) -> TrimPoint:
    """The steady flight `spec` of `plant`. Raises SpecError where the request makes no sense.

    Raises TrimError where the aircraft cannot fly so: it says what falls short by how much, and carries the best point
    found and the nearest speed at which it can.
    """
    _must_be_possible(spec)
    if not plant.earth.g:
        raise SpecError(
            "Trim is over a flat Earth: trim there, and begin the flight over another Earth from that state."
        )
    point = solve(plant, spec)
    short = shortfalls(point, plant.limits)
    if not short:
        return point
    nearest = nearest_speed(plant, spec)
    hint = (
        f"The nearest speed at which it can be flown is {nearest:.4g} m/s."
        if nearest
        else "No speed near it can be flown so: try another height or flight path."
    )
    raise TrimError(
        f"No trim at {spec.V:.4g} m/s, {spec.h:,.0f} m, climbing {spec.gamma / DEG:.3g} deg, turning "
        f"{spec.turn / DEG:.3g} deg/s: {'; '.join(short)}. {hint}",
        best=point,
        nearest=nearest,
    )


def nearest_speed(plant: SixDof, spec: TrimSpec) -> float | None:
    """The speed [m/s] nearest to that of `spec` at which it can be flown, to a thousandth; None where there is none."""

    def flies(V: float) -> bool:
        return not shortfalls(solve(plant, spec._replace(V=V)), plant.limits)

    found = next((spec.V * k for k in TRIED if flies(spec.V * k)), None)
    if found is None:
        return None
    cannot = found / 1.1 if found > spec.V else found * 1.1
    while abs(found - cannot) > 1e-3 * found:
        between = 0.5 * (found + cannot)
        found, cannot = (between, cannot) if flies(between) else (found, between)
    return found


def shortfalls(point: TrimPoint, limits: Limits) -> list[str]:
    """What keeps the aircraft from flying so, in words; nothing where it can."""
    if not point.residual < 100.0 * ENOUGH:
        left = f"{point.residual:.2g} m/s^2 or rad/s^2"
        return [f"nothing balances it (lift may be at its largest): the best point still accelerates by {left}"]
    found = []
    for name, value, low, high in zip(Surfaces._fields, point.surfaces, limits.lower, limits.upper, strict=True):
        if low - 1e-9 <= value <= high + 1e-9:
            continue
        stop = low if value < low else high
        angle = name != "throttle"
        said = f"{value / DEG:.3g} deg, and stops at {stop / DEG:.3g} deg" if angle else f"{value:.4g} of {stop:g}"
        found.append(f"the {name} would have to be {said}")
    return found


def solve(plant: SixDof, spec: TrimSpec) -> TrimPoint:
    """The nearest to a balance that Newton's method finds, whatever the stops are.

    It begins at the angle of attack of the plant's initial flight. Where that leads nowhere, as it may across the kinks
    of tables, it begins at others; derivatives have no kinks.
    """
    first = solve_from(plant, spec, atan2(plant.initial.w, plant.initial.u))
    if first.residual < ENOUGH or plant.aerodynamics is derivative_loads:
        return first
    points = [first, *(solve_from(plant, spec, alpha) for alpha in OTHER_STARTS)]
    return min(points, key=lambda point: point.residual)


def solve_from(plant: SixDof, spec: TrimSpec, alpha: float) -> TrimPoint:
    """The nearest to a balance that Newton's method finds from that angle of attack [rad]."""
    free = plant._replace(limits=FREE, rest=Surfaces())
    z = np.array([alpha, _bank(plant, spec), 0.0, 0.0, 0.0, plant.rest.throttle])
    residual = _accelerations(free, spec, z)
    iterations = 0
    while iterations < ITERATIONS and _size(residual) > ENOUGH:
        change = np.linalg.lstsq(_jacobian(free, spec, z), -residual, rcond=None)[0]
        change *= min(1.0, 0.2 / max(float(np.abs(change[:2]).max()), 1e-12))  # at most 11 deg of alpha or bank
        for _ in range(HALVINGS):
            then = _accelerations(free, spec, z + change)
            if _size(then) < _size(residual):
                break
            change *= 0.5
        else:
            break
        z, residual, iterations = z + change, then, iterations + 1
    alpha, phi, *controls = (float(v) for v in z)
    state, theta = _state(spec, alpha, phi)
    surfaces = Surfaces(*controls)
    state = state._replace(power=plant.settled(plant.engine, surfaces.throttle))
    flown = plant._replace(initial=state, rest=surfaces)
    return TrimPoint(spec, alpha, phi, theta, surfaces, state, _size(residual), iterations, flown)


def _bank(plant: SixDof, spec: TrimSpec) -> float:
    """Of a coordinated turn, where the search begins: tan(phi) = V turn / g."""
    bank: float = atan2(spec.V * cos(spec.gamma) * spec.turn, plant.earth.g)
    return bank


def _size(residual: NDArray[np.float64]) -> float:
    largest = float(np.abs(residual).max())
    return largest if np.isfinite(largest) else np.inf


def _accelerations(plant: SixDof, spec: TrimSpec, z: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.array(_six(plant, spec, z.tolist()))


def _jacobian(plant: SixDof, spec: TrimSpec, z: NDArray[np.float64]) -> NDArray[np.float64]:
    columns = []
    for k in range(len(z)):
        stepped: list[complex] = [complex(v, TINY if i == k else 0.0) for i, v in enumerate(z.tolist())]
        columns.append([v.imag / TINY for v in _six(plant, spec, stepped)])
    return np.array(columns).T


def _six(plant: SixDof, spec: TrimSpec, z: list[float] | list[complex]) -> list[float]:
    """u_dot, v_dot, w_dot [m/s^2], p_dot, q_dot, r_dot [rad/s^2]."""
    alpha, phi, *controls = z
    x, _ = _state(spec, alpha, phi)  # type: ignore[arg-type]  # a complex one, for the Jacobian
    held = Surfaces(*controls)
    rate = plant.derivative(x._replace(power=plant.settled(plant.engine, held.throttle)), held, CALM)
    return [rate.u, rate.v, rate.w, rate.p, rate.q, rate.r]


def _state(spec: TrimSpec, alpha: float, phi: float) -> tuple[State, float]:
    """The state in that flight, heading north at first, and its pitch. Stevens et al., sec. 3.6, rate of climb."""
    cb, sb, ca, sa = cos(spec.beta), sin(spec.beta), cos(alpha), sin(alpha)
    a, b = ca * cb, sin(phi) * sb + cos(phi) * sa * cb
    s = sin(spec.gamma)
    under = a * a - s * s + b * b
    root = sqrt(under) if under.real > 0.0 else 0.0 * under
    theta = atan2(a * b + s * root, a * a - s * s)
    ct, st = cos(theta), sin(theta)
    turn = spec.turn
    zero = 0.0 * alpha
    u, v, w = spec.V * ca * cb, spec.V * sb + zero, spec.V * sa * cb
    e = quaternion(phi, theta, zero)
    return State(zero, zero, zero - spec.h, u, v, w, *e, -turn * st, turn * sin(phi) * ct, turn * cos(phi) * ct), theta
