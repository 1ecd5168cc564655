"""Steady flights asked for in other words than speed, path and turn: what is asked for is what is flown."""

import math
from itertools import product

import pytest

from fdes.aircraft import load
from fdes.analysis.airspeeds import airspeeds
from fdes.analysis.jacobian import linearized
from fdes.analysis.trim import TrimPoint, TrimSpec, spec_of, trim
from fdes.errors import SpecError
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.signals import Air
from fdes.units import DEG, FOOT, G0, KNOT

DEFAULT = TrimSpec(V=150.0, h=1500.0)
TURNS = ["bank=45 deg", "turn=2 g", "turn=-2 g"]
BENT = ["n=2", "n=0.3", "q=4 deg/s", "q=-4 deg/s"]


def flown(aircraft: str, text: str) -> TrimPoint:
    return trim(six_dof_of(load(aircraft).at()), spec_of(text, DEFAULT))


@pytest.mark.parametrize("aircraft", ["A-4D", "F-16"])
@pytest.mark.parametrize(("text", "also"), [*product(BENT + TURNS, ["", " throttle=0.2"]), *product(TURNS, [" n_y=0"])])
def test_nothing_is_left_but_what_bends_the_path(aircraft: str, text: str, also: str) -> None:
    point = flown(aircraft, text + also)
    y = point.outputs()
    d = point.plant.derivative(point.state, point.plant.trim(), Air())
    assert max(abs(v) for v in (d.u, d.v, d.w, d.p, d.q, d.r)) < 1e-8
    assert (y.V, y.h) == pytest.approx((150.0, 1500.0))
    value = float(text.split("=")[1].split(maxsplit=1)[0])
    if "bank" in text:
        assert y.phi == pytest.approx(45.0 * DEG)
    if "turn" in text:
        assert y.n_z == pytest.approx(2.0, abs=1e-9)
        assert math.copysign(1.0, y.psi_dot) == math.copysign(1.0, value)
    if text.startswith("n="):
        assert y.n_z == pytest.approx(value, abs=1e-9)
        assert y.q == pytest.approx(G0 * (value - math.cos(y.theta)) / (150.0 * math.cos(y.alpha)), rel=0.01)
    if text.startswith("q="):
        assert y.q == pytest.approx(value * DEG)
    if "n_y" in also:
        assert y.n_y == pytest.approx(0.0, abs=1e-9)
    if "throttle" in also:
        assert y.throttle == pytest.approx(0.2)
        assert y.gamma == pytest.approx(point.spec.gamma)


def test_a_coordinated_turn_takes_the_load_factor_of_its_bank() -> None:
    """n = 1 / cos(phi) where the force is across the path. Stevens et al., sec. 3.6; n_z is that along the body."""
    y = flown("F-16", "V=250 m/s bank=60 deg n_y=0").outputs()
    assert math.hypot(y.n_z, y.n_x) == pytest.approx(2.0, rel=0.01)
    assert y.psi_dot == pytest.approx(G0 * math.tan(60.0 * DEG) / 250.0, rel=0.02)


def test_a_bank_without_a_turn_is_a_sideslip() -> None:
    point = flown("B747", "V=110 m/s h=0 m bank=5 deg turn=0")
    y = point.outputs()
    assert (y.phi, y.psi_dot) == pytest.approx((5.0 * DEG, 0.0), abs=1e-9)
    assert y.beta > 0.0
    back = flown("B747", f"V=110 m/s h=0 m beta={y.beta} rad")
    assert back.phi == pytest.approx(5.0 * DEG, rel=1e-6)


def test_an_approach_at_an_angle_of_attack_finds_its_speed() -> None:
    point = flown("F-16", "alpha=11 deg gamma=-3 deg h=0 m")
    y = point.outputs()
    assert (y.alpha, y.gamma) == pytest.approx((11.0 * DEG, -3.0 * DEG))
    assert 60.0 < point.spec.V < 90.0
    again = flown("F-16", f"V={point.spec.V} m/s gamma=-3 deg h=0 m")
    assert again.alpha == pytest.approx(11.0 * DEG, rel=1e-6)


@pytest.mark.parametrize(
    ("text", "V"),
    [
        ("M=0.6 h=20000 ft", airspeeds("mach", 0.6, 20000 * FOOT).tas),
        ("CAS=250kt h=20000 ft", airspeeds("cas", 250 * KNOT, 20000 * FOOT).tas),
        ("EAS=250 kt h=6 km", airspeeds("eas", 250 * KNOT, 6000.0).tas),
    ],
)
def test_speeds_of_all_kinds(text: str, V: float) -> None:
    assert pytest.approx(V) == spec_of(text, DEFAULT).V


def test_a_rate_of_climb_is_a_path() -> None:
    point = flown("A-4D", "climb=2000 ft/min")
    assert point.outputs().h_dot == pytest.approx(2000 * FOOT / 60.0, rel=1e-6)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("V=100 kt CAS=90 kt", r"Both V and CAS are given for the trim \(how fast it flies\): leave one"),
        ("alpha=8 deg M=0.3", "Both M and alpha are given"),
        ("gamma=3 deg climb=500 ft/min", r"Both gamma and climb are given for the trim \(how steeply it climbs\)"),
        ("throttle=0.5 gamma=3 deg", "Both gamma and throttle are given"),
        ("turn=3 deg/s bank=30 deg", "at one speed each follows from the other"),
        ("turn=2 g bank=30 deg", "at one speed each follows from the other"),
        ("turn=2 g turn=3 deg/s", "The trim gives turn twice"),
        ("n=2 bank=30 deg", r"Both bank and n are given for the trim \(how its path bends\)"),
        ("n=2 q=3 deg/s", "Both q and n are given"),
        ("beta=2 deg n_y=0", r"Both beta and n_y are given for the trim \(how it sideslips\)"),
        ("bank=5 deg turn=0 beta=2 deg", "two of them fix the third"),
        ("bank=89 deg", "a bank of 89 deg is asked for; at most 85 deg"),
        ("turn=0.5 g", "level turns have more than 1"),
        ("n=40", "a load factor of 40 is asked for; at most 20"),
        ("throttle=1.2", "a throttle of 1.2 is asked for; it must be from 0 to 1"),
        ("climb=200 m/s", "it must be less than the speed"),
        ("alpha=8 deg climb=2 m/s", "give gamma instead of climb"),
        ("bank=30", r"bank=30 has no unit\. Write it like 'bank=30 rad'"),
    ],
)
def test_contradictions_are_named(text: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        spec_of(text, DEFAULT)


@pytest.mark.parametrize(
    "spec",
    [
        DEFAULT._replace(n=2.0, bank=0.5),
        DEFAULT._replace(n=2.0, q=0.1),
        DEFAULT._replace(turn=0.1, n_turn=2.0),
        DEFAULT._replace(turn=0.1, bank=0.3),
        DEFAULT._replace(gamma=0.1, throttle=0.3),
        DEFAULT._replace(beta=0.1, n_y=0.0),
        DEFAULT._replace(slip_bank=0.1, n_y=0.0),
    ],
)
def test_contradictions_in_python_too(spec: TrimSpec) -> None:
    with pytest.raises(SpecError):
        trim(six_dof_of(load("A-4D").at()), spec)


def test_a_pull_up_is_not_linearized() -> None:
    with pytest.raises(SpecError, match="leave turns, pull-ups and sideslip out"):
        linearized(flown("A-4D", "n=2"))
