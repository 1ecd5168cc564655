"""Drawings say what they show, in their units, and a page of one needs no network."""

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import fdes
from fdes.analysis.drawing import COLORS, FORMATS, Drawing, save
from fdes.analysis.plots import responses, s_plane
from fdes.flight import Clock

NAVION = fdes.load("NAVION").at()


@pytest.fixture(scope="module")
def response() -> Drawing:
    flight = fdes.simulate(NAVION, ["doublet elevator 2deg at 1s for 2s"], clock=Clock(0.02, duration=6.0))
    return responses(flight, "a doublet", units="us")


def test_every_mode_is_named_and_crossed_in_the_s_plane() -> None:
    found = fdes.modes(NAVION)
    panels = s_plane(found, "NAVION").panels
    words = {note.words for panel in panels for note in panel.notes}
    assert {mode.name.replace("_", " ") for mode in found} <= words
    crosses = [xy for curve in panels[0].curves if curve.line == "none" for xy in zip(curve.x, curve.y, strict=True)]
    assert {(m.eigenvalue.real, m.eigenvalue.imag) for m in found} <= set(crosses)
    for panel in panels:
        assert panel.x_range
        assert panel.y_range
        assert np.ptp(panel.x_range) == pytest.approx(np.ptp(panel.y_range))  # a circle of frequency is one


def test_a_response_shows_inputs_first_and_only_what_moved_in_the_units_asked_for(response: Drawing) -> None:
    shown = [[curve.label for curve in panel.curves] for panel in response.panels]
    assert shown[0] == ["elevator"]
    assert {"p", "beta", "phi"} & {name for names in shown for name in names} == set()
    assert [panel.y_label for panel in response.panels][:2] == ["[deg]", "[deg/s]"]
    assert max(response.panels[0].curves[0].y) == pytest.approx(2.0)


@pytest.mark.parametrize("suffix", FORMATS)
def test_every_format_is_written_and_names_its_signals(response: Drawing, suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"plot{suffix}"
    save(response, path)
    content = path.read_bytes()
    if suffix == ".png":
        assert content.startswith(b"\x89PNG")
    else:
        assert b"elevator" in content
        assert b"[deg" in content
    if suffix == ".html":
        assert re.findall(rb"<(?:script|link|img)[^>]+(?:src|href)=", content) == []


def test_neighboring_colors_differ_in_lightness_too() -> None:
    """So that a gray print and every kind of color blindness keep the first three apart (relative luminance)."""
    shares = [int(c[1:3], 16) * 0.2126 + int(c[3:5], 16) * 0.7152 + int(c[5:7], 16) * 0.0722 for c in COLORS[:3]]
    assert all(abs(one - other) > 5.0 for one, other in pairwise(shares))
