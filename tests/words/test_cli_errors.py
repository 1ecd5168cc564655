"""A user's mistake at the command line: status 2, a few lines on stderr that say what to do, and no traceback."""

import errno
import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fdes.cli import app

FLY = ["fly", "--no-browser", "--port", "0"]
A4D = ["simulate", "A-4D"]

MISTAKES = [
    (["modes", "NAVIN"], "There is no aircraft named 'NAVIN'. Did you mean 'NAVION'? Known: A-4D, A-7A, B747"),
    (["modes", "boing747"], "There is no aircraft named 'boing747'. Did you mean 'B747'?"),
    (["aircraft", "a5d"], "There is no aircraft named 'a5d'. Did you mean 'A-4D'?"),
    ([*FLY, "navin"], "There is no aircraft named 'navin'. Did you mean 'NAVION'?"),
    (["modes", "./nothing.toml"], "There is no aircraft file nothing.toml."),
    (
        ["modes", "A-4D", "-c", "M0.5_SL"],
        "There is no flight condition of the A-4D named 'M0.5_SL'. Did you mean 'M0.4_SL'?",
    ),
    ([*FLY, "A-4D", "-c", "M9"], "There is no flight condition of the A-4D named 'M9'. Known: M0.4_SL, M0.8_35kft."),
    (
        ["modes", "A-4D", "--form", "nelsn"],
        "There is no form of the linear equations named 'nelsn'. Did you mean 'nelson'?",
    ),
    (["derivatives", "A-4D", "--form", "ful"], "Did you mean 'full'? Known: full, nelson, paper."),
    ([*A4D, "--form", "papr"], "Did you mean 'paper'?"),
    ([*FLY, "--form", "x"], "There is no form of the linear equations named 'x'. Known: full, nelson, paper."),
    (["modes", "A-4D", "--variant", "print"], "There is no variant named 'print'. Did you mean 'printed'?"),
    ([*FLY, "--variant", "corected"], "There is no variant named 'corected'. Did you mean 'corrected'?"),
    (
        [*A4D, "--integrator", "rk5"],
        "There is no integrator named 'rk5'. Did you mean 'rk4'? Known: dopri5, euler, exact",
    ),
    ([*FLY, "--integrator", "exakt"], "There is no integrator named 'exakt'. Did you mean 'exact'?"),
    ([*A4D, "--units", "uss"], "There is no system of units named 'uss'. Did you mean 'us'? Known: si, us."),
    ([*A4D, "--dt", "0"], "The time step is 0 s; it must be a positive number, such as 0.01."),
    ([*A4D, "--dt", "-0.01"], "The time step is -0.01 s; it must be a positive number"),
    ([*A4D, "--dt", "nan"], "The time step is nan s; it must be a positive number"),
    (
        [*A4D, "--dt", "1e-9"],
        "10 s in steps of 1e-09 s are 10,000,000,000 rows; at most 500,000 fit. Take a larger --dt",
    ),
    ([*A4D, "--dt", "10", "--duration", "6"], "The time step of 10 s is longer than the flight of 6 s."),
    ([*A4D, "--duration", "-1"], "The duration is -1 s"),
    ([*A4D, "--duration", "inf"], "The duration is inf s"),
    ([*A4D, "--substeps", "0"], "The number of substeps is 0; it must be at least 1."),
    ([*A4D, "--height", "1500 fet"], "Unknown unit 'fet'. Did you mean 'ft'? Known units: m, km, ft, nmi."),
    (
        [*A4D, "--height", "15 deg"],
        "'15 deg' is in deg, which is not a unit of this quantity. Use one of: m, km, ft, nmi.",
    ),
    ([*A4D, "--input", "step ailron 15deg"], "There is no input channel named 'ailron'. Did you mean 'aileron'?"),
    ([*A4D, "--input", "stp aileron 15deg"], "There is no input named 'stp'. Did you mean 'step'?"),
    (
        [*A4D, "--input", "step aileron 15kt"],
        "'15kt' is in kt, which is not a unit of this quantity. Use one of: rad, deg.",
    ),
    ([*A4D, "--input", "step aileron 15 at 0s"], "does not say the unit of 15. Write 15deg, or 15rad."),
    ([*A4D, "--input", "step aileron nan deg"], "'nan deg' is not a number with a unit."),
    ([*A4D, "--input", "doublet elevator 5deg for -2s"], "says for -2s; it must last longer than 0 s."),
    (
        [*A4D, "--out", "run.txt"],
        "run.txt cannot be written: let its name end in .csv, .nc, .mat.",
    ),
    ([*A4D, "--out", "run.nc", "--units", "us"], ".nc files carry their units and are written in SI."),
    ([*A4D, "--initial", "bta=5deg"], "There is no state named 'bta'. Did you mean 'beta'?"),
    ([*A4D, "--height", "-99999m"], "A flight cannot begin at -99,999 m: it can between -500 m and 86,000 m."),
    ([*A4D, "--input", ""], "The input '' is incomplete."),
    ([*A4D, "--initial", "beta=5"], "The initial perturbation 'beta=5' has no unit. Write it like 'beta=5deg'"),
    ([*A4D, "--initial", "beta"], "The initial perturbation 'beta' is not understood. Write it like 'beta=5deg'."),
    ([*A4D, "--initial", "beta=5kt"], "'5kt' is in kt, which is not a unit of this quantity. Use one of: rad, deg"),
    ([*A4D, "--out", "nowhere/run.csv"], "nowhere/run.csv cannot be written: there is no folder "),
    ([*FLY, "--host", "nowhere.invalid"], "There is no host 'nowhere.invalid' here. Use 127.0.0.1 for this machine"),
]


