"""Performance against closed forms of the drag polar, which know nothing of trim, and against published figures."""

import math

import pytest

from fdes.aircraft import edited, load
from fdes.analysis.climb import SERVICE, best_excess, rate_of_climb
from fdes.analysis.level_flight import (
    Craft,
    largest_lift,
    level_speeds,
    stall,
    steady_climb,
)
from fdes.analysis.maneuver import (
    KEPT_TURNING,
    STRAIGHT,
    Maneuver,
    balanced,
    state_of,
)
from fdes.analysis.performance import ALL, Performance, Wanted, craft_of, performance
from fdes.analysis.trim import TrimSpec, solve
from fdes.errors import NoSuchPart
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.plant import SixDof
from fdes.physics.signals import Air
from fdes.units import FOOT

G = 9.80665
NAVION = load("NAVION").at()
PLAIN_NAVION = edited(NAVION, ["CL_de=0"])  # the polar of textbooks: in trim its elevator has no lift
HANGAR = ("A-4D", "F-104A", "NAVION", "CV-880", "B747", "JETSTAR", "F-16")


def craft(name: str) -> Craft:
    condition = load(name).at()
    return craft_of(condition, six_dof_of(condition), ALL)


def polar(plant: SixDof, h: float) -> tuple[float, float, float, float]:
    """CD_0, K, W/S and rho: all that the textbook's formulas ask for."""
    aero = plant.aero
    return aero.CD_0, aero.K, plant.inertia.m * G / aero.S, standard_atmosphere(h).rho


@pytest.fixture(scope="module")
def navion() -> Performance:
    return performance(NAVION)


@pytest.mark.parametrize("name", HANGAR)
def test_level_flight_is_that_of_trim(name: str) -> None:
    asked = craft(name)
    found = balanced(asked.plant, asked.first(asked.V, asked.h, 0.5), STRAIGHT)
    trimmed = solve(asked.plant, TrimSpec(asked.V, asked.h))
    assert found is not None
    assert found.alpha == pytest.approx(trimmed.alpha, abs=1e-9)
    assert found.elevator == pytest.approx(trimmed.surfaces.elevator, abs=1e-9)
    assert found.throttle == pytest.approx(trimmed.surfaces.throttle, abs=1e-9)


@pytest.mark.parametrize("name", ["A-4D", "F-16"])
def test_a_turn_is_that_of_trim(name: str) -> None:
    asked = craft(name)
    V = 1.3 * asked.V
    guess = Maneuver(V, asked.h, alpha=0.1, phi=1.0, turn=G / V, throttle=0.9)
    found = balanced(asked.plant, guess, KEPT_TURNING)
    assert found is not None
    trimmed = solve(asked.plant, TrimSpec(V, asked.h, turn=found.turn))
    assert trimmed.surfaces.throttle == pytest.approx(0.9, abs=1e-6)
    assert trimmed.phi == pytest.approx(found.phi, abs=1e-6)


@pytest.mark.parametrize("name", HANGAR)
def test_a_steady_climb_is_steady(name: str) -> None:
    asked = craft(name)
    level = balanced(asked.plant, asked.first(asked.V, asked.h, 0.5), STRAIGHT)
    assert level is not None
    climb = steady_climb(asked._replace(full=min(1.0, level.throttle + 0.2)), level)
    assert climb is not None
    plant = asked.plant._replace(rest=asked.plant.rest._replace(elevator=0.0, aileron=0.0, rudder=0.0))
    rate = plant.derivative(state_of(plant, climb), climb.surfaces, Air())
    assert max(abs(v) for v in rate[3:13]) < 1e-8
    assert -rate.z == pytest.approx(rate_of_climb(climb), rel=1e-9)


def test_least_drag_is_where_the_polar_says() -> None:
    """CL = sqrt(CD_0 / K), L/D = 1 / (2 sqrt(K CD_0)): Anderson, eq. 5.27 and 5.30. Thrust carries the rest."""
    plant = six_dof_of(PLAIN_NAVION)
    found = performance(PLAIN_NAVION)
    CD_0, K, loading, rho = polar(plant, 0.0)
    V = math.sqrt(2.0 * loading / rho * math.sqrt(K / CD_0))
    assert found.figure("least drag").value == pytest.approx(V, rel=0.01)
    assert found.figure("weight over least thrust").value == pytest.approx(0.5 / math.sqrt(K * CD_0), rel=0.01)


def test_the_elevator_takes_lift_off_in_trim(navion: Performance) -> None:
    """What the plain polar does not know: the wing carries the elevator's part too, and the best speed rises."""
    k = NAVION.coefficients
    lost = k.CL_de * k.Cm_alpha / (k.Cm_de * k.CL_alpha)
    assert lost == pytest.approx(0.063, abs=0.001)
    plain = performance(PLAIN_NAVION)
    assert 1.02 < navion.figure("least drag").value / plain.figure("least drag").value < 1.04
    assert navion.figure("weight over least thrust").value < plain.figure("weight over least thrust").value


def test_least_power_of_a_wing_far_from_its_stall() -> None:
    """At 3^(-1/4) of the speed of least drag: Anderson, eq. 5.41."""
    found = performance(load("A-4D").at(), Wanted(h=6000.0))
    assert found.figure("least power").value == pytest.approx(3.0**-0.25 * found.figure("least drag").value, rel=0.01)


