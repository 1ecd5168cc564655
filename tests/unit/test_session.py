"""A session without a server: how flights end, what becomes of their recordings, and replays."""

import math
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.cockpit import commands, wire
from fdes.cockpit import session as session_module
from fdes.cockpit import sortie as sortie_module
from fdes.cockpit.craft import Craft, condition_name, make_craft
from fdes.cockpit.excite import excite, held, preview
from fdes.cockpit.fleet import Fleet, craft_of
from fdes.cockpit.replay import replay_of
from fdes.cockpit.session import Session
from fdes.control import Stick
from fdes.errors import FdesError, NoSuchPart, RecordingError, SpecError
from fdes.flight import Edit, Excitation, Recorder, Recording, open_recording
from fdes.flight.recorder import columns_of

CRAFT = make_craft(load("A-4D").at())
TRIM = CRAFT.condition.trim_throttle


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    session = Session("one", CRAFT, tmp_path)
    session.watched = True
    yield session
    session.close()
    wait_for_recordings()


def wait_for_recordings() -> None:
    for thread in threading.enumerate():
        if thread.name.startswith("closing"):
            thread.join(10.0)


def ticks(session: Session, count: int) -> list[bytes]:
    frames = [session.tick(number, late=False) for number in range(count)]
    return [frame for frame in frames if frame is not None]


def stick(**controls: float) -> wire.Input:
    return wire.Input(Stick(**{"throttle": TRIM, **controls}))


def test_sixty_frames_a_second_and_ten_when_frozen(session: Session) -> None:
    assert len(ticks(session, 120)) == pytest.approx(60, abs=1)
    session.freeze()
    assert len(ticks(session, 120)) == pytest.approx(10, abs=1)


def test_a_lever_that_stands_where_the_aircraft_before_had_it_disturbs_nothing(session: Session) -> None:
    """The page needs some frames to learn of the other aircraft and to put its lever where that is in trim."""
    navion = make_craft(load("NAVION").at())
    session.change(navion)
    assert abs(navion.trim_throttle - TRIM) > 0.1
    assert session.put(stick()) is False, "nobody moved a control"
    ticks(session, 12)
    assert session._sortie.frame.stick.throttle == navion.trim_throttle
    session.put(stick(throttle=navion.trim_throttle))
    assert session.put(stick(throttle=TRIM)) is True, "now it is moved"
    ticks(session, 2)
    assert session._sortie.frame.stick.throttle == TRIM


def test_a_lever_that_is_not_put_in_trim_is_believed_after_half_a_second(session: Session) -> None:
    session.change(make_craft(load("NAVION").at()))
    ticks(session, 65)
    session.put(stick())
    ticks(session, 2)
    assert session._sortie.frame.stick.throttle == TRIM


def test_a_frame_goes_with_the_tick_that_flies_an_input(session: Session) -> None:
    sent = []
    for number in range(40):
        if number % 2 and 10 <= number < 30:  # a page whose screen is in step with the odd ticks
            session.put(stick(roll=number / 100))
        if session.tick(number, late=False):
            sent.append(number)
    leading = [number for number in sent if 12 <= number < 30]
    assert leading == list(range(13, 30, 2))
    assert len(sent) == pytest.approx(20, abs=2)
    quick = 0
    for number in range(40, 160):
        session.put(stick(roll=number / 1000))
        quick += session.tick(number, late=False) is not None
    assert quick == pytest.approx(60, abs=1)


def test_nothing_moves_while_nobody_watches(session: Session) -> None:
    session.watched = False
    assert ticks(session, 50) == []
    assert session._sortie.frame.t == 0.0


def test_how_it_stands_is_told_each_second(session: Session) -> None:
    told = 0
    for number in range(600):
        session.changed = False
        session.tick(number, late=False)
        told += session.changed
    assert told == 5


def test_outside_the_linear_range_is_flagged(session: Session) -> None:
    session.put(stick(roll=1.0))
    flags = [int.from_bytes(frame[2:4], "little") for frame in ticks(session, 120)]
    assert not flags[0] & wire.OUTSIDE
    assert flags[-1] & wire.OUTSIDE


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"h": -1.0}, "You met the ground. Press R to start again."),
        ({"u": -CRAFT.setup.plant.start().u - 135.9}, "the airspeed fell to 0."),
        ({"w": 1e10}, "The flight departed at t = "),
        ({"w": math.nan}, "The flight departed at t = "),
    ],
)
def test_how_flights_end(session: Session, changes: dict[str, float], words: str) -> None:
    flown = session._sortie
    flown._edits = [Edit(state=CRAFT.start._replace(**changes))]
    ticks(session, 3)
    status = session.status()
    assert status["frozen"]
    assert words in status["notice"]
    for refused in (session.freeze, session.run, session.step):
        with pytest.raises(SpecError, match="The flight has ended"):
            refused()
    session.reset()
    assert session.status() == {"frozen": False, "recording": None, "replay": None, "held": {}, "notice": None}
    assert ticks(session, 5)


