"""Performance against closed forms of the drag polar, which know nothing of trim, and against published figures."""

import math

import pytest

from fdes.aircraft import edited, load
from fdes.analysis.climb import SERVICE, AtHeight, best_excess, rate_of_climb, times_to_climb
from fdes.analysis.level_flight import (
    Craft,
    Speeds,
    largest_lift,
    level_speeds,
    reach_of,
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
from fdes.analysis.v_n import equivalent, fallen, lift_slope, load_factors, structure_of
from fdes.errors import NoSuchPart
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.plant import SixDof
from fdes.physics.signals import Air
from fdes.units import FOOT, KNOT, POUND_FORCE

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
    assert pytest.approx(V, rel=0.01) == found.figure("least thrust").V
    assert found.figure("weight over least thrust").value == pytest.approx(0.5 / math.sqrt(K * CD_0), rel=0.01)


def test_the_elevator_takes_lift_off_in_trim(navion: Performance) -> None:
    """What the plain polar does not know: the wing carries the elevator's part too, and the best speed rises."""
    k, plain = NAVION.coefficients, performance(PLAIN_NAVION)
    lost = k.CL_de * k.Cm_alpha / (k.Cm_de * k.CL_alpha)
    speeds = [found.figure("least thrust").V or 0.0 for found in (navion, plain)]
    assert speeds[0] / speeds[1] == pytest.approx(1.0 + 0.5 * lost, abs=0.01)
    assert navion.figure("weight over least thrust").value < plain.figure("weight over least thrust").value


def test_least_power_of_a_wing_far_from_its_stall() -> None:
    """At 3^(-1/4) of the speed of least drag: Anderson, eq. 5.41."""
    found = performance(load("A-4D").at(), Wanted(h=6000.0))
    drag, power = found.figure("least thrust").V, found.figure("least power").V
    assert drag is not None
    assert power == pytest.approx(3.0**-0.25 * drag, rel=0.01)


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
    assert found.figure("specific excess power").value == pytest.approx(1110.0 * FOOT / 60.0, rel=0.05)
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


def test_a_turn_kept_up_is_that_of_the_polar() -> None:
    """n^2 = q S (T - q S CD_0) / (K W^2): Anderson, eq. 6.17. Thrust carries the rest."""
    plain = edited(load("A-4D").at(), ["CL_de=0", "CL_q=0"])
    plant = six_dof_of(plain)
    found = performance(plain)
    CD_0, K, loading, rho = polar(plant, 0.0)
    V, n = found.turn["V"].values, found.turn["n_sustained"].values
    q = 0.5 * rho * V**2
    thrust = plant.engine.T_max / plant.aero.S
    expected = (q * (thrust - q * CD_0) / (K * loading**2)) ** 0.5
    slow, fast = 20, 41
    assert n[slow:fast] == pytest.approx(expected[slow:fast], rel=0.015)


def test_rate_and_radius_are_those_of_a_circle(navion: Performance) -> None:
    turn = navion.turn
    V, n = turn["V"].values, turn["n"].values
    assert turn["radius"].values == pytest.approx(V**2 / (G * (n**2 - 1.0) ** 0.5))
    assert turn["rate"].values * turn["radius"].values == pytest.approx(V)


def test_the_turn_of_an_instant_is_that_of_the_largest_lift() -> None:
    """n = rho V^2 S CL_max / (2 W) where no elevator and no thrust add lift: at its corner and below."""
    plain = edited(load("B747").at(), ["CL_de=0", "CL_q=0", "CL_M=0", "T_max*=0.5"])
    plant = six_dof_of(plain)
    found = performance(plain)
    _, _, loading, rho = polar(plant, 0.0)
    corner = found.figure("corner speed").value
    lift = 0.5 * rho * corner**2 * plant.aero.CL_max / loading
    assert lift == pytest.approx(found.figure("largest load factor").value, rel=0.02)


def test_the_corner_is_where_lift_meets_structure(navion: Performance) -> None:
    turn, corner = navion.turn, navion.figure("corner speed").value
    limited = turn["n"].values >= navion.figure("largest load factor").value
    assert (turn["V"].values[limited] >= 0.999 * corner).all()
    assert (turn["V"].values[~limited] < corner).all()
    rate = navion.figure("instantaneous turn rate")
    assert pytest.approx(corner, rel=0.02) == rate.V


@pytest.mark.parametrize(
    ("airplane_class", "pounds", "n_max", "n_min"),
    [("I", 2750, 3.8, -1.52), ("I", 12500, 2.1 + 24000 / 22500, -0.4 * (2.1 + 24000 / 22500)),
     ("III", 636600, 2.5, -1.0), ("II-L", 38204, 2.1 + 24000 / 48204, -1.0), ("IV", 17578, 6.5, -3.0)],
)  # fmt: skip
def test_load_factors_of_the_rules(airplane_class: str, pounds: float, n_max: float, n_min: float) -> None:
    assert load_factors(airplane_class, pounds * POUND_FORCE)[:2] == pytest.approx((n_max, n_min))


def test_a_gust_in_the_units_of_the_rule(navion: Performance) -> None:
    """FAR 23.341(c) as printed: n = 1 + K_g U_de V a / (498 W/S), in ft/s, kt, 1/rad and lb/ft^2."""
    ref, a = NAVION.reference, NAVION.coefficients.CL_alpha
    loading = ref.m * G / ref.S * FOOT**2 / POUND_FORCE
    mu = 2.0 * loading / (0.0023769 * ref.c / FOOT * a * 32.174)
    alleviated = 0.88 * mu / (5.3 + mu)
    for name, gust in (("V_C", 50.0), ("V_D", 25.0)):
        V = navion.figure(name).value / KNOT
        n = 1.0 + alleviated * gust * V * a / (498.0 * loading)
        assert navion.figure(f"load factor of a gust at {name}").value == pytest.approx(n, rel=0.002)


def test_gusts_fall_with_height() -> None:
    """FAR 23.333(c): 50 ft/s at V_C to 20,000 ft, then straight to 25 ft/s at 50,000 ft."""
    of = [fallen(50.0, h * FOOT) for h in (0.0, 20000.0, 35000.0, 50000.0, 60000.0)]
    assert of == pytest.approx([50.0, 50.0, 37.5, 25.0, 25.0])


def test_the_lift_slope_is_that_of_the_file() -> None:
    asked = craft("B747")
    speeds = level_speeds(asked, largest_lift(asked), 0.0)
    assert speeds is not None
    assert lift_slope(asked, speeds.line[20]) == pytest.approx(load("B747").at().coefficients.CL_alpha, rel=1e-9)


def test_the_maneuver_boundary(navion: Performance) -> None:
    """From V_A on it is the structure's; below, n grows as the square of the speed, from 1 at V_S; it closes at V_D."""
    bounds = navion.v_n
    V, up = bounds["V"].values, bounds["n_upper"].values
    V_S, V_A = navion.figure("V_S").value, navion.figure("V_A").value
    assert up[V > V_A] == pytest.approx(3.8)
    assert up[V < V_A] == pytest.approx((V[V < V_A] / V_S) ** 2, rel=0.03)
    assert pytest.approx(V_S * math.sqrt(3.8), rel=0.03) == V_A
    assert bounds["n_lower"].values[-1] == pytest.approx(0.0, abs=1e-9)


def test_load_factors_that_are_asked_for() -> None:
    found = performance(load("F-16").at(), Wanted(n_max=9.0, n_min=-3.0))
    assert found.figure("largest load factor") == ("largest load factor", 9.0, "1", None, "asked for")
    assert float(found.v_n["n_upper"].max()) == 9.0
    assert float(found.turn["n"].max()) == 9.0


def test_across_mach_reaches_from_the_slowest_to_the_fastest_condition() -> None:
    alone, both = load("A-4D").at(), load("A-4D").at(across="mach")
    assert reach_of(alone).slow == 0.0
    assert reach_of(both).slow == 0.0
    assert reach_of(load("A-4D").at("M0.8_35kft")).slow > 0.0
    assert performance(both, Wanted(h=8000.0)).figure("fastest").value > 200.0


def test_the_way_up_is_the_integral_of_an_excess_that_is_straight_in_height() -> None:
    """From 10 to 5 m/s over 1000 m: H / (a - b) ln(a / b)."""
    rows = [AtHeight(h, 30.0, 40.0, excess, (), None) for h, excess in ((0.0, 10.0), (1000.0, 5.0), (1500.0, 5.0))]
    assert times_to_climb(rows) == pytest.approx([0.0, 200.0 * math.log(2.0), 200.0 * math.log(2.0) + 100.0])


def test_design_speeds_are_equivalent_and_no_faster_than_the_data_know() -> None:
    """At 3000 m sound goes 328.58 m/s and the density is 0.90925 kg/m^3: U.S. Standard Atmosphere, 1976, table I."""
    known = 0.3 * 328.58 * math.sqrt(0.90925 / 1.2250)
    assert equivalent(0.3 * 328.58, 3000.0) == pytest.approx(known, rel=1e-5)
    asked = craft_of(NAVION, six_dof_of(NAVION), Wanted(fastest=0.3))
    fastest = Speeds(3000.0, 30.0, (asked.first(80.0, 3000.0, 1.0),), "", "")
    found = structure_of(NAVION, asked, fastest, None, None)
    normal = 33.0 * math.sqrt(2750.0 / 184.0) * KNOT
    design_speeds = found.V_C, found.V_D
    assert design_speeds == pytest.approx((normal, known), rel=1e-4)
