"""Laws and actuators in the cockpit: engaged in flight, shown as they fly, recorded so that they can be flown again."""

import math
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.what_if import what_if
from fdes.cockpit import commands, wire
from fdes.cockpit.craft import Craft, make_craft
from fdes.cockpit.fleet import craft_of
from fdes.cockpit.flight_control import laws_message
from fdes.cockpit.handover import LASTING
from fdes.cockpit.history import History
from fdes.cockpit.laboratory import ready, wanted
from fdes.cockpit.session import Session
from fdes.control import Stick
from fdes.errors import FdesError, NoSuchPart, SpecError
from fdes.flight import open_recording

A4D = make_craft(load("A-4D").at("M0.4_SL"))
TRIM = A4D.condition.trim_throttle
OF_SURFACES = ("elevator", "aileron", "rudder")


def obeying(craft: Craft, command: commands.Engage | commands.UseActuators | commands.Edit) -> Craft:
    return ready(craft, wanted(command, craft, History()))


def with_law(text: str, craft: Craft = A4D, *, sampled: bool = False) -> Craft:
    return obeying(craft, commands.Engage(text, sampled))


def mode(craft: Craft, name: str) -> float:
    return float(next(m["zeta"] for m in craft.modes if m["name"] == name))


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    session = Session("one", A4D, tmp_path)
    session.watched = True
    yield session
    session.close()
    wait_for_recordings()


def wait_for_recordings() -> None:
    for thread in threading.enumerate():
        if thread.name.startswith("closing"):
            thread.join(10.0)


def fly(session: Session, frames: int) -> None:
    for number in range(frames):
        t = session._sortie.frame.t
        session.put(wire.Input(Stick(0.2 * math.sin(6.0 * t), 0.3, 0.2 * math.sin(8.0 * t), TRIM)))
        session.tick(number, late=False)


def test_the_bare_yaw_damper_damps_what_is_shown_and_judged() -> None:
    damped = with_law("yaw_damper")
    assert mode(damped, "dutch_roll") >= 1.5 * mode(A4D, "dutch_roll")
    assert damped.modes_message["bare"] == [[m.eigenvalue.real, m.eigenvalue.imag] for m in A4D.natural]
    assert A4D.modes_message["bare"] == []
    levels = [
        {v["criterion"]: v["level"] for v in craft.qualities["verdicts"]}["mil_f_8785c_dutch_roll"]
        for craft in (A4D, damped)
    ]
    assert levels == [2, 1]
    assert damped.qualities["verdicts"][0]["value"] == A4D.qualities["verdicts"][0]["value"]


def test_what_is_told_of_a_law() -> None:
    told = with_law("yaw_damper zeta=0.5; roll_rate_damper").control
    yaw, roll = told["achieved"]
    assert (yaw["wanted"], yaw["designed"]) == (0.5, pytest.approx(0.5, rel=1e-6))
    assert yaw["flown"] == pytest.approx(yaw["continuous"], rel=0.02)
    assert yaw["flown"] != yaw["continuous"]
    assert roll["quantity"] == "time_constant"
    assert told["actuators"] | {"reason": ""} == {
        "on": False,
        "bandwidth": 20.0,
        "rate_limit": pytest.approx(math.radians(60.0)),
        "reason": "",
    }
    assert {law["name"] for law in laws_message()["laws"]} == {
        *("pitch_rate_damper", "pitch_rate_pi", "roll_angle", "roll_rate_damper"),
        *("yaw_damper", "spiral_stabilization"),
    }


def test_a_wish_out_of_reach_is_answered() -> None:
    told = with_law("roll_rate_damper time_constant=0.001").control
    assert not told["achieved"][0]["reached"]
    assert "out of reach" in told["notes"][0]


