"""The compiled slopes of the nonlinear derivative, against the complex step of the plain text."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from fdes.aircraft import load
from fdes.analysis.jacobian import linearized
from fdes.analysis.jacobians import COLUMNS, linear_models, slopes_at
from fdes.analysis.trim import TrimSpec, trim
from fdes.errors import SpecError
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.attitude import quaternion
from fdes.physics.earth import WGS84
from fdes.physics.plant import SixDof, State, state_at
from fdes.physics.signals import Air, Surfaces
from fdes.physics.wind import Wind

TINY = 1e-30
EXACT = 1e-12  # relative to 1 + the size of a slope


@cache
def plant_of(name: str) -> SixDof:
    return six_dof_of(load(name).at())._replace(wind=Wind(3.0, -5.0, 0.0, 0.001, 0.002), warmer=5.0)


def by_complex_step(plant: SixDof, x: State, held: Surfaces, air: Air) -> NDArray[np.float64]:
    columns = []
    for k in range(len(COLUMNS)):
        z = [complex(v, TINY if i == k else 0.0) for i, v in enumerate([*x, *held])]
        rate = plant.derivative(State(*z[: len(x)]), Surfaces(*z[len(x) :]), air)  # type: ignore[arg-type]
        columns.append([v.imag / TINY for v in rate])
    return np.array(columns).T


def off(plant: SixDof, x: State, held: Surfaces, air: Air) -> float:
    """The largest error of a slope and of a rate."""
    found, wanted = slopes_at([plant], [x], [held], air), by_complex_step(plant, x, held, air)
    rates = np.array(plant.derivative(x, held, air))
    return float(
        max(
            (np.abs(found.by[0] - wanted) / (1.0 + np.abs(wanted))).max(),
            (np.abs(found.rates[0] - rates) / (1.0 + np.abs(rates))).max(),
        )
    )


def between(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_subnormal=False)


STATES = st.builds(
    lambda h, u, v, w, angles, p, q, r, power: State(10.0, 20.0, -h, u, v, w, *quaternion(*angles), p, q, r, power),
    between(0.0, 18000.0),
    between(30.0, 300.0),
    between(-60.0, 60.0),
    between(-80.0, 200.0),
    st.tuples(between(-3.0, 3.0), between(-1.5, 1.5), between(-3.0, 3.0)),
    between(-2.0, 2.0),
    between(-1.0, 1.0),
    between(-1.0, 1.0),
    between(0.0, 100.0),
)
SURFACES = st.builds(Surfaces, between(-0.5, 0.5), between(-0.5, 0.5), between(-0.6, 0.6), between(-0.1, 1.1))
GUSTS = st.builds(Air, *[between(-5.0, 5.0)] * 6)


@pytest.mark.parametrize("name", ["F-16", "NAVION"])
@settings(max_examples=60)
@given(x=STATES, held=SURFACES, air=GUSTS)
def test_slopes_are_those_of_the_plain_text(name: str, x: State, held: Surfaces, air: Air) -> None:
    """Anywhere: stalled and beyond the ends of tables, with surfaces at their stops, the afterburner lit or not."""
    assert off(plant_of(name), x, held, air) < EXACT


def test_slopes_between_two_conditions() -> None:
    plant = six_dof_of(load("A-4D").at(across="mach", spool=True))  # as in test_across_mach.py: compiled once
    x = plant.start()._replace(u=0.5 * (plant.aero.low.mach_0 + plant.aero.high.mach_0) * 330.0, v=5.0, q=0.05)
    assert off(plant, x, Surfaces(-0.05, 0.02, 0.01, 0.4), Air()) < EXACT


def test_slopes_over_the_turning_earth() -> None:
    here = state_at(WGS84, (0.7, 0.3, 3000.0), (150.0, 10.0, 2.0), (0.1, 0.06, 0.4), (0.1, 0.05, -0.02))
    assert off(plant_of("F-16")._replace(earth=WGS84), here, Surfaces(-0.05, 0.02, 0.01, 0.4), Air()) < EXACT


def test_each_point_has_its_own_plant_and_its_own_slopes() -> None:
    plant = plant_of("F-16")
    heavy = plant._replace(inertia=plant.inertia._replace(m=2.0 * plant.inertia.m))
    rest = [plant.trim()] * 2
    both = slopes_at([plant, heavy], [plant.start()] * 2, rest)
    alone = [slopes_at([p], [plant.start()], rest[:1]).by[0] for p in (plant, heavy)]
    assert (both.by == np.array(alone)).all()
    assert both.by.shape == (2, 14, 18)
    surge = COLUMNS.index("u"), COLUMNS.index("throttle")
    assert both.by[(0, *surge)] == pytest.approx(0.0)  # thrust follows the power, and the power the throttle
    assert both.by[0, COLUMNS.index("power"), COLUMNS.index("throttle")] > 10.0


@pytest.mark.parametrize(("name", "speeds"), [("F-16", (130.0, 160.0)), ("NAVION", (45.0, 50.0, 55.0))])
def test_linear_models_are_those_of_the_complex_step(name: str, speeds: tuple[float, ...]) -> None:
    condition = load(name).at()
    points = [trim(six_dof_of(condition), TrimSpec(V, 1000.0, gamma=0.02)) for V in speeds]
    for point, found in zip(points, linear_models(points), strict=True):
        wanted = linearized(point)
        assert pytest.approx(wanted.A, rel=1e-12, abs=1e-12) == found.A
        assert pytest.approx(wanted.B, rel=1e-12, abs=1e-12) == found.B
        assert (found.states, found.inputs, found.point) == (wanted.states, wanted.inputs, wanted.point)
    turning = trim(six_dof_of(condition), TrimSpec(speeds[-1], 1000.0, turn=0.02))
    with pytest.raises(SpecError, match=r"Only straight flight without sideslip is linearized"):
        linear_models([*points, turning])


def test_one_of_each_is_asked_for() -> None:
    plant = plant_of("F-16")
    with pytest.raises(SpecError, match=r"1 plants, 2 states and 1 settings of the surfaces were given"):
        slopes_at([plant], [plant.start()] * 2, [plant.trim()])
    with pytest.raises(SpecError, match=r"Make a batch of each kind"):
        slopes_at([plant, plant_of("NAVION")], [plant.start()] * 2, [plant.trim()] * 2)
