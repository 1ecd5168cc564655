"""What if nothing changes: a flight with any law, actuators and sensors, recorded from its middle, comes out again."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.design import law_for
from fdes.analysis.what_if import setup_of, what_if
from fdes.control import Stick
from fdes.flight import Clock, Excitation, Recorder, Recording, SteadyAir, fly, open_recording
from fdes.flight.recorder import columns_of
from fdes.flight.simulation import Edit
from fdes.shelf import shelf

A4D = load("A-4D").at("M0.4_SL")
DT = 1.0 / 120.0
BEGINS = 77  # frames before the recorder is switched on
LAWS = [name for name in shelf("laws").names() if name != "sensors"]
SENSED = "yaw_damper; pitch_rate_pi; sensors lag=20ms delay=50ms"


def header(law: str, integrator: str, *, actuators: bool) -> dict[str, Any]:
    return {
        "aircraft": A4D.aircraft_id,
        "condition": A4D.condition,
        "variant": "corrected",
        "document": A4D.document,
        "form": "full",
        "integrator": integrator,
        "dt": DT,
        "law": law_for(law, A4D, frame=DT).text,
        "actuators": actuators,
    }


def stirring(t: float) -> Stick:
    return Stick(0.3 * math.sin(2.0 * t), 0.2 * math.sin(1.3 * t), 0.2 * math.sin(0.7 * t), A4D.trim_throttle)


def recorded(said: dict[str, Any], folder: Path, edits: dict[int, Edit] | None = None) -> Recording:
    """Two seconds of stick, a test input and a gust, recorded from their middle on."""
    setup = setup_of(said)
    start = setup.plant.start(500.0)
    recorder = Recorder(folder / "flight.fdes", type(start), said)
    put_in = Excitation.parse(["doublet rudder 2deg at 0.4s"])
    frames = fly(
        start, setup, stirring, SteadyAir(), Clock(DT, 1, 2.0), put_in, lambda t: (edits or {}).get(round(t / DT))
    )
    for k, frame in enumerate(frames):
        if k >= BEGINS:
            recorder.append(frame)
    recorder.close()
    return open_recording(recorder.path)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(
    ("integrator", "actuators", "sensors"),
    [("exact", False, ""), ("rk4", False, ""), ("rk4", True, ""), ("rk4", True, "; sensors lag=20ms delay=50ms")],
)
def test_every_law_flies_again_from_the_middle_bit_for_bit(
    tmp_path: Path, law: str, integrator: str, *, actuators: bool, sensors: str
) -> None:
    flown = recorded(header(law + sensors, integrator, actuators=actuators), tmp_path)
    assert flown["t"][0] == pytest.approx(BEGINS * DT)
    again = what_if(flown).recording
    np.testing.assert_array_equal(again.data, flown.data)
    assert again.edits == flown.edits


def test_what_sensors_remember_matters(tmp_path: Path) -> None:
    """The flight would not come out the same had its law begun anew: the tests above can fail."""
    flown = recorded(header(SENSED, "rk4", actuators=True), tmp_path)
    (first, *_) = flown.edits
    assert set(first) == {"t", "memory"}
    forgetful = Recording(flown.header, flown.columns, flown.data, (), complete=True)
    assert np.abs(what_if(forgetful).recording["command_rudder"] - flown["command_rudder"])[0] > 1e-6


def test_so_it_does_with_a_law_changed_in_flight(tmp_path: Path) -> None:
    """A gain is turned, then a loop taken off: the law remembers through the first, begins anew at the second."""
    said = header(SENSED, "rk4", actuators=True)
    texts = {
        120: "yaw_damper gain=0.2; pitch_rate_pi gain=0.4 integral_gain=1; sensors lag=40ms delay=30ms",
        170: "yaw_damper gain=0.2; sensors delay=33ms",
    }
    edits = {}
    for k, text in texts.items():
        full = law_for(text, A4D, frame=DT).text
        edits[k] = Edit(law=setup_of({**said, "law": full}).law, note={"law": full})
    flown = recorded(said, tmp_path, edits)
    assert [e.get("law", "")[:19] for e in flown.edits][1:] == ["yaw_damper gain=0.2"] * 2
    again = what_if(flown).recording
    np.testing.assert_array_equal(again.data, flown.data)


def test_a_law_that_remembers_something_else_begins_anew(tmp_path: Path) -> None:
    flown = recorded(header(SENSED, "rk4", actuators=False), tmp_path)
    again = what_if(flown, "law=pitch_rate_pi; yaw_damper gain=0.1").recording
    assert np.isfinite(again.data).all()
    assert again.columns == columns_of(type(setup_of(dict(flown.header)).plant.start()))
