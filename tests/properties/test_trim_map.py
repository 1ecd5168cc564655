"""Trim over speed and height, and what it says of performance."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from fdes.aircraft import load
from fdes.analysis.trim import TrimSpec, shortfalls, solve
from fdes.analysis.trim_map import TrimLine, drawn, trim_map
from fdes.cli import app
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.atmosphere import standard_atmosphere

run = CliRunner().invoke
NAVION = load("NAVION").at()
PLANT = six_dof_of(NAVION)
SPEC = TrimSpec(NAVION.reference.V, NAVION.reference.h)
LOW, HIGH = trim_map(PLANT, SPEC, [0.0, 3000.0])


@pytest.mark.parametrize("line", [LOW, HIGH], ids=["low", "high"])
def test_its_ends_are_ends(line: TrimLine) -> None:
    slowest, fastest = line.speeds[0], line.speeds[-1]
    assert not any(shortfalls(point, PLANT.limits) for point in line.points)
    for V, words in ((0.995 * slowest, line.slow_end), (1.005 * fastest, line.fast_end)):
        assert shortfalls(solve(PLANT, TrimSpec(V, line.h)), PLANT.limits)
        assert words


def test_thrust_equals_drag_along_the_line() -> None:
    """The required thrust against the polar of the file, at the lift that balances weight and thrust."""
    aero, rho, weight = PLANT.aero, standard_atmosphere(0.0).rho, PLANT.inertia.m * 9.80665
    for point, T in list(zip(LOW.points, LOW.required, strict=True))[10:]:
        qS = 0.5 * rho * point.spec.V**2 * aero.S
        CL = aero.k.CL + aero.k.CL_alpha * (point.alpha - aero.alpha_0)
        drag = qS * (aero.CD_0 + aero.K * CL**2)
        inclined = math.cos(point.alpha + PLANT.engine.tilt)
        assert pytest.approx(drag / inclined, rel=1e-9) == T
    assert weight > 0.0


def test_least_drag_is_where_the_polar_says() -> None:
    """Where induced and zero-lift drag are equal: CL = sqrt(CD_0 / K). Anderson, eq. 5.27."""
    best = LOW.points[int(np.argmin(LOW.required))]
    aero = PLANT.aero
    CL = aero.k.CL + aero.k.CL_alpha * (best.alpha - aero.alpha_0)
    assert pytest.approx(math.sqrt(aero.CD_0 / aero.K), rel=0.1) == CL  # one point of 41


def test_thin_air_needs_more_speed_and_leaves_less_power() -> None:
    assert HIGH.speeds[0] > LOW.speeds[0]
    assert max(HIGH.excess_power()) < max(LOW.excess_power())
    assert LOW.excess_power()[-1] == pytest.approx(0.0, abs=0.1)  # the fastest flight is that at full throttle


def test_excess_power_is_the_climb_that_full_throttle_allows() -> None:
    """To first order: a trim at that climb rate needs nearly all of the throttle."""
    k = len(LOW.points) // 2
    V, climb = LOW.speeds[k], LOW.excess_power()[k]
    climbing = solve(PLANT, TrimSpec(V, 0.0, gamma=math.asin(climb / V)))
    assert climbing.surfaces.throttle == pytest.approx(1.0, abs=0.01)


def test_heights_that_cannot_be_flown_are_left_out() -> None:
    assert [line.h for line in trim_map(PLANT, SPEC, [0.0, 20000.0])] == [0.0]


def test_every_panel_has_a_curve_for_each_height() -> None:
    drawing = drawn([LOW, HIGH], "NAVION")
    assert [len(panel.curves) for panel in drawing.panels] == [2] * 5
    assert all(len(curve.x) == len(curve.y) == 41 for panel in drawing.panels for curve in panel.curves)


def test_on_the_command_line(tmp_path: Path) -> None:
    picture = tmp_path / "map.svg"
    done = run(app, ["trim", "NAVION", "--heights", "0 ft, 6000 ft", "--plot", str(picture)])
    assert done.exit_code == 0, done.output
    assert "At 0 m, faster: the throttle would have to be 1.0" in done.stdout
    assert "least power" in done.stdout
    assert picture.read_text(encoding="utf-8").startswith("<?xml")
    found = json.loads(run(app, ["trim", "NAVION", "--heights", "0 ft", "--json"]).stdout)["lines"][0]
    assert len(found["V"]) == len(found["throttle"]) == 41
    none = run(app, ["trim", "NAVION", "--heights", "25 km"])
    assert none.exit_code == 2
    assert "At none of these heights can it be flown" in none.stderr
