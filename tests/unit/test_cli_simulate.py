"""`fdes simulate`: the numbers it writes, and that it writes all of them or none."""

import csv
import errno
import json
import subprocess
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from scipy.io import loadmat
from scipy.linalg import expm
from typer.testing import CliRunner

from fdes.cli import app
from fdes.cli.flight_files import whole
from fdes.errors import SpecError
from fdes.units import DEG, FOOT, KNOT

STEP = ["--input", "step aileron 15deg at 0s"]
ROLL = ["A-4D", "--condition", "M0.4_SL", *STEP, "--dt", "0.01", "--duration", "6"]


def run(*words: str) -> Any:
    return CliRunner().invoke(app, ["simulate", *words], env={"COLUMNS": "80"})


def table_of(text: str) -> dict[str, np.ndarray]:
    """Columns by their name and unit."""
    head, *rows = csv.reader(StringIO(text))
    return dict(zip(head, np.array(rows, dtype=float).T, strict=True))


def flown(*words: str) -> dict[str, np.ndarray]:
    result = run(*words, "--out", "-")
    assert result.exit_code == 0, result.output
    return table_of(result.stdout)


def test_the_installed_command_writes_the_promised_file(fdes_command: str, tmp_path: Path) -> None:
    out = tmp_path / "run.csv"
    command = [fdes_command, "simulate", *ROLL, "--integrator", "rk4", "--out", str(out)]
    said = subprocess.run(command, capture_output=True, text=True, check=True)
    assert said.stdout == f"{out}: 601 rows, 67 columns\n"
    columns = table_of(out.read_text())
    assert list(columns)[:2] == ["t [s]", "V [m/s]"]
    assert columns["t [s]"][-1] == 6.0
    assert columns["aileron [rad]"][-1] == pytest.approx(15 * DEG)
    assert columns["p [rad/s]"][-1] > 1.0
    assert [p.name for p in tmp_path.iterdir()] == ["run.csv"]


@pytest.mark.parametrize("form", ["paper", "nelson", "full"])
def test_the_response_is_that_of_the_matrices_that_derivatives_prints(form: str) -> None:
    """The exact hold against one matrix exponential over the whole flight."""
    said = json.loads(CliRunner().invoke(app, ["derivatives", "A-4D", "--form", form, "--json"]).stdout)["lateral"]
    A, B = np.array(said["A"]), np.array(said["B"])
    augmented = np.zeros((5, 5))
    augmented[:4, :4], augmented[:4, 4] = A, B[:, 0] * 15 * DEG
    expected = expm(augmented * 6.0)[:4, 4]
    for integrator, tolerance in (("exact", 1e-9), ("rk4", 1e-6)):
        columns = flown(*ROLL, "--form", form, "--integrator", integrator)
        got = [columns[f"state_{name}"][-1] for name in ("beta [rad]", "p [rad/s]", "r [rad/s]", "phi [rad]")]
        assert got == pytest.approx(expected, rel=tolerance)


def test_us_units_are_the_same_flight() -> None:
    si, us = flown(*ROLL), flown(*ROLL, "--units", "us")
    assert us["phi [deg]"] == pytest.approx(si["phi [rad]"] / DEG, abs=1e-9)
    assert us["V [ft/s]"] == pytest.approx(si["V [m/s]"] / FOOT)
    assert us["n_z [1]"] == pytest.approx(si["n_z [1]"])


def test_surfaces_go_as_far_as_asked_unless_limits_are_wanted() -> None:
    words = ["A-4D", "--input", "step aileron 30deg at 0s", "--duration", "1"]
    free, limited = run(*words, "--out", "-"), run(*words, "--out", "-", "--limits")
    assert table_of(free.stdout)["aileron [rad]"][-1] == pytest.approx(30 * DEG)
    assert table_of(limited.stdout)["aileron [rad]"][-1] == pytest.approx(20 * DEG)
    assert "aileron is asked for 30 deg, beyond the assumed limit of 20 deg, and goes there all the same" in free.stderr
    assert "beyond the assumed limit of 20 deg, and stops there" in limited.stderr


def test_several_inputs_height_and_substeps() -> None:
    inputs = ["-i", "step elevator -1deg at 0s", "-i", "doublet rudder 2deg at 0.1s for 0.4s"]
    columns = flown("NAVION", *inputs, "--height", "1500 ft", "--duration", "1", "--dt", "0.1", "--substeps", "10")
    assert columns["h [m]"][0] == pytest.approx(1500 * FOOT)
    assert columns["excitation_elevator [rad]"] == pytest.approx(-1 * DEG)
    assert columns["excitation_rudder [rad]"] / DEG == pytest.approx([0, 2, 2, -2, -2, 0, 0, 0, 0, 0, 0])
    fine = flown("NAVION", *inputs, "--height", "1500 ft", "--duration", "1", "--dt", "0.1", "--integrator", "exact")
    assert columns["q [rad/s]"] == pytest.approx(fine["q [rad/s]"], abs=1e-7)


def test_a_flight_that_departs_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    out = tmp_path / "run.csv"
    out.write_text("mine")
    result = run(*ROLL[:-4], "--dt", "0.5", "--duration", "1000", "--integrator", "euler", "--out", str(out))
    assert result.exit_code == 2
    assert "The flight departed at t = " in result.stderr
    assert out.read_text() == "mine"
    assert list(tmp_path.iterdir()) == [out]


@pytest.mark.parametrize("trouble", [KeyboardInterrupt(), OSError(errno.ENOSPC, "No space left on device")], ids=repr)
def test_what_cannot_be_written_to_the_end_is_not_there_at_all(tmp_path: Path, trouble: BaseException) -> None:
    def write_half() -> None:
        with whole(tmp_path / "run.csv") as part:
            part.write_text("half")
            raise trouble

    with pytest.raises((KeyboardInterrupt, SpecError)):
        write_half()
    assert list(tmp_path.iterdir()) == []


def test_a_step_beyond_the_stability_limit_is_announced() -> None:
    words = ["A-4D", "--variant", "printed", "--form", "paper", *STEP, "--duration", "6", "--integrator", "euler"]
    assert (
        "beyond the stability limit of euler here, 0.0558 s, set by the dutch roll" in run(*words, "--dt", "0.1").stderr
    )
    assert "stability limit" not in run(*words, "--dt", "0.04").stderr


def test_initial_perturbations_are_where_the_flight_starts() -> None:
    columns = flown("A-4D", "--initial", "beta=5deg, u=+10kt", "--initial", "theta=-1deg", "--duration", "1")
    assert columns["state_beta [rad]"][0] == pytest.approx(5 * DEG)
    assert columns["state_u [m/s]"][0] == pytest.approx(10 * KNOT)
    assert columns["state_theta [rad]"][0] == pytest.approx(-1 * DEG)


@pytest.mark.parametrize("suffix", [".nc", ".mat"])
def test_other_formats_hold_the_same_flight(tmp_path: Path, suffix: str) -> None:
    out = tmp_path / f"run{suffix}"
    assert run(*ROLL, "--out", str(out)).exit_code == 0
    expected = flown(*ROLL)["p [rad/s]"]
    if suffix == ".mat":
        found = loadmat(out)["p"][:, 0]
    else:
        with xarray.open_dataset(out, engine="scipy") as data:
            found = data["p"].values
    assert found == pytest.approx(expected)
    assert list(tmp_path.iterdir()) == [out]