def test_a_flight_is_recorded_from_its_first_movement_and_ends_with_it(session: Session, tmp_path: Path) -> None:
    assert not session.put(stick())
    assert session.put(stick(roll=0.5))
    assert not session.put(stick(roll=0.6))
    name = session.start_recording()
    ticks(session, 30)
    session.reset()
    ticks(session, 10)
    session.fail(ValueError("planted"))
    wait_for_recordings()
    recording = open_recording(tmp_path / f"{name}.fdes")
    assert recording.complete
    assert len(recording.data) == 40
    assert [edit["reset"] for edit in recording.edits] == [True]
    assert recording["phi"][30] == 0.0


def test_after_a_recording_was_stopped_and_a_reset_the_next_flight_is_recorded_too(session: Session) -> None:
    session.put(stick(roll=0.5))
    session.start_recording()
    ticks(session, 5)
    session.stop_recording()
    assert not session.put(stick(roll=0.7))
    session.reset()
    ticks(session, 2)
    assert not session.put(stick())
    assert session.put(stick(roll=0.5))
    session.start_recording()
    session.reset()
    ticks(session, 2)
    assert not session.put(stick(roll=0.2))


def test_recording_is_not_automatic_where_it_is_not_wanted(tmp_path: Path) -> None:
    session = Session("one", CRAFT, tmp_path, record=False)
    assert not session.put(stick(roll=0.5))
    session.start_recording()
    session.close()
    wait_for_recordings()


