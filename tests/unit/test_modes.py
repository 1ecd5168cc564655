"""Modes are named by who takes part in them, also where they merge or split."""

import math
from dataclasses import replace

import numpy as np
import pytest

from fdes.aircraft import FlightCondition, load
from fdes.analysis import linear_model, modes


@pytest.fixture
def navion() -> FlightCondition:
    return load("NAVION").at("M0.158_SL")


def edited(condition: FlightCondition, **coefficients: float) -> FlightCondition:
    return replace(condition, aerodynamics=condition.coefficients._replace(**coefficients))


def names(condition: FlightCondition, axis: str) -> list[str]:
    return [m.name for m in modes(condition) if m.axis == axis]


def test_the_five_classical_modes(navion: FlightCondition) -> None:
    assert names(navion, "longitudinal") == ["short_period", "phugoid"]
    assert names(navion, "lateral") == ["roll", "dutch_roll", "spiral"]


def test_every_eigenvalue_has_one_name(navion: FlightCondition) -> None:
    found = modes(navion)
    assert sum(2 if m.oscillatory else 1 for m in found) == 8
    assert len({m.name for m in found}) == len(found)
    for m in found:
        assert sum(m.participation.values()) == pytest.approx(1.0)


def test_unstable_in_pitch_the_short_period_is_split_and_a_third_oscillation_appears(navion: FlightCondition) -> None:
    assert names(edited(navion, Cm_alpha=0.3), "longitudinal") == [
        "short_period_fast",
        "third_oscillatory",
        "phugoid_slow",
    ]
    seen = {
        name for value in np.linspace(-0.7, 0.4, 221) for name in names(edited(navion, Cm_alpha=value), "longitudinal")
    }
    assert {"short_period", "phugoid", "short_period_fast", "short_period_slow", "third_oscillatory"} <= seen


def test_of_what_two_merged_modes_leave_the_faster_half_is_the_short_periods() -> None:
    """At this point the root at zero has nothing but w in it, and by its share alone it would be the short period."""
    left = [m for m in modes(edited(load("A-4D").at(), Cm_alpha=0.0, Cm_q=0.0)) if m.axis == "longitudinal"]
    assert [m.name for m in left] == ["short_period_fast", "third_oscillatory", "phugoid_slow"]
    assert left[0].eigenvalue == pytest.approx(-1.221, abs=1e-3)


def test_unstable_in_yaw_the_dutch_roll_is_split(navion: FlightCondition) -> None:
    assert set(names(edited(navion, Cn_beta=-0.05), "lateral")) == {
        "roll",
        "dutch_roll_fast",
        "dutch_roll_slow",
        "spiral",
    }


def test_with_much_dihedral_and_little_roll_damping_roll_and_spiral_merge(navion: FlightCondition) -> None:
    much = edited(navion, Cl_p=-0.1, Cn_p=0.1, Cl_beta=-0.12, Cn_r=-0.25, Cl_r=0.0, Cn_beta=0.15)
    assert names(much, "lateral") == ["dutch_roll", "roll_spiral"]


def test_without_weathercock_stability_yaw_joins_roll_and_sideslip_joins_bank() -> None:
    """Neither oscillation is a Dutch roll, and as Cn_beta falls their names do not change places."""
    a4d = load("A-4D").at()
    assert set(names(edited(a4d, Cn_beta=0.01), "lateral")) == {"roll", "dutch_roll_fast", "spiral_dutch_roll"}
    for unstable in (0.005, 0.0, -0.01, -0.03):
        found = {m.name: m.eigenvalue for m in modes(edited(a4d, Cn_beta=unstable)) if m.axis == "lateral"}
        assert set(found) == {"roll_dutch_roll", "spiral_dutch_roll"}
        assert found["roll_dutch_roll"].real < -1.0
        assert found["spiral_dutch_roll"].real > 0.0


@pytest.mark.parametrize("name", ["Cm_alpha", "Cm_q", "Cn_beta", "Cl_p", "Cl_beta", "Cn_r"])
def test_names_stay_unique_over_a_wide_range_of_every_derivative(navion: FlightCondition, name: str) -> None:
    printed = getattr(navion.coefficients, name)
    for factor in np.linspace(-3.0, 3.0, 61):
        found = modes(edited(navion, **{name: printed * factor}))
        assert len({m.name for m in found}) == len(found)


def test_times_and_damping(navion: FlightCondition) -> None:
    for m in modes(navion):
        sigma = m.eigenvalue.real
        assert m.omega_n == pytest.approx(abs(m.eigenvalue))
        assert m.time_constant == pytest.approx(-1.0 / sigma)
        assert m.time_to_half == pytest.approx(math.log(2.0) / -sigma)
        assert m.time_to_double is None
        if m.oscillatory:
            assert m.period == pytest.approx(2.0 * math.pi / m.eigenvalue.imag)
            assert m.zeta == pytest.approx(-sigma / m.omega_n)
        else:
            assert (m.zeta, m.period) == (1.0, None)


def test_an_unstable_real_root_doubles(navion: FlightCondition) -> None:
    spiral = next(m for m in modes(edited(navion, Cl_beta=-0.005)) if m.name == "spiral")
    assert spiral.eigenvalue.real > 0.0
    assert spiral.zeta == -1.0
    assert (spiral.time_constant, spiral.time_to_half) == (None, None)
    assert spiral.time_to_double == pytest.approx(math.log(2.0) / spiral.eigenvalue.real)


def test_a_root_that_is_zero_but_for_rounding_is_zero() -> None:
    """With neither static stability nor an effect of speed on the moment, nothing brings the pitch attitude back."""
    neutral = edited(load("A-4D").at("M0.4_SL"), Cm_alpha=0.0)
    slow = next(m for m in modes(neutral) if m.name == "phugoid_slow")
    assert (slow.eigenvalue, slow.omega_n, slow.zeta) == (0j, 0.0, 0.0)
    assert (slow.time_constant, slow.time_to_half, slow.time_to_double) == (None, None, None)


def test_participation_does_not_depend_on_units(navion: FlightCondition) -> None:
    model = linear_model(navion)
    scale = np.diag([1 / 0.3048, 1 / 0.3048, 57.3, 57.3, 57.3, 57.3, 57.3, 57.3])
    other = replace(model, A=scale @ model.A @ np.linalg.inv(scale), B=scale @ model.B)
    for one, two in zip(modes(model), modes(other), strict=True):
        assert one.name == two.name
        assert one.participation == pytest.approx(two.participation)
