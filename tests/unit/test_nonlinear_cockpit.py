"""The cockpit flies the nonlinear plant: trimmed, switched to and from in flight, edited, recorded and flown again."""

import threading
from math import radians
from pathlib import Path

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.what_if import what_if
from fdes.cockpit import wire
from fdes.cockpit.craft import Craft, make_craft
from fdes.cockpit.session import Session
from fdes.control import Stick
from fdes.errors import NoSuchPart, SpecError
from fdes.flight import Recording, open_recording
from fdes.physics.signals import Outputs

LINEAR = make_craft(load("A-4D").at())
NONLINEAR = LINEAR.but(plant="nonlinear")


def flying(craft: Craft, folder: Path) -> Session:
    session = Session("nonlinear", craft, folder, record=False)
    session.watched = True
    return session


def fly(session: Session, ticks: int) -> Outputs:
    for number in range(ticks):
        session.tick(number, late=False)
    return session._sortie.frame.outputs


def flags(session: Session) -> int:
    frame = None
    while frame is None:
        frame = session.tick(10**6, late=False)
    return int.from_bytes(frame[2:4], "little")


def pull(session: Session, pitch: float, roll: float = 0.0, throttle: float | None = None) -> None:
    lever = session.flown.trim_throttle if throttle is None else throttle
    session.put(wire.Input(Stick(pitch=pitch, roll=roll, throttle=lever)))


@pytest.mark.parametrize("name", ["A-4D", "F-104A", "NAVION", "Convair880", "B747", "Jetstar"])
def test_every_aircraft_is_trimmed_and_stays_so_hands_off(name: str, tmp_path: Path) -> None:
    craft = make_craft(load(name).at(), plant="nonlinear")
    session = flying(craft, tmp_path)
    before = session._sortie.frame.outputs
    after = fly(session, 1200)
    assert not session._sortie.ended
    assert after.excursion < 1e-8
    assert pytest.approx(before.V, abs=1e-6) == after.V
    assert after.h == pytest.approx(before.h, abs=1e-5)
    assert after.north == pytest.approx(10.0 * before.V, rel=1e-3)


def test_a_switch_in_flight_keeps_place_speed_and_deviations(tmp_path: Path) -> None:
    session = flying(LINEAR, tmp_path)
    pull(session, 0.1, 0.1)
    before = fly(session, 90)
    session.edit(NONLINEAR)
    after = fly(session, 1)
    shift = NONLINEAR.briefing["alpha_trim"] - LINEAR.briefing["alpha_trim"]  # thinner air at the height of the start
    assert pytest.approx(before.V, rel=1e-3) == after.V
    assert after.north == pytest.approx(before.north + before.V / 120.0, abs=0.05)
    assert after.h == pytest.approx(before.h, abs=0.1)
    assert after.alpha - before.alpha == pytest.approx(shift, abs=2e-3)
    assert after.phi == pytest.approx(before.phi, abs=0.01)
    assert after.q == pytest.approx(before.q, abs=0.01)
    session.edit(LINEAR)
    back = fly(session, 1)
    assert back.alpha == pytest.approx(after.alpha - shift, abs=2e-3)
    assert back.psi == pytest.approx(after.psi, abs=1e-3)
    assert session._sortie.notice is None


def test_beyond_small_perturbations_the_linear_plant_begins_in_trim_where_it_is(tmp_path: Path) -> None:
    session = flying(NONLINEAR, tmp_path)
    pull(session, 0.0, 1.0)
    before = fly(session, 120)
    assert abs(before.phi) > radians(30.0)
    session.edit(LINEAR)
    after = fly(session, 1)
    assert (after.phi, after.beta) == (0.0, 0.0)
    assert after.h == pytest.approx(before.h, abs=1e-9)
    assert after.psi == pytest.approx(before.psi, abs=1e-6)
    assert "begins anew" in (session.status()["notice"] or "")


def test_it_loops_and_only_the_linear_plant_warns_of_15_degrees(tmp_path: Path) -> None:
    session = flying(make_craft(load("A-4D").at(), plant="nonlinear", changes=["V*=1.8"]), tmp_path)
    pull(session, 0.75, throttle=1.0)
    pitches, flown = [], []
    for _ in range(240):
        y = fly(session, 10)
        pitches.append(y.theta)
        flown.append(y)
        if session._sortie.ended:
            break
    upside_down = [y for y in flown if abs(y.phi) > radians(170.0)]
    assert max(pitches) > radians(75.0)
    assert upside_down
    assert not flags(session) & wire.OUTSIDE
    assert max(y.n_z for y in flown) > 2.5


