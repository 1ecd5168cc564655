"""Trim of the nonlinear plant over a flat Earth: straight, climbing, turning, pulling up, sideslipping flight.

The search (`trim_search`) knows no stops: those of the surfaces are asked only of what is found, and then it can be
said by how much they fall short.
"""

import math

from fdes.analysis.trim_request import TrimSpec, in_words, must_be_possible, spec_of
from fdes.analysis.trim_search import ENOUGH, ITERATIONS, TrimPoint, solve, solve_briefly, solve_from
from fdes.elementary import cos, sin
from fdes.errors import SpecError, TrimError
from fdes.flight.steady import CALM, FREE, TINY
from fdes.physics.aero import DerivativeAero
from fdes.physics.plant import SixDof
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.units import DEG

__all__ = [
    "CALM",
    "ENOUGH",
    "FREE",
    "ITERATIONS",
    "TINY",
    "TrimPoint",
    "TrimSpec",
    "balanced",
    "nearest_speed",
    "shortfalls",
    "solve",
    "solve_from",
    "spec_of",
    "stalled",
    "trim",
]

TRIED = tuple(1.1 ** (s * k) for k in range(1, 13) for s in (1, -1))  # of the speed asked for: a third to three times
CLEARLY = 1e-3  # of an acceleration [m/s^2 or rad/s^2]: what is less is not worth a word beside what is more


def trim(plant: SixDof, spec: TrimSpec) -> TrimPoint:
    """The steady flight `spec` of `plant`. Raises SpecError where the request makes no sense.

    Raises TrimError where the aircraft cannot fly so: it says what falls short by how much, and carries the best point
    found and the nearest speed at which it can.
    """
    must_be_possible(spec)
    if not plant.earth.g:
        raise SpecError(
            "Trim is over a flat Earth: trim there, and begin the flight over another Earth from that state."
        )
    point = solve(plant, spec)
    short = shortfalls(point, plant.limits)
    if not short:
        return point
    nearest = nearest_speed(plant, spec) if spec.alpha is None else None
    hints = [_path_instead(plant, point), _speed_instead(spec, nearest)]
    raise TrimError(
        " ".join([f"No trim at {in_words(spec)}: {'; '.join(short)}.", *filter(None, hints)]), point, nearest
    )


def _path_instead(plant: SixDof, point: TrimPoint) -> str:
    """Where the throttle is what falls short: the path that its stop allows at that speed."""
    spec, low, high = point.asked, plant.limits.lower.throttle, plant.limits.upper.throttle
    needed = point.surfaces.throttle
    if spec.throttle is not None or low <= needed <= high or not balanced(point):
        return ""
    stop = high if needed > high else low
    there = solve(plant, spec._replace(throttle=stop, gamma=0.0))
    if shortfalls(there, plant.limits):
        return ""
    return f"With a throttle of {stop:g} its path would be {there.spec.gamma / DEG:.3g} deg."


def _speed_instead(spec: TrimSpec, nearest: float | None) -> str:
    if spec.alpha is not None:
        return "Try another angle of attack, or give a speed instead."
    if nearest is not None:
        return f"The nearest speed at which it can be flown is {nearest:.4g} m/s."
    tried = f"from {spec.V * min(TRIED):.4g} to {spec.V * max(TRIED):.4g} m/s"
    return f"No speed near it can be flown so ({tried} were tried): try another height or flight path."


def nearest_speed(plant: SixDof, spec: TrimSpec) -> float | None:
    """The speed [m/s] nearest to that of `spec` at which it can be flown, to a thousandth; None where there is none."""

    def flies(V: float) -> bool:
        return not shortfalls(solve_briefly(plant, spec._replace(V=V)), plant.limits)

    found = next((spec.V * k for k in TRIED if flies(spec.V * k)), None)
    if found is None:
        return None
    cannot = found / 1.1 if found > spec.V else found * 1.1
    while abs(found - cannot) > 1e-3 * found:
        between = 0.5 * (found + cannot)
        found, cannot = (between, cannot) if flies(between) else (found, between)
    return found


def balanced(point: TrimPoint) -> bool:
    """Whether nothing accelerates there, wherever the surfaces would have to be for that."""
    return point.residual < 100.0 * ENOUGH


def shortfalls(point: TrimPoint, limits: Limits) -> list[str]:
    """What keeps the aircraft from flying so, in words; nothing where it can."""
    if not balanced(point):
        return [f"nothing balances it: the best point, at an angle of attack of {_still_accelerating(point)}"]
    found = []
    for name, value, low, high in zip(Surfaces._fields, point.surfaces, limits.lower, limits.upper, strict=True):
        if low - 1e-9 <= value <= high + 1e-9:
            continue
        stop = low if value < low else high
        if name != "throttle":
            said = f"{value / DEG:.3g} deg, and stops at {stop / DEG:.3g} deg"
        else:
            said = f"{value:.4g} of {stop:g}" if value > high else f"{value:.4g}, and stops at {stop:g}"
        found.append(f"the {name} would have to be {said}")
    return found


def stalled(point: TrimPoint) -> list[str]:
    """A sentence where the straight line of lift has ended, of an aircraft whose largest lift is assumed."""
    aero = point.plant.aero
    if not isinstance(aero, DerivativeAero):
        return []
    CL = aero.k.CL + aero.k.CL_alpha * (point.alpha - aero.alpha_0)
    if abs(CL) < aero.CL_max:
        return []
    ends = aero.alpha_0 + (math.copysign(aero.CL_max, CL) - aero.k.CL) / aero.k.CL_alpha
    said = f"This is a stalled flight: its angle of attack of {point.alpha / DEG:.3g} deg is beyond the"
    return [f"{said} {ends / DEG:.3g} deg at which the assumed largest lift is reached. No source speaks of it."]


def _still_accelerating(point: TrimPoint) -> str:
    """Such as ``19.3 deg, still accelerates by 2.1 m/s^2 downward, for lift falls short``."""
    d = point.plant._replace(limits=FREE).derivative(point.state, point.plant.trim(), CALM)
    sa, ca = sin(point.alpha), cos(point.alpha)
    down, along = d.w * ca - d.u * sa, d.u * ca + d.w * sa
    kinds = [
        (down, "m/s^2", "downward, for lift falls short", "upward, for lift is too much"),
        (along, "m/s^2", "forward, for drag falls short", "backward, for thrust falls short"),
        (d.v, "m/s^2", "to the right", "to the left"),
        (d.p, "rad/s^2", "in roll", "in roll"),
        (d.q, "rad/s^2", "in pitch", "in pitch"),
        (d.r, "rad/s^2", "in yaw", "in yaw"),
    ]
    clearly = min(CLEARLY, 0.5 * max(abs(a) for a, *_ in kinds))
    said = [f"{abs(a):.2g} {unit} {up if a > 0.0 else under}" for a, unit, up, under in kinds if abs(a) > clearly]
    return f"{point.alpha / DEG:.3g} deg, still accelerates by {' and '.join(said)}"
