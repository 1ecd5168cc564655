"""`fdes linearize` and `fdes simulate --plant nonlinear`."""

import json
from csv import DictReader
from pathlib import Path

import numpy as np
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


def test_a_linearization_with_a_law() -> None:
    """Put together by hand from the open loop: rudder = gain (r - x), x' = (r - x) / washout, r along the body axis."""
    shown = run(app, ["linearize", "A-4D", "--law", "yaw_damper gain=0.5"])
    assert shown.exit_code == 0, shown.output
    assert "yaw_damper: gain 0.5" in shown.stdout
    found = json.loads(run(app, ["linearize", "A-4D", "--law", "yaw_damper gain=0.5", "--json"]).stdout)
    assert found["states"][-1] == "yaw_washout"
    assert "stick_yaw" in found["inputs"]
    open_loop = json.loads(run(app, ["linearize", "A-4D", "--json"]).stdout)
    A, B, C = (np.array(open_loop[name]) for name in "ABC")
    b, c = B[:, open_loop["inputs"].index("rudder")], C[open_loop["outputs"].index("r")]
    gain, washout = 0.5, 3.0
    by_hand = np.block([
        [A + gain * np.outer(b, c), -gain * b[:, None]],
        [c[None, :] / washout, np.array([[-1.0 / washout]])],
    ])  # fmt: skip
    np.testing.assert_allclose(
        np.sort_complex(np.linalg.eigvals(np.array(found["A"]))), np.sort_complex(np.linalg.eigvals(by_hand)), atol=1e-9
    )


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


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--names", "s119"], "--names s119 is of flights over an Earth: give --plant nonlinear with it."),
        (["--plant", "nonlinear", "--names", "s119"], "--names s119 are columns of a CSV file: name one with --out"),
        (["--plant", "nonlinear", "--names", "s120"], "Did you mean 's119'?"),
        (["--earth", "wgs84"], "The linear plant knows no Earth: give --earth and --at with --plant nonlinear."),
        (["--plant", "nonlinear", "--earth", "mars"], "There is no Earth named 'mars'."),
        (["--plant", "nonlinear", "--at", "latitude=3 deg"], "--at is a place on a round Earth: give --earth wgs84"),
        (["--plant", "nonlinear", "--earth", "round", "--at", "lat=3 deg"], "Did you mean 'latitude'?"),
        (["--plant", "nonlinear", "--earth", "round", "--at", "latitude=3"], "latitude=3 has no unit."),
        (["--plant", "nonlinear", "--earth", "round", "--at", "latitude=91deg"], "no direction is north."),
        (["--plant", "nonlinear", "--earth", "round", "--at", "here"], "--at 'here' cannot be read."),
        (["--plant", "nonlinear", "--earth", "round", "--trim", "bank=30 deg"], "give V, h and gamma alone"),
        (["--plant", "nonlinear", "--earth", "round", "--initial", "u=1 m/s"], "takes no initial perturbation"),
        (["--rate", "33"], "--rate 33 rows a second cannot be taken from frames 0.01 s apart: let it be 100 divided"),
        (["--rate", "0"], "--rate 0 rows a second cannot be taken"),
    ],
)
def test_mistakes_over_an_earth(words: list[str], said: str) -> None:
    done = run(app, ["simulate", "F-16", "--duration", "1", *words])
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())


def test_a_flight_over_the_earth_under_the_names_of_the_check_cases(tmp_path: Path) -> None:
    """Ten rows a second of a hundred flown, over the turning Earth."""
    file = tmp_path / "run.csv"
    words = ["--plant", "nonlinear", "--earth", "wgs84", "--trim", "V=565.685 ft/s h=10013 ft", "--duration", "2"]
    place = ["--at", "latitude=36.01916667 deg longitude=-75.67444444 deg heading=45 deg"]
    done = run(app, ["simulate", "F-16", *words, *place, "--rate", "10", "--names", "s119", "--out", str(file)])
    assert done.exit_code == 0
    assert f"{file}: 21 rows" in " ".join(done.stdout.split())
    with file.open(encoding="utf-8") as rows:
        flown = [{name: float(value) for name, value in row.items()} for row in DictReader(rows)]
    assert flown[-1]["time"] == pytest.approx(2.0)
    assert flown[0]["latitude_deg"] == pytest.approx(36.01916667)
    assert flown[0]["feVelocity_ft_s_X"] == pytest.approx(400.0, abs=1e-3)
    assert flown[-1]["altitudeMsl_ft"] == pytest.approx(10013.0, abs=0.01)
    assert flown[-1]["eulerAngle_deg_Yaw"] == pytest.approx(45.0, abs=0.02)


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