def test_two_who_start_a_recording_at_once_start_one(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened = sortie_module.open_recorder

    def meanwhile(folder: Path, craft: Craft) -> Recorder:
        monkeypatch.setattr(session_module, "open_recorder", opened)
        session.start_recording()
        return opened(folder, craft)

    monkeypatch.setattr(session_module, "open_recorder", meanwhile)
    with pytest.raises(SpecError, match="is being recorded already"):
        session.start_recording()
    with pytest.raises(SpecError, match="End it before you start another"):
        session.start_recording()
    (kept,) = tmp_path.iterdir()
    assert session.status()["recording"]["name"] == kept.stem


def test_another_aircraft_ends_the_recording(session: Session, tmp_path: Path) -> None:
    name = session.start_recording()
    ticks(session, 10)
    session.change(make_craft(load("NAVION").at()))
    wait_for_recordings()
    assert open_recording(tmp_path / f"{name}.fdes").complete
    assert session.status()["recording"] is None
    assert session.shown.briefing["id"] == "NAVION"


def test_a_recording_does_not_grow_for_ever(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sortie_module, "LONGEST_RECORDING", 0.5)
    session.start_recording()
    ticks(session, 100)
    assert session.status()["recording"] is None
    assert "The recording ended after 0 minutes, and was kept." in session.status()["notice"]
    assert not session.status()["frozen"]


def test_a_disk_that_fails_ends_the_recording_and_not_the_flight(session: Session) -> None:
    session.start_recording()
    recorder = session._sortie.recorder
    assert recorder
    recorder.trouble = "x.fdes could not be written: No space left on device."
    ticks(session, 10)
    status = session.status()
    assert status["recording"] is None
    assert "No space left on device" in status["notice"]
    assert not status["frozen"]


def test_a_folder_that_is_gone_is_told(tmp_path: Path) -> None:
    session = Session("one", CRAFT, tmp_path / "gone")
    with pytest.raises(SpecError, match=r"The flight is not recorded: .*gone cannot be written \(No such file"):
        session.start_recording()
    assert "is not recorded" in session.status()["notice"]


def recording_of(craft: Craft, frames: int, leave_out: str = "") -> Recording:
    columns = columns_of(type(craft.start))
    data = np.arange(frames)[:, None] / 120 + 5.0 + np.zeros(len(columns))
    kept = [i for i, c in enumerate(columns) if c.name != leave_out]
    return Recording(craft.header(), tuple(columns[i] for i in kept), data[:, kept], (), True)


def test_a_replay_runs_at_its_own_pace_to_its_end_and_stays(session: Session) -> None:
    ticks(session, 20)
    flown = session._sortie.frame.t
    session.play(replay_of("r", recording_of(CRAFT, 61)))
    ticks(session, 30)
    assert session.status()["replay"] == {"name": "r", "t": pytest.approx(0.25, abs=1e-3), "duration": 0.5}
    session.changed = False
    ticks(session, 60)
    assert session.changed
    assert session.status()["frozen"]
    assert session.status()["replay"]["t"] == 0.5
    session.run()
    assert session.status()["replay"]["t"] == 0.0
    session.freeze()
    session.step()
    assert session.status()["replay"]["t"] == pytest.approx(1 / 120, abs=1e-3)
    session.seek(99.0)
    assert session.status()["replay"]["t"] == 0.5
    session.seek(-1.0)
    assert session.status()["replay"]["t"] == 0.0
    session.stop_replay()
    assert session.status()["frozen"]
    assert session._sortie.frame.t == flown


def test_frames_of_a_replay_are_those_that_were_recorded() -> None:
    replay = replay_of("r", recording_of(CRAFT, 121, leave_out="n_z"))
    for k in range(121):
        replay.seek(k / 120)
        values = dict(zip([c.name for c in wire.CHANNELS], replay.frame(), strict=True))
        assert values["phi"] == pytest.approx(5.0 + k / 120, rel=1e-6)
        assert math.isnan(values["n_z"])


def test_an_empty_recording_is_no_replay() -> None:
    with pytest.raises(RecordingError, match="holds no frames"):
        replay_of("r", recording_of(CRAFT, 0))


def fleet(*said: str) -> Callable[[], Fleet]:
    return lambda: Fleet(load("A-4D"), *said)


def test_a_fleet_offers_the_hangar_and_says_what_it_has_not() -> None:
    offered = Fleet(load("A-4D"), None, "corrected", "nelson", "exact")
    craft = offered.craft("NAVION", None, "printed", offered.first)
    assert (craft.form, craft.integrator, craft.briefing["name"]) == ("nelson", "exact", "Ryan NAVION")
    for wrong in (fleet("M9", "corrected", "full", "rk4"), fleet("M0.4_SL", "corrected", "fool", "rk4")):
        with pytest.raises(NoSuchPart):
            wrong()
    with pytest.raises(NoSuchPart, match="integrator named 'rk5'"):
        Fleet(load("A-4D"), None, "corrected", "full", "rk5")


def test_a_recording_brings_its_aircraft_along() -> None:
    craft = make_craft(load("B747").at(None, "printed"), "nelson", "euler")
    again = craft_of("r", craft.header())
    assert again
    assert again.briefing == craft.briefing
    assert craft_of("r", {}) is None
    assert craft_of("r", craft.header() | {"document": {"format": 99}}) is None


def test_condition_names() -> None:
    assert condition_name(0.4, 0.0) == "M 0.40, sea level"
    assert condition_name(0.8, 35_000 * 0.3048) == "M 0.80, 35,000 ft"


def test_a_test_input_begins_now_and_ends(session: Session) -> None:
    ticks(session, 10)
    session.put_in(Excitation.parse(["pulse aileron 2deg for 0.1s"]))
    ticks(session, 7)
    assert session._sortie.frame.outputs.aileron == pytest.approx(math.radians(2.0))
    ticks(session, 20)
    assert session._sortie.frame.outputs.aileron == 0.0
    assert session._sortie.frame.outputs.phi > 0.0


def test_inputs_can_be_cleared_and_a_reset_clears_them(session: Session) -> None:
    for end in (session.clear_inputs, session.reset):
        session.put_in(Excitation.parse(["step elevator -1deg"]))
        ticks(session, 3)
        assert session._sortie.frame.command.elevator == pytest.approx(math.radians(-1.0))
        end()
        ticks(session, 3)
        assert session._sortie.frame.command.elevator == 0.0


def test_a_disturbance_is_added_to_the_state_and_recorded_as_an_edit(session: Session) -> None:
    session.disturb("beta=5deg")
    ticks(session, 1)
    frame = session._sortie.frame
    assert frame.state.beta == pytest.approx(math.radians(5.0))
    assert frame.edit is not None
    assert frame.edit.note == {"disturb": "beta=5deg"}


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (
            lambda s: excite(s, commands.PutIn("stp aileron 1deg")),
            "There is no input named 'stp'. Did you mean 'step'?",
        ),
        (lambda s: s.disturb("bta=5deg"), "There is no state named 'bta'. Did you mean 'beta'?"),
    ],
)
def test_what_cannot_be_put_in_is_said_and_the_flight_goes_on(session: Session, ask: Any, words: str) -> None:
    with pytest.raises(FdesError) as error:
        ask(session)
    assert words in str(error.value)
    before = session._sortie.frame.t
    ticks(session, 2)
    assert session._sortie.frame.t > before


def test_a_long_step_is_flown_as_such(tmp_path: Path) -> None:
    session = Session("slow", make_craft(CRAFT.condition, "full", "euler", 0.1), tmp_path)
    session.watched = True
    ticks(session, 120)
    assert session._sortie.frame.t == pytest.approx(1.0, abs=0.11)
    assert session.shown.briefing["dt"] == 0.1
    assert session.shown.briefing["step_limit"]["mode"] == "dutch_roll"
    with pytest.raises(SpecError, match=r"A step of 0\.001 s cannot be flown"):
        make_craft(CRAFT.condition, "full", "euler", 0.001)


