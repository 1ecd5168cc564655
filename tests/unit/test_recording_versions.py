"""Every version of the recording format that was ever written still opens, with the numbers it had."""

from pathlib import Path

import pytest

from fdes.flight import open_recording
from fdes.flight.recorder import FORMAT

KEPT = Path(__file__).parent / "recordings"


def test_format_1() -> None:
    recording = open_recording(KEPT / "format_1.fdes")
    assert recording.complete
    assert (recording.header["format"], recording.header["aircraft"]) == (1, "A-4D")
    assert recording.edits == ({"t": 0.5, "reset": True},)
    assert recording["t"][-1] == pytest.approx(1.0)
    assert recording["phi"][9] == pytest.approx(0.03276965488738514, rel=1e-12)
    assert recording["phi"][10] == 0.0
    assert recording["phi"][-1] == pytest.approx(0.09256612203656808, rel=1e-12)


def test_the_present_format_is_kept() -> None:
    assert (KEPT / f"format_{FORMAT}.fdes").exists()
