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


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["trim", "NAVION", "V=300 kt"], "the throttle would have to be"),
        (["trim", "NAVION", "V=300"], "V=300 has no unit. Write it like 'V=300 m/s'."),
        (["trim", "NAVION", "v=300 kt"], "Did you mean 'V'?"),
        (["trim", "A-7A"], "cannot fly nonlinear: its source gives dimensional derivatives"),
    ],
)
def test_mistakes(words: list[str], said: str) -> None:
    done = run(app, words)
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())
