"""What `fdes trim` prints, and what it says when there is no trim."""

import json

import pytest
from typer.testing import CliRunner

from fdes.cli import app

run = CliRunner().invoke


def test_a_trim_as_a_table() -> None:
    done = run(app, ["trim", "NAVION", "V=90 kt h=5000 ft turn=3 deg/s"])
    assert done.exit_code == 0, done.output
    said = " ".join(done.stdout.split())
    assert "Ryan NAVION, M0.158_SL: V = 46.3 m/s, h = 1,524 m" in said
    assert "turn rate 3.000 deg/s" in said
    assert "elevator, from the condition's" in said
    notes = " ".join(done.stderr.split())
    assert "Assumed: the lift coefficient of the wing ends at 1.20" in notes
    assert "as of a propeller at constant power" in notes


def test_a_trim_as_json_is_that_of_the_condition_when_nothing_is_said() -> None:
    found = json.loads(run(app, ["trim", "B747", "--json"]).stdout)
    assert found["asked"]["turn"] == 0.0
    assert found["controls"].keys() == {"elevator", "aileron", "rudder", "throttle"}
    assert found["residual"] < 1e-9
    assert found["iterations"] <= 4
    assert len(found["notes"]) == 4


def test_an_edited_aircraft_is_trimmed_too() -> None:
    heavy = json.loads(run(app, ["trim", "B747", "--set", "Cm_alpha*=2", "V=95 m/s", "--json"]).stdout)
    usual = json.loads(run(app, ["trim", "B747", "V=95 m/s", "--json"]).stdout)
    assert abs(heavy["controls"]["elevator"]) > 1.5 * abs(usual["controls"]["elevator"])


def test_what_is_asked_for_and_what_follows() -> None:
    found = json.loads(run(app, ["trim", "F-16", "alpha=11 deg gamma=-3 deg h=0 m", "--json"]).stdout)
    assert "V" not in found["asked"]
    assert found["asked"]["alpha"] == pytest.approx(0.19199, abs=1e-5)
    assert found["flight"]["V"] == pytest.approx(81.64, abs=0.01)
    pull = json.loads(run(app, ["trim", "A-4D", "V=300 kt n=2", "--json"]).stdout)
    assert pull["asked"]["n"] == 2.0
    assert pull["flight"]["q"] > 0.0
    told = run(app, ["trim", "A-4D", "V=300 kt n=2"])
    assert "load factor n_z 2.000 g" in " ".join(told.stdout.split())


def test_a_stalled_flight_is_called_so() -> None:
    said = " ".join(run(app, ["trim", "NAVION", "V=60 kt gamma=-3 deg"]).stderr.split())
    assert "This is a stalled flight: its angle of attack of 29.2 deg is beyond the" in said
    assert "stalled flight" not in run(app, ["trim", "NAVION"]).stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["trim", "NAVION", "V=300 kt"], "the throttle would have to be"),
        (["trim", "A-4D", "V=5 m/s h=0 ft"], "the throttle would have to be -2.291, and stops at 0. "),
        (["trim", "NAVION", "V=300 kt"], "With a throttle of 1 its path would be -"),
        (["trim", "B747", "V=250 kt beta=14 deg"], "the aileron would have to be 63.6 deg, and stops at 25 deg"),
        (["trim", "A-4D", "V=200 kt h=5000 ft n=2"], "m/s^2 downward, for lift falls short"),
        (["trim", "A-4D", "V=90 kt CAS=80 kt"], "Both V and CAS are given for the trim (how fast it flies)"),
        (["trim", "A-4D", "bank=20 deg turn=3 deg/s"], "or say turn=0 for a straight sideslip with that bank"),
        (["trim", "A-4D", "alpha=8 deg", "--heights", "0 ft"], "an angle of attack fixes one: leave alpha out"),
        (["trim", "NAVION", "V=300"], "V=300 has no unit. Write it like 'V=300 m/s'."),
        (["trim", "NAVION", "v=300 kt"], "Did you mean 'V'?"),
        (["trim", "A-7A"], "cannot fly nonlinear: its source gives dimensional derivatives"),
    ],
)
def test_mistakes(words: list[str], said: str) -> None:
    done = run(app, words)
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())
