"""Integrators: their order is measured, and on a linear plant each is a recursion with its stability function."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as some

from fdes.physics.runge_kutta import Tableau, Vector, stability_function, step
from fdes.shelf import shelf

NAMES = shelf("integrators").names()


def pendulum(y: tuple[float, ...]) -> tuple[float, ...]:
    """A nonlinear oscillator in (angle, rate)."""
    angle, rate = y
    return rate, -math.sin(angle)


def at_one_second(tableau: Tableau, n: int) -> tuple[float, ...]:
    y: tuple[float, ...] = (1.0, 0.5)
    for _ in range(n):
        y = step(pendulum, y, 1.0 / n, tableau)
    return y


@pytest.mark.parametrize("name", NAMES)
def test_rows_sum_to_nodes_and_weights_to_one(name: str) -> None:
    tableau: Tableau = shelf("integrators").get(name)
    assert [sum(row) for row in tableau.a] == pytest.approx(tableau.c)
    assert sum(tableau.b) == pytest.approx(1.0)
    assert len(tableau.a) == len(tableau.b) == len(tableau.c)
    assert tableau.reference


@pytest.mark.parametrize("name", NAMES)
def test_measured_order_is_the_claimed_order(name: str) -> None:
    tableau: Tableau = shelf("integrators").get(name)
    exact = at_one_second(shelf("integrators").get("dopri5"), 4096)
    coarse, fine = (math.dist(at_one_second(tableau, n), exact) for n in (16, 32))
    assert math.log2(coarse / fine) == pytest.approx(tableau.order, abs=0.35)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("z", [complex(-0.5, 0.0), complex(-0.3, 0.8), complex(0.1, -1.0)])
def test_linear_step_is_the_stability_function(name: str, z: complex) -> None:
    """A step of y' = z y is R(z)."""
    tableau: Tableau = shelf("integrators").get(name)

    def linear(y: tuple[float, ...]) -> tuple[float, ...]:
        x = z * complex(*y)
        return x.real, x.imag

    assert complex(*step(linear, (1.0, 0.0), 1.0, tableau)) == pytest.approx(stability_function(tableau, z))


@pytest.mark.parametrize("name", NAMES)
@given(
    numbers=some.lists(some.tuples(*[some.floats(-1e3, 1e3)] * 3), min_size=1, max_size=14),
    h=some.floats(1e-3, 1.0),
)
def test_a_step_is_that_of_plain_loops_to_the_last_bit(name: str, numbers: list[tuple[float, ...]], h: float) -> None:
    """Every method as the textbook has it, one slope after the other."""
    tableau: Tableau = shelf("integrators").get(name)
    y, rate, shift = zip(*numbers, strict=True)

    def f(x: Vector) -> Vector:
        return tuple(r * v + s for r, v, s in zip(rate, x, shift, strict=True))

    def on(weights: Vector, slopes: list[Vector]) -> Vector:
        x = y
        for weight, slope in zip(weights, slopes, strict=False):
            x = tuple(v + h * weight * s for v, s in zip(x, slope, strict=True))
        return x

    slopes: list[Vector] = []
    for row in tableau.a:
        slopes.append(f(on(row, slopes)))
    assert step(f, y, h, tableau) == on(tableau.b, slopes)
