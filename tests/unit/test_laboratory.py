"""Variable stability without a server: what an edit does to the flight, to its recording and to what can be undone."""

import struct
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.airspeeds import airspeeds
from fdes.analysis.what_if import what_if
from fdes.cockpit import commands, wire
from fdes.cockpit.craft import make_craft
from fdes.cockpit.history import History
from fdes.cockpit.laboratory import laboratory, ready, wanted
from fdes.cockpit.session import Session
from fdes.control import Stick
from fdes.errors import FdesError, SpecError
from fdes.flight import Recording, open_recording
from fdes.units import KNOT

CRAFT = make_craft(load("A-4D").at())
PULL = wire.Input(Stick(pitch=0.2, throttle=CRAFT.condition.trim_throttle))


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    session = Session("one", CRAFT, tmp_path)
    session.watched = True
    yield session
    session.close()


def tick(session: Session, count: int) -> None:
    for number in range(count):
        session.tick(number, late=False)


def recorded(session: Session) -> Recording:
    """What was recorded, when it has been written."""
    folder = session._recordings
    session.stop_recording()
    for thread in threading.enumerate():
        if thread.name.startswith("closing"):
            thread.join(10.0)
    return open_recording(next(folder.iterdir()))


def test_an_edit_keeps_the_state_and_changes_what_follows(session: Session) -> None:
    session.put(PULL)
    tick(session, 60)
    before = session._sortie.frame
    session.edit(CRAFT.edited(["Cm_q=0", "Cm_alpha*=0.5"]))
    tick(session, 1)
    after = session._sortie.frame
    unedited = CRAFT.setup.plant.advance(before.state, before.command, before.air, CRAFT.clock.dt, 1)
    assert after.state == unedited
    assert after.outputs.q_dot != CRAFT.setup.plant.observe(after.state, after.held, after.air).q_dot
    assert after.edit is not None
    assert after.edit.note["changes"] == ["Cm_q=0.0", "Cm_alpha*=0.5"]


def test_undo_brings_the_response_back_bit_for_bit(tmp_path: Path) -> None:
    def response(*edits: list[str]) -> list[float]:
        session = Session("one", CRAFT, tmp_path, record=False)
        session.watched = True
        for changes in edits:
            session.edit(CRAFT.edited(changes))
            tick(session, 5)
        session.reset()
        session.put(PULL)
        tick(session, 1)
        session.put(PULL)
        rates = []
        for number in range(120):
            session.tick(number, late=False)
            rates.append(session._sortie.frame.outputs.q)
        return rates

    printed = response([], [])
    assert response(["Cm_q=0"], []) == printed
    assert max(response([], ["Cm_q=0"])) > 1.02 * max(printed)


def test_a_recording_says_when_what_was_changed_and_flies_again_bit_for_bit(session: Session) -> None:
    session.start_recording()
    session.put(PULL)
    tick(session, 40)
    session.edit(CRAFT.edited(["Cm_q=0"]))
    tick(session, 30)
    session.edit(CRAFT.edited(["Cm_q=0", "h=3000 m", "V*=1.1"]))
    tick(session, 30)
    session.edit(CRAFT)
    tick(session, 30)
    recording = recorded(session)
    assert [edit["changes"] for edit in recording.edits] == [["Cm_q=0.0"], ["Cm_q=0.0", "h=3000.0 m", "V*=1.1"], []]
    again = what_if(recording).recording
    assert np.array_equal(again.data, recording.data)


def test_an_edited_aircraft_is_recorded_as_such_from_the_start(session: Session) -> None:
    session.freeze()
    session.edit(CRAFT.edited(["Cm_q=0"]))
    session.start_recording()
    session.run()
    session.put(PULL)
    tick(session, 30)
    recording = recorded(session)
    assert recording.header["changes"] == ["Cm_q=0.0"]
    assert np.array_equal(what_if(recording).recording.data, recording.data)


def test_another_altitude_takes_the_aircraft_along(session: Session) -> None:
    tick(session, 10)
    low = session._sortie.frame.outputs.h
    craft = CRAFT.edited(["h=3000 m"])
    session.edit(craft)
    tick(session, 1)
    assert session._sortie.frame.outputs.h == pytest.approx(low + craft.start.h - CRAFT.start.h, abs=1e-9)


def test_edits_while_frozen_are_one_edit_when_it_goes_on(session: Session) -> None:
    session.freeze()
    for k in range(5):
        session.edit(CRAFT.edited([f"Cm_q={-float(k)}"]))
    tick(session, 5)
    session.run()
    tick(session, 1)
    edit = session._sortie.frame.edit
    assert edit is not None
    assert edit.note["changes"] == ["Cm_q=-4.0"]
    tick(session, 1)
    assert session._sortie.frame.edit is None


