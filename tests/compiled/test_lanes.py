"""The elementary functions of lanes, held to those of the C library over the ranges that their docstrings name."""

import math
import random
from collections.abc import Callable

import pytest

from fdes import elementary, lanes

ULPS = 4  # units in the last place
COUNT = 4000


def over(low: float, high: float, seed: int = 1) -> list[tuple[float, ...]]:
    numbers = random.Random(seed)  # the same numbers each time
    return [(numbers.uniform(low, high),) for _ in range(COUNT)]


def pairs(first: tuple[float, float], second: tuple[float, float]) -> list[tuple[float, ...]]:
    return [a + b for a, b in zip(over(*first), over(*second, seed=2), strict=True)]


CASES: list[tuple[str, Callable[..., float], list[tuple[float, ...]]]] = [
    ("exp", math.exp, [*over(-700.0, 700.0), *over(-1.0, 1.0), (0.0,)]),
    ("log", math.log, [*over(1e-300, 1e300), *over(0.5, 2.0), (1.0,), (1.0 + 1e-12,)]),
    ("pow", math.pow, pairs((0.7, 1.4), (-5.0, 5.0))),
    ("sqrt", math.sqrt, over(0.0, 1e9)),
    ("sin", math.sin, [*over(-1e5, 1e5), *over(-0.1, 0.1), (0.0,)]),
    ("cos", math.cos, [*over(-1e5, 1e5), *over(-0.1, 0.1), (0.0,)]),
    ("tan", math.tan, over(-1e4, 1e4)),
    ("atan2", math.atan2, pairs((-9.0, 9.0), (-9.0, 9.0))),
    ("atan2", math.atan2, [(0.0, 0.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (1e-300, 1.0)]),
]


@pytest.mark.parametrize(("name", "reference", "points"), CASES, ids=[name for name, *_ in CASES])
def test_lanes_agree_with_the_c_library(
    name: str, reference: Callable[..., float], points: list[tuple[float, ...]]
) -> None:
    function = getattr(lanes, name)
    for point in points:
        wanted = reference(*point)
        assert abs(float(function(*point)) - wanted) <= ULPS * math.ulp(wanted), point


def test_what_physics_may_ask_for_exists_in_lanes() -> None:
    """But for what takes rows and columns of numbers, which a kernel does not."""
    of_columns = {"combined", "dot", "each"}
    assert set(elementary.__all__) - of_columns <= set(vars(lanes))


@pytest.mark.parametrize("name", ["sqrt", "exp", "log", "sin", "cos", "tan"])
def test_imaginary_part_is_the_derivative(name: str) -> None:
    """The complex form of each function: a step along the imaginary axis against a difference of floats."""
    f = getattr(elementary, name)
    x, h = 0.7, 1e-6
    slope = f(complex(x, 1e-30)).imag / 1e-30
    assert slope == pytest.approx((f(x + h) - f(x - h)) / (2.0 * h), rel=1e-9)


def test_imaginary_part_of_an_angle_and_of_a_power() -> None:
    h = 1e-30
    assert elementary.atan2(complex(0.3, h), -0.4).imag / h == pytest.approx(-0.4 / 0.25, rel=1e-14)
    assert elementary.atan2(0.3, complex(-0.4, h)).imag / h == pytest.approx(-0.3 / 0.25, rel=1e-14)
    assert elementary.pow(complex(0.3, h), 2.5).imag / h == pytest.approx(2.5 * 0.3**1.5, rel=1e-14)
