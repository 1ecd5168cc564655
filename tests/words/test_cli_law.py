"""What the command line says of closed loops."""

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis import modes
from fdes.analysis.closed_loop import close
from fdes.analysis.design import law_for
from fdes.flight.actuated import actuators_of

Run = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture
def run(fdes_command: str, tmp_path: Path) -> Run:
    def run(*words: str) -> "subprocess.CompletedProcess[str]":
        return subprocess.run([fdes_command, *words], capture_output=True, encoding="utf-8", check=False, cwd=tmp_path)

    return run


@pytest.mark.parametrize("options", [[], ["--sampled", "120"], ["--actuators"], ["--sampled", "60", "--actuators"]])
def test_modes_answers_for_the_closed_loop(run: Run, options: list[str]) -> None:
    """Continuous, without actuators, unless asked for."""
    said = json.loads(run("modes", "NAVION", "--law", "yaw_damper gain=0.5", *options, "--json").stdout)
    navion = load("NAVION").at()
    dt = 1.0 / float(options[1]) if "--sampled" in options else None
    on = actuators_of(navion) if "--actuators" in options else None
    expected = modes(close(navion, law_for("yaw_damper gain=0.5", navion).law, dt, on))
    assert [m["name"] for m in said["modes"]] == [m.name for m in expected]
    for one, other in zip(said["modes"], expected, strict=True):
        assert complex(*one["eigenvalue"]) == pytest.approx(other.eigenvalue, rel=1e-9)
    assert said["law"]["gains"] == {"yaw_damper": {"gain": 0.5, "washout": 3.0}}


def test_an_edited_aircraft_and_a_law_go_together(run: Run) -> None:
    changes = ("--set", "Cm_alpha=-0.3", "--set", "Cn_r*=2")
    said = json.loads(run("modes", "NAVION", *changes, "--law", "yaw_damper gain=0.5", "--json").stdout)
    plain = json.loads(run("modes", "NAVION", "--law", "yaw_damper gain=0.5", "--json").stdout)
    assert len(said["changes"]) == 2
    assert said["law"]["achieved"][0]["continuous"] > plain["law"]["achieved"][0]["continuous"]


def test_a_law_named_bare_prints_its_gains(run: Run) -> None:
    text = run("modes", "A-4D", "--law", "yaw_damper").stdout
    assert text.splitlines()[2] == "yaw_damper: gain 0.3520, washout 3.000"
    (row,) = [line.split() for line in text.splitlines() if line.startswith(" yaw_damper")]
    assert row[-5:] == ["0.4000", "0.1122", "0.4000", "0.4000", "0.4022"]
    assert "The closed loop, continuous, without actuators" in text


def test_a_wish_out_of_reach_is_told(run: Run) -> None:
    done = run("modes", "B747", "--law", "yaw_damper zeta=0.9")
    assert done.returncode == 0
    words = " ".join(done.stderr.split())
    assert "yaw_damper: zeta 0.9 is out of reach. The best that a positive gain attains is 0.242, at gain" in words


def test_margins_show_what_sensors_actuators_and_frames_cost(run: Run) -> None:
    words = ("modes", "A-4D", "--law", "yaw_damper gain=0.35; sensors lag=20ms delay=30ms", "--sampled", "60")
    text = run(*words, "--actuators").stdout
    assert max(map(len, text.splitlines())) <= 80
    at = text.index("Margins, the loop broken at one surface")
    rows = [line.split() for line in text[at:].splitlines() if " law alone " in line or " + " in line]
    assert rows[0][:3] == ["rudder", "law", "alone"]
    said = json.loads(run(*words, "--actuators", "--json").stdout)["margins"]
    assert [m["with"] for m in said] == ["law alone", "+ sensors", "+ actuators", "+ frames"]
    assert {m["surface"] for m in said} == {"rudder"}
    gains = [m["gain_margin_db"] for m in said]
    assert gains == sorted(gains, reverse=True)
    assert [float(row[-5]) for row in rows] == pytest.approx(gains, rel=6e-3)
    assert [float(row[-1]) for row in rows] == pytest.approx([1000.0 * m["delay_margin_s"] for m in said], rel=6e-3)


def test_a_law_without_a_loop_has_no_margins(run: Run) -> None:
    assert "Margins" not in run("modes", "A-4D", "--actuators").stdout
    assert json.loads(run("modes", "A-4D", "--actuators", "--json").stdout)["margins"] == []


def test_simulate_flies_the_law(run: Run, tmp_path: Path) -> None:
    done = run("simulate", "A-4D", "--initial", "beta=5deg", "--law", "yaw_damper", "--actuators", "--out", "run.csv")
    assert done.returncode == 0, done.stderr
    assert "yaw_damper: gain 0.3321" in done.stdout
    head, *_ = (tmp_path / "run.csv").read_text(encoding="utf-8").splitlines()
    assert "state_rudder_position [rad]" in head


def test_a_law_of_ones_own_is_flown(run: Run, tmp_path: Path) -> None:
    shelf = Path(__file__).parents[2] / "src/fdes/control/laws/roll_rate_damper.py"
    (tmp_path / "mine.py").write_text(shelf.read_text(encoding="utf-8"), encoding="utf-8")
    done = run("simulate", "A-4D", "--input", "step aileron 1deg", "--law", "./mine.py gain=0.2", "--out", "-")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    columns = [name.split(" ")[0] for name in lines[0].split(",")]
    row = dict(zip(columns, map(float, lines[-1].split(",")), strict=True))
    assert row["command_aileron"] == pytest.approx(np.radians(1.0) - 0.2 * row["p"], abs=1e-9)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("modes", "A-4D", "--law", "yaw_dampr"), "There is no law named 'yaw_dampr'. Did you mean 'yaw_damper'?"),
        (("modes", "A-4D", "--law", "./mine.py"), "There is no law in mine.py: it is no file."),
        (("modes", "A-4D", "--law", "yaw_damper", "--sampled", "0"), "A loop cannot be sampled 0 times a second:"),
        (("simulate", "A-4D", "--law", "yaw_damper zeta=2"), "cannot be designed for zeta 2"),
    ],
)
def test_mistakes_end_with_status_2(run: Run, words: tuple[str, ...], said: str) -> None:
    done = run(*words)
    assert done.returncode == 2
    assert said in " ".join(done.stderr.split())
