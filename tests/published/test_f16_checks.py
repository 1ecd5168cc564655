"""The F-16 against the numbers that Stevens, Lewis and Johnson print of it, and against NASA's trimmed flight."""

import copy
import json

import numpy as np
import pytest
from typer.testing import CliRunner

from fdes.aircraft import load
from fdes.analysis import f16_checks as module
from fdes.analysis.f16_checks import BOOK, f16_checks
from fdes.analysis.trim import TrimSpec, trim
from fdes.analysis.verify import Check
from fdes.cli import app
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.signals import Air
from fdes.sources import sources
from fdes.units import DEG, FOOT

FOUND = f16_checks()


@pytest.mark.parametrize("check", FOUND, ids=lambda c: f"{c.item} {c.quantity} {c.verdict}")
def test_as_printed(check: Check) -> None:
    assert check.passed, f"{check.published} in {check.where}; computed {check.computed:.9g}"


def test_every_printed_number_is_held_but_one() -> None:
    """4 trims, 16 speeds, one state derivative, one matrix: and the slope that is theirs by finite differences."""
    held = {(c.item, c.quantity) for c in FOUND if c.verdict == "ok"}
    assert {(c.item, c.quantity) for c in FOUND} - held == {("F16_LINEAR", "A[V, alpha]")}
    assert len(held) == 16 * 3 + 3 * 3 + 10 + 13 + 20 - 1


def test_where_the_tables_of_the_file_make_something_else() -> None:
    """The reasoned list: beyond 45 deg, in the turn, where sideslip is large, and by the book's rounded constants."""
    other = {(c.item, c.quantity) for c in FOUND if c.verdict == "no check"} - {("F16_LINEAR", "A[V, alpha]")}
    assert {quantity for item, quantity in other if item == "F16_SPEEDS"} == {
        f"{name} at 130 ft/s" for name in ("throttle", "alpha_deg", "elevator")
    }
    assert {q for item, q in other if item == "F16_TRIMS"} == {"turn: aileron", "turn: rudder"}
    rest = {q for item, q in other if item in {"F16_DERIVATIVE", "F16_LINEAR"}}
    assert rest == {
        *("V_dot", "alpha_dot", "p_dot", "q_dot", "r_dot", "power_dot"),
        *("A[q, alpha]", "A[q, q]", "B[q, elevator]"),
    }


@pytest.mark.parametrize("part", ["speeds", "trims", "state_derivative", "linear", "lineage"])
def test_one_wrong_number_is_seen(part: str, monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = copy.deepcopy({BOOK: sources()[BOOK]})
    book = wrong[BOOK]["f16"]
    if part == "trims":
        book["trims"]["nominal"]["published"]["alpha"] *= 1.01
    elif part == "state_derivative":
        book[part]["published"][0] *= 1.01
    else:
        rows = book[part][{"speeds": "rows", "linear": "A", "lineage": "tables"}[part]]
        rows[-3][-1] = rows[-3][-1] * 1.1 + 0.05
    monkeypatch.setattr(module, "sources", lambda: wrong)
    assert any(check.verdict == "failed" for check in f16_checks())


def test_on_the_command_line() -> None:
    result = CliRunner().invoke(app, ["verify", "f16"])
    assert result.exit_code == 0
    *_, shown, last = result.stdout.strip().splitlines()
    assert last == "99 checks: 99 passed, 0 failed"
    assert shown.startswith("15 more numbers are shown")
    assert max(map(len, result.stdout.splitlines())) <= 80


def test_trim_on_the_command_line_has_the_printed_digits() -> None:
    """Table 3.6-3, nominal: alpha 0.03691, elevator -0.7588 deg. The throttle, 0.1385, is that of the book's air."""
    result = CliRunner().invoke(app, ["trim", "F-16", "V=502 ft/s h=0 ft", "--json"])
    assert result.exit_code == 0, result.output
    said = json.loads(result.stdout)
    assert round(said["alpha"], 5) == 0.03691
    assert round(said["controls"]["elevator"] / DEG, 4) == -0.7588
    assert said["controls"]["throttle"] == pytest.approx(0.1385, abs=1e-4)
    assert said["state"]["power"] == pytest.approx(64.94 * said["controls"]["throttle"], rel=1e-12)


def test_trim_of_the_check_case() -> None:
    """F16_README.html of NASA/TM-2015-218675: 2.6538 deg, elevator -3.241 deg, throttle 13.9019 % by constant gravity.

    Their throttle is FDES's power, which the engine's own line makes of the throttle.
    """
    condition = load("F-16").at("M0.53_10kft")
    point = trim(six_dof_of(condition), TrimSpec(565.685 * FOOT, 10013.0 * FOOT))
    assert point.alpha / DEG == pytest.approx(2.6538, abs=5e-4)
    assert point.surfaces.elevator / DEG == pytest.approx(-3.241, abs=5e-4)
    assert point.state.power == pytest.approx(13.9019, abs=1e-3)


def test_power_follows_the_throttle_and_the_airplane_the_power() -> None:
    """Full throttle from trim: power for 60 by its lag, past 50, then for 100 at 5 per second."""
    condition = load("F-16").at("M0.53_10kft")
    plant = trim(six_dof_of(condition), TrimSpec(565.685 * FOOT, 10013.0 * FOOT)).plant
    x, held = plant.start(), plant.trim()._replace(throttle=1.0)
    speeds, powers = [x.u], [x.power]
    for _ in range(500):
        x = plant.advance(x, held, Air(), 0.01)
        speeds.append(x.u)
        powers.append(x.power)
    assert np.all(np.diff(powers) > 0.0)
    assert powers[-1] == pytest.approx(100.0, abs=0.01)
    behind = 60.0 - powers[0]
    assert (powers[1] - powers[0]) / 0.01 == pytest.approx((1.9 - 0.036 * behind) * behind, rel=0.01)
    assert speeds[-1] > speeds[0] + 15.0
