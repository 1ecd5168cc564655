"""`--set`: the same changes, in the same words, on every command that takes an aircraft."""

import csv
import json
from io import StringIO
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.aircraft import edited, load
from fdes.analysis import modes
from fdes.cli import app

CHANGES = ["--set", "Cm_alpha=-0.3", "--set", "Cn_r*=2"]


def run(*words: str) -> Any:
    return CliRunner().invoke(app, words, env={"COLUMNS": "80"})


def test_modes_answers_for_the_changed_aircraft() -> None:
    said = json.loads(run("modes", "NAVION", *CHANGES, "--json").stdout)
    assert said["changes"] == ["Cm_alpha=-0.3", "Cn_r*=2.0"]
    changed = edited(load("NAVION").at(), ["Cm_alpha=-0.3", "Cn_r*=2"])
    expected = [[m.eigenvalue.real, m.eigenvalue.imag] for m in modes(changed)]
    assert [m["eigenvalue"] for m in said["modes"]] == expected


def test_what_is_printed_says_what_was_changed() -> None:
    assert "corrected values, Cm_alpha=-0.3, Cn_r*=2.0, form full" in run("modes", "NAVION", *CHANGES).stdout


def test_simulate_flies_the_changed_aircraft() -> None:
    def farthest_pitch_rate(*more: str) -> float:
        flown = run("simulate", "A-4D", "-i", "step elevator -1deg", "--duration", "2", "--out", "-", *more)
        return max(float(row["q [rad/s]"]) for row in csv.DictReader(StringIO(flown.stdout)))

    assert farthest_pitch_rate("--set", "Cm_q*=0") > 1.1 * farthest_pitch_rate()


@pytest.mark.parametrize("command", ["modes", "derivatives", "simulate"])
def test_change_that_cannot_be_made_ends_with_status_2(command: str) -> None:
    result = run(command, "NAVION", "--set", "Cm_alpa=-0.3")
    assert result.exit_code == 2
    assert "Did you mean 'Cm_alpha'?" in result.stderr


def test_derivatives_are_those_of_the_changed_aircraft() -> None:
    def pitch_damping(*more: str) -> float:
        said = json.loads(run("derivatives", "A-4D", "--json", *more).stdout)
        return float(said["dimensional"]["M_q"]["value"])

    assert pitch_damping("--set", "Cm_q*=0.5") == pytest.approx(0.5 * pitch_damping())
