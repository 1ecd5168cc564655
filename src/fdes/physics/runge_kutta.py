"""One step of an explicit Runge-Kutta method, whatever its tableau.

An integrator is data: a Butcher tableau with its order and its reference, one file each on the shelf `integrators`.
"""

from collections.abc import Callable
from typing import NamedTuple

from fdes.elementary import combined

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


def stability_function(tableau: Tableau, z: complex) -> complex:
    """R(z): what one step makes of y' = lambda y, h lambda being z. Hairer and Wanner II, eq. IV.3.2, by stages."""
    stages: list[complex] = []
    for row in tableau.a:
        stages.append(1.0 + z * sum([a * k for a, k in zip(row, stages, strict=False)]))
    return 1.0 + z * sum([b * k for b, k in zip(tableau.b, stages, strict=True)])


def _along(y: Vector, h: float, weights: tuple[float, ...], slopes: list[Vector]) -> Vector:
    """y + h * sum(weight * slope)."""
    return combined(y, [(h * weight, slope) for weight, slope in zip(weights, slopes, strict=False) if weight])
