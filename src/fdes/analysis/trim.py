"""Trim of the nonlinear plant over a flat Earth: straight, climbing, turning, pulling up, sideslipping flight.

The search (`trim_search`) knows no stops: those of the surfaces are asked only of what is found, and then it can be
said by how much they fall short.
"""

from fdes.analysis.trim_request import TrimSpec, in_words, must_be_possible, spec_of
from fdes.analysis.trim_search import CALM, ENOUGH, FREE, ITERATIONS, TINY, TrimPoint, solve, solve_from
from fdes.errors import SpecError, TrimError
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
    "nearest_speed",
    "shortfalls",
    "solve",
    "solve_from",
    "spec_of",
    "trim",
]

TRIED = tuple(1.1 ** (s * k) for k in range(1, 13) for s in (1, -1))  # of the speed asked for: a third to three times


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
    if spec.alpha is not None:
        raise TrimError(
            f"No trim at {in_words(spec)}: {'; '.join(short)}. Try another angle of attack, or give a speed instead.",
            best=point,
            nearest=None,
        )
    nearest = nearest_speed(plant, spec)
    hint = (
        f"The nearest speed at which it can be flown is {nearest:.4g} m/s."
        if nearest
        else "No speed near it can be flown so: try another height or flight path."
    )
    raise TrimError(f"No trim at {in_words(spec)}: {'; '.join(short)}. {hint}", best=point, nearest=nearest)


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