def test_a_reset_after_a_replay_flies_on(session: Session, tmp_path: Path) -> None:
    ticks(session, 5)
    session.play(replay_of("r", recording_of(CRAFT, 50)))
    session.stop_replay()
    session.reset()
    before = session._sortie.frame.t
    ticks(session, 5)
    assert session._sortie.frame.t > before
    session.freeze()
    session.reset()
    assert session.status()["frozen"]  # what the pilot froze stays frozen


def test_held_values_are_added_and_recorded_until_they_are_cleared(session: Session, tmp_path: Path) -> None:
    assert session.hold("elevator", 0.02)
    assert not session.hold("gust_w", -3.0)
    session.start_recording()
    ticks(session, 10)
    assert session.status()["held"] == {"elevator": 0.02, "gust_w": -3.0}
    session.hold("elevator", 0.0)
    ticks(session, 10)
    assert session.status()["held"] == {"gust_w": -3.0}
    session.clear_inputs()
    ticks(session, 10)
    session.hold("aileron", 0.1)
    session.reset()
    assert session.status()["held"] == {}
    ticks(session, 10)
    name = session.stop_recording()
    wait_for_recordings()
    recording = open_recording(tmp_path / f"{name}.fdes")
    assert recording["excitation_elevator"].tolist() == [0.02] * 10 + [0.0] * 30
    assert recording["air_gust_w"].tolist() == [-3.0] * 20 + [0.0] * 20
    assert not recording["excitation_aileron"].any()
    assert recording["n_z"][0] > 1.01


def test_a_measured_history_is_flown_as_it_is(session: Session) -> None:
    excite(session, commands.PutInHistory("aileron", (5.0, 5.1, 5.2), (0.0, 0.1, 0.0)))
    added = []
    for _ in range(40):
        ticks(session, 1)
        added.append(session._sortie.frame.excitation.aileron)
    assert max(added) == pytest.approx(0.1)
    assert added[-1] == 0.0
    with pytest.raises(SpecError, match="must grow from row to row; row 2 goes from 1 s to 1 s"):
        excite(session, commands.PutInHistory("aileron", (1.0, 1.0), (0.0, 0.1)))


def test_inputs_that_are_over_are_forgotten_and_too_many_are_refused(session: Session) -> None:
    for _ in range(3):
        for _ in range(60):
            excite(session, commands.PutIn("pulse elevator 0.01deg for 0.05s"))
        ticks(session, 20)
    for _ in range(64):
        excite(session, commands.PutIn("step elevator 0.01deg"))
    with pytest.raises(SpecError, match=r"64 test inputs are under way, and 64 can be at once\. End them all"):
        excite(session, commands.PutIn("step elevator 0.01deg"))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("elevator 2deg; step rudder 1deg", "cannot be held: say one channel and its value"),
        ("elevator 2deg at 3s", "cannot be held"),
        ("elevator 2", "does not say the unit of 2. Write 2deg"),
        ("flaps 2deg", "There is no input channel named 'flaps'"),
    ],
)
def test_says_why_a_value_cannot_be_held(text: str, words: str) -> None:
    with pytest.raises(FdesError, match=words):
        held(text)


def test_a_preview_is_the_input_itself() -> None:
    seen = preview("doublet gust_w -3m/s for 2s")
    assert (seen["channel"], seen["unit"]) == ("gust_w", "m/s")
    assert seen["start"] < 0.0
    assert seen["start"] + seen["dt"] * (len(seen["values"]) - 1) > 2.0
    put = Excitation.parse(["doublet gust_w -3m/s for 2s"])
    assert seen["values"] == [put.gusts(seen["start"] + k * seen["dt"]).gust_w for k in range(len(seen["values"]))]
    with pytest.raises(SpecError, match="cannot be flown"):
        preview("sweep elevator 1deg slowest 1e300s fastest 1e-300s")


def test_the_network_cannot_name_a_file(session: Session, tmp_path: Path) -> None:
    """Whether the file exists or not, the same refusal: nothing of the disk comes out."""
    there = tmp_path / "secret.csv"
    there.write_text("t,elevator [deg]\n0,1\n1,2\n", encoding="utf-8")
    refusals = set()
    for path in (there, tmp_path / "none.csv"):
        text = f"measured elevator {path}"
        for ask in (lambda t: excite(session, commands.PutIn(t)), preview, lambda t: excite(session, commands.Hold(t))):
            with pytest.raises(FdesError) as no:
                ask(text)
            refusals.add(str(no.value).replace(str(path), "PATH")[:60])
    assert len(refusals) == 2  # the one of inputs, and the one of values held
    assert session._sortie._everything.parts == ()
