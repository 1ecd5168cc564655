"""Trim and linearization of the nonlinear plant, for every aircraft of the hangar that has coefficients."""

import math
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from fdes.aircraft import FlightCondition, catalogue, load
from fdes.analysis.jacobian import linearized
from fdes.analysis.trim import TrimSpec, shortfalls, solve, spec_of, trim
from fdes.errors import SpecError, TrimError
from fdes.flight.nonlinear import assumptions, six_dof_of
from fdes.physics.aero import limited_lift
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import dimensional, matrices
from fdes.physics.earth import ROUND
from fdes.physics.signals import Air, Outputs, Surfaces
from fdes.units import DEG

CONDITIONS = [
    (aircraft.id, condition.id)
    for aircraft in catalogue()
    for condition in aircraft.conditions
    if aircraft.at(condition.id).nondimensional
]
SMOOTH = [(aircraft, condition) for aircraft, condition in CONDITIONS if load(aircraft).at(condition).tables is None]
each_smooth = pytest.mark.parametrize("name", SMOOTH, ids=" ".join)  # tables have kinks, and are not of one condition
each_condition = pytest.mark.parametrize("name", CONDITIONS, ids=" ".join)


@cache
def condition_of(name: tuple[str, str]) -> FlightCondition:
    return load(name[0]).at(name[1])


