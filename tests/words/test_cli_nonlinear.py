"""`fdes linearize` and `fdes simulate --plant nonlinear`."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fdes.cli import app

run = CliRunner().invoke


def test_a_linearization_as_tables_and_as_json() -> None:
    shown = run(app, ["linearize", "A-4D", "mach=0.5 h=10000 ft"])
    assert shown.exit_code == 0, shown.output
    assert "short period" in shown.stdout
    assert "Assumed: the lift coefficient" in shown.stderr
    found = json.loads(run(app, ["linearize", "A-4D", "mach=0.5 h=10000 ft", "--json"]).stdout)
    assert [len(found[name]) for name in "ABCD"] == [8, 8, 18, 18]
    assert found["states"][:3] == ["u", "w", "q"]
    assert found["units"]["n_z"] == "1"


def test_thrust_may_be_held() -> None:
    drag = [
        json.loads(run(app, ["linearize", "NAVION", "--json", *more]).stdout)["A"][0][0]
        for more in ([], ["--thrust-held"])
    ]
    assert drag[0] < drag[1] < 0.0


def test_a_nonlinear_flight_is_written_like_a_linear_one(tmp_path: Path) -> None:
    out, words = tmp_path / "run.csv", ["--plant", "nonlinear", "--duration", "1", "-i", "step aileron 2deg"]
    done = run(app, ["simulate", "NAVION", *words, "--trim", "V=100 kt h=2000 ft", "--out", str(out)])
    assert done.exit_code == 0, done.output
    assert "Assumed: thrust changes" in done.stderr
    header, first, *_ = out.read_text(encoding="utf-8").splitlines()
    assert header.startswith("t [s],V [m/s]")
    assert float(first.split(",")[1]) == pytest.approx(51.44, abs=0.01)
    shown = run(app, ["simulate", "NAVION", *words])
    assert "at the start" in shown.stdout


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["simulate", "A-4D", "--plant", "nonlinaer"], "Did you mean 'nonlinear'?"),
        (["simulate", "A-4D", "--trim", "V=300 kt"], "give --trim with --plant nonlinear"),
        (["simulate", "A-4D", "--plant", "nonlinear", "--actuators"], "The nonlinear plant has no actuators"),
        (["linearize", "A-4D", "turn=3 deg/s"], "Only straight flight without sideslip is linearized"),
    ],
)
def test_mistakes(words: list[str], said: str) -> None:
    done = run(app, words)
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())


def test_names_of_a_scenario_are_not_silently_left_out() -> None:
    done = run(app, ["simulate", "F-16", "--plant", "nonlinear", "--names", "s119", "--duration", "1"])
    assert done.exit_code == 2
    assert "--names s119 is for a scenario, which says where on Earth it flies: give a --scenario." in done.stderr


def test_spool_where_it_means_nothing() -> None:
    own = CliRunner().invoke(app, ["simulate", "F-16", "--plant", "nonlinear", "--spool"])
    assert own.exit_code == 2
    assert (
        "The engine of the F-16 follows its throttle with a lag of its own, which always acts. Leave --spool out."
        in " ".join(own.output.split())
    )
    linear = CliRunner().invoke(app, ["simulate", "A-4D", "--spool"])
    assert linear.exit_code == 2
    assert "The thrust of the linear plant follows at once: give --spool with --plant nonlinear." in " ".join(
        linear.output.split()
    )
