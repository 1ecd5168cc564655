"""Variable stability: what a change changes, what goes with it, and what it leaves alone."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fdes.aircraft import Change, FlightCondition, catalogue, edited, load
from fdes.aircraft.edit import editable, read_change, unit_of, value_of
from fdes.aircraft.knobs import knobs
from fdes.analysis import modes
from fdes.analysis.approximations import static_figures
from fdes.physics.derivatives import Coefficients
from fdes.units import FOOT, G0

A4D = load("A-4D").at("M0.4_SL")
ALL = [a.at(c.id, variant) for a in catalogue() for c in a.conditions for variant in ("corrected", "printed")]


def short_period(condition: FlightCondition) -> float:
    return next(m.zeta for m in modes(condition) if m.name == "short_period")


@pytest.mark.parametrize(("factor", "zeta"), [(1.0, 0.36), (0.5, 0.28), (0.0, 0.195)])
def test_less_pitch_damping_damps_the_short_period_less(factor: float, zeta: float) -> None:
    assert short_period(edited(A4D, [f"Cm_q*={factor}"])) == pytest.approx(zeta, abs=0.005)


def test_a_derivative_is_set_multiplied_and_added_to() -> None:
    after = edited(A4D, ["Cm_alpha=-0.3", "Cn_r*=2", "Cl_p+=-0.04"])
    assert after.coefficients == A4D.coefficients._replace(Cm_alpha=-0.3, Cn_r=-0.7, Cl_p=-0.26 + -0.04)
    assert replace(after, aerodynamics=A4D.aerodynamics, changes=()) == A4D


def test_changes_are_made_in_their_order() -> None:
    assert edited(A4D, ["Cm_q=-2", "Cm_q*=3"]).coefficients.Cm_q == -6.0
    assert edited(A4D, ["Cm_q*=3", "Cm_q=-2"]).coefficients.Cm_q == -2.0


def test_all_numbers_can_be_named_by_what_people_say() -> None:
    assert edited(A4D, ["mass*=1.1"]).reference.m == pytest.approx(1.1 * A4D.reference.m)
    assert edited(A4D, ["altitude=10000 ft"]).reference.h == 10000 * FOOT
    assert edited(A4D, ["Cm_alpha=-0.0066 1/deg"]).coefficients.Cm_alpha == pytest.approx(-0.378, abs=1e-3)


def test_the_neutral_point_stays_where_it_is_when_the_center_of_gravity_moves() -> None:
    before = static_figures(A4D, A4D.cg)
    aft = edited(A4D, ["cg+=0.05"])
    after = static_figures(aft, aft.cg)
    assert aft.cg == pytest.approx(0.30)
    assert after.neutral_point == pytest.approx(before.neutral_point, abs=1e-12)
    assert after.static_margin == pytest.approx(before.static_margin - 0.05, abs=1e-12)


def test_at_the_neutral_point_there_is_no_pitch_stiffness() -> None:
    neutral = static_figures(A4D, A4D.cg).neutral_point
    assert edited(A4D, [f"cg={neutral!r}"]).coefficients.Cm_alpha == pytest.approx(0.0, abs=1e-12)


def linear(k: Coefficients, of: str, **motion: float) -> float:
    """A coefficient from its derivatives, for small motions."""
    return sum(getattr(k, f"{of}_{name}", 0.0) * value for name, value in motion.items())


@given(
    x=st.floats(-0.3, 0.3),
    alpha=st.floats(-0.1, 0.1),
    q=st.floats(-0.01, 0.01),
    beta=st.floats(-0.1, 0.1),
    r=st.floats(-0.01, 0.01),
)
def test_moments_about_a_new_center_are_those_of_the_same_forces(
    x: float, alpha: float, q: float, beta: float, r: float
) -> None:
    """The air at the old center, in motion about the new one, gives the forces; their moments are taken by hand."""
    ref, k = A4D.reference, A4D.coefficients
    moved = edited(A4D, [Change("cg", "+=", x, "1")]).coefficients
    ahead = x * ref.c  # of the new center lies the old one [m]
    rate_q, rate_r = q * 2.0 * ref.V / ref.c, r * 2.0 * ref.V / ref.b  # rad/s
    there = {"alpha": alpha - rate_q * ahead / ref.V, "q": q}
    aside = {"beta": beta + rate_r * ahead / ref.V, "r": r}
    lift, side = linear(k, "CL", **there), linear(k, "Cy", **aside)
    assert linear(moved, "CL", alpha=alpha, q=q) == pytest.approx(lift, abs=1e-12)
    assert linear(moved, "Cm", alpha=alpha, q=q) == pytest.approx(linear(k, "Cm", **there) + lift * x, abs=1e-12)
    assert linear(moved, "Cy", beta=beta, r=r) == pytest.approx(side, abs=1e-12)
    assert linear(moved, "Cl", beta=beta, r=r) == pytest.approx(linear(k, "Cl", **aside), abs=1e-12)
    by_side = side * ahead / ref.b
    assert linear(moved, "Cn", beta=beta, r=r) == pytest.approx(linear(k, "Cn", **aside) + by_side, abs=1e-12)


@pytest.mark.parametrize("change", ["m*=1.3", "V=170 m/s", "mach=0.6", "h=20000 ft", "S*=1.2"])
def test_lift_carries_the_weight_again(change: str) -> None:
    def carried(condition: FlightCondition) -> float:
        ref = condition.reference
        return condition.coefficients.CL * 0.5 * ref.rho * ref.V**2 * ref.S / (ref.m * G0)

    after = edited(A4D, [change])
    assert carried(after) == pytest.approx(carried(A4D), rel=1e-12)
    rise = after.coefficients.CL - A4D.coefficients.CL
    assert after.reference.alpha - A4D.reference.alpha == pytest.approx(rise / A4D.coefficients.CL_alpha)
    # On one parabola: CD - K CL^2 is the same, and so is K.
    for polar in (A4D, after):
        k = polar.coefficients
        K = k.CD_alpha / (2.0 * k.CL * k.CL_alpha)
        assert pytest.approx(0.3 / (2.0 * 0.28 * 3.45)) == K
        assert pytest.approx(0.03 - 0.3 * 0.28 / (2.0 * 3.45)) == k.CD - K * k.CL**2
    ref = after.reference
    drag = after.coefficients.CD * 0.5 * ref.rho * ref.V**2 * ref.S
    assert after.trim_throttle * ref.T_max == pytest.approx(drag)


def test_speed_and_mach_number_go_together() -> None:
    sound = A4D.reference.V / A4D.reference.mach
    assert edited(A4D, ["V=170 m/s"]).reference.mach == pytest.approx(170.0 / sound)
    assert pytest.approx(0.5 * sound) == edited(A4D, ["mach=0.5"]).reference.V


def test_dimensional_derivatives_can_be_changed_too() -> None:
    before = load("B747_CR2144").at()
    after = edited(before, ["M_q*=2"])
    assert after.equations("full").A_lon[2] != before.equations("full").A_lon[2]
    assert after.equations("full").A_lat == before.equations("full").A_lat


@pytest.mark.parametrize("condition", ALL, ids=lambda c: f"{c.aircraft_id} {c.condition} {c.variant}")
def test_every_number_of_every_aircraft_can_be_changed(condition: FlightCondition) -> None:
    for knob in knobs(condition):
        assert knob.low < knob.high
        assert knob.low <= knob.value <= knob.high
        assert knob.value == value_of(condition, knob.name)
        if knob.name == "T_max":  # half of it may be too little
            continue
        asked = Change(knob.name, "+=", 0.01 * (knob.high - knob.low), knob.unit)
        after = edited(condition, [asked])
        assert value_of(after, knob.name) == pytest.approx(knob.value + asked.amount)
        assert after.changes == (asked,)
        assert modes(after)


@given(
    name=st.sampled_from(editable(A4D)),
    operator=st.sampled_from(["=", "*=", "+="]),
    amount=st.floats(allow_nan=False, allow_infinity=False),
)
def test_a_change_can_be_read_again_from_its_text(name: str, operator: str, amount: float) -> None:
    change = Change(name, operator, amount, unit_of(A4D, name))  # type: ignore[arg-type]  # one of the three
    assert read_change(A4D, str(change)) == change