def test_fastest_is_where_thrust_is_drag() -> None:
    """Of a propeller at constant power: T V = D V with the polar's drag."""
    plant = six_dof_of(PLAIN_NAVION)
    CD_0, K, loading, rho = polar(plant, 0.0)
    V = performance(PLAIN_NAVION).figure("fastest").value
    q = 0.5 * rho * V * V
    drag = q * plant.aero.S * (CD_0 + K * (loading / q) ** 2)
    assert drag * V == pytest.approx(plant.engine.T_max * plant.engine.V_ref, rel=0.005)


def test_largest_excess_power_of_a_jet() -> None:
    """Anderson, eq. 5.120: the dynamic pressure of the best rate of climb of a jet, and that rate."""
    plain = edited(load("A-4D").at(), ["CL_de=0"])
    asked = craft_of(plain, six_dof_of(plain), ALL)
    CD_0, K, loading, rho = polar(asked.plant, 0.0)
    thrust = asked.plant.engine.T_max / (asked.plant.inertia.m * G)
    q = thrust * loading / (6.0 * CD_0) * (1.0 + math.sqrt(1.0 + 12.0 * K * CD_0 / thrust**2))
    V = math.sqrt(2.0 * q / rho)
    climb = V * (thrust - q * CD_0 / loading - K * loading / q)
    found = best_excess(asked, largest_lift(asked), 0.0)
    assert found is not None
    assert found.V_climb == pytest.approx(V, rel=0.01)
    assert found.excess == pytest.approx(climb, rel=0.01)


def test_excess_power_is_nothing_at_the_ceiling(navion: Performance) -> None:
    asked = craft("NAVION")
    lift = largest_lift(asked)
    for name, climb in (("service ceiling", SERVICE), ("absolute ceiling", 0.0)):
        at = best_excess(asked, lift, navion.figure(name).value)
        assert at is not None
        assert at.excess == pytest.approx(climb, abs=0.005)


def test_a_navion_climbs_as_published() -> None:
    """Of 205 hp and 2,750 lb: 1,110 ft/min, ceiling 15,600 ft, top speed 163 mph (Plane & Pilot, Ryan Navion).

    Its power and propeller are assumed; the polar, that of the book at one condition, costs it a tenth of the speed.
    """
    found = performance(NAVION)
    assert found.figure("largest specific excess power").value == pytest.approx(1110.0 * FOOT / 60.0, rel=0.05)
    assert found.figure("service ceiling").value == pytest.approx(15600.0 * FOOT, rel=0.05)
    assert found.figure("fastest").value == pytest.approx(163.0 * 1609.344 / 3600.0, rel=0.12)


def test_stall_is_that_of_the_assumed_lift(navion: Performance) -> None:
    """V = sqrt(2 W / (rho S CL)), the elevator's lift, which is negative there, counted."""
    asked = craft("NAVION")
    stalled = stall(asked, largest_lift(asked), 0.0)
    assert stalled is not None
    aero = asked.plant.aero
    CL = aero.CL_max + aero.k.CL_de * stalled[0].elevator
    assert aero.CL_max > CL
    _, _, loading, rho = polar(asked.plant, 0.0)
    assert navion.figure("stall at idle throttle").value == pytest.approx(
        math.sqrt(2.0 * loading / (rho * CL)), rel=0.01
    )


@pytest.mark.parametrize("name", HANGAR)
def test_the_ends_of_the_range_of_speeds_are_ends(name: str) -> None:
    asked = craft(name)
    speeds = level_speeds(asked, largest_lift(asked), asked.h)
    assert speeds is not None
    assert all(b.V > a.V for a, b in zip(speeds.line, speeds.line[1:], strict=False))
    assert all(m.throttle <= 1.0 for m in speeds.line)
    assert speeds.slow_end
    assert speeds.fast_end
    assert 1.01 * speeds.V_stall > speeds.line[0].V


def test_thrust_makes_the_ends_where_it_is_short() -> None:
    """High up, both ends are those of thrust: there the throttle is full."""
    found = performance(load("A-4D").at(), Wanted(h=14000.0, fastest=0.9))
    assert found.figure("slowest").limit.startswith("thrust")
    assert float(found.level["throttle"][0]) == pytest.approx(1.0, abs=1e-3)
    assert float(found.level["excess_power"][0]) == pytest.approx(0.0, abs=0.2)


def test_tables_carry_their_units(navion: Performance) -> None:
    assert all(v.attrs["units"] and v.attrs["long_name"] for v in navion.level.variables.values())
    assert all(v.attrs["units"] and v.attrs["long_name"] for v in navion.heights.variables.values())
    need, V = navion.level["thrust_required"], navion.level["V"]
    assert (navion.level["power_required"] == need * V).all()
    assert navion.heights["time"].values[1] > 0.0
    assert navion.heights["V_stall"].values == pytest.approx(sorted(navion.heights["V_stall"].values))


def test_the_f16_stays_within_the_tables_of_its_engine() -> None:
    found = performance(load("F-16").at())
    assert found.figure("service ceiling").value == pytest.approx(50000.0 * FOOT)
    assert found.figure("service ceiling").limit == "the tables of its engine end there"


def test_what_is_not_a_figure() -> None:
    with pytest.raises(NoSuchPart, match="service ceiling"):
        performance(NAVION).figure("service celing")
