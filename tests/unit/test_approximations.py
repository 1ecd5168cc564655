"""Approximate modes are near the exact ones where the textbook says so; static figures follow their definitions."""

from dataclasses import replace

import pytest

from fdes.aircraft import catalogue, load
from fdes.analysis import modes
from fdes.analysis.approximations import approximate_modes, static_figures
from fdes.analysis.linearize import linear_model
from fdes.analysis.measured import measure


@pytest.mark.parametrize("name", ["short_period", "roll", "dutch_roll"])
def test_fast_modes_are_well_approximated(name: str) -> None:
    """Within 15 % in frequency for the NAVION; the spiral is not, by a factor of fifteen, as the book remarks."""
    condition = load("NAVION").at()
    approximate = {a.name: a.eigenvalue for a in approximate_modes(condition)}
    exact = {m.name: m.eigenvalue for m in modes(condition, "nelson")}
    assert abs(approximate[name]) == pytest.approx(abs(exact[name]), rel=0.15)
    assert abs(approximate["spiral"]) > 10.0 * abs(exact["spiral"])


def test_a_split_short_period_is_a_real_root() -> None:
    condition = load("NAVION").at()
    unstable = replace(condition, aerodynamics=condition.coefficients._replace(Cm_alpha=0.6))
    found = next(a for a in approximate_modes(unstable) if a.name == "short_period")
    assert found.eigenvalue.imag == 0.0
    assert found.eigenvalue.real > 0.0
    assert static_figures(unstable).maneuver_margin < 0.0


def test_static_figures_of_the_navion() -> None:
    condition = load("NAVION").at("M0.158_SL", variant="printed")
    figures = static_figures(condition, cg=0.295)
    assert figures.static_margin == pytest.approx(0.683 / 4.44)
    assert figures.neutral_point == pytest.approx(0.295 + 0.683 / 4.44)
    assert figures.maneuver_margin > figures.static_margin
    assert figures.roll_rate == pytest.approx(0.134 / 0.41 * 2 * 176 / 33.4)


def test_level_flight_needs_the_load_factor_that_alpha_gives() -> None:
    """n per radian is CL_alpha / CL where weight and lift agree."""
    for aircraft in catalogue():
        condition = aircraft.at()
        if not condition.nondimensional:
            continue
        figures = static_figures(condition)
        k = condition.coefficients
        assert figures.n_alpha_lift == pytest.approx(k.CL_alpha / k.CL, rel=0.2), aircraft.id
        assert figures.n_alpha == measure(linear_model(condition)).n_alpha, "as the qualities have it"
        assert figures.n_alpha == pytest.approx(figures.n_alpha_lift, rel=0.25), aircraft.id
