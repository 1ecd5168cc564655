"""What holds for any rigid body over any Earth: conservation, symmetry, and that equations say the same as others."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some
from scipy.integrate import solve_ivp

from fdes.errors import Departed, SpecError
from fdes.physics.aero import SimpleBody, simple_body_loads
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.attitude import Three, euler_angles, quaternion, rotation, seen_from, turned, turned_back
from fdes.physics.earth import EARTHS, FLAT, ROUND, WGS84, Earth, geodetic, gravitation, place, position, potential
from fdes.physics.integrators.dopri5 import dopri5
from fdes.physics.integrators.rk4 import rk4
from fdes.physics.plant import SixDof, State, raised, state_at
from fdes.physics.rigid_body import Inertia, angular_acceleration
from fdes.physics.runge_kutta import Tableau
from fdes.physics.signals import Air, Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.physics.wind import Wind
from fdes.units import DEG, G0

LOPSIDED = Inertia(m=2.0, Ix=2.0, Iy=3.0, Iz=4.0, Ixz=0.5, Ixy=-0.3, Iyz=0.2)
BALL = SimpleBody(S=0.02, b=0.3, c=0.3, CD=0.1)
VACUUM = SimpleBody(S=0.0, b=1.0, c=1.0)
MICROMETER = 1e-6


def body(earth: Earth, initial: State, aero: SimpleBody = VACUUM, method: Tableau = rk4, **more: object) -> SixDof:
    fixed = Limits(Surfaces(), Surfaces())
    return SixDof(LOPSIDED, aero, simple_body_loads, earth, initial, fixed, method, **more)  # type: ignore[arg-type]


def flown(plant: SixDof, seconds: float, dt: float = 0.01) -> State:
    x = plant.start()
    for _ in range(round(seconds / dt)):
        x = plant.advance(x, Surfaces(), Air(), dt)
    return x


@pytest.mark.parametrize("earth", [ROUND, WGS84], ids=["round", "wgs84"])
def test_a_free_fall_keeps_its_energy(earth: Earth) -> None:
    """Kinetic and potential, with that of the centrifugal force: what is conserved in axes that turn."""
    start = state_at(earth, (0.7, 2.0, 20000.0), (100.0, 200.0, -50.0), (0.0, 0.0, 0.0))
    end = flown(body(earth, start), 20.0)

    def energy(x: State) -> float:
        motion = 0.5 * (x.u**2 + x.v**2 + x.w**2) - 0.5 * earth.Omega**2 * (x.x**2 + x.y**2)
        return motion + potential(earth, x.x, x.y, x.z)

    assert energy(end) - energy(start) == pytest.approx(0.0, abs=1e-6)  # of 6e7 J/kg: rounding
    assert abs(end.w - start.w) > 100.0


@pytest.mark.parametrize(("method", "order"), [(rk4, 4), (dopri5, 5)], ids=["rk4", "dopri5"])
def test_error_falls_with_the_order_of_the_integrator(method: Tableau, order: int) -> None:
    start = state_at(FLAT, (0.0, 0.0, 5000.0), (30.0, 0.0, 0.0), (0.1, 0.2, 0.3), (1.0, 2.0, 3.0))
    plant = body(FLAT, start, BALL, method)
    exact = flown(plant, 2.0, 0.0025)
    coarse, fine = (
        math.dist(flown(plant, 2.0, dt)[10:], exact[10:]) for dt in (0.1, 0.05)
    )  # of the rates, in which the equations are not linear
    assert math.log2(coarse / fine) == pytest.approx(order, abs=0.4)


@given(some.floats(-1.5, 1.5), some.floats(-3.1, 3.1), some.floats(-5000.0, 500000.0))
def test_gravity_is_the_gradient_of_its_potential(latitude: float, longitude: float, h: float) -> None:
    """By complex step, which is exact."""
    r = position(WGS84, latitude, longitude, h)
    for k, pull in enumerate(gravitation(WGS84, *r)):
        tilted = [complex(c, 1e-30 if i == k else 0.0) for i, c in enumerate(r)]
        gradient = potential(WGS84, *tilted).imag / 1e-30  # type: ignore[arg-type]
        assert pull == pytest.approx(-gradient, rel=1e-12, abs=1e-12)


def test_gravity_of_wgs84_is_the_published_one() -> None:
    """Normal gravity at equator and poles, NIMA TR8350.2 table 3.4, but for what the ellipsoid's J4 adds to J2."""
    J4 = -2.37091222e-6  # of the normal field, NIMA TR8350.2 table 3.3, C40 times -3
    equator, pole = position(WGS84, 0.0, 0.0, 0.0), position(WGS84, 0.5 * math.pi, 0.0, 0.0)
    at_equator = -gravitation(WGS84, *equator)[0] - WGS84.Omega**2 * equator[0]
    at_pole = -gravitation(WGS84, *pole)[2]
    assert at_equator == pytest.approx(9.7803253359 + 15.0 / 8.0 * 9.798 * J4, abs=1e-6)
    assert at_pole == pytest.approx(9.8321849378 + 5.0 * 9.864 * J4 * (6378137.0 / 6356752.3142) ** 4, abs=2e-6)


