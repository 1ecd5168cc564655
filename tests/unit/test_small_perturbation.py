"""The linear plant: signs, forms, and that each of its solvers solves its equations."""

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.control import exact_hold
from fdes.flight import plant_of
from fdes.physics.derivatives import FORMS, dimensional, stability_axis_inertia
from fdes.physics.signals import Air, Surfaces
from fdes.physics.small_perturbation import PerturbationState, SmallPerturbation
from fdes.units import DEG

CALM = Air()
STIRRED = PerturbationState(3.0, -2.0, 0.05, 0.03, -0.04, 0.2, -0.03, 0.1, 0.02, 10.0, 20.0, 500.0)


@pytest.fixture
def skyhawk() -> SmallPerturbation:
    return plant_of(load("A-4D").at("M0.4_SL"))


def test_undisturbed_flight_stays_undisturbed(skyhawk: SmallPerturbation) -> None:
    x = skyhawk.start()
    dx = skyhawk.derivative(x, skyhawk.trim(), CALM)
    assert dx == PerturbationState(north=skyhawk.reference.V)
    y = skyhawk.observe(x, skyhawk.trim(), CALM)
    assert (y.n_x, y.n_y, y.n_z) == (0.0, 0.0, 1.0)
    assert y.theta == y.alpha == pytest.approx(4.7 * DEG)
    assert y.mach == pytest.approx(0.4)
    assert y.cas == pytest.approx(y.eas, rel=1e-3) == y.V


@pytest.mark.parametrize("name", ["A-4D", "NAVION"])
@pytest.mark.parametrize("form", FORMS)
def test_signs(name: str, form: str) -> None:
    plant = plant_of(load(name).at(), form=form)
    x, trim = plant.start(), plant.trim()

    def after_a_quarter_second(**surface: float) -> PerturbationState:
        y = x
        for _ in range(30):
            y = plant.advance(y, trim._replace(**surface), CALM, 1 / 120, 1)
        return y

    assert after_a_quarter_second(elevator=1 * DEG).q < 0.0
    assert after_a_quarter_second(aileron=1 * DEG).phi > 0.0
    assert after_a_quarter_second(rudder=1 * DEG).r < 0.0
    assert after_a_quarter_second(throttle=1.0).u > 0.0


def test_gust_from_below_lifts_and_gust_from_the_right_is_sideslip_to_the_right(skyhawk: SmallPerturbation) -> None:
    x = skyhawk.start()
    rising = skyhawk.observe(x, skyhawk.trim(), Air(gust_w=-5.0))
    assert rising.n_z > 1.0
    assert rising.alpha > skyhawk.reference.alpha
    from_right = skyhawk.observe(x, skyhawk.trim(), Air(gust_v=-5.0))
    assert from_right.beta > 0.0


def test_steady_wind_moves_the_ground_track_and_nothing_else(skyhawk: SmallPerturbation) -> None:
    still = skyhawk.derivative(STIRRED, skyhawk.trim(), CALM)
    blown = skyhawk.derivative(STIRRED, skyhawk.trim(), Air(wind_north=3.0, wind_east=-4.0, wind_down=1.0))
    assert blown == pytest.approx(still._replace(north=still.north + 3.0, east=still.east - 4.0, h=still.h - 1.0))


def test_surfaces_stop_at_their_limits(skyhawk: SmallPerturbation) -> None:
    most = skyhawk.limits.upper.aileron
    asked = Surfaces(aileron=10.0 * most, throttle=skyhawk.trim_throttle)
    y = skyhawk.observe(STIRRED, asked, CALM)
    assert y.aileron == most
    assert y == skyhawk.observe(STIRRED, asked._replace(aileron=most), CALM)


def test_inertia_rotation_keeps_trace_and_determinant() -> None:
    ref = load("A-4D").at("M0.4_SL").reference
    Ix, Iz, Ixz = stability_axis_inertia(ref)
    assert Ix + Iz == pytest.approx(ref.Ix + ref.Iz)
    assert Ix * Iz - Ixz**2 == pytest.approx(ref.Ix * ref.Iz - ref.Ixz**2)
    assert stability_axis_inertia(ref._replace(alpha=0.0)) == (ref.Ix, ref.Iz, ref.Ixz)


