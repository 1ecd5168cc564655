"""Gusts as inputs: what an aircraft must do in one, worked out by hand, and where they are recorded."""

from math import cos, radians
from typing import Any

import pytest

from fdes.aircraft import FlightCondition, load
from fdes.flight import Clock, Excitation, simulate
from fdes.physics.signals import Air

# Stable in pitch (Cm_alpha < 0) and in yaw (Cn_beta > 0), with dihedral (Cl_beta < 0).
STABLE = [
    ("A-4D", "M0.4_SL"),
    ("NAVION", None),
    ("JetStar", None),
    ("F-104A", None),
    ("B747", None),
    ("Convair 880", None),
]


@pytest.fixture(params=STABLE, ids=lambda p: p[0])
def fc(request: pytest.FixtureRequest) -> FlightCondition:
    aircraft, condition = request.param
    return load(aircraft).at(condition)


def flown(fc: FlightCondition, text: str, duration: float = 0.5) -> Any:
    return simulate(fc, [text], clock=Clock(0.005, duration=duration), form="nelson", integrator="exact")


def test_an_upward_gust_lifts_at_once_and_then_the_nose_goes_down(fc: FlightCondition) -> None:
    """By hand: the wing meets the flow w_g / V steeper, so n_z jumps by -Z_w w_g / g before anything has moved."""
    flight = flown(fc, "step gust_w -3m/s")
    (_, Zw, *_), g = fc.equations("nelson")[0][1], fc.reference.g
    assert flight["n_z"][0] == pytest.approx(cos(fc.reference.gamma) + -Zw * 3.0 / g, rel=1e-9)
    assert flight["n_z"][0] > 1.0
    assert flight["alpha"][0] > fc.reference.alpha
    assert flight["q_dot"][0] < 0.0
    assert flight["q"][20] < 0.0
    assert flight["h_dot"][20] > flight["h_dot"][0]


def test_a_gust_from_the_right_pushes_left_and_turns_the_nose_into_it(fc: FlightCondition) -> None:
    """By hand: air from the right is positive sideslip. Side force is Y_beta < 0, dihedral rolls away, the fin turns
    the nose to the right, to where the air comes from.
    """
    flight = flown(fc, "step gust_v -3m/s")
    V, g = fc.reference.V, fc.reference.g
    _, _, A_lat, _ = fc.equations("nelson")
    assert flight["beta"][0] > 0.0
    assert flight["n_y"][0] == pytest.approx(A_lat[0][0] * 3.0 / g, rel=1e-9)  # V beta_dot / g, and beta = 3 / V
    assert flight["n_y"][0] < 0.0
    assert flight["p_dot"][0] == pytest.approx(A_lat[1][0] * 3.0 / V, rel=1e-9)
    assert flight["p"][10] < 0.0 < flight["r"][10]


def test_a_gust_from_ahead_is_felt_as_airspeed(fc: FlightCondition) -> None:
    """gust_u is the velocity of the air: from behind it takes airspeed away, and lift with it."""
    flight = flown(fc, "step gust_u 2m/s")
    assert flight["V"][0] == pytest.approx(fc.reference.V - 2.0, rel=1e-12)
    assert flight["n_z"][0] < cos(fc.reference.gamma)


@pytest.mark.parametrize(("angle", "speed", "sees"), [("alpha_g", "gust_w", "alpha"), ("beta_g", "gust_v", "beta")])
def test_a_gust_angle_adds_to_the_angle_of_the_flow(fc: FlightCondition, angle: str, speed: str, sees: str) -> None:
    V = fc.reference.V
    by_angle = flown(fc, f"step {angle} 2deg at 0.1s")
    by_speed = flown(fc, f"step {speed} {-V * radians(2.0)!r} m/s at 0.1s")
    assert by_angle[sees][20] - by_angle[sees][19] == pytest.approx(radians(2.0), rel=1e-3)
    assert by_angle[f"air_{speed}"][20] == pytest.approx(-V * radians(2.0))
    assert abs(by_angle.data - by_speed.data).max() < 1e-9


def test_a_gust_goes_by_both_orders_of_its_words() -> None:
    assert Excitation.parse(["step w_gust -5m/s at 1s"]) == Excitation.parse(["step gust_w -5 m/s at 1 s"])


def test_gusts_come_on_top_of_the_air_that_is() -> None:
    from fdes.flight.excitation import blown

    gusts = Excitation.parse(["step gust_u 1m/s; step gust_w 2m/s; step alpha_g 1rad; step beta_g -1rad"]).gusts(0.0)
    assert blown(Air(9.0, 8.0, 7.0, 1.0, 2.0, 3.0), gusts, 10.0) == Air(9.0, 8.0, 7.0, 2.0, 12.0, -5.0)