LATITUDES = some.floats(-90.0, 90.0) | some.sampled_from([-90.0, -89.9999999, 0.0, 45.0, 89.9999999, 90.0])
LONGITUDES = some.floats(-180.0, 180.0) | some.sampled_from([-180.0, -179.9999999, 0.0, 90.0, 179.9999999, 180.0])


@given(some.sampled_from([ROUND, WGS84]), LATITUDES, LONGITUDES, some.floats(-9000.0, 500000.0))
def test_geodetic_position_there_and_back(earth: Earth, latitude: float, longitude: float, h: float) -> None:
    """At the poles and at the date line too."""
    there = position(earth, latitude * DEG, longitude * DEG, h)
    back = geodetic(earth, *there)
    assert math.dist(position(earth, *back), there) < MICROMETER
    assert back[2] == pytest.approx(h, abs=MICROMETER)
    assert back[0] == pytest.approx(latitude * DEG, abs=1e-12)


@given(LATITUDES, LONGITUDES, some.floats(-3.0, 3.0), some.floats(-1.5, 1.5), some.floats(-3.0, 3.0))
def test_attitude_is_found_again_anywhere(lat: float, lon: float, phi: float, theta: float, psi: float) -> None:
    x = state_at(WGS84, (lat * DEG, lon * DEG, 1000.0), (0.0, 0.0, 0.0), (phi, theta, psi))
    local = place(WGS84, x.x, x.y, x.z).local
    seen = rotation(*quaternion(phi, theta, psi))
    assert seen_from(local, rotation(x.e0, x.e1, x.e2, x.e3)) == pytest.approx(seen, abs=1e-9)
    if abs(lat) < 89.999999:
        assert euler_angles(seen_from(local, rotation(x.e0, x.e1, x.e2, x.e3))) == pytest.approx(
            (phi, theta, psi), abs=1e-7
        )


@pytest.mark.parametrize("longitude", [90.0, 179.99, -123.0])
def test_the_same_flight_at_another_longitude(longitude: float) -> None:
    """Also across the date line: height, speed, heading do not know the longitude."""

    def outputs(shift: float) -> list[float]:
        start = state_at(WGS84, (0.6, shift * DEG, 3000.0), (50.0, 120.0, 3.0), (0.3, 0.1, 1.5), (0.5, 0.2, -0.4))
        plant = body(WGS84, start, BALL, wind=Wind(north=4.0, east=-7.0, shear_east=0.002))
        return list(plant.observe(flown(plant, 20.0), Surfaces(), Air()))

    assert outputs(longitude) == pytest.approx(outputs(0.0), rel=1e-8, abs=1e-7)