@each_smooth
def test_linearized_it_is_the_full_form(name: tuple[str, str]) -> None:
    """Of an aircraft whose weight is its published lift, in the standard atmosphere: there both speak of one flight."""
    condition = condition_of(name)
    ref = condition.reference
    air = standard_atmosphere(ref.h)
    lift = 0.5 * air.rho * ref.V**2 * ref.S * condition.coefficients.CL
    plant = six_dof_of(condition)
    plant = plant._replace(inertia=plant.inertia._replace(m=lift / ref.g), earth=plant.earth._replace(g=ref.g))
    balanced = ref._replace(rho=air.rho, mach=ref.V / air.a, m=lift / ref.g)
    point = solve(plant, TrimSpec(ref.V, ref.h))
    assert (point.alpha, point.surfaces.elevator) == pytest.approx((ref.alpha, 0.0), abs=1e-10)
    found = linearized(point, thrust_held=True)
    full = matrices(dimensional(condition.coefficients, balanced, "full"), balanced, "full")
    for ours, expected in ((found.A[:4, :4], full.A_lon), (found.A[4:, 4:], full.A_lat)):
        np.testing.assert_allclose(ours, expected, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(found.B[:4, :2], full.B_lon, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(found.B[4:, 2:], full.B_lat, rtol=1e-6, atol=1e-9)
    assert np.abs(found.A[:4, 4:]).max() < 1e-12
    assert np.abs(found.A[4:, :4]).max() < 1e-12


@each_condition
def test_trimmed_stays_trimmed(name: tuple[str, str]) -> None:
    """Ten seconds by rk4, hands off: what moves is what an unstable mode makes of rounding."""
    condition = condition_of(name)
    plant = trim(six_dof_of(condition), TrimSpec(condition.reference.V, condition.reference.h)).plant
    x, held = plant.start(), plant.trim()
    first = plant.observe(x, held, Air())
    for _ in range(200):
        x = plant.advance(x, held, Air(), 0.05)
    last = plant.observe(x, held, Air())
    assert last._replace(north=first.north) == pytest.approx(first, abs=1e-5)
    assert last.north == pytest.approx(10.0 * condition.reference.V, rel=1e-8)
    assert first.excursion == 0.0


@each_smooth
def test_accelerations_meet_those_of_the_linear_plant(name: tuple[str, str]) -> None:
    """Half the step of a surface, a quarter of the difference: what is left is of second order."""
    condition = condition_of(name)
    point = trim(six_dof_of(condition), TrimSpec(condition.reference.V, condition.reference.h))
    model = linearized(point)

    def apart(size: float) -> float:
        """After half a second with elevator and rudder held, in pitch and yaw rate along the axes of the model."""
        u = np.array([size, 0.0, 0.0, size])
        z, h = np.zeros(8), 0.005
        for _ in range(100):
            k1 = model.A @ z + model.B @ u
            k2 = model.A @ (z + 0.5 * h * k1) + model.B @ u
            k3 = model.A @ (z + 0.5 * h * k2) + model.B @ u
            z = z + h * (k1 + 2.0 * k2 + 2.0 * k3 + model.A @ (z + h * k3) + model.B @ u) / 6.0
        x = point.plant.start()
        held = Surfaces(elevator=size, rudder=size, throttle=point.surfaces.throttle)
        for _ in range(100):
            x = point.plant.advance(x, held, Air(), h)
        return abs(x.q - z[2])

    assert apart(0.02) / apart(0.01) > 3.5


def trimmed_outputs(name: tuple[str, str], text: str) -> Outputs:
    condition = condition_of(name)
    spec = spec_of(text, TrimSpec(condition.reference.V, condition.reference.h))
    plant = trim(six_dof_of(condition), spec).plant
    return plant.observe(plant.start(), plant.trim(), Air())


def test_what_is_asked_for_is_what_is_flown() -> None:
    """A climbing turn: path, turn rate, load factor of a coordinated turn, no side force but that of the sideslip."""
    y = trimmed_outputs(("A-4D", "M0.4_SL"), "V=160 m/s h=2000 ft gamma=4 deg turn=6 deg/s")
    assert (y.V, y.h) == pytest.approx((160.0, 609.6))
    assert (y.gamma, y.psi_dot, y.beta) == pytest.approx((4.0 * DEG, 6.0 * DEG, 0.0))
    assert (y.p_dot, y.q_dot, y.r_dot) == pytest.approx((0.0, 0.0, 0.0), abs=1e-8)
    centripetal = 160.0 * math.cos(4.0 * DEG) * 6.0 * DEG / 9.80665
    assert math.hypot(y.n_x, y.n_y, y.n_z) == pytest.approx(math.hypot(1.0, centripetal), rel=1e-10)
    assert math.tan(y.phi) == pytest.approx(centripetal, rel=0.05)  # equal where the whole force is across the path
    assert abs(y.n_y) < 0.01


def test_a_sideslip_is_held_by_rudder_and_bank() -> None:
    """Air from the right: right aileron and left rudder (positive), and the right wing down into it."""
    condition = condition_of(("B747", "M0.25_SL"))
    spec = TrimSpec(condition.reference.V, condition.reference.h, beta=5.0 * DEG)
    point = trim(six_dof_of(condition), spec)
    assert point.surfaces.aileron > 0.0
    assert point.surfaces.rudder > 0.0
    assert point.phi > 0.0


def test_a_turn_to_the_left_mirrors_one_to_the_right() -> None:
    condition = condition_of(("NAVION", "M0.158_SL"))
    left, right = (trim(six_dof_of(condition), TrimSpec(50.0, 500.0, turn=sign * 5.0 * DEG)) for sign in (-1.0, 1.0))
    assert left.alpha == pytest.approx(right.alpha)
    assert (left.phi, left.surfaces.aileron, left.surfaces.rudder) == pytest.approx(
        (-right.phi, -right.surfaces.aileron, -right.surfaces.rudder)
    )


@settings(max_examples=60, deadline=None)
@given(
    some.sampled_from(CONDITIONS),
    some.floats(5.0, 900.0),
    some.floats(-500.0, 25000.0),
    some.floats(-1.2, 1.2),
    some.floats(-0.5, 0.5),
    some.floats(-0.5, 0.5),
)
def test_every_request_ends_in_a_trim_or_in_words(
    name: tuple[str, str], V: float, h: float, gamma: float, turn: float, beta: float
) -> None:
    plant = six_dof_of(condition_of(name))
    spec = TrimSpec(V, h, gamma, turn, beta)
    found = solve(plant, spec)
    if shortfalls(found, plant.limits):
        with pytest.raises(
            TrimError, match=r"would have to be|still accelerates by .* m/s\^2|in (roll|pitch|yaw)"
        ) as mistake:
            trim(plant, spec)
        assert mistake.value.best == found
    else:
        point = trim(plant, spec)
        assert point.residual < 1e-8
        assert all(low <= s + 1e-8 <= high + 2e-8 for s, low, high in zip(point.surfaces, *plant.limits, strict=True))


def test_the_nearest_speed_can_be_flown() -> None:
    condition = condition_of(("NAVION", "M0.158_SL"))
    plant = six_dof_of(condition)
    with pytest.raises(
        TrimError,
        match=r"the throttle would have to be 2\.\d+ of 1\. With a throttle of 1 its .* The nearest speed .* m/s\.",
    ) as slow:
        trim(plant, TrimSpec(90.0, 0.0))
    assert slow.value.nearest is not None
    assert trim(plant, TrimSpec(slow.value.nearest, 0.0)).surfaces.throttle <= 1.0
    with pytest.raises(
        TrimError,
        match=r"nothing balances it: the best point, at an angle of attack of .* deg, still accelerates by .* "
        r"downward, for lift falls short.* No speed near it can be flown so \(from 12.75 to 125.5 m/s were tried\)",
    ):
        trim(six_dof_of(condition_of(("A-4D", "M0.4_SL"))), TrimSpec(40.0, 20000.0))


def test_lift_is_straight_then_round_then_flat() -> None:
    assert [limited_lift(c, 1.5) for c in (0.0, 1.0, 1.35, -1.2)] == [0.0, 1.0, 1.35, -1.2]
    assert limited_lift(1.36, 1.5) == pytest.approx(1.36, abs=2e-4)
    assert [limited_lift(c, 1.5) for c in (1.65, 9.0, -9.0)] == pytest.approx([1.5, 1.5, -1.5])
    slope = (limited_lift(1.65 + 1e-7, 1.5) - limited_lift(1.65 - 1e-7, 1.5)) / 2e-7
    assert slope == pytest.approx(0.0, abs=1e-5)


def test_thrust_of_a_propeller_falls_with_speed() -> None:
    condition = condition_of(("NAVION", "M0.158_SL"))
    plant = six_dof_of(condition)
    model, held = (linearized(solve(plant, TrimSpec(50.0, 0.0)), thrust_held=h) for h in (False, True))
    thrust = solve(plant, TrimSpec(50.0, 0.0)).surfaces.throttle * plant.engine.T_max * plant.engine.V_ref / 50.0
    assert model.A[0, 0] - held.A[0, 0] == pytest.approx(-thrust / 50.0 / plant.inertia.m, rel=1e-3)
    assert "propeller at constant power" in assumptions(condition, plant)[1]
    assert (
        "as of a jet"
        in assumptions(condition_of(("A-4D", "M0.4_SL")), six_dof_of(condition_of(("A-4D", "M0.4_SL"))))[1]
    )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("V=100", r"V=100 has no unit\. Write it like 'V=100 m/s'"),
        ("speed=100 kt", r"There is no quantity of a trim named 'speed'"),
        ("V=100 kt mach=0.3", "Both V and mach are given"),
        ("V=0 kt", "the speed must be greater than zero"),
        ("h=90 km", r"A trim at 90,000 m is asked for; the height must be from -1,000 m to 80,000 m"),
        ("gamma=85 deg", r"flight-path angle of 85 deg is asked for; at most 80 deg"),
        ("fast", r"The trim 'fast' is not understood\. Write it like 'V=170 kt h=5000 ft gamma=3 deg'"),
        ("V= h=3 m", r"gives no value for 'V'"),
    ],
)
def test_mistakes_in_a_request(text: str, words: str) -> None:
    with pytest.raises(SpecError if "speed=" not in text else Exception, match=words):
        spec_of(text, TrimSpec(100.0, 0.0))


def test_a_mach_number_may_be_asked_for() -> None:
    spec = spec_of("mach=0.5, h=36000 ft; turn=-3 deg/s", TrimSpec(100.0, 0.0))
    assert pytest.approx(0.5 * standard_atmosphere(36000 * 0.3048).a) == spec.V
    assert spec.turn == pytest.approx(-3.0 * DEG)


def test_what_cannot_be_trimmed_is_said() -> None:
    with pytest.raises(SpecError, match="dimensional derivatives, which hold at one speed and height alone"):
        six_dof_of(load("A-7A").at())
    plant = six_dof_of(condition_of(("A-4D", "M0.4_SL")))._replace(earth=ROUND)
    with pytest.raises(SpecError, match="Trim is over a flat Earth"):
        trim(plant, TrimSpec(100.0, 0.0))
