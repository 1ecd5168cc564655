"""Integrators: their order is measured, and on a linear plant each is a recursion with its stability function."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as some

from fdes.physics.integrators.rk4 import rk4
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


@given(some.lists(some.tuples(*[some.floats(-1e3, 1e3)] * 3), min_size=1, max_size=12), some.floats(1e-3, 1.0))
def test_four_slopes_in_one_pass_give_the_same_to_the_last_bit(numbers: list[tuple[float, ...]], h: float) -> None:
    """The classical method written out, one slope after the other."""
    y, rate, shift = zip(*numbers, strict=True)

    def f(x: Vector) -> Vector:
        return tuple(r * v + s for r, v, s in zip(rate, x, shift, strict=True))

    def on(x: Vector, step_: float, slope: Vector) -> Vector:
        return tuple(v + step_ * s for v, s in zip(x, slope, strict=True))

    k1 = f(y)
    k2 = f(on(y, h * 0.5, k1))
    k3 = f(on(y, h * 0.5, k2))
    k4 = f(on(y, h * 1.0, k3))
    expected = y
    for weight, slope in zip(rk4.b, (k1, k2, k3, k4), strict=True):
        expected = on(expected, h * weight, slope)
    assert step(f, y, h, rk4) == expected
