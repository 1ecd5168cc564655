"""What people read at the command line: help, tables, notes; and that it keeps quiet when nobody listens."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes import __version__
from fdes.aircraft import catalogue, load
from fdes.cli import app
from fdes.cli.output import track, working
from fdes.physics.derivatives import FORMS

CONDITIONS = [(a.id, c.id) for a in catalogue() for c in a.conditions]
COMMANDS = [
    ["fly"],
    ["modes"],
    ["qualities"],
    ["derivatives"],
    ["simulate"],
    ["whatif"],
    ["aircraft"],
    ["aircraft", "list"],
    ["aircraft", "show"],
    ["check"],
    ["settings"],
    ["shelves"],
    ["verify", "textbooks"],
    ["verify", "paper"],
]
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals and pipes as POSIX has them")


def run(*words: str) -> Any:
    result = CliRunner().invoke(app, [*words], prog_name="fdes", env={"COLUMNS": "80"})
    assert result.exit_code == 0, result.output
    return result


def fits(text: str) -> bool:
    return max(len(line.rstrip()) for line in text.splitlines()) <= 80


@pytest.mark.parametrize("command", [[], *COMMANDS], ids=" ".join)
def test_help_ends_with_an_example(command: list[str]) -> None:
    text = run(*command, "--help").stdout
    assert fits(text)
    last = " ".join(text.split("│")[-1].split("╯")[-1].split())
    assert last.startswith(f"Example: fdes {' '.join(command)}".rstrip())


def test_version(fdes_command: str) -> None:
    run = subprocess.run([fdes_command, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout == f"fdes {__version__}\n"


@pytest.mark.parametrize("options", [["--version"], ["modes", "--help"]], ids=" ".join)
def test_what_needs_no_numbers_does_not_wait_for_them(options: list[str]) -> None:
    code = "import sys, fdes.cli\ntry: fdes.cli.main()\nfinally: print(*sys.modules, file=sys.stderr)"
    run = subprocess.run([sys.executable, "-c", code, *options], capture_output=True, text=True, check=True)
    assert not {"numpy", "scipy", "starlette", "uvicorn", "fdes.aircraft"} & set(run.stderr.split())


@pytest.mark.parametrize(("aircraft", "condition"), CONDITIONS)
@pytest.mark.parametrize("variant", ["corrected", "printed"])
def test_every_table_fits_80_columns_whole(aircraft: str, condition: str, variant: str) -> None:
    which = [aircraft, "--condition", condition, "--variant", variant]
    forms = FORMS if load(aircraft).at(condition).nondimensional else ("full",)
    texts = [run("modes", *which, "--form", form).stdout for form in forms]
    texts += [run("derivatives", *which).stdout, run("aircraft", "show", *which).stdout]
    texts += [run("simulate", *which, "--input", "doublet elevator 1deg; step rudder 1deg").stdout]
    for text in texts:
        assert fits(text)
        assert "…" not in text


def test_modes_of_the_navion_can_be_laid_beside_the_book() -> None:
    text = run("modes", "NAVION", "--form", "nelson", "--variant", "printed").stdout
    rows = [" ".join(line.split()) for line in text.splitlines()]
    assert rows[0] == "Ryan NAVION, M0.158_SL: printed values, form nelson"
    assert "phugoid -0.01711 ± 0.2130i 0.214 0.0800 58.5 40.5 29.5 1.37" in rows
    assert rows.index("Longitudinal") < rows.index("Lateral")


def test_an_unstable_mode_says_when_it_doubles() -> None:
    text = run("modes", "F-104A").stdout
    spiral = next(line.split() for line in text.splitlines() if line.startswith(" spiral"))
    assert spiral[-1] == "x2"
    assert spiral[3] == "-1.00"


def test_an_approximation_stands_beside_its_mode_with_its_error() -> None:
    rows = [" ".join(line.split()) for line in run("modes", "NAVION").stdout.splitlines()]
    assert "phugoid -0.02252 ± 0.2590i 0.260 +21 % 0.0866 +11 %" in rows
    assert "steady roll rate 3.44 deg/s per degree of aileron, rolling alone" in rows


def test_an_approximation_without_a_partner_and_an_aircraft_without_coefficients_say_so() -> None:
    text = run("modes", "F-104A", "--condition", "M1.8_55kft").stdout
    assert "phugoid: no exact mode to compare with: split into two real roots." in text
    text = " ".join(run("modes", "NT-33A", "--condition", "FC1_dimensional").stdout.split())
    assert "The source gives dimensional derivatives. The approximations," in text
    assert "approximations, and how far" not in text


def test_what_is_assumed_is_marked() -> None:
    derivatives = run("derivatives", "A-4D").stdout
    assert " X_dT* " in derivatives
    assert "throttle*" in derivatives
    assert "* rests on an ASSUMED thrust of 7,700 lbf: " in derivatives
    shown = run("aircraft", "A-4D").stdout
    assert shown.index("ASSUMED: no source gives these") < shown.index("max_thrust ") < shown.index("\nNotes")


def test_a_corrected_number_is_shown_beside_the_printed_one_with_its_reason() -> None:
    text = " ".join(run("aircraft", "show", "A-4D").stdout.split())
    assert "Cn_da 0.06 0.006 1/rad medium 0.006000 1/rad" in text
    assert "Cn_da decimal slip; Teper's N'_da = 1.4875 1/s^2 gives 0.006. " in text
    assert "Presumed: no source has it." in run("aircraft", "show", "Convair880").stdout


@pytest.mark.parametrize("words", [["aircraft"], ["aircraft", "list"]], ids=" ".join)
def test_aircraft_are_listed_with_conditions_and_sources(words: list[str]) -> None:
    text = run(*words).stdout
    assert all(f"{aircraft} " in text and f"{condition} " in text for aircraft, condition in CONDITIONS)
    assert "table B.3" in text


def test_without_a_file_simulate_tells_what_moved() -> None:
    result = run("simulate", "A-4D", "--input", "step aileron 15deg at 0s", "--duration", "6")
    rows = {line.split()[0]: line.split() for line in result.stdout.splitlines() if line.strip()}
    assert set(rows) >= {"phi", "p", "r", "beta"}
    assert not {"alpha", "theta", "q", "h"} & set(rows)
    assert rows["phi"][1] == "rad"
    assert "From t = 0.39 s on the flight is more than 15 deg from its reference condition" in result.stderr


@pytest.mark.parametrize("words", ["modes NAVION", "simulate NAVION --initial beta=5deg --duration 2"])
def test_a_plot_is_written_beside_the_table(words: str, tmp_path: Path) -> None:
    plot = tmp_path / "plot.svg"
    assert run(*words.split(), "--plot", str(plot)).stdout.endswith("plot.svg is written.\n")
    assert plot.read_text(encoding="utf-8").count("Ryan NAVION, M0.158_SL: ") >= 1


def test_simulate_without_an_input_says_so() -> None:
    result = run("simulate", "A-4D", "--duration", "1")
    assert result.stdout == ""
    assert result.stderr.startswith("Note: Nothing moved")


@POSIX
@pytest.mark.parametrize("words", ["modes NAVION", "simulate A-4D --out -", "aircraft --json"])
def test_a_reader_that_has_enough_is_no_error(fdes_command: str, words: str) -> None:
    piped = f"'{fdes_command}' {words} | head -1"
    run = subprocess.run(piped, shell=True, capture_output=True, text=True, check=True)
    assert len(run.stdout.splitlines()) == 1
    assert run.stderr == ""


@pytest.fixture
def ctrl_c() -> Iterator[None]:
    """Programs that are started can be interrupted, though these tests may run in the background, where none can."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@POSIX
