"""The flight loop: rows follow from their own fields, edits act at a frame boundary, flights can be flown again."""

import math
from itertools import pairwise

import pytest

from fdes.aircraft import load
from fdes.control import Stick
from fdes.control.laws.direct import Direct
from fdes.control.laws.pitch_rate_damper import PitchRateDamper
from fdes.control.laws.yaw_damper import YawDamper
from fdes.errors import Departed, SpecError
from fdes.flight import Clock, Edit, Excitation, Frame, HandsOff, SameStick, Setup, SteadyAir, fly, plant_of
from fdes.physics.signals import Air
from fdes.physics.small_perturbation import PerturbationState, SmallPerturbation

DT = 1 / 120


def setup(integrator: str = "rk4", form: str = "full", step: float = DT) -> Setup:
    condition = load("A-4D").at("M0.4_SL", variant="printed")
    return Setup(plant_of(condition, form, integrator, step), Direct(condition.full_stick))


def stirring(t: float) -> Stick:
    """A stick that never rests."""
    return Stick(0.3 * math.sin(2.0 * t), 0.5 * math.sin(1.3 * t), 0.2 * math.sin(0.7 * t), 0.4)


def edits(t: float) -> Edit | None:
    """At one second other equations, at two seconds back to trim."""
    if t == 1.0:
        return Edit(plant=setup(form="nelson").plant, note={"form": "nelson"})
    if t == 2.0:
        return Edit(state=PerturbationState(h=100.0), note={"reset": True})
    return None


def stirred_flight() -> list[Frame]:
    plant = setup().plant
    return list(fly(plant.start(), setup(), stirring, SteadyAir(Air(gust_w=1.0)), Clock(0.125, 4, 3.0), edits=edits))


def test_every_row_follows_from_its_own_fields() -> None:
    frames = stirred_flight()
    plant, law = setup()
    for now, then in pairwise(frames):
        if now.edit and now.edit.plant:
            plant = now.edit.plant
        assert now.outputs == plant.observe(now.state, now.held, now.air)
        assert now.command == law.step(now.outputs, now.stick, now.memory, 0.125)[0]
        if then.edit is None:
            assert then.held == now.command
            assert then.state == plant.advance(now.state, now.command, now.air, 0.125, 4)


def test_time_is_a_whole_number_of_frames() -> None:
    assert [f.t for f in stirred_flight()] == [k * 0.125 for k in range(25)]


def test_edits_act_at_their_frame_and_are_in_it() -> None:
    frames = stirred_flight()
    assert [f.t for f in frames if f.edit] == [1.0, 2.0]
    at_reset = frames[16]
    assert at_reset.state == PerturbationState(h=100.0)
    assert at_reset.held == setup().plant.trim()
    assert frames[8].state == setup().plant.advance(frames[7].state, frames[7].command, frames[7].air, 0.125, 4)


def test_the_same_stick_flies_the_same_flight_bit_for_bit() -> None:
    frames = stirred_flight()
    again = fly(
        frames[0].state,
        setup(),
        SameStick([f.stick for f in frames], 0.125),
        SteadyAir(Air(gust_w=1.0)),
        Clock(0.125, 4, 3.0),
        edits=edits,
    )
    assert [f.state for f in again] == [f.state for f in frames]


def roll_rates(integrator: str, dt: float, duration: float = 6.0) -> list[float]:
    start = setup(integrator, "paper", dt)
    assert isinstance(start.plant, SmallPerturbation)
    unlimited = start.plant._replace(
        limits=start.plant.limits._replace(upper=start.plant.limits.upper._replace(aileron=9.0))
    )
    step = Excitation.parse(["step aileron 0.2618rad at 0s"])
    pilot = HandsOff(start.plant.trim_throttle)
    flight = fly(start.plant.start(), start._replace(plant=unlimited), pilot, SteadyAir(), Clock(dt, 1, duration), step)
    return [f.outputs.p for f in flight]


def test_roll_response_of_the_paper() -> None:
    """Mansor and Perumal, figures 8, 10, 11: Euler fails at 0.1 s and overshoots at 0.04 s, Kutta-Merson does not."""
    exact = roll_rates("exact", 0.02)
    assert max(exact) == pytest.approx(3.501, abs=0.001)
    assert max(roll_rates("euler", 0.04)) > 1.03 * max(exact)
    assert max(roll_rates("euler", 0.1, 30.0)) > 10.0 * max(exact)
    merson = roll_rates("kutta_merson", 0.1)
    assert max(abs(a - b) for a, b in zip(merson, exact[::5], strict=True)) < 1e-4


def test_an_unstable_integrator_departs_with_words() -> None:
    with pytest.raises(
        Departed, match=r"departed at t = [\d.]+ s: \w+ reached .* integrator is unstable with this time step"
    ):
        roll_rates("euler", 0.5, 600.0)


@pytest.mark.parametrize("dt", [0.0, -1.0, math.nan, math.inf])
def test_a_bad_time_step_is_refused(dt: float) -> None:
    with pytest.raises(SpecError, match=r"The time step is .* must be a positive number"):
        Clock(dt)


def test_a_law_of_the_same_kind_remembers_through_an_edit() -> None:
    plant, direct = setup()
    damper = YawDamper(direct, 0.5)

    def washout_after(edit: Edit | None) -> float:
        at_one_second = lambda t: edit if t == 1.0 else None  # noqa: E731  shorter than a function
        clock = Clock(0.125, 4, 1.0)
        last = list(fly(plant.start(), Setup(plant, damper), stirring, SteadyAir(), clock, edits=at_one_second))[-1]
        return float(last.memory.washout)

    same = Edit(plant=setup(form="nelson").plant, law=YawDamper(direct, 0.5))
    assert washout_after(same) == washout_after(None) != 0.0
    assert washout_after(Edit(law=YawDamper(direct, 0.6))) == washout_after(None)
    assert washout_after(Edit(law=YawDamper(PitchRateDamper(direct, 0.1), 0.5))) != washout_after(None)
