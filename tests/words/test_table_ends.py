"""A flight that leaves the tables of its plant goes on, and says so."""

import json

from typer.testing import CliRunner

from fdes.aircraft import load
from fdes.analysis.nonlinear_response import simulate_nonlinear
from fdes.cli import app
from fdes.flight.nonlinear import six_dof_of
from fdes.flight.simulation import Clock
from fdes.flight.table_ends import table_ends
from fdes.units import DEG, FOOT

NOT_THEIRS = "What is computed there is no longer the source's."


def notes(*arguments: str) -> list[str]:
    result = CliRunner().invoke(app, [*arguments, "--json"])
    assert result.exit_code == 0, result.output
    said: list[str] = json.loads(result.stdout)["notes"]
    return said


def test_a_trim_beyond_the_tables() -> None:
    (said,) = [n for n in notes("trim", "F-16", "V=130 ft/s h=0 ft") if "beyond its" in n]
    assert said == f"alpha is beyond its tables: it reaches 47.31 deg, and they end at 45 deg. {NOT_THEIRS}"
    (said,) = [n for n in notes("linearize", "F-16", "V=1300 ft/s h=0 ft") if "beyond its" in n]
    assert said == f"mach is beyond its tables: it reaches 1.164, and they end at 1. {NOT_THEIRS}"
    assert not [n for n in notes("trim", "F-16", "V=502 ft/s h=0 ft") if "beyond its" in n]


def test_a_flight_that_leaves_the_tables() -> None:
    condition = load("F-16").at()
    calm, pulled = (
        simulate_nonlinear(condition, inputs, clock=Clock(0.02, duration=4.0))
        for inputs in ([], ["step elevator -30deg at 1s"])
    )
    assert not [n for n in calm.header["assumptions"] if "beyond its tables" in n]
    found = [n for n in pulled.header["assumptions"] if "beyond its tables" in n]
    elevator = "elevator is beyond its tables from t = 1.02 s on: it reaches -30.76 deg, and they end at -24 deg. "
    assert elevator + NOT_THEIRS in found
    assert pulled["alpha"].max() > 45.0 * DEG
    assert any(n.startswith("alpha is beyond its tables from t = ") for n in found)


def test_the_ends() -> None:
    found = table_ends(six_dof_of(load("F-16").at()))
    assert set(found) == {"alpha", "beta", "elevator", "mach", "h"}
    assert found["h"] == (0.0, 50000.0 * FOOT)
    assert table_ends(six_dof_of(load("A-4D").at())) == {}


def test_a_changed_derivative_does_not_change_tables() -> None:
    result = CliRunner().invoke(app, ["trim", "F-16", "--set", "Cm_alpha=-0.5"])
    assert result.exit_code == 2
    said = " ".join(result.output.split())
    assert (
        "F-16 cannot fly nonlinear with Cm_alpha changed: there its aerodynamics are tables, not derivatives." in said
    )
    moved = CliRunner().invoke(app, ["trim", "F-16", "--set", "cg=0.3", "--json"])
    assert round(json.loads(moved.stdout)["alpha"], 5) == 0.03937
