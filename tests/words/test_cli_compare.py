"""What `fdes compare` says."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fdes.cli import app

run = CliRunner().invoke
DOUBLET = ["-i", "doublet elevator 2deg for 2s", "--dt", "0.05"]


def test_where_they_part() -> None:
    done = run(app, ["compare", "A-4D", *DOUBLET])
    assert done.exit_code == 0, done.output
    assert "Linear and nonlinear part company, by 10 % in theta, at elevator 7." in done.stdout
    assert "Assumed: the lift coefficient" in done.stderr
    assert max(map(len, done.stdout.splitlines())) <= 80


def test_as_json() -> None:
    found = json.loads(run(app, ["compare", "A-4D", *DOUBLET, "--json"]).stdout)
    assert found["shares"]["theta"] < 0.1
    assert found["parting"]["amplitudes"][0]["channel"] == "elevator"
    assert found["parting"]["shares"]["theta"] == pytest.approx(0.1, rel=0.05)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["-i", "doublet aileron 5deg for 2s"], "stay within 10 % up to aileron 20.0 deg."),
        (
            ["-i", "doublet elevator 2deg for 2s", "--allowed", "0.0001"],
            "even at elevator 0.0312 deg: not by their amplitude",
        ),
    ],
)
def test_where_there_is_no_such_amplitude(words: list[str], said: str) -> None:
    assert said in " ".join(run(app, ["compare", "A-4D", "--dt", "0.05", *words]).stdout.split())


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["A-4D", *DOUBLET, "--allowed", "2"], "The difference allowed is 2; it must be a share between 0 and 1"),
        (
            ["A-4D", "-i", "step elevator 1deg at 20s"],
            "Nothing moved: let the input begin before the end of the flight.",
        ),
        (["B747_CR2144", *DOUBLET], "cannot fly nonlinear: its source gives dimensional derivatives"),
        (["A-5D", *DOUBLET], "Did you mean 'A-4D'?"),
        (["A-4D", "-i", "stp elevator 1deg"], "Did you mean 'step'?"),
        (["A-4D", *DOUBLET, "--plot", "x.jpg"], "let its name end in .png, .svg, .html"),
    ],
)
def test_mistakes(words: list[str], said: str) -> None:
    done = run(app, ["compare", *words])
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())


def test_a_plot(tmp_path: Path) -> None:
    file = tmp_path / "compare.html"
    done = run(app, ["compare", "A-4D", *DOUBLET, "--plot", str(file)])
    assert done.exit_code == 0
    assert "nonlinear" in file.read_text("utf-8")
