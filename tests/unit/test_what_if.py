"""What if: a recording of the cockpit flown again, unchanged, changed, and on another aircraft."""

import math
from pathlib import Path

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.design import law_for
from fdes.analysis.what_if import Variation, what_if
from fdes.cockpit.craft import make_craft
from fdes.cockpit.sortie import Sortie, open_recorder
from fdes.cockpit.wire import Input
from fdes.control import Stick
from fdes.errors import FdesError, RecordingError
from fdes.flight import Clock, Excitation, Recording, open_recording, simulate
from fdes.units import DEG


@pytest.fixture(params=["rk4", "exact", "euler"])
def recording(request: pytest.FixtureRequest, tmp_path: Path) -> Recording:
    """Four seconds in the cockpit: stick, a test input, a disturbance and a reset, recorded by the cockpit itself."""
    craft = make_craft(load("A-4D").at("M0.4_SL"), integrator=request.param)
    rest = craft.condition.trim_throttle
    sortie = Sortie(craft, Stick(throttle=rest))
    sortie.recorder = recorder = open_recorder(tmp_path, craft)
    for k in range(480):
        t = k / 120.0
        sortie.take(Input(Stick(0.4 * math.sin(2.0 * t), 0.3 * math.cos(t), 0.1, rest + 0.1)))
        if k == 100:
            sortie.put_in(Excitation.parse(["doublet elevator 2deg for 1s", "pulse gust_v 3m/s for 1s"]))
        if k == 200:
            sortie.disturb("beta=2deg")
        if k == 300:
            sortie.reset()
        sortie.advance()
    recorder.close()
    return open_recording(recorder.path)


def test_with_nothing_changed_it_is_the_recording_bit_for_bit(recording: Recording) -> None:
    again = what_if(recording)
    assert len(recording.data) == 480
    np.testing.assert_array_equal(again.recording.data, recording.data)
    assert again.recording.edits == recording.edits


def test_same_stick_on_a_changed_aircraft(recording: Recording) -> None:
    again = what_if(recording, Variation.parse("Cm_q*=0")).recording
    np.testing.assert_array_equal(again["stick_pitch"], recording["stick_pitch"])
    assert np.abs(again["q"] - recording["q"]).max() > 1.0 * DEG
    np.testing.assert_array_equal(again["p"], recording["p"])
    assert (again.header["changes"], again.header["what_if"]) == (["Cm_q*=0"], "Cm_q*=0")
    # What was made of it can be flown again in its turn, and is the same again.
    np.testing.assert_array_equal(what_if(again).recording.data, again.data)


def test_same_stick_on_another_aircraft_holds_its_own_trim(recording: Recording) -> None:
    again = what_if(recording, Variation.parse("aircraft=NAVION")).recording
    assert again.header["aircraft"] == "NAVION"
    moved = recording["stick_throttle"][0] - load("A-4D").at("M0.4_SL").trim_throttle
    assert again["stick_throttle"][0] == pytest.approx(load("NAVION").at().trim_throttle + moved)
    assert again["V"][0] == pytest.approx(load("NAVION").at().reference.V, rel=0.05)


@pytest.mark.parametrize("text", ["form=paper", "integrator=heun", "variant=printed", "condition=M0.8_35kft"])
def test_each_thing_can_be_put_instead(recording: Recording, text: str) -> None:
    name, _, value = text.partition("=")
    again = what_if(recording, Variation.parse(text)).recording
    assert again.header[name] == value
    assert not np.array_equal(again.data, recording.data)


def test_a_law_is_designed_once_and_keeps_its_gains(recording: Recording) -> None:
    again = what_if(recording, Variation.parse("law=yaw_damper; roll_rate_damper gain=0.1; Cn_r*=0.5")).recording
    law = str(again.header["law"])
    assert law.startswith("yaw_damper gain=")
    assert law.endswith("roll_rate_damper gain=0.1")
    assert again.header["changes"] == ["Cn_r*=0.5"]
    assert np.abs(again["rudder"] - recording["rudder"]).max() > 0.1 * DEG
    np.testing.assert_array_equal(what_if(again).recording.data, again.data)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("law=yaw_dampr", "Did you mean 'yaw_damper'"),
        ("law=./mine.py", "mine"),
        ("faster", "'faster' says nothing that could be different. Write it like 'Cm_q\\*=0.5', 'law=yaw_damper'"),
        ("form=paper; form=full", "says form twice"),
        ("form=ful", "Did you mean 'full'"),
        ("Cm_alpa=1", "Did you mean 'Cm_alpha'"),
        ("aircraft=NAVIO", "Did you mean 'NAVION'"),
        ("aircraft=./mine.toml", r"aircraft=\./mine\.toml is a file; what a recording is flown on is an aircraft of"),
        ("aircraft=/etc/passwd", "is a file"),
        ("integrator=rk5", "There is no integrator named 'rk5'"),
    ],
)
def test_what_cannot_be_tried_is_said(text: str, words: str) -> None:
    flight = simulate(load("A-4D").at(), clock=Clock(0.1, duration=1.0))
    with pytest.raises(FdesError, match=words):
        what_if(flight, Variation.parse(text))


def test_recording_that_does_not_say_what_was_flown() -> None:
    flight = simulate(load("A-4D").at(), clock=Clock(0.1, duration=1.0))
    bare = Recording({"dt": 0.1}, flight.columns, flight.data, (), True)
    with pytest.raises(RecordingError, match="its header lacks document, condition, variant, form, integrator"):
        what_if(bare)


def test_law_and_actuators_of_a_recording_fly_again_bit_for_bit() -> None:
    condition = load("A-4D").at("M0.4_SL")
    designed = law_for("yaw_damper; pitch_rate_pi", condition)
    flown = simulate(
        condition,
        ["doublet rudder 3deg for 1s", "doublet elevator 2deg for 1s"],
        clock=Clock(1.0 / 120.0, duration=4.0),
        law=designed.law,
        said=designed.text,
        actuators=True,
    )
    assert "state_rudder_position" in [c.name for c in flown.columns]
    np.testing.assert_array_equal(what_if(flown).recording.data, flown.data)
