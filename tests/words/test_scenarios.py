"""What is said of scenario files, and the flight that their documentation shows."""

import csv
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from fdes.cli import app
from fdes.control.laws.direct import Direct
from fdes.errors import NoSuchPart, SpecError
from fdes.flight import HandsOff, Setup, SteadyAir, fly
from fdes.flight.scenario import fly_scenario, load_scenario, scenario_names, scenario_of
from fdes.physics.signals import Surfaces

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "scenarios.md"
SHOWN = re.findall(r"```toml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)[0]
run = CliRunner().invoke


def test_the_documented_file_flies(tmp_path: Path) -> None:
    path = tmp_path / "barrel.toml"
    path.write_text(SHOWN, encoding="utf-8")
    flight = fly_scenario(load_scenario(path))
    assert flight["h"][0] == pytest.approx(120.0)
    assert 35.0 < flight["h"][-1] < 55.0
    assert flight["state_q"][0] == pytest.approx(np.radians(200.0), abs=1e-4)  # in inertial space
    assert flight["V"][0] == pytest.approx(np.hypot(3.0, 6.0 + 0.02 * 120.0))


def test_the_loop_that_flies_linear_aircraft_flies_it_unchanged() -> None:
    scenario = load_scenario("nesc_02_tumbling_brick")
    setup = Setup(scenario.plant, Direct(Surfaces()))
    frames = list(fly(scenario.plant.start(1000.0), setup, HandsOff(0.0), SteadyAir(), scenario.clock))
    assert len(frames) == 301
    again = scenario.plant.observe(frames[100].state, frames[100].held, frames[100].air)
    assert again == frames[100].outputs


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"earht": "flat"}, r"earht is not a known key\. Did you mean 'earth'\?"),
        ({"format": 2}, r"format is 2; this FDES reads format = 1"),
        ({"earth": "mars"}, r"There is no Earth named 'mars'\."),
        ({"integrator": "rk5"}, r"no integrator named 'rk5'\. Did you mean 'rk4'\?"),
        ({"body": 3}, r"body is 3; it must be a table, under \[body\]"),
        ({"body": {"mass": "3 ft"}}, r"body\.mass: '3 ft' is in ft, which is not a unit of this quantity"),
        ({"body": {"mass": 3.0}}, r'body\.mass is 3 without a unit\. Write it like "3 kg"'),
        ({"body": {"mass": "3 kg", "Ix": True}}, r"body\.Ix is True; it must be a number with a unit, in quotes"),
        ({"body": {"mas": "3 kg"}}, r"body\.mas is not a known key\. Did you mean 'mass'\?"),
        ({"body": {}}, r"body\.mass is missing: give it with a unit of the kind of kg"),
        ({"rates_from": "stars"}, r'rates_from is \'stars\'; it must be "earth" or "inertial"'),
        ({"air": {"wnd_east": "3 m/s"}}, r"air\.wnd_east is not a known key\. Did you mean 'wind_east'\?"),
    ],
)
def test_mistakes_in_a_file(change: dict, words: str) -> None:
    with pytest.raises((SpecError, NoSuchPart), match=words):
        scenario_of(tomllib.loads(SHOWN) | change)


def test_a_mass_of_nothing_is_refused() -> None:
    document = tomllib.loads(SHOWN)
    document["body"]["mass"] = "0 kg"
    with pytest.raises(SpecError, match=r"body\.mass is 0 kg; it must be greater than zero"):
        scenario_of(document)
    document["body"] |= {"mass": "1 kg", "Iz": "20 kg m^2"}
    with pytest.raises(SpecError, match="No body has such moments of inertia"):
        scenario_of(document)


def test_names_of_files(tmp_path: Path) -> None:
    with pytest.raises(NoSuchPart, match="Did you mean 'nesc_02_tumbling_brick'"):
        load_scenario("nesc_02_tumbling_brik")
    with pytest.raises(SpecError, match=r"none\.toml cannot be read: No such file"):
        load_scenario(tmp_path / "none.toml")
    (tmp_path / "bad.toml").write_text("a = ", encoding="utf-8")
    with pytest.raises(SpecError, match=r"bad\.toml is not TOML"):
        load_scenario(tmp_path / "bad.toml")
    assert len(scenario_names()) == 6


def test_on_the_command_line(tmp_path: Path) -> None:
    out = tmp_path / "run.csv"
    done = run(app, ["simulate", "--scenario", "nesc_01_dropped_sphere", "--names", "s119", "--out", str(out)])
    assert done.exit_code == 0, done.output
    rows = list(csv.DictReader(out.open(encoding="utf-8")))
    assert len(rows) == 301
    assert float(rows[-1]["altitudeMsl_ft"]) == pytest.approx(15598.904352, abs=1e-5)
    assert {"feVelocity_ft_s_X", "eulerAngle_deg_Roll", "bodyAngularRateWrtEi_deg_s_Roll"} <= rows[0].keys()
    shown = run(app, ["simulate", "--scenario", "nesc_01_dropped_sphere"])
    assert "at t = 30 s" in shown.output
    assert "4754.546 m\n" in shown.output
    assert run(app, ["simulate", "--scenario", "nesc_01_dropped_sphere", "--out", "-"]).output.startswith(
        "t [s],V [m/s]"
    )


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["simulate"], "name an aircraft, as in fdes simulate A-4D"),
        (["simulate", "A-4D", "--scenario", "nesc_01_dropped_sphere"], "A scenario says all of its flight"),
        (["simulate", "--scenario", "nesc_01_dropped_sphere", "--names", "s120"], "Did you mean 's119'?"),
        (["simulate", "--scenario", "nesc_01_dropped_sphere", "--out", "run.nc"], "ends in .csv"),
        (["verify", "nesc", "--out", "report.pdf"], "ends in .html"),
    ],
)
def test_mistakes_on_the_command_line(words: list[str], said: str) -> None:
    done = run(app, words)
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())


def test_verify_nesc_writes_a_report(tmp_path: Path) -> None:
    out = tmp_path / "nesc.html"
    done = run(app, ["verify", "nesc", "--out", str(out)])
    assert done.exit_code == 0, done.output
    assert "21 comparisons: 21 passed, 0 failed" in done.output
    page = out.read_text(encoding="utf-8")
    assert "difference of altitudeMsl_ft" in page
    assert page.count("<table>") == 6
