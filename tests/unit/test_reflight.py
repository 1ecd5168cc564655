"""A recording flown again from its own file."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import edited, load, parse
from fdes.control import Stick
from fdes.control.laws.direct import Direct
from fdes.errors import RecordingError
from fdes.flight import (
    Clock,
    Edit,
    Excitation,
    Recorder,
    Recording,
    Setup,
    SteadyAir,
    fly,
    open_recording,
    plant_of,
    simulate,
)
from fdes.flight.recorder import ENGINE
from fdes.flight.reflight import differences, fly_again
from fdes.flight.response import disturbed
from fdes.physics.signals import Air
from fdes.physics.small_perturbation import PerturbationState

DT = 1 / 120
BASE = load("A-4D").at("M0.4_SL")
HEADER = {"aircraft": "A-4D", "condition": "M0.4_SL", "variant": "corrected", "document": BASE.document, "dt": DT}


def remake(header: Mapping[str, Any]) -> Setup:
    condition = parse(header["document"], "here").at(header["condition"], header["variant"])
    condition = edited(condition, header.get("changes", ()))
    return Setup(
        plant_of(condition, "full", header.get("integrator", "rk4"), header["dt"]), Direct(condition.full_stick)
    )


def stirring(t: float) -> Stick:
    return Stick(0.3 * math.sin(2.0 * t), 0.5 * math.sin(1.3 * t), 0.2 * math.sin(0.7 * t), 0.4)


def edits(t: float) -> Edit | None:
    """A derivative changed, a disturbance, and a reset."""
    if t == 60 * DT:
        return Edit(plant=remake({**HEADER, "changes": ["Cm_q*=0.3"]}).plant, note={"changes": ["Cm_q*=0.3"]})
    if t == 120 * DT:
        return Edit(disturb=lambda x: disturbed(x, ["beta=3deg"]), note={"disturb": "beta=3deg"})
    if t == 180 * DT:
        return Edit(state=PerturbationState(h=500.0), note={"reset": True})
    return None


@pytest.fixture
def recording(tmp_path: Path) -> Recording:
    """A flight with everything in it, recorded from its second half second on, as the cockpit does."""
    recorder = Recorder(tmp_path / "flight.fdes", PerturbationState, HEADER)
    setup = remake(HEADER)
    put_in = Excitation.parse(["doublet rudder 3deg at 1s"])
    weather = SteadyAir(Air(wind_north=3.0, gust_w=0.5))
    start = setup.plant.start(300.0)
    for k, frame in enumerate(fly(start, setup, stirring, weather, Clock(DT, duration=2.5), put_in, edits)):
        if k >= 30:
            recorder.append(frame)
    recorder.close()
    return open_recording(tmp_path / "flight.fdes")


def test_it_is_the_same_bit_for_bit(recording: Recording) -> None:
    again = fly_again(recording, remake)
    assert again.departed is None
    assert again.recording.columns == recording.columns
    np.testing.assert_array_equal(again.recording.data, recording.data)
    assert again.recording.edits == recording.edits
    assert list(differences(recording, again.recording)) == []
    assert recording.header["engine"] == ENGINE


def test_another_derivative_flies_differently_from_the_first_frame_that_feels_it(recording: Recording) -> None:
    def slack(header: Mapping[str, Any]) -> Setup:
        return remake({**header, "changes": [*header.get("changes", ()), "Cm_q*=0"]})

    again = fly_again(recording, slack, lambda header: {**header, "whatif": ["Cm_q*=0"]})
    assert again.recording.header["whatif"] == ["Cm_q*=0"]
    np.testing.assert_array_equal(again.recording["stick_pitch"], recording["stick_pitch"])
    np.testing.assert_array_equal(again.recording["state_q"][0], recording["state_q"][0])
    assert again.recording["state_q"][1] != recording["state_q"][1]
    np.testing.assert_array_equal(again.recording["p"], recording["p"])  # the lateral set does not feel it
    found = {name: (unit, apart, t) for name, unit, apart, t, _ in differences(recording, again.recording)}
    unit, apart, t = found["q"]
    assert unit == "rad/s"
    k = round(t / DT)  # since the recording began, 0.25 s into the flight
    assert apart == again.recording["q"][k] - recording["q"][k]
    assert "p" not in found


def test_flight_that_departs_ends_there_and_says_so(recording: Recording) -> None:
    def unstable(header: Mapping[str, Any]) -> Setup:
        return remake({**header, "changes": ["Cm_alpha=900"]})

    again = fly_again(recording, unstable)
    assert again.departed is not None
    assert "The flight departed at t = " in again.departed
    assert 1 < len(again.recording.data) < len(recording.data)
    assert not again.recording.complete


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda r: Recording(r.header, r.columns, r.data[:1], r.edits, True), "fewer than two frames"),
        (
            lambda r: Recording(r.header, r.columns[:20], r.data[:, :20], r.edits, True),
            "it lacks n_x, n_y, n_z, h and 27 more columns",
        ),
        (
            lambda r: Recording({"aircraft": "A-4D"}, r.columns, r.data, r.edits, True),
            "its header lacks the time step, dt",
        ),
        (
            lambda r: Recording(r.header, r.columns, np.delete(r.data, 7, axis=0), r.edits, True),
            "its frames are not 0.00833333 s apart throughout",
        ),
    ],
)
def test_recording_that_lacks_something_says_what(recording: Recording, spoil: Any, words: str) -> None:
    with pytest.raises(RecordingError, match=words):
        fly_again(spoil(recording), remake)


def test_simulated_flight_says_what_it_was_and_can_be_flown_again() -> None:
    """`simulate` computes all columns at once, `fly_again` frame by frame: the same to rounding."""
    inputs = ["doublet elevator 2deg at 0.5s", "step gust_v 2m/s at 1s"]
    changed = edited(BASE, ["Cm_q*=0.5"])
    flight = simulate(changed, inputs, clock=Clock(0.01, duration=4.0), initial=["beta=1deg"])
    assert {k: flight.header[k] for k in ("aircraft", "changes", "inputs", "initial", "dt", "law")} == {
        "aircraft": "A-4D",
        "changes": ["Cm_q*=0.5"],
        "inputs": inputs,
        "initial": ["beta=1deg"],
        "dt": 0.01,
        "law": "direct",
    }
    again = fly_again(flight, remake).recording
    np.testing.assert_allclose(again.data, flight.data, rtol=1e-9, atol=1e-11)
    assert flight.to_dataset().attrs["changes"] == '["Cm_q*=0.5"]'


def test_what_is_saved_opens_as_it_was(recording: Recording, tmp_path: Path) -> None:
    again = fly_again(recording, remake).recording
    again.save(tmp_path / "again.fdes")
    opened = open_recording(tmp_path / "again.fdes")
    np.testing.assert_array_equal(opened.data, again.data)
    assert (opened.edits, opened.columns, opened.complete) == (again.edits, again.columns, True)
    assert opened.header == again.header
    with pytest.raises(FileExistsError):
        again.save(tmp_path / "again.fdes")
