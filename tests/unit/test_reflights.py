"""What-if in the cockpit: another process flies a recording again, and nothing it is told can name code."""

import asyncio
from pathlib import Path

import pytest

from fdes.aircraft import load
from fdes.cockpit import reflights as reflights_module
from fdes.cockpit.cabins import Cabins
from fdes.cockpit.craft import make_craft
from fdes.cockpit.fleet import Fleet
from fdes.cockpit.reflights import MOST_VARIATIONS, Reflights
from fdes.cockpit.sortie import Sortie, open_recorder
from fdes.cockpit.wire import Input
from fdes.control import Stick
from fdes.errors import FdesError, RecordingError, SpecError
from fdes.flight import open_recording


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """A second in the cockpit."""
    craft = make_craft(load("A-4D").at("M0.4_SL"))
    sortie = Sortie(craft, Stick(throttle=craft.condition.trim_throttle))
    sortie.recorder = recorder = open_recorder(tmp_path, craft)
    for _ in range(120):
        sortie.take(Input(Stick(0.3, 0.2, 0.1, craft.condition.trim_throttle)))
        sortie.advance()
    recorder.close()
    return recorder.path


def test_unchanged_it_differs_in_nothing_and_variants_are_kept_beside_it(recording: Path) -> None:
    came = asyncio.run(Reflights().fly(recording, ["", "Cm_q*=0.5; law=yaw_damper; roll_rate_damper gain=0.1"]))
    same, other = came
    assert (same["same"], same["differences"], same["frames"]) == (True, {}, 120)
    assert not other["same"]
    assert abs(other["differences"]["q"]["greatest"]) > 0.0
    assert [one["name"] for one in came] == [f"{recording.stem}_what_if_{k}" for k in (1, 2)]
    flown = open_recording(recording.with_name(f"{other['name']}.fdes"))
    assert flown.header["law"].startswith("yaw_damper gain=")
    again = asyncio.run(Reflights().fly(recording, [""]))
    assert again[0]["name"] == f"{recording.stem}_what_if_3"
    assert len(list(recording.parent.iterdir())) == 4


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("law=./mine.py", "There is no law named './mine.py'."),
        ("aircraft=./mine.toml", "is a file"),
        ("aircraft=../../etc/passwd", "is a file"),
        ("Cm_qq*=2", "Did you mean 'Cm_q'?"),
        ("law=yaw_damper gain=__import__('os')", "is not a number with a unit"),
    ],
)
def test_what_cannot_be_is_said_and_nothing_is_kept(recording: Path, text: str, words: str) -> None:
    with pytest.raises(RecordingError) as caught:
        asyncio.run(Reflights().fly(recording, [text]))
    assert words in str(caught.value)
    assert [path.name for path in recording.parent.iterdir()] == [recording.name]


def test_it_is_bounded_in_number_and_time(recording: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def asked() -> None:
        flying = Reflights()
        with pytest.raises(SpecError, match=f"1 to {MOST_VARIATIONS} can be flown at once"):
            flying.must_be_possible([""] * (MOST_VARIATIONS + 1))
        with pytest.raises(SpecError, match="says nothing that could be different"):
            flying.must_be_possible(["--out=/tmp"[:5]])
        monkeypatch.setattr(reflights_module, "LONGEST", 0.01)
        monkeypatch.setattr(reflights_module, "MOST_WAITING", 1)
        slow = asyncio.create_task(flying.fly(recording, [""]))
        await asyncio.sleep(0)
        with pytest.raises(SpecError, match="wait to be flown again"):
            flying.must_be_possible([""])
        with pytest.raises(RecordingError, match="takes longer than 0 s"):
            await slow
        flying.must_be_possible([""])

    asyncio.run(asked())
    assert [path.name for path in recording.parent.iterdir()] == [recording.name]


@pytest.mark.parametrize("name", ["/etc/passwd", "../outside", "*", "", "recording.fdes"])
def test_only_what_the_folder_lists_is_a_recording(recording: Path, name: str) -> None:
    (recording.parent.parent / "outside.fdes").write_bytes(recording.read_bytes())
    cabins = Cabins(Fleet(load("A-4D"), None, "corrected", "full", "rk4"), recording.parent)
    with pytest.raises(FdesError, match="There is no recording named"):
        cabins.recording(name)