def test_the_stall_is_announced(tmp_path: Path) -> None:
    session = flying(NONLINEAR, tmp_path)
    point = NONLINEAR.trimmed
    assert point is not None
    assert point.stall is not None
    assert not flags(session) & wire.STALLED
    session.disturb(f"w={2.0 * point.stall[1] * point.V}m/s")
    fly(session, 1)
    assert session._sortie.frame.outputs.alpha > point.stall[1]
    assert flags(session) & wire.STALLED


def test_an_edit_changes_the_motion_and_keeps_the_state(tmp_path: Path) -> None:
    """Pitching is damped less with Cm_q taken away, the rest being the same; laws and actuators fly on it too."""
    rates = {}
    for change in ("Cm_q*=1", "Cm_q*=0.1"):
        session = flying(NONLINEAR, tmp_path)
        fly(session, 10)
        session.edit(session.flown.edited([change]))
        session.disturb("q=5deg/s")
        flown = [fly(session, 1) for _ in range(360)]
        rates[change] = max(abs(y.q) for y in flown[240:])
    assert rates["Cm_q*=0.1"] > 1.3 * rates["Cm_q*=1"]


def test_a_flight_with_switch_law_actuators_and_edits_is_flown_again_bit_for_bit(tmp_path: Path) -> None:
    session = flying(LINEAR, tmp_path)
    pull(session, 0.1, 0.2)
    fly(session, 30)
    control = session.flown.fit.control
    session.edit(session.flown.but(plant="nonlinear", control=control.asked("yaw_damper gain=0.4", sampled=False)))
    fly(session, 1)
    name = session.start_recording()
    fly(session, 60)
    session.edit(session.flown.edited(["Cn_r*=0.5"]))
    fly(session, 60)
    session.disturb("beta=3deg")
    pull(session, 0.4, 1.0)
    fly(session, 60)
    session.reset()
    fly(session, 60)
    session.edit(session.flown.edited(["V*=1.1"]))
    fly(session, 60)
    session.stop_recording()
    recording = _when_whole(tmp_path, name)
    again = what_if(recording)
    assert recording.header["plant"] == "nonlinear"
    assert again.departed is None
    assert np.array_equal(recording.data, again.recording.data)
    less = what_if(recording, "Cm_q*=0.2")
    assert not np.array_equal(recording["q"], less.recording["q"])


def test_actuators_move_the_surfaces_of_the_nonlinear_aircraft(tmp_path: Path) -> None:
    control = NONLINEAR.fit.control
    craft = NONLINEAR.but(control=type(control)(actuators=True))
    session = flying(craft, tmp_path)
    pull(session, 0.5)
    moved = [fly(session, 1).elevator for _ in range(30)]
    assert 0.0 < abs(moved[2]) < abs(moved[-1])
    state = session._sortie.frame.state
    assert state.e0**2 + state.e1**2 + state.e2**2 + state.e3**2 == pytest.approx(1.0, abs=1e-14)


def test_what_cannot_be_is_said() -> None:
    with pytest.raises(NoSuchPart, match="nonlinear"):
        make_craft(load("A-4D").at(), plant="nonlinaer")
    with pytest.raises(SpecError, match="exact hold"):
        LINEAR.but(plant="nonlinear", integrator="exact")
    with pytest.raises(SpecError, match="Fly the linear plant"):
        make_craft(load("A-7A").at(), plant="nonlinear")


def _when_whole(folder: Path, name: str) -> Recording:
    for thread in threading.enumerate():
        if thread.name.startswith("closing"):
            thread.join(5.0)
    return open_recording(next(folder.glob(f"{name}*")))


def test_what_if_flies_the_same_stick_with_the_other_plant(tmp_path: Path) -> None:
    """Near trim the two agree; the recording's trim and lever are those of whichever flies."""
    session = flying(LINEAR, tmp_path)
    name = session.start_recording()
    pull(session, 0.05)
    fly(session, 240)
    session.stop_recording()
    recording = _when_whole(tmp_path, name)
    other = what_if(recording, "plant=nonlinear").recording
    assert other.header["plant"] == "nonlinear"
    assert other.header["trim"]["h"] == pytest.approx(recording["h"][0], abs=1e-9)
    assert not np.array_equal(other["q"], recording["q"])
    assert np.abs(other["q"] - recording["q"]).max() < 0.1 * np.abs(recording["q"]).max()
    assert np.abs(other["V"] - recording["V"]).max() < 1.0
    back = what_if(other, "plant=linear").recording
    assert np.allclose(back["q"], recording["q"], rtol=0.0, atol=1e-9)
    jet = what_if(other, "aircraft=F-104A").recording
    assert jet["V"][0] == pytest.approx(make_craft(load("F-104A").at()).briefing["V"], rel=1e-3)