def test_an_edit_keeps_the_gains_and_what_was_wanted() -> None:
    damped = with_law("yaw_damper zeta=0.5")
    edited = obeying(damped, commands.Edit(("Cn_r*=2",)))
    assert edited.control["text"] == damped.control["text"]
    assert edited.setup.law == damped.setup.law
    assert edited.control["achieved"][0]["wanted"] == 0.5
    assert edited.control["achieved"][0]["flown"] > damped.control["achieved"][0]["flown"]
    more = with_law(f"{edited.fit.control.law}; pitch_rate_damper", edited)
    assert [a["wanted"] for a in more.control["achieved"]] == [0.5, 0.7]
    by_hand = with_law("yaw_damper gain=0.1", edited)
    assert by_hand.control["achieved"][0]["wanted"] is None


def test_actuators_cost_damping_and_say_so() -> None:
    told = told_by = obeying(with_law("pitch_rate_damper zeta=0.7"), commands.UseActuators(on=True))
    one = told.control["achieved"][0]
    assert one["alone"] == one["wanted"] == pytest.approx(0.7), "the gain was designed before"
    assert one["continuous"] != pytest.approx(one["alone"], rel=0.01)
    assert one["flown"] != one["continuous"], "half a frame"
    again = with_law("pitch_rate_damper zeta=0.7", told_by)
    (one,) = again.control["achieved"]
    assert one["designed"] == one["continuous"] == pytest.approx(0.7, rel=1e-3)
    assert one["flown"] == pytest.approx(0.7, rel=0.02)
    assert one["alone"] != pytest.approx(0.7, rel=0.01)
    assert again.fit.control.law != told_by.fit.control.law
    assert any(m["name"] == "elevator_actuator" for m in told.modes)
    delays = [v for v in told.qualities["verdicts"] if v["mode"] == "response"]
    assert all(v["value"] == pytest.approx(0.05) for v in delays)


def test_the_exact_hold_has_no_actuators() -> None:
    with pytest.raises(SpecError, match="The exact hold needs surfaces that stand still"):
        obeying(make_craft(load("A-4D").at(), integrator="exact"), commands.UseActuators(on=True))


