"""What is said of scenario files, and the flight that their documentation shows."""

import csv
import re
import tomllib
from math import radians
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from fdes.cli import app
from fdes.control.laws.direct import Direct
from fdes.errors import NoSuchPart, SpecError
from fdes.flight import HandsOff, Setup, SteadyAir, fly
from fdes.flight.scenario import SHIPPED, fly_scenario, load_scenario, scenario_names, scenario_of
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
        ({"earth": {"a": 1}}, r"There is no Earth named"),
        ({"rates_from": ["earth"]}, r"rates_from is \['earth'\]; it must be"),
        ({"rates_from": "stars"}, r'rates_from is \'stars\'; it must be "earth" or "inertial"'),
        ({"air": {"wnd_east": "3 m/s"}}, r"air\.wnd_east is not a known key\. Did you mean 'wind_east'\?"),
    ],
)
def test_mistakes_in_a_file(change: dict, words: str) -> None:
    with pytest.raises((SpecError, NoSuchPart), match=words):
        scenario_of(tomllib.loads(SHOWN) | change)


VEHICLE = (SHIPPED / "nesc_13_1_f16_altitude.toml").read_text("utf-8")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"body": {"mass": "1 kg"}}, r"flies either a \[body\] or a \[vehicle\]: give one of the two"),
        ({"vehicle": {}}, r'vehicle\.aircraft is missing: name one, such as "F-16"'),
        ({"vehicle": {"aircraft": "F-17"}}, r"no aircraft named 'F-17'\. Did you mean 'F-16'\?"),
        ({"vehicle": {"aircraft": "F-16", "rotor": 1}}, r"vehicle\.rotor is 1; it must be true or false"),
        (
            {"vehicle": {"aircraft": "F-16", "power": "levr"}},
            r"no kind of vehicle\.power named 'levr'\. Did you mean 'lever'",
        ),
        (
            {"vehicle": {"aircraft": "A-4D", "power": "lever"}},
            r"The thrust of the A-4D follows its lever already: leave vehicle\.power out",
        ),
        ({"law": "yaw_damper zeta=0.3"}, r"gain of yaw_damper is not said, and in a scenario nothing is designed"),
        (
            {"law": {"name": "autopilot"}},
            r"it must be a text such as 'yaw_damper gain=0\.5', or have name = 'f16_autopilot'",
        ),
        (
            {"law": {"name": "f16_autopilot", "altitud": "1 ft"}},
            r"law\.altitud is not a known key\. Did you mean 'altitude'",
        ),
        ({"law": "yaw_damper gain=0.3"}, r"commands are for a law that takes some"),
        ({"commands": [{"altitude": "1 ft"}]}, r"commands\.at is missing: give it with a unit of the kind of s"),
        ({"commands": 3}, r"commands are tables, each under \[\[commands\]\]"),
        ({"inputs": "step elevator 1deg"}, r"inputs is no list of texts"),
        (
            {"initial": {"latitude": "91 deg", "longitude": "0 deg", "height": "0 m"}},
            r"initial\.latitude is 91 deg; it must be between",
        ),
        ({"air": {"wind_east": "3 m/s"}}, r'initial\.theta = "trim" is for calm air'),
        (
            {"earth": "flat", "initial": {"height": "9 km", "v_north": "170 m/s", "theta": "trim"}},
            r"is for a round Earth",
        ),
    ],
)
def test_mistakes_in_a_vehicle(change: dict, words: str) -> None:
    with pytest.raises((SpecError, NoSuchPart), match=words):
        scenario_of(tomllib.loads(VEHICLE) | change)


def test_what_a_trim_finds_is_not_said() -> None:
    document = tomllib.loads(VEHICLE)
    document["initial"] |= {"phi": "3 deg"}
    with pytest.raises(SpecError, match=r'initial\.phi is found where theta is "trim": leave it out'):
        scenario_of(document)
    del document["initial"]["phi"], document["initial"]["v_north"], document["initial"]["v_east"]
    with pytest.raises(SpecError, match="a vehicle in trim must go somewhere"):
        scenario_of(document)


def test_a_body_has_no_surfaces() -> None:
    with pytest.raises(SpecError, match=r"inputs is for a \[vehicle\]: a \[body\] has no surfaces"):
        scenario_of(tomllib.loads(SHOWN) | {"inputs": ["step elevator 1deg"]})


def test_a_vehicle_flown_as_it_is_told() -> None:
    """Without a trim: surfaces as given, a law with its gain, inputs, and rows every so many steps."""
    document = tomllib.loads(VEHICLE)
    del document["law"], document["commands"]
    document["initial"] |= {"theta": "2.64 deg", "psi": "45 deg", "elevator": "-3.23 deg", "throttle": 0.1387}
    document |= {"duration": "3 s", "law": "yaw_damper gain=0.3", "inputs": ["doublet rudder 2deg at 1s for 1s"]}
    flight = fly_scenario(scenario_of(document))
    assert flight["t"].tolist() == pytest.approx([0.1 * k for k in range(31)])
    assert abs(flight["r"][8]) < 1e-3 < abs(flight["r"][14])
    assert flight["theta"][5] == pytest.approx(radians(2.64), abs=2e-3)


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
    (tmp_path / "noise.toml").write_bytes(b"a\xff\xfe")
    with pytest.raises(SpecError, match=r"noise\.toml cannot be used: it is not text in UTF-8\.$"):
        load_scenario(tmp_path / "noise.toml")
    assert len(scenario_names()) == 8


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
    assert "25 comparisons: 25 passed, 0 failed" in done.output
    page = out.read_text(encoding="utf-8")
    assert "difference of altitudeMsl_ft" in page
    assert page.count("<table>") == 8
