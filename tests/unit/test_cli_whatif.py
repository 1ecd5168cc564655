"""`fdes whatif`: what it prints, keeps and draws."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from fdes.aircraft import load
from fdes.cli import app
from fdes.flight import Clock, Recording, open_recording, simulate
from fdes.flight.recorder import ENGINE


def run(*words: str) -> Any:
    return CliRunner().invoke(app, ["whatif", *words], env={"COLUMNS": "80"})


@pytest.fixture
def flight(tmp_path: Path) -> Path:
    """A doublet, kept as a recording in a data folder, as flown frame by frame on this machine."""
    from fdes.analysis.what_if import what_if

    flown: Recording = simulate(load("A-4D").at(), ["doublet elevator 3deg"], clock=Clock(0.02, duration=4.0))
    (tmp_path / "recordings").mkdir()
    path = tmp_path / "recordings" / "doublet.fdes"
    what_if(flown).recording.save(path)
    return path


def test_unchanged_it_is_bit_for_bit_the_recording(flight: Path) -> None:
    result = run(str(flight))
    assert result.exit_code == 0, result.output
    assert result.stdout == "flown again: 201 frames, bit for bit as they were recorded.\n"
    assert result.stderr == ""


def test_a_recording_goes_by_its_name_too(flight: Path) -> None:
    assert "bit for bit" in run("doublet", "--data", str(flight.parents[1])).stdout


def test_differences_are_those_of_the_flights(flight: Path) -> None:
    said = json.loads(run(str(flight), "--try", "Cm_q*=0", "--try", "form=paper", "--json").stdout)
    slack, paper = said["variations"]
    assert (slack["variation"], paper["variation"], slack["frames"]) == ("Cm_q*=0", "form=paper", 201)
    q = slack["differences"]["q"]
    assert q["unit"] == "rad/s"
    assert abs(q["greatest"]) > q["rms"] > 0.0
    assert 1.0 <= q["t"] <= 4.0
    assert "p" not in slack["differences"]


def test_each_variation_has_its_table_in_the_units_that_are_asked_for(flight: Path) -> None:
    result = run(str(flight), "--try", "Cm_q*=0", "--units", "us")
    assert "Cm_q*=0" in result.stdout
    assert "deg/s" in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 80


def test_what_was_flown_is_kept_and_drawn(flight: Path, tmp_path: Path) -> None:
    result = run(str(flight), "--try", "Cm_q*=0", "--out", str(tmp_path), "--plot", str(tmp_path / "o.html"))
    assert result.exit_code == 0, result.output
    kept = open_recording(tmp_path / "doublet_what_if_1.fdes")
    np.testing.assert_array_equal(kept["stick_pitch"], open_recording(flight)["stick_pitch"])
    assert kept.header["changes"] == ["Cm_q*=0"]
    assert "Cm_q*=0" in (tmp_path / "o.html").read_text()
    again = run(str(flight), "--try", "Cm_q*=0", "--out", str(tmp_path))
    assert again.exit_code == 2
    assert "is there already. Move it away, or name another folder." in again.stderr


def test_flight_that_departs_says_so(flight: Path) -> None:
    result = run(str(flight), "--try", "Cm_alpha=5000")
    assert "Note: Cm_alpha=5000: The flight departed at t =" in result.stderr


def test_recording_of_another_engine_is_the_same_to_rounding(flight: Path, tmp_path: Path) -> None:
    recorded = open_recording(flight)
    elsewhere = Recording({**recorded.header, "engine": "elsewhere"}, recorded.columns, recorded.data, (), True)
    elsewhere.save(tmp_path / "elsewhere.fdes")
    result = run(str(tmp_path / "elsewhere.fdes"))
    assert f"(elsewhere) and flown again by FDES 0.1.0 ({ENGINE}): the two agree to rounding" in result.stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["doublt"], "There is no recording named 'doublt'. Did you mean 'doublet'?"),
        (["none.fdes"], "none.fdes cannot be read: No such file or directory."),
        (["doublet", "--try", "faster"], "'faster' says nothing that could be different."),
        (["doublet", "--try", "Cm_alpa=1"], "Did you mean 'Cm_alpha'?"),
        (["doublet", "--out", "nowhere"], "nowhere is no folder. Make it first, or name another."),
        (["doublet", "--plot", "o.pdf"], "o.pdf cannot be written: let its name end in .png, .svg, .html."),
        (["doublet", "--units", "imperial"], "There is no system of units named 'imperial'."),
    ],
)
def test_mistakes_end_with_status_2(flight: Path, words: list[str], said: str) -> None:
    result = run(*words, "--data", str(flight.parents[1]))
    assert result.exit_code == 2
    assert said in result.stderr


def test_without_any_recordings_it_says_where_it_looked(tmp_path: Path) -> None:
    result = run("doublet", "--data", str(tmp_path))
    assert result.exit_code == 2
    assert f"There is no recording doublet, and none at all in {tmp_path}." in result.stderr.replace("\n", " ")