@pytest.mark.parametrize(
    "text",
    [
        "/etc/passwd",
        "../mine.py",
        "mine.py:Law",
        "fdes.control.laws.yaw_damper",
        "yaw_damper; ./mine.py",
        "__import__('os').system('true')",
        "yaw_damper gain=__import__('os')",
        "yaw_damper gain=open('x')",
        "yaw_damper inner=direct",
        "",
        "yaw_damper gain=nan",
        "yaw_damper gain=1e308",
    ],
)
def test_no_path_no_code_and_no_nonsense_is_taken_for_a_law(text: str, tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text("raise SystemExit('it was run')")
    before = set(sys.modules)
    with pytest.raises(FdesError):
        with_law(text)
    assert not {name for name in set(sys.modules) - before if "mine" in name}


def test_words_of_an_unknown_law() -> None:
    with pytest.raises(NoSuchPart, match=r"There is no law named 'yaw_dampr'\. Did you mean 'yaw_damper'\?"):
        with_law("yaw_dampr")


def test_engaged_in_flight_without_a_bump_and_flown_again_bit_for_bit(session: Session, tmp_path: Path) -> None:
    session.start_recording()
    fly(session, 200)
    session.edit(with_law("yaw_damper; roll_angle; pitch_rate_damper"))
    fly(session, 150)
    session.edit(with_law("direct"))
    fly(session, 150)
    name = session.stop_recording()
    wait_for_recordings()
    recorded = open_recording(tmp_path / f"{name}.fdes")
    notes = [edit for edit in recorded.edits if "law" in edit]
    assert [note["law"].split()[0] for note in notes] == ["yaw_damper", "direct"]
    assert recorded.header["law"] == "direct"
    for surface in OF_SURFACES:
        steps = np.abs(np.diff(recorded[f"command_{surface}"]))
        usual = steps[10:150].max()
        for note in notes:
            k = int(np.searchsorted(recorded["t"], note["t"]))
            assert steps[k - 1] <= usual + np.radians(0.05), surface
    ends = notes[0]["t"] + LASTING
    assert recorded["excitation_aileron"][int(np.searchsorted(recorded["t"], ends + 0.01))] == 0.0
    np.testing.assert_array_equal(what_if(recorded).recording.data, recorded.data)


def switched(session: Session, *, on: bool) -> Craft:
    return obeying(session.flown, commands.UseActuators(on))


def test_actuators_switched_in_flight_are_marked_in_the_recording_and_flown_again_bit_for_bit(
    session: Session, tmp_path: Path
) -> None:
    name = session.start_recording()
    fly(session, 100)
    assert not session.edit(switched(session, on=True))
    fly(session, 100)
    assert not session.edit(with_law("yaw_damper gain=0.3; sensors lag=20ms delay=30ms", session.flown))
    fly(session, 60)
    session.reset()
    fly(session, 60)
    assert not session.edit(switched(session, on=False))
    fly(session, 100)
    assert session.stop_recording() == name
    wait_for_recordings()
    recorded = open_recording(tmp_path / f"{name}.fdes")
    assert recorded.header["actuators"] is False
    assert [edit["actuators"] for edit in recorded.edits if "actuators" in edit] == [True, True, False]
    assert len(recorded.data) == 420
    assert type(session._sortie.frame.state) is type(A4D.start)
    again = what_if(recorded).recording
    np.testing.assert_array_equal(again.data, recorded.data)
    assert (again.edits, again.columns) == (recorded.edits, recorded.columns)
    shown = craft_of(name, recorded.header)
    assert shown is not None
    assert not shown.fit.control.actuators


def test_switching_actuators_moves_no_surface_by_more_than_they_do(session: Session, tmp_path: Path) -> None:
    """On, they begin where the surfaces are; off, what they were behind the command is faded out."""
    name = session.start_recording()
    fly(session, 100)
    session.edit(switched(session, on=True))
    fly(session, 103)
    behind = [
        getattr(session._sortie.frame.command, s) - getattr(session._sortie.frame.outputs, s) for s in OF_SURFACES
    ]
    assert max(map(abs, behind)) > math.radians(0.5), "nothing to be seen here"
    session.edit(switched(session, on=False))
    fly(session, 101)
    session.stop_recording()
    wait_for_recordings()
    recorded = open_recording(tmp_path / f"{name}.fdes")
    rate = A4D.control["actuators"]["rate_limit"] / 120.0
    for rate_of, angle in (("q", "theta"), ("p", "phi"), ("r", "psi")):
        np.testing.assert_allclose(np.diff(recorded[angle])[98:], recorded[rate_of][98:-1] / 120.0, atol=1e-3)
    for surface in OF_SURFACES:
        flown = recorded[surface]
        assert np.abs(np.diff(flown))[98:].max() <= rate + 1e-9, surface
        np.testing.assert_allclose(flown[280:], recorded[f"command_{surface}"][279:-1], atol=1e-12)


def test_what_if_with_actuators_on_a_recording_in_which_they_were_off(session: Session, tmp_path: Path) -> None:
    name = session.start_recording()
    fly(session, 60)
    session.edit(switched(session, on=True))
    fly(session, 60)
    session.stop_recording()
    wait_for_recordings()
    recorded = open_recording(tmp_path / f"{name}.fdes")
    on, off = (what_if(recorded, f"actuators={said}").recording for said in ("on", "off"))
    assert np.abs(on["elevator"] - recorded["elevator"])[:60].max() > math.radians(0.2)
    np.testing.assert_array_equal(off.data[:60, :20], recorded.data[:60, :20])
    assert np.abs(off["elevator"] - off["held_elevator"]).max() == 0.0
    with pytest.raises(SpecError, match="actuators=perhaps says neither on nor off"):
        what_if(recorded, "actuators=perhaps")


def test_another_aircraft_begins_without_a_law() -> None:
    damped = with_law("yaw_damper")
    assert damped.but(integrator="euler").fit.control.law == damped.fit.control.law
    assert make_craft(load("NAVION").at(), damped.form).fit.control.law == "direct"
