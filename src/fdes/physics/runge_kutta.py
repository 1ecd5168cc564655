"""One step of an explicit Runge-Kutta method, whatever its tableau.

An integrator is data: a Butcher tableau with its order and its reference, one file each on the shelf `integrators`.
"""

from collections.abc import Callable
from typing import NamedTuple

Vector = tuple[float, ...]


class Tableau(NamedTuple):
    """A Butcher tableau: y_next = y + h sum(b_i k_i), k_i = f(y + h sum(a_ij k_j))."""

    name: str
    order: int
    a: tuple[tuple[float, ...], ...]
    b: tuple[float, ...]
    c: tuple[float, ...]
    reference: str


def step(f: Callable[[Vector], Vector], y: Vector, h: float, tableau: Tableau) -> Vector:
    """The state one step `h` later, for an autonomous right-hand side `f`. Hairer, Norsett and Wanner, eq. II.1.8."""
    slopes: list[Vector] = []
    for row in tableau.a:
        slopes.append(f(_along(y, h, row, slopes)))
    return _along(y, h, tableau.b, slopes)


def _along(y: Vector, h: float, weights: tuple[float, ...], slopes: list[Vector]) -> Vector:
    """y + h * sum(weight * slope), leaving out the zeros that tableaux are full of."""
    used = [(h * w, k) for w, k in zip(weights, slopes, strict=False) if w]
    if not used:
        return y
    if len(used) == 1:
        ((w, k),) = used
        return tuple([v + w * s for v, s in zip(y, k, strict=True)])
    scale = [w for w, _ in used]
    columns = zip(*[k for _, k in used], strict=True)
    return tuple([v + sum([w * s for w, s in zip(scale, column, strict=True)]) for v, column in zip(y, columns, strict=True)])
