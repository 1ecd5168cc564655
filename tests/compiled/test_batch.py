"""The nonlinear plant as a batch in lanes, against the plain text that it is compiled from."""

from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.batch import Given, flat_earth_batch, numbers_of
from fdes.analysis.trim import TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.integrators.rk4 import rk4
from fdes.physics.plant import SixDof, State, derivative
from fdes.physics.runge_kutta import step
from fdes.physics.signals import Air, Surfaces
from fdes.physics.wind import Wind

SOLVER = flat_earth_batch()
STEPS, H = 200, 0.01


def flat(values: tuple[Any, ...]) -> list[float]:
    return [v for part in values for v in (flat(part) if isinstance(part, tuple) else [part])]


def plants() -> list[SixDof]:
    """Six kinds of aircraft at once, in wind, on a warm day, one of them with its stall near."""
    found = []
    for name in ("A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar"):
        condition = load(name).at()
        plant = trim(six_dof_of(condition), TrimSpec(condition.reference.V, condition.reference.h)).plant
        found.append(plant._replace(wind=Wind(3.0, -5.0, 0.0, 0.001, 0.002), warmer=12.0))
    return [*found, found[0]._replace(aero=found[0].aero._replace(CL_max=0.4))]


def test_a_batch_of_different_aircraft_flies_as_each_does_alone() -> None:
    """Two seconds with surfaces held and a gust, each state to 1e-11 of 1 + its size."""
    flown = plants()
    given = [Given(Surfaces(-0.02, 0.01 * k, 0.005, 0.6), Air(gust_v=0.5 * k, gust_w=-1.0)) for k in range(len(flown))]
    x = np.array([plant.start() for plant in flown]).T.copy()
    held = np.array([flat(g) for g in given]).T.copy()
    numbers = np.array([flat(numbers_of(plant)) for plant in flown]).T.copy()
    assert len(SOLVER.states) == x.shape[0]
    assert len(SOLVER.inputs) == held.shape[0]
    assert len(SOLVER.parameters) == numbers.shape[0]
    SOLVER.advance(x, held, numbers, H, STEPS)
    for k, plant in enumerate(flown):
        y: tuple[float, ...] = plant.start()
        for _ in range(STEPS):
            y = step(lambda z, p=plant, g=given[k]: derivative(p, State(*z), g.held, g.air), y, H, rk4)  # type: ignore[misc]
        error = np.abs(x[:, k] - np.array(y)) / (1.0 + np.abs(y))
        assert error.max() < 1e-11
        assert np.abs(np.array(y[3:]) - np.array(plant.start()[3:])).max() > 0.1  # it did move


def test_numbers_have_the_names_of_the_plant() -> None:
    assert {"inertia.m", "aero.k.Cm_q", "engine.T_max", "limits.upper.elevator", "warmer"} <= set(SOLVER.parameters)
    assert SOLVER.inputs == (*(f"held.{n}" for n in Surfaces._fields), *(f"air.{n}" for n in Air._fields))


@pytest.mark.parametrize("count", [1, 8, 9])
def test_a_block_need_not_be_full(count: int) -> None:
    plant = plants()[0]
    x, held, numbers = (
        np.repeat(np.array(flat(t))[:, None], count, axis=1)
        for t in (plant.start(), Given(plant.trim(), Air()), numbers_of(plant))
    )
    SOLVER.advance(x, held, numbers, H, 10)
    assert np.ptp(x, axis=1).max() == 0.0
