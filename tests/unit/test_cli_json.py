"""What other programs read from the command line: names and types of all that `--json` prints."""

import json
import subprocess
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.cli import app
from fdes.physics.derivatives import Dimensional

NAVION = ["NAVION", "--condition", "M0.158_SL", "--form", "nelson", "--variant", "printed", "--json"]
ABOUT = {
    "aircraft": "NAVION",
    "condition": "M0.158_SL",
    "form": "nelson",
    "variant": "printed",
    "changes": [],
    "units": "SI",
}
MODE = ["name", "axis", "eigenvalue", "omega_n", "zeta", "time_constant", "time_to_half", "time_to_double", "period"]


def printed(*words: str) -> Any:
    result = CliRunner().invoke(app, [*words])
    assert result.exit_code == 0, result.output
    assert result.stderr == ""
    return json.loads(result.stdout)


def console(command: str, *words: str) -> Any:
    run = subprocess.run([command, *words], capture_output=True, text=True, check=True)
    assert run.stderr == ""
    return json.loads(run.stdout)


def test_modes_say_first_of_what_they_are(fdes_command: str) -> None:
    said = console(fdes_command, "modes", *NAVION)
    assert list(said) == [*ABOUT, "modes", "approximations", "static", "without_coefficients"]
    assert {key: said[key] for key in ABOUT} == ABOUT


def test_a_mode_has_the_promised_keys_and_types() -> None:
    for mode in printed("modes", *NAVION)["modes"]:
        assert list(mode)[: len(MODE)] == MODE
        assert mode["axis"] in {"longitudinal", "lateral"}
        re, im = mode["eigenvalue"]
        assert im >= 0.0
        assert mode["omega_n"] == pytest.approx(abs(complex(re, im)))
        assert (mode["period"] is None) == (im == 0.0)
        assert (mode["time_to_half"] is None) != (mode["time_to_double"] is None)
        assert (mode["time_constant"] is None) == (re >= 0.0)
        if im == 0.0:
            assert mode["zeta"] == (1.0 if re < 0.0 else -1.0)


def test_modes_are_those_of_the_book() -> None:
    modes = {mode["name"]: mode for mode in printed("modes", *NAVION)["modes"]}
    assert list(modes) == ["short_period", "phugoid", "roll", "dutch_roll", "spiral"]
    assert modes["phugoid"]["eigenvalue"] == pytest.approx([-0.0171, 0.213], rel=0.005)
    assert modes["short_period"]["eigenvalue"] == pytest.approx([-2.51, 2.59], rel=0.005)


def test_derivatives_have_matrices_with_names_and_units(fdes_command: str) -> None:
    said = console(fdes_command, "derivatives", *NAVION)
    assert list(said) == [*ABOUT, "longitudinal", "lateral", "dimensional"]
    assert {key: said[key] for key in ABOUT} == ABOUT
    for axis, states, inputs in (
        ("longitudinal", ["u", "w", "q", "theta"], ["elevator", "throttle"]),
        ("lateral", ["beta", "p", "r", "phi"], ["aileron", "rudder"]),
    ):
        assert list(said[axis]) == ["states", "inputs", "A", "B"]
        assert (said[axis]["states"], said[axis]["inputs"]) == (states, inputs)
        assert [len(row) for row in said[axis]["A"]] == [4] * 4
        assert [len(row) for row in said[axis]["B"]] == [2] * 4
    assert list(said["dimensional"]) == list(Dimensional._fields)
    assert said["dimensional"]["M_q"]["unit"] == "1/s"
    assert all(list(d) == ["value", "unit"] for d in said["dimensional"].values())


def test_conditions_and_names_are_the_canonical_ones_whatever_was_typed() -> None:
    said = printed("modes", "boeing 747", "--condition", "m0.90-40KFT", "--json")
    assert (said["aircraft"], said["condition"], said["form"], said["variant"]) == (
        "B747",
        "M0.90_40kft",
        "full",
        "corrected",
    )


def test_aircraft_are_listed_for_programs(fdes_command: str) -> None:
    listed = console(fdes_command, "aircraft", "list", "--json")
    assert [a["id"] for a in listed][:6] == ["A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar"]
    assert list(listed[0]) == ["id", "name", "summary", "aliases", "conditions", "source"]
    assert listed == printed("aircraft", "--json")


def test_every_number_of_an_aircraft_says_where_it_is_from() -> None:
    shown = printed("aircraft", "show", "A-4D", "--json")
    assert shown == printed("aircraft", "a4d", "--json")
    assert (shown["condition"], shown["variant"]) == ("M0.4_SL", "corrected")
    slip = shown["numbers"]["Cn_da"]
    assert (slip["printed"], slip["corrected"], slip["value"]) == (0.06, 0.006, 0.006)
    assert slip["reason"]
    assert slip["confidence"] in {"high", "medium", "low"}
    assert set(slip["sources"]) <= set(shown["sources"])
    assert set(shown["assumed"]["max_thrust"]) == {"value", "unit", "reason"}
