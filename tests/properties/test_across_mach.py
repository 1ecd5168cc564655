"""An aircraft interpolated across Mach: at each of its conditions it is that one, and smooth between them."""

import tomllib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from fdes.aircraft import Aircraft, FlightCondition, edited, load, parse
from fdes.aircraft.load import HANGAR
from fdes.analysis.jacobian import linearized
from fdes.analysis.nonlinear_response import simulate_nonlinear
from fdes.analysis.trim import TrimSpec, solve, trim
from fdes.analysis.what_if import what_if
from fdes.errors import SpecError
from fdes.flight import Clock
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.across_mach import AcrossMach, Between, conditions_of, loads_between, mach_derivatives, static
from fdes.physics.aero import Flow, derivative_loads
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import dimensional, matrices
from fdes.physics.plant import SixDof, state_at
from fdes.physics.rigid_body import Inertia
from fdes.physics.signals import Air, Surfaces
from fdes.units import DEG

ENDS = ("M0.4_SL", "M0.8_35kft")
FIRST, SECOND = ENDS


def skyhawk(alpha: float | None = None, cg: float | None = None) -> Aircraft:
    """The A-4D, as if its second condition had that trim angle of attack [deg] and center of gravity."""
    document = tomllib.loads((HANGAR / "a4d.toml").read_text(encoding="utf-8"))
    second = document["conditions"][1]
    if alpha is not None:
        second["trim_alpha"] = {"printed": alpha, "unit": "deg"}
    if cg is not None:
        second["mass"] = {**document["mass"], "cg": cg}
    return parse(document, "the test's aircraft")


def flow(mach: float, alpha: float, beta: float = 0.0, rate: float = 0.0) -> Flow:
    u, v, w = 100.0 * np.cos(alpha), 100.0 * beta, 100.0 * np.sin(alpha)
    return Flow(100.0, u, v, w, alpha, beta, rate, rate, -rate, 1.0, mach, 5000.0)