def said(*words: str) -> str:
    """What the mistake is answered with, on one line as a reader would take it."""
    result = CliRunner().invoke(app, [*words], prog_name="fdes", env={"COLUMNS": "80"})
    assert result.exit_code == 2
    assert result.stdout == ""
    assert "Traceback" not in result.stderr
    assert len(result.stderr.splitlines()) <= 8
    return result.stderr


@pytest.mark.parametrize(("words", "text"), MISTAKES, ids=lambda part: " ".join(part) if isinstance(part, list) else "")
def test_says_what_is_wrong_and_what_would_be_right(
    words: list[str], text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    answer = said(*words)
    assert answer.startswith("Error: ")
    assert text in answer
    assert list(tmp_path.rglob("*.csv")) == []


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["mode", "NAVION"], "No such command 'mode'. Did you mean 'modes'?"),
        (["modes"], "Missing argument 'AIRCRAFT'"),
        (["modes", "NAVION", "--from", "nelson"], "--form"),
        ([*A4D, "--dt", "fast"], "Invalid value for '--dt'"),
        (["fly", "--no-browser", "--port", "99999"], "Invalid value for '--port'"),
    ],
)
def test_words_that_cannot_be_read_are_answered_with_the_usage(words: list[str], text: str) -> None:
    answer = " ".join(said(*words).replace("│", " ").split())
    assert answer.startswith("Usage: fdes")
    assert text in answer


@pytest.mark.parametrize("command", ["modes", "derivatives", "simulate", "fly", "aircraft"])
def test_the_installed_commands_exit_with_2(fdes_command: str, command: str) -> None:
    run = subprocess.run([fdes_command, command, "NAVIN"], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith("Error: There is no aircraft named 'NAVIN'. Did you mean 'NAVION'?")
    assert run.stderr.count("\n") == 1


def test_python_m_fdes_is_the_same() -> None:
    run = subprocess.run([sys.executable, "-m", "fdes", "modes", "NAVIN"], capture_output=True, text=True, check=False)
    assert run.returncode == 2
    assert "Did you mean 'NAVION'?" in run.stderr


def test_a_port_in_use_that_was_asked_for_is_a_mistake() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        answer = said("fly", "--no-browser", "--port", str(port))
    assert f"Error: Port {port} is in use. Use --port " in answer


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="Windows keeps permissions otherwise")
def test_a_folder_that_cannot_be_written_is_named_before_anything_is_flown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    answer = said(*A4D, "--out", str(tmp_path / "run.csv"))
    assert f"run.csv cannot be written: no permission to write in {tmp_path}." in answer


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    folder = tmp_path / "run.csv"
    folder.mkdir()
    assert "run.csv cannot be written: it is a folder." in said(*A4D, "--out", str(folder))


def test_a_full_disk_is_told_and_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("fdes.flight.recording.write_csv", full)
    answer = said(*A4D, "--duration", "1", "--out", str(tmp_path / "run.csv"))
    assert f"run.csv cannot be written: {os.strerror(errno.ENOSPC)}." in answer
    assert list(tmp_path.iterdir()) == []