def test_flight_over_the_pole() -> None:
    """North along one meridian, across, and south along the other: nothing jumps but the heading."""
    start = state_at(ROUND, (89.999 * DEG, 20.0 * DEG, 5000.0), (200.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    plant = body(ROUND, start)
    x = flown(plant, 2.0)
    latitude, longitude, h = geodetic(ROUND, x.x, x.y, x.z)
    assert longitude == pytest.approx(-160.0 * DEG, abs=1e-9)
    assert latitude / DEG == pytest.approx(180.0 - 89.999 - 400.0 / (ROUND.a + 5000.0) / DEG, abs=1e-6)
    assert h == pytest.approx(5000.0 - 0.5 * 9.80 * 4.0, abs=0.05)
    assert plant.observe(x, Surfaces(), Air()).chi == pytest.approx(math.pi, abs=1e-9)


@pytest.mark.parametrize("earth", list(EARTHS.values()), ids=list(EARTHS))
def test_a_body_at_rest_in_the_air_feels_no_wind(earth: Earth) -> None:
    """It drifts with the air, and its airspeed and its damping are those relative to it."""
    start = state_at(earth, (0.0, 0.0, 3000.0), (4.0, -7.0, 0.0), (0.1, 0.2, 0.3))
    y = body(earth, start, BALL, wind=Wind(north=4.0, east=-7.0)).observe(start, Surfaces(), Air())
    assert pytest.approx(0.0, abs=1e-9) == y.V
    assert (y.n_x, y.n_y, y.n_z) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
    assert y.ground_speed == pytest.approx(math.hypot(4.0, 7.0), rel=1e-12)


def test_weight_of_the_three_earths() -> None:
    """A body that is held has its weight: the acceleration of its fall, at latitude 45 degrees."""
    for earth, weight in ((FLAT, G0), (ROUND, 9.8202), (WGS84, 9.8062)):
        start = state_at(earth, (45.0 * DEG, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
        assert body(earth, start).derivative(start, Surfaces(), Air()).w == pytest.approx(weight, abs=2e-4)


def test_a_falling_ball_agrees_with_newton_in_inertial_space() -> None:
    """Another form of the equations, Cartesian and not turning, solved by another integrator to 1e-12."""
    start = state_at(WGS84, (0.2, 0.3, 9000.0), (-100.0, 300.0, -200.0), (0.0, 0.0, 0.0))
    plant = body(WGS84, start, BALL, wind=Wind(east=6.0))
    omega = np.array([0.0, 0.0, WGS84.Omega])
    R = rotation(start.e0, start.e1, start.e2, start.e3)

    def newton(t: float, s: np.ndarray) -> np.ndarray:
        r, v = s[:3], s[3:]
        angle = WGS84.Omega * t
        c, n = math.cos(angle), math.sin(angle)
        fixed = np.array([[c, n, 0.0], [-n, c, 0.0], [0.0, 0.0, 1.0]])
        _, longitude, h = geodetic(WGS84, *(fixed @ r))
        east = fixed.T @ [-math.sin(longitude), math.cos(longitude), 0.0]
        relative = v - np.cross(omega, r) - 6.0 * east
        drag = 0.5 * standard_atmosphere(h).rho * np.linalg.norm(relative) * BALL.S * BALL.CD / LOPSIDED.m
        return np.concatenate([v, np.array(gravitation(WGS84, *r)) - drag * relative])

    r0 = np.array(start[:3])
    v0 = np.array(turned(R, start.u, start.v, start.w)) + np.cross(omega, r0)
    end = solve_ivp(newton, (0.0, 30.0), [*r0, *v0], method="DOP853", rtol=1e-12, atol=1e-9).y[:3, -1]
    angle = WGS84.Omega * 30.0
    c, n = math.cos(angle), math.sin(angle)
    x = flown(plant, 30.0)
    expected = [c * end[0] + n * end[1], -n * end[0] + c * end[1], end[2]]
    assert [x.x, x.y, x.z] == pytest.approx(expected, abs=10.0 * MICROMETER)


def test_euler_equations_against_the_tensor_itself() -> None:
    """I omega_dot = M - omega x (I omega + h), solved by NumPy."""
    with_rotor = LOPSIDED._replace(Hx=7.0)
    tensor = np.array([[2.0, 0.3, -0.5], [0.3, 3.0, -0.2], [-0.5, -0.2, 4.0]])
    omega, moment = np.array([0.4, -0.7, 1.1]), np.array([1.0, 2.0, -3.0])
    expected = np.linalg.solve(tensor, moment - np.cross(omega, tensor @ omega + [7.0, 0.0, 0.0]))
    assert angular_acceleration(with_rotor, *omega, *moment) == pytest.approx(expected, rel=1e-13)


@settings(max_examples=200)
@given(
    some.sampled_from(list(EARTHS.values())),
    some.floats(-1.6, 1.6),
    some.floats(-4000.0, 80000.0),
    some.tuples(*[some.floats(-900.0, 900.0)] * 3),
    some.tuples(*[some.floats(-7.0, 7.0)] * 3),
    some.tuples(*[some.floats(-30.0, 30.0)] * 3),
)
def test_no_state_within_the_atmosphere_gives_what_is_no_number(
    earth: Earth, latitude: float, h: float, velocity: Three, attitude: Three, rates: Three
) -> None:
    latitude = max(min(latitude, 0.5 * math.pi), -0.5 * math.pi)
    start = state_at(earth, (latitude, 1.0, h), velocity, attitude, rates)
    plant = body(earth, start, BALL._replace(Cl_p=-0.4, Cm_q=-9.0, Cn_r=-0.2))
    assert all(map(math.isfinite, plant.advance(start, Surfaces(), Air(), 0.001)))
    assert all(map(math.isfinite, plant.observe(start, Surfaces(), Air())))


def test_whoever_leaves_the_atmosphere_is_told_so() -> None:
    start = state_at(ROUND, (0.0, 0.0, 85000.0), (0.0, 0.0, -1000.0), (0.0, 0.0, 0.0))
    with pytest.raises(Departed, match=r"its height reached 85,9\d\d m, and the atmosphere .* to 85,900 m"):
        flown(body(ROUND, start), 2.0)


def test_a_flat_earth_has_no_latitude() -> None:
    with pytest.raises(SpecError, match="no latitude and longitude: use north and east"):
        geodetic(FLAT, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("earth", list(EARTHS.values()), ids=list(EARTHS))
def test_a_flight_can_begin_at_another_height(earth: Earth) -> None:
    start = state_at(earth, (0.8, 0.1, 1000.0), (50.0, 0.0, 0.0), (0.0, 0.1, 0.0))
    plant = body(earth, start)
    y = plant.observe(plant.start(4000.0), Surfaces(), Air())
    assert y.h == pytest.approx(4000.0, abs=MICROMETER)
    assert (y.north, y.east) == pytest.approx((0.0, 0.0), abs=1e-3)
    assert raised(earth, plant.start(4000.0), 1000.0) == pytest.approx(start, abs=1e-6)


def test_a_warm_day_is_thin_at_the_pressure_of_the_standard_day() -> None:
    """ISA + 20 K at sea level: 35 degrees Celsius, 1.1455 kg/m^3 by the gas law."""
    warm, standard = standard_atmosphere(0.0, 20.0), standard_atmosphere(0.0)
    assert (warm.T, warm.p) == (308.15, standard.p)
    assert warm.rho == pytest.approx(1.1455, abs=5e-5)
    assert warm.a == pytest.approx(standard.a * math.sqrt(308.15 / 288.15), rel=1e-14)


def test_rotations_there_and_back() -> None:
    R = rotation(*quaternion(0.4, -1.2, 2.5))
    assert turned_back(R, *turned(R, 1.0, 2.0, 3.0)) == pytest.approx((1.0, 2.0, 3.0), rel=1e-14)
    assert euler_angles(R) == pytest.approx((0.4, -1.2, 2.5), rel=1e-14)
    assert turned(rotation(*quaternion(0.0, 0.0, 90.0 * DEG)), 1.0, 0.0, 0.0) == pytest.approx((0.0, 1.0, 0.0))  # east
    assert turned(rotation(*quaternion(0.0, 90.0 * DEG, 0.0)), 1.0, 0.0, 0.0) == pytest.approx((0.0, 0.0, -1.0))  # up
    assert turned(rotation(*quaternion(90.0 * DEG, 0.0, 0.0)), 0.0, 1.0, 0.0) == pytest.approx((0.0, 0.0, 1.0))  # down