def full_form_of(condition: FlightCondition, plant: SixDof) -> None:
    """Trimmed at its speed and height with the mass that its lift carries, `plant` is the full form of `condition`."""
    ref = condition.reference
    air = standard_atmosphere(ref.h)
    lift = 0.5 * air.rho * ref.V**2 * ref.S * condition.coefficients.CL
    plant = plant._replace(inertia=plant.inertia._replace(m=lift / ref.g), earth=plant.earth._replace(g=ref.g))
    balanced = ref._replace(rho=air.rho, mach=ref.V / air.a, m=lift / ref.g)
    point = solve(plant, TrimSpec(ref.V, ref.h))
    assert (point.alpha, point.surfaces.elevator) == pytest.approx((ref.alpha, 0.0), abs=1e-10)
    found = linearized(point, thrust_held=True)
    full = matrices(dimensional(condition.coefficients, balanced, "full"), balanced, "full")
    for ours, expected in (
        (found.A[:4, :4], full.A_lon),
        (found.A[4:, 4:], full.A_lat),
    ):
        np.testing.assert_allclose(ours, expected, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("name", ENDS)
def test_chosen_at_either_end_it_is_the_full_form_with_the_printed_mach_derivatives(name: str) -> None:
    condition = load("A-4D").at(name, across="mach")
    full_form_of(condition, six_dof_of(condition))


@pytest.mark.parametrize(("chosen", "there"), [ENDS, ENDS[::-1]])
def test_flown_from_one_end_to_the_other_it_is_the_full_form_of_that(chosen: str, there: str) -> None:
    """With the loading and the engine of that; both angles of attack known, so that one body has both."""
    aircraft = skyhawk(alpha=3.9)
    plant, other = six_dof_of(aircraft.at(chosen, across="mach")), aircraft.at(there)
    ref = other.reference
    engine = six_dof_of(other).engine  # its thrust is along the flight path of its own condition
    full_form_of(other, plant._replace(inertia=Inertia(ref.m, ref.Ix, ref.Iy, ref.Iz, ref.Ixz), engine=engine))


@pytest.mark.parametrize("end", [0, 1])
def test_no_kink_at_the_ends(end: int) -> None:
    """Slopes over Mach to either side of a condition at its trim are the printed Mach derivatives."""
    aero: Between = six_dof_of(load("A-4D").at(across="mach")).aero
    here = conditions_of(aero)[end]
    step = 1e-6

    def coefficients(mach: float) -> np.ndarray:
        at = flow(mach, here.alpha_0)
        loads = loads_between(aero, at, Surfaces())
        ca, sa = np.cos(at.alpha), np.sin(at.alpha)
        lift, drag = loads.X * sa - loads.Z * ca, -loads.X * ca - loads.Z * sa
        return np.array([lift, drag, loads.M / here.c]) / (at.qbar * here.S)

    middle = coefficients(here.mach_0)
    np.testing.assert_allclose(middle, static(here, here.alpha_0), rtol=1e-12, atol=1e-15)
    for side in (step, -step):
        slope = (coefficients(here.mach_0 + side) - middle) / side
        np.testing.assert_allclose(slope, mach_derivatives(here), atol=1e-5)


def test_halfway_every_derivative_is_the_mean() -> None:
    aero: Between = six_dof_of(skyhawk(alpha=4.7).at(across="mach")).aero
    low, high = conditions_of(aero)
    half = 0.5 * (low.mach_0 + high.mach_0)

    def change(alpha: float, beta: float, rate: float, *surfaces: float) -> np.ndarray:
        rest = loads_between(aero, flow(half, low.alpha_0), Surfaces())
        moved = loads_between(aero, flow(half, low.alpha_0 + alpha, beta, rate), Surfaces(*surfaces))
        return np.subtract(moved, rest)

    def mean(alpha: float, beta: float, rate: float, *surfaces: float) -> np.ndarray:
        ends = []
        for a in (low, high):
            rest = derivative_loads(a, flow(a.mach_0, low.alpha_0), Surfaces())
            moved = derivative_loads(a, flow(a.mach_0, low.alpha_0 + alpha, beta, rate), Surfaces(*surfaces))
            ends.append(np.subtract(moved, rest))
        return 0.5 * (ends[0] + ends[1])

    for asked in ((0.0, 0.05, 0.1, 0.02, 0.03, -0.04), (0.0, 0.0, 0.0, 0.1, 0.0, 0.0)):
        np.testing.assert_allclose(change(*asked), mean(*asked), rtol=1e-9, atol=1e-6)


@pytest.mark.parametrize(("mach", "end"), [(0.25, 0), (0.9, 1)])
def test_beyond_it_is_the_plant_of_the_nearest_condition(mach: float, end: int) -> None:
    aero: Between = six_dof_of(load("A-4D").at(across="mach")).aero
    at, held = flow(mach, 0.1, 0.03, 0.2), Surfaces(0.05, 0.02, -0.03)
    assert loads_between(aero, at, held) == derivative_loads(conditions_of(aero)[end], at, held)


def test_lift_ends_at_the_same_angle_where_an_angle_of_attack_is_not_known() -> None:
    for chosen in ENDS:
        sets = conditions_of(six_dof_of(load("A-4D").at(chosen, across="mach")).aero)
        low, high = (a.alpha_0 - a.k.CL / a.k.CL_alpha for a in sets)
        assert low == pytest.approx(high, abs=1e-12)
    assert six_dof_of(skyhawk(alpha=3.0).at(across="mach")).aero.high.alpha_0 == pytest.approx(3.0 * DEG)


def test_a_change_is_made_to_both_ends_and_the_flight_condition_is_not() -> None:
    aircraft = load("A-4D")
    calm = edited(aircraft.at(across="mach"), ["Cn_r*=2", "cg+=0.03", "Ix*=1.5"])
    apart = [edited(aircraft.at(name), ["Cn_r*=2", "cg+=0.03"]) for name in ENDS]
    assert [c.coefficients for c in (calm, *calm.across)] == [c.coefficients for c in apart]
    assert calm.across[0].reference == aircraft.at(SECOND).reference


def test_changed_to_the_mach_number_of_the_other_condition_there_is_nothing_between() -> None:
    condition = skyhawk(alpha=4.0).at(across="mach")
    there = condition.across[0].reference
    mach = there.V / standard_atmosphere(there.h).a
    with pytest.raises(SpecError, match="is at the Mach number of another condition"):
        six_dof_of(edited(condition, [f"mach={mach!r}"]))


def test_moments_of_the_other_condition_are_about_the_chosen_center_of_gravity() -> None:
    moved = skyhawk(alpha=4.0, cg=0.35).at(FIRST, across="mach").across[0]
    there = skyhawk(alpha=4.0).at(SECOND)
    # Its derivatives were about 0.35, so about 0.25 it is more stable by a tenth of the lift slope.
    assert moved.cg == 0.25
    assert moved.coefficients.Cm_alpha == pytest.approx(there.coefficients.Cm_alpha - 0.1 * there.coefficients.CL_alpha)


def test_every_speed_between_trims_and_the_needs_vary_smoothly() -> None:
    condition = load("A-4D").at(across="mach")
    plant, h = six_dof_of(condition), 6000.0
    a = standard_atmosphere(h).a
    points = [trim(plant, TrimSpec(mach * a, h)) for mach in np.linspace(0.35, 0.85, 26)]
    assert max(p.residual for p in points) < 1e-10
    throttle = np.array([p.surfaces.throttle for p in points])
    elevator = np.array([p.surfaces.elevator for p in points]) / DEG
    assert np.abs(np.diff(throttle, 2)).max() < 0.02
    assert np.abs(np.diff(elevator, 2)).max() < 0.5


def test_a_flight_is_flown_again_bit_for_bit_and_says_where_it_was_beyond() -> None:
    condition = edited(load("A-4D").at(across="mach"), ["Cm_q*=1.5"])
    dive = simulate_nonlinear(
        condition, ["step throttle 0.6 at 1s"], clock=Clock(0.05, duration=20.0), spec=TrimSpec(140.0, 1000.0)
    )
    assert dive.header["across"] == "mach"
    again = what_if(dive).recording
    np.testing.assert_array_equal(dive.data, again.data)
    alone = what_if(dive, "condition=M0.4_SL").recording
    assert alone.header["across"] == "mach"
    slow = simulate_nonlinear(condition, clock=Clock(0.05, duration=1.0), spec=TrimSpec(100.0, 1000.0))
    assert any(n.startswith("mach is beyond its conditions from t = 0 s on: ") for n in slow.header["assumptions"])
    between = simulate_nonlinear(condition, clock=Clock(0.05, duration=1.0), spec=TrimSpec(200.0, 1000.0))
    assert not any("beyond its conditions" in n for n in between.header["assumptions"])


def test_three_conditions_are_two_pieces_that_meet_without_a_kink() -> None:
    """The middle one is the full form of itself, whichever is chosen."""
    document = tomllib.loads((HANGAR / "a4d.toml").read_text(encoding="utf-8"))
    first, second = document["conditions"]
    second["trim_alpha"] = {"printed": 3.9, "unit": "deg"}
    middle = {**second, "id": "between", "mach": 0.6, "altitude": {"printed": 20000, "unit": "ft"}}
    middle["derivatives"] = {**second["derivatives"], "CL": 0.25, "Cm_alpha": -0.35, "CL_M": 0.08, "Cm_M": -0.02}
    document["conditions"] = [first, second, middle]
    aircraft = parse(document, "the test's aircraft")
    plant = six_dof_of(aircraft.at("between", across="mach"))
    assert isinstance(plant.aero, AcrossMach)
    assert [round(a.mach_0, 3) for a in conditions_of(plant.aero)] == [0.4, 0.6, 0.8]
    full_form_of(aircraft.at("between"), plant)
    slower, faster = (plant._replace(aero=piece, aerodynamics=loads_between) for piece in plant.aero.pieces)
    for one in (slower, faster):
        full_form_of(aircraft.at("between"), one)
    at, held = flow(0.7, 0.05), Surfaces(0.02)
    assert plant.aerodynamics(plant.aero, at, held) == loads_between(faster.aero, at, held)
    assert plant.aerodynamics(plant.aero, at._replace(mach=0.5), held) == loads_between(
        slower.aero, at._replace(mach=0.5), held
    )


SPEEDS, ANGLES, HEIGHTS = some.floats(0.0, 700.0), some.floats(-3.2, 3.2), some.floats(-4000.0, 80000.0)
SURFACES = some.builds(Surfaces, *[some.floats(-1.0, 1.0)] * 3, some.floats(-0.5, 1.5))
WHOLE = six_dof_of(load("A-4D").at(across="mach", spool=True))


@settings(max_examples=150, deadline=None)
@given(SPEEDS, ANGLES, some.floats(-1.5, 1.5), HEIGHTS, some.tuples(*[some.floats(-6.0, 6.0)] * 3), SURFACES)
def test_no_state_of_the_envelope_gives_what_is_no_number(
    V: float, alpha: float, beta: float, h: float, rates: tuple[float, float, float], held: Surfaces
) -> None:
    still = state_at(WHOLE.earth, (0.0, 0.0, h), (0.0, 0.0, 0.0), (0.3, 0.2, 0.1), rates)
    x = still._replace(u=V * np.cos(alpha) * np.cos(beta), v=V * np.sin(beta), w=V * np.sin(alpha) * np.cos(beta))
    assert np.isfinite(WHOLE.observe(x, held, Air())).all()
    assert np.isfinite(WHOLE.advance(x, held, Air(), 1.0 / 120.0)).all()
