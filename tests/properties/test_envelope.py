"""In the envelope of states every aircraft's equations give numbers; out of it, Departed says which state left."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from fdes.aircraft import catalogue
from fdes.errors import Departed
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.earth import FLAT, ROUND, WGS84, Earth
from fdes.physics.envelope import FASTEST, HIGHEST, LOWEST, POWER, QUICKEST, must_be_inside
from fdes.physics.plant import SixDof, State, state_at
from fdes.physics.signals import Air, Surfaces

PLANTS = {
    f"{aircraft.id} {condition.id}": six_dof_of(aircraft.at(condition.id))
    for aircraft in catalogue()
    for condition in aircraft.conditions
    if aircraft.at(condition.id).nondimensional
}
angle = some.floats(-math.pi, math.pi)
speed = some.one_of(some.floats(-FASTEST, FASTEST), some.floats(-400.0, 400.0), some.just(0.0))
rate = some.one_of(some.floats(-QUICKEST, QUICKEST), some.floats(-1.0, 1.0), some.just(0.0))
surfaces = some.builds(Surfaces, *[some.floats(-2.0, 2.0)] * 3, some.floats(-0.5, 1.5))
air = some.builds(Air, *[some.floats(-60.0, 60.0)] * 6)


@some.composite
def states(draw: some.DrawFn, earth: Earth) -> State:
    """Any state of the envelope."""
    place = draw(some.floats(-0.5 * math.pi, 0.5 * math.pi)), draw(angle), draw(some.floats(LOWEST, HIGHEST))
    x = state_at(earth, place, (0.0, 0.0, 0.0), (draw(angle), 0.5 * draw(angle), draw(angle)))
    power = draw(some.floats(-POWER, POWER))
    motion = {name: draw(speed) for name in "uvw"} | {name: draw(rate) for name in "pqr"}
    return x._replace(**motion, power=power)


@pytest.mark.parametrize("name", PLANTS)
@settings(max_examples=60, deadline=None)
@given(some.data(), some.sampled_from([FLAT, ROUND, WGS84]), surfaces, air)
def test_there_are_numbers_everywhere_in_it(
    name: str, data: some.DataObject, earth: Earth, held: Surfaces, moving: Air
) -> None:
    plant = PLANTS[name]._replace(earth=earth)
    x = data.draw(states(earth))
    assert all(map(math.isfinite, plant.derivative(x, held, moving)))
    plant = plant._replace(initial=x)
    assert all(map(math.isfinite, plant.observe(x, held, moving)))


@pytest.mark.parametrize("name", PLANTS)
@settings(max_examples=25, deadline=None)
@given(some.data(), some.sampled_from([FLAT, WGS84]), surfaces, some.sampled_from([0.001, 0.01, 0.1]))
def test_a_step_from_it_stays_in_numbers_or_has_departed(
    name: str, data: some.DataObject, earth: Earth, held: Surfaces, dt: float
) -> None:
    plant = PLANTS[name]._replace(earth=earth)
    x = data.draw(states(earth))
    after = stepped(plant, x, held, dt)
    if isinstance(after, str):
        assert after.startswith("The flight departed: ")
        assert any(said in after for said in (*(f"{state} " for state in ("u", *"vwpqr", "power")), "its height"))
        assert "nan reached" not in after
    else:
        assert all(map(math.isfinite, after))


def stepped(plant: SixDof, x: State, held: Surfaces, dt: float) -> State | str:
    try:
        return plant.advance(x, held, Air(), dt)
    except Departed as ending:
        return str(ending)


@pytest.mark.parametrize(
    ("state", "value", "said"),
    [
        ("u", 3500.0, "u reached 3500 m/s, and its plant is sure of numbers up to 3000 m/s"),
        ("q", -120.0, "q reached -120 rad/s, and its plant is sure of numbers up to 100 rad/s"),
        ("r", float("nan"), "r reached nan rad/s"),
        ("power", 2000.0, "power reached 2000 %"),
    ],
)
def test_it_says_which_state_left(state: str, value: float, said: str) -> None:
    x = State(0.0, 0.0, -1000.0, 100.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    must_be_inside(x, 1000.0)
    with pytest.raises(Departed, match=said):
        must_be_inside(x._replace(**{state: value}), 1000.0)
    with pytest.raises(Departed, match="its height reached nan m"):
        must_be_inside(x, float("nan"))
