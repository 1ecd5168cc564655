"""A and B leave FDES as they are: their names, units and numbers can be read back."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat
from typer.testing import CliRunner

import fdes
from fdes.cli import app

MODEL = fdes.linear_model(fdes.load("NAVION").at())


def written(path: Path) -> Path:
    result = CliRunner().invoke(app, ["derivatives", "NAVION", "--matrices", str(path)])
    assert result.exit_code == 0, result.output
    assert result.stdout.endswith(f"{path.name} is written.\n")
    return path


def test_latex_has_every_number_to_four_digits_and_every_name_with_its_unit(tmp_path: Path) -> None:
    text = written(tmp_path / "navion.tex").read_text(encoding="utf-8")
    assert r"\usepackage{amsmath}" in text
    lateral = text[text.index("% lateral") :]
    assert MODEL.lateral().to_latex() in lateral
    rows = re.findall(r"pmatrix\} (.*?) \\end", lateral)[1].split(r" \\ ")
    A = np.array([[float(cell) for cell in row.split("&")] for row in rows])
    assert pytest.approx(MODEL.lateral().A, rel=5e-4) == A
    assert r"\beta\ [\mathrm{rad}] \\ p\ [\mathrm{rad/s}]" in lateral
    assert "-0 " not in text
    assert text.count(r"\begin") == text.count(r"\end")


def test_a_notebook_shows_the_equation() -> None:
    assert MODEL._repr_latex_() == f"$$\n{MODEL.to_latex()}\n$$"


def test_a_mat_file_has_the_matrices_whole(tmp_path: Path) -> None:
    read = loadmat(written(tmp_path / "navion.mat"), simplify_cells=True)["longitudinal"]
    part = MODEL.longitudinal()
    assert np.array_equal(read["A"], part.A)
    assert np.array_equal(read["B"], part.B)
    assert tuple(read["states"]) == part.states
    assert tuple(read["state_units"]) == ("m/s", "m/s", "rad/s", "rad")
    path = tmp_path / "whole.mat"
    MODEL.to_mat(path)
    assert loadmat(path, simplify_cells=True)["model"]["A"].shape == (8, 8)


def test_a_json_file_says_what_the_matrices_are(tmp_path: Path) -> None:
    read = json.loads(written(tmp_path / "navion.json").read_text(encoding="utf-8"))
    assert (read["aircraft"], read["form"], read["units"]) == ("NAVION", "full", "SI")
    assert read["lateral"]["A"] == MODEL.lateral().A.tolist()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["derivatives", "NAVION", "--matrices", "m.txt"], "m.txt cannot be written: let its name end in .tex, .mat,"),
        (
            ["modes", "NAVION", "--plot", "plot.gif"],
            "plot.gif cannot be written: let its name end in .png, .svg, .html.",
        ),
        (["modes", "NAVION", "--plot", "no/where.png"], "no/where.png cannot be written: there is no folder no."),
    ],
)
def test_a_file_that_cannot_be_written_is_a_mistake(words: list[str], said: str) -> None:
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stdout == ""
