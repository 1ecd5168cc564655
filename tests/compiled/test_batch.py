"""The nonlinear plant as a batch in lanes, against the plain text that it is compiled from."""

from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.batch import columns_of, fly_many, solver_of
from fdes.analysis.compiled_plant import Given, numbers_of
from fdes.errors import SpecError
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.across_mach import across_mach, across_mach_loads
from fdes.physics.earth import WGS84
from fdes.physics.plant import SixDof, State, derivative, state_at
from fdes.physics.runge_kutta import step
from fdes.physics.signals import Air, Surfaces
from fdes.physics.tables import Axis
from fdes.physics.wind import Wind
from fdes.units import DEG

STEPS, H = 200, 0.01
WINDY, WARM = Wind(3.0, -5.0, 0.0, 0.001, 0.002), 12.0


def of_derivatives() -> list[SixDof]:
    """Six kinds of aircraft at once, in wind, on a warm day, one of them with its stall near."""
    names = ("A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar")
    found = [six_dof_of(load(name).at())._replace(wind=WINDY, warmer=WARM) for name in names]
    return [*found, found[0]._replace(aero=found[0].aero._replace(CL_max=0.4))]


def of_tables() -> list[SixDof]:
    """The F-16 at several throttles, one of them with its afterburner lit, and with several centers of gravity."""
    plant = six_dof_of(load("F-16").at())._replace(wind=WINDY, warmer=WARM)
    aero, mass = plant.aero, plant.inertia
    return [
        plant,
        plant._replace(initial=plant.initial._replace(power=80.0, v=12.0)),
        plant._replace(aero=aero._replace(arm=0.1), initial=plant.initial._replace(p=0.5)),
        plant._replace(inertia=mass._replace(m=1.1 * mass.m), initial=plant.initial._replace(v=-20.0, power=49.0)),
    ]


def given(count: int) -> list[Given]:
    """Surfaces held and a gust, of each aircraft its own; the second and later ones light the afterburner."""
    return [
        Given(Surfaces(-0.02, 0.01 * k, 0.005, 0.6 + 0.1 * k), Air(gust_v=0.5 * k, gust_w=-1.0)) for k in range(count)
    ]


@pytest.mark.parametrize("make", [of_derivatives, of_tables])
def test_a_batch_of_different_aircraft_flies_as_each_does_alone(make: Any) -> None:
    """Two seconds with surfaces held and a gust, each state to 1e-12 of 1 + its size."""
    plants = make()
    held = given(len(plants))
    ends = fly_many(plants, [plant.start() for plant in plants], held, H, STEPS)
    for plant, end, g in zip(plants, ends, held, strict=True):
        y: tuple[float, ...] = plant.start()
        for _ in range(STEPS):
            y = step(lambda z, p=plant, g=g: derivative(p, State(*z), g.held, g.air), y, H, plant.integrator)  # type: ignore[misc]
        error = np.abs(np.array(end) - np.array(y)) / (1.0 + np.abs(y))
        assert error.max() < 1e-12
        assert np.abs(np.array(y[3:]) - np.array(plant.start()[3:])).max() > 0.1  # it did move


def over_the_turning_earth(w: float) -> SixDof:
    """The F-16 there, with tables that go on beyond their ends: one kind, compiled once for the tests of both."""
    plant = of_tables()[0]
    straight = tuple(axis._replace(axis=Axis(axis.axis.breakpoints, held=False)) for axis in plant.aero.axes)
    here = state_at(WGS84, (0.7, 0.3, 3000.0), (150.0, 10.0, w), (0.1, 0.06, 0.4))
    return plant._replace(aero=plant.aero._replace(axes=straight), earth=WGS84, initial=here._replace(power=20.0))


def test_an_aircraft_flies_in_a_batch_over_the_turning_earth() -> None:
    plant = over_the_turning_earth(w=2.0)
    g = given(1)[0]
    (end,) = fly_many([plant], [plant.start()], [g], H, 50)
    y: tuple[float, ...] = plant.start()
    for _ in range(50):
        y = step(lambda z: derivative(plant, State(*z), g.held, g.air), y, H, plant.integrator)
    assert end == pytest.approx(y, rel=1e-12, abs=1e-12)


def test_numbers_have_the_names_of_the_plant() -> None:
    solver = solver_of(of_derivatives()[0])
    assert {"inertia.m", "aero.k.Cm_q", "engine.T_max", "limits.upper.elevator", "warmer"} <= set(solver.parameters)
    assert solver.inputs == (*(f"held.{n}" for n in Surfaces._fields), *(f"air.{n}" for n in Air._fields))
    assert {"aero.arm", "engine.lag.slow", "earth.g"} <= set(solver_of(of_tables()[0]).parameters)


@pytest.mark.parametrize("count", [1, 8, 9])
def test_a_block_need_not_be_full(count: int) -> None:
    plant = of_derivatives()[0]
    ends = fly_many([plant] * count, [plant.start()] * count, [Given(plant.trim(), Air())] * count, H, 10)
    assert len(set(ends)) == 1


def test_tables_that_differ_are_not_taken_for_each_other() -> None:
    """Even where all that differs is a number in a table: what is compiled is kept by its content."""
    plant = of_tables()[0]
    first, *others = plant.aero.tables
    more = first._replace(values=tuple(tuple(v + 0.01 for v in row) for row in first.values))
    changed = plant._replace(aero=plant.aero._replace(tables=(more, *others)))
    one, two = (fly_many([p], [p.start()], given(1), H, 20)[0] for p in (plant, changed))
    assert two.u - one.u > 0.05
    with pytest.raises(
        SpecError, match=r"Aircraft 2 of 2 flies by other functions, other tables or over another Earth"
    ):
        fly_many([plant, changed], [plant.start()] * 2, given(2), H, 1)


def test_tables_may_go_on_beyond_their_ends() -> None:
    plant = over_the_turning_earth(w=250.0)
    assert np.arctan2(plant.initial.w, plant.initial.u) > 50.0 * DEG
    (end,) = fly_many([plant], [plant.start()], given(1), H, 1)
    g = given(1)[0]
    y = step(lambda z: derivative(plant, State(*z), g.held, g.air), plant.start(), H, plant.integrator)
    assert end == pytest.approx(y, rel=1e-13, abs=1e-13)


def test_what_chooses_among_conditions_underway_is_refused() -> None:
    plant = six_dof_of(load("A-4D").at())
    sets = tuple(plant.aero._replace(mach_0=mach) for mach in (0.4, 0.6, 0.8))
    plant = plant._replace(aero=across_mach(sets), aerodynamics=across_mach_loads)
    with pytest.raises(
        SpecError, match=r"between 3 conditions cannot be compiled.* in the plain form, or without across"
    ):
        solver_of(plant)


def test_columns_are_aircraft() -> None:
    assert columns_of(given(3)).shape == (10, 3)
    assert columns_of([numbers_of(p) for p in of_tables()]).shape == (len(solver_of(of_tables()[0]).parameters), 4)