def test_a_drag_is_one_step_and_an_edit_forgets_what_was_undone() -> None:
    past = History()
    past.note(())
    past.note(("a=1",), dragging=True)
    past.note(("a=1", "b=1"), dragging=True)
    past.note(("a=1", "b=2"))  # the drag ends
    assert past.depth == (2, 0)
    assert past.before() == ("a=1",)
    past.undone(("a=1", "b=3"))
    assert past.depth == (1, 1)
    assert past.after() == ("a=1", "b=3")
    past.note(("a=1",))
    assert past.depth == (2, 0)


def test_without_edits_there_is_nothing_to_undo() -> None:
    for command, words in ((commands.Undo(), "no edit to undo"), (commands.Redo(), "no undone edit")):
        with pytest.raises(SpecError, match=words):
            wanted(command, CRAFT, History())


def test_levels_follow_the_class_that_is_chosen() -> None:
    asked = wanted(commands.Judge("III", "C"), CRAFT, History())
    craft = ready(CRAFT, asked)
    assert craft.setup is CRAFT.setup  # nothing that flies has changed
    (qualities,) = (m for m in laboratory(craft, History()) if m["type"] == "qualities")
    assert qualities["role"]["says"] == "Class III, Category C"


@pytest.mark.parametrize(("Cm_q", "zeta", "level"), [("-3.6", 0.357, 1), ("-1.8", 0.278, 2), ("0", 0.195, 3)])
def test_pitch_damping_and_its_level(Cm_q: str, zeta: float, level: int) -> None:
    craft = CRAFT.edited([f"Cm_q={Cm_q}"])
    assert craft.modes[0]["zeta"] == pytest.approx(zeta, abs=2e-3)
    assert craft.qualities["verdicts"][0]["level"] == level


def test_cap_goes_through_the_levels_as_the_pitch_stiffness_vanishes() -> None:
    levels = []
    for Cm_alpha in np.linspace(-0.38, 0.0, 60):
        chart = CRAFT.edited([f"Cm_alpha={Cm_alpha}"]).qualities["charts"][1]
        reason = CRAFT.edited([f"Cm_alpha={Cm_alpha}"]).qualities["verdicts"][0]
        cap = chart["point"][1] if chart["point"] else -1.0
        levels.append(1 if cap >= 0.28 else 2 if cap >= 0.16 else 4)
    assert reason["level"] == 4
    assert sorted(set(levels)) == [1, 2, 4]
    assert levels == sorted(levels)


def test_documents_are_laid_out_as_documented() -> None:
    data = struct.pack("<BBHI", 4, 1, 1, 9) + b"{}"
    assert wire.unpack_command(data) == (9, commands.OpenExperiment("{}"))
    assert wire.unpack_command(data[:2] + b"\0\0" + data[4:]) == (9, commands.OpenAircraft("{}"))


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"\4\1", "A document has 8 bytes and a text; 2 bytes came."),
        (struct.pack("<BBHI", 4, 2, 0, 9), "version 2; this server speaks version 1"),
        (struct.pack("<BBHI", 4, 1, 7, 9), "no document of kind 7"),
        (struct.pack("<BBHI", 4, 1, 0, 9) + b"\xff\xfe", "not text in UTF-8"),
    ],
)
def test_says_what_is_wrong_with_a_document(data: bytes, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        wire.unpack_command(data)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ("Cm_q=0", "'changes' of the command 'edit' is 'Cm_q=0'; it must be a list of texts"),
        ([1], "it must be a list of texts"),
        (["Cm_q=0"] * 65, "has 65 texts; it can have 64"),
    ],
)
def test_says_what_is_wrong_with_a_list(changes: object, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        wire.command_of({"name": "edit", "changes": changes})


@pytest.mark.parametrize("kind", ["mach", "tas", "eas", "cas"])
@pytest.mark.parametrize("h", [0.0, 5000.0, 12000.0])
@pytest.mark.parametrize("mach", [0.2, 0.85, 1.6])
def test_airspeeds_agree_from_wherever_they_come(kind: str, h: float, mach: float) -> None:
    known = airspeeds("mach", mach, h)
    assert airspeeds(kind, getattr(known, kind), h) == pytest.approx(known, rel=1e-9)


def test_airspeeds_at_sea_level_are_one() -> None:
    _, tas, eas, cas = airspeeds("tas", 250.0 * KNOT, 0.0)
    assert (eas, cas) == (pytest.approx(tas), pytest.approx(tas))


@pytest.mark.parametrize(
    ("said", "words"),
    [(("mach", -1.0, 0.0), "from zero up"), (("cas", 3000.0, 0.0), "Mach"), (("ias", 1.0, 0.0), "cas")],
)
def test_what_is_no_airspeed_is_refused(said: tuple[str, float, float], words: str) -> None:
    with pytest.raises(FdesError, match=words):
        airspeeds(*said)