@pytest.mark.parametrize("form", FORMS)
def test_exact_hold_is_the_limit_of_ever_smaller_steps(form: str) -> None:
    condition = load("A-4D").at("M0.4_SL")
    held = Surfaces(-0.02, 0.05, 0.01, 0.5)
    air = Air(gust_u=1.0, gust_v=-2.0, gust_w=3.0)
    exact = plant_of(condition, form, "exact", 0.1)
    fine = plant_of(condition, form, "dopri5")
    x, y = STIRRED, STIRRED
    for _ in range(20):
        x = exact.advance(x, held, air, 0.1, 1)
        y = fine.advance(y, held, air, 0.1, 50)
    assert x[:9] == pytest.approx(y[:9], rel=1e-10, abs=1e-12)
    assert x[9:] == pytest.approx(y[9:], abs=0.5)  # m: the place follows by the trapezoidal rule, here with 0.1 s steps


def test_exact_hold_matches_the_continuous_matrix(skyhawk: SmallPerturbation) -> None:
    hold = exact_hold(skyhawk.matrices, skyhawk.reference, 1e-6)
    np.testing.assert_allclose(
        (np.array(hold.Phi_lon) - np.eye(4)) / 1e-6, skyhawk.matrices.A_lon, rtol=1e-3, atol=1e-3
    )


def test_mirror_symmetry(skyhawk: SmallPerturbation) -> None:
    """Flying the mirror image is the mirror image of flying."""
    odd = {"beta", "p", "r", "phi", "psi", "east"}

    def mirror(x: PerturbationState) -> PerturbationState:
        return PerturbationState(**{n: -v if n in odd else v for n, v in x._asdict().items()})

    held = Surfaces(0.02, 0.05, -0.03, 0.4)
    image = Surfaces(0.02, -0.05, 0.03, 0.4)
    one = skyhawk.advance(STIRRED, held, CALM, 0.01, 5)
    other = skyhawk.advance(mirror(STIRRED), image, CALM, 0.01, 5)
    assert mirror(other) == pytest.approx(one, abs=1e-12)


def test_steady_roll_rate_is_that_of_one_degree_of_freedom() -> None:
    """p = -(L_da / L_p) da, the pure rolling motion of Nelson, section 5.3, with the value that UTM-FDES data give."""
    condition = load("A-4D").at("M0.4_SL", variant="printed")
    k, ref = condition.coefficients, condition.reference
    expected = -k.Cl_da / k.Cl_p * 2.0 * ref.V / ref.b * 0.2618
    assert expected == pytest.approx(2.6163, rel=1e-3)


def test_a_steady_slip_to_the_right_pushes_left_and_a_coordinated_turn_not_at_all(skyhawk: SmallPerturbation) -> None:
    """n_y is the side force alone: Y / (m g) = Y_beta beta / g."""
    ref = skyhawk.reference
    slipping = PerturbationState(beta=5 * DEG, r=0.1, phi=0.3)
    condition = load("A-4D").at("M0.4_SL")
    Y_beta = condition.coefficients.Cy_beta * 0.5 * ref.rho * ref.V**2 * ref.S / ref.m
    found = skyhawk.observe(slipping, skyhawk.trim(), CALM)
    assert found.n_y == pytest.approx(Y_beta * 5 * DEG / ref.g)
    assert found.n_y < 0.0
    turning = PerturbationState(r=ref.g * 0.3 / ref.V, phi=0.3)
    assert skyhawk.observe(turning, skyhawk.trim(), CALM).n_y == pytest.approx(0.0, abs=1e-12)


def test_thrust_is_felt_forward_and_drag_backward(skyhawk: SmallPerturbation) -> None:
    """n_x is thrust less drag alone: pitching up level changes gravity along the axis, not what is felt."""
    ref = skyhawk.reference
    more = skyhawk.trim()._replace(throttle=skyhawk.trim_throttle + 0.1)
    assert skyhawk.observe(PerturbationState(), more, CALM).n_x == pytest.approx(0.1 * ref.T_max / (ref.m * ref.g))
    assert skyhawk.observe(PerturbationState(theta=0.1), skyhawk.trim(), CALM).n_x == pytest.approx(0.0, abs=1e-12)
    assert skyhawk.observe(PerturbationState(u=10.0), skyhawk.trim(), CALM).n_x < 0.0


def test_a_drag_of_the_elevator_slows_down() -> None:
    condition = load("A-4D").at("M0.4_SL")
    k = condition.coefficients._replace(CD_de=0.5)
    d = dimensional(k, condition.reference, "full")
    ref = condition.reference
    assert d.X_de == pytest.approx(-0.5 * 0.5 * ref.rho * ref.V**2 * ref.S / ref.m)