@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_is_quiet_and_leaves_nothing(fdes_command: str, tmp_path: Path) -> None:
    command = [fdes_command, "simulate", "A-4D", "--duration", "400", "--out", str(tmp_path / "run.csv")]
    flying = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while flying.poll() is None and not list(tmp_path.iterdir()):
        time.sleep(0.02)
    flying.send_signal(signal.SIGINT)  # while it writes
    assert flying.communicate(timeout=10) == ("", "")
    assert flying.returncode == 130
    assert list(tmp_path.iterdir()) == []


def test_a_terminal_that_knows_only_ascii_gets_all_the_same_table(fdes_command: str) -> None:
    plain = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    run = subprocess.run([fdes_command, "modes", "NAVION"], capture_output=True, env=plain, check=True)
    assert b"short period" in run.stdout.decode("ascii").encode()


def test_how_the_dutch_roll_depends_on_an_uncertain_angle_is_shown() -> None:
    text = run("aircraft", "show", "F-104A", "--condition", "M0.257_SL").stdout
    rows = [line.split() for line in text.split("the Dutch roll depends on it")[1].splitlines()[4:13]]
    assert [row[0] for row in rows] == ["0", "1", "2", "2.3", "3", "4", "6", "8", "10"]
    assert [float(row[1]) < 0.0 for row in rows[:4]] == [True, True, False, False]
    assert rows[3][-1] == "used"
    assert "depends on it" in run("aircraft", "show", "A-4D", "--condition", "M0.8_35kft").stdout
    assert "depends on it" not in run("aircraft", "show", "B747").stdout


def test_what_dimensional_derivatives_cannot_say_is_said() -> None:
    assert "The source gives dimensional derivatives: fdes aircraft show has them" in run("derivatives", "A-7A").stdout
    shown = " ".join(run("aircraft", "show", "A-7A").stdout.split())
    assert "M_u 0.00201 1/(ft s) medium 0.006594 1/(m s)" in shown
    assert "The source gives dimensional derivatives in body axes" in shown


def test_shelves_name_every_part() -> None:
    text = run("shelves").stdout
    assert fits(text)
    for part in ("kutta_merson", "direct", "three_two_one_one"):
        assert part in text


def test_what_takes_long_shows_how_far_it_is_on_a_terminal_only(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert list(track([1, 2], "Flying again")) == [1, 2]
    with working("Drawing"):
        pass
    assert capsys.readouterr() == ("", "")
    monkeypatch.setenv("FORCE_COLOR", "1")  # what makes Rich take anything for a terminal
    assert list(track([1, 2], "Flying again")) == [1, 2]
    with working("Drawing"):
        pass
    said = capsys.readouterr()
    assert said.out == ""
    assert "Flying again" in said.err
    assert "Drawing" in said.err
