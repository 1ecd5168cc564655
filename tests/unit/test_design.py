"""Laws designed for an aircraft: what is wished is had, in the domain it was designed in, or the answer is honest."""

from dataclasses import fields
from math import exp

import numpy as np
import pytest

from fdes.aircraft import FlightCondition, edited, load
from fdes.analysis import modes
from fdes.analysis.closed_loop import close
from fdes.analysis.command_settings import FASTEST
from fdes.analysis.design import law_for
from fdes.analysis.design_rules import RULES
from fdes.control.laws.roll_rate_damper import RollRateDamper
from fdes.control.laws.yaw_damper import YawDamper
from fdes.errors import NoSuchPart, SpecError
from fdes.shelf import shelf
from fdes.units import DEG

DT = 1.0 / 120.0


@pytest.fixture(scope="module")
def a4d() -> FlightCondition:
    return load("A-4D").at("M0.4_SL")


@pytest.mark.parametrize(
    ("text", "mode", "quantity", "wanted"),
    [
        ("pitch_rate_damper zeta=0.6", "short_period", "zeta", 0.6),
        ("pitch_rate_pi zeta=0.7", "short_period", "zeta", 0.7),
        ("roll_rate_damper time_constant=0.3", "roll", "time_constant", 0.3),
        ("yaw_damper zeta=0.35", "dutch_roll", "zeta", 0.35),
        ("spiral_stabilization tau=15s", "spiral", "time_constant", 15.0),
    ],
)
@pytest.mark.parametrize("dt", [None, DT, 0.05])
def test_what_is_wished_is_had_where_it_was_designed(
    a4d: FlightCondition, text: str, mode: str, quantity: str, wanted: float, dt: float | None
) -> None:
    """Read from the eigenvalues of the closed loop: ln(z) / dt where it was designed in z."""
    designed = law_for(text, a4d, dt=dt)
    found = next(m for m in modes(close(a4d, designed.law, dt)) if m.name == mode)
    assert getattr(found, quantity) == pytest.approx(wanted, rel=1e-6)
    (achieved,) = designed.achieved
    assert (achieved.designed, achieved.wanted, achieved.reached) == (pytest.approx(wanted, rel=1e-6), wanted, True)
    assert not designed.notes


@pytest.mark.parametrize("dt", [None, DT])
@pytest.mark.parametrize("text", ["roll_angle omega=3 zeta=0.7", "roll_angle zeta=0.7 time_constant=0.47619047619"])
def test_two_gains_place_a_pair(a4d: FlightCondition, text: str, dt: float | None) -> None:
    law = law_for(text, a4d, dt=dt).law
    pair = next(m for m in modes(close(a4d, law, dt)) if m.name == "roll_spiral")
    assert (pair.omega_n, pair.zeta) == pytest.approx((3.0, 0.7), rel=1e-6)


def test_a_pi_places_a_pair_as_well(a4d: FlightCondition) -> None:
    law = law_for("pitch_rate_pi omega=6 zeta=0.7", a4d).law
    pair = next(m for m in modes(close(a4d, law)) if m.name == "short_period")
    assert (pair.omega_n, pair.zeta) == pytest.approx((6.0, 0.7), rel=1e-6)


def test_the_flown_damping_stands_beside_the_designed_one(a4d: FlightCondition) -> None:
    """In s it is had in s and not when flown at 20 frames a second; in z the other way round."""
    (in_s,) = law_for("yaw_damper zeta=0.35", a4d, frame=0.05).achieved
    (in_z,) = law_for("yaw_damper zeta=0.35", a4d, dt=0.05).achieved
    assert in_s.continuous == pytest.approx(0.35, rel=1e-6)
    assert abs(in_s.flown - 0.35) > 0.002
    assert in_z.flown == pytest.approx(0.35, rel=1e-6)
    assert abs(in_z.continuous - 0.35) > 0.002


def test_the_bare_yaw_damper_helps_the_a4d(a4d: FlightCondition) -> None:
    (achieved,) = law_for("yaw_damper", a4d).achieved
    assert achieved.before == pytest.approx(next(m.zeta for m in modes(a4d) if m.name == "dutch_roll"), rel=1e-3)
    assert achieved.continuous >= 1.5 * achieved.before
    assert achieved.flown >= 1.5 * achieved.before


@pytest.mark.parametrize("name", list(RULES))
@pytest.mark.parametrize("aircraft", ["A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar", "NT-33A", "A-7A"])
def test_named_bare_every_law_improves_every_aircraft(aircraft: str, name: str) -> None:
    condition = load(aircraft).at()
    designed = law_for(name, condition)
    (achieved,) = designed.achieved
    if name != "roll_angle":  # its pair is made of a roll and a spiral root, and neither was an oscillation
        better = achieved.continuous - achieved.before
        assert better < 0.0 if achieved.quantity == "time_constant" else better > 0.0
    assert all(value >= 0.0 for gain in RULES[name].gains for value in [designed.gains[name][gain]])
    growing = [m.eigenvalue.real for m in modes(condition)]
    assert max(m.eigenvalue.real for m in modes(close(condition, designed.law, DT))) <= max(0.0, *growing) + 1e-6


def test_every_law_of_the_shelf_but_direct_and_sensors_has_a_design() -> None:
    inside = {n for n in shelf("laws").names() if "inner" in [f.name for f in fields(shelf("laws").get(n))]} - {
        "sensors"
    }
    assert set(RULES) == inside


def test_out_of_reach_says_the_best_and_at_which_gain() -> None:
    b747 = load("B747").at()
    designed = law_for("yaw_damper zeta=0.9", b747)
    (achieved,), (note,) = designed.achieved, designed.notes
    gain = designed.gains["yaw_damper"]["gain"]
    assert not achieved.reached
    assert note == (
        f"yaw_damper: zeta 0.9 is out of reach. The best that a positive gain attains is {achieved.designed:.3g}, "
        f"at gain {gain:.4g}, which is taken."
    )
    for other in (0.9 * gain, 1.1 * gain):
        assert law_for(f"yaw_damper gain={other!r}", b747).achieved[0].continuous < achieved.continuous


def test_no_better_than_without_is_gain_zero(a4d: FlightCondition) -> None:
    designed = law_for("yaw_damper zeta=0.05", a4d)
    assert designed.gains["yaw_damper"]["gain"] == 0.0
    assert designed.notes == (
        "yaw_damper: zeta 0.05 is no better than the 0.112 of the dutch roll without it: the gain is 0.",
    )


def test_a_pair_out_of_reach_of_positive_gains_says_the_nearest() -> None:
    navion = load("NAVION").at()
    designed = law_for("roll_angle omega=1.5 zeta=0.8", navion)
    assert designed.notes[0].startswith(
        "roll_angle: omega 1.5 rad/s with zeta 0.8 is out of reach with positive gains. The nearest is "
    )
    assert min(designed.gains["roll_angle"][k] for k in ("gain", "rate_gain")) >= 0.0


def test_half_the_gain_at_which_something_else_grows_is_the_limit() -> None:
    jetstar = load("JetStar").at()
    designed = law_for("spiral_stabilization time_constant=5", jetstar)
    gain = designed.gains["spiral_stabilization"]["gain"]
    assert designed.notes[0].endswith("With more gain another mode would come within 6 dB of growing.")
    twice = law_for(f"spiral_stabilization gain={2.1 * gain!r}", jetstar)
    assert "grows faster" in twice.notes[0]


def test_the_other_half_of_a_mode_that_a_loop_has_split_is_told(a4d: FlightCondition) -> None:
    """With so much gain the root that was the Dutch roll is real; what swings now is no better damped than before."""
    firm, much = (law_for(f"yaw_damper gain={gain}", a4d) for gain in (0.5, 20))
    assert firm.notes == ()
    assert much.achieved[0].continuous == pytest.approx(1.0)
    assert much.notes == (
        "The dutch roll has split. Its other half is in the spiral dutch roll, zeta 0.0376 at 0.626 rad/s.",
    )


def test_gains_by_hand_are_what_they_are(a4d: FlightCondition) -> None:
    law = law_for("yaw_damper gain=0.5 washout=2 s", a4d).law
    assert law == YawDamper(shelf("laws").get("direct")(a4d.full_stick), 0.5, 2.0)
    assert law_for("roll_angle gain=1 full_bank=45deg", a4d).gains["roll_angle"] == {
        "gain": 1.0,
        "rate_gain": 0.0,
        "full_bank": 45.0 * DEG,
    }


@pytest.mark.parametrize("text", ["yaw_damper", "pitch_rate_pi; roll_angle; yaw_damper", "roll_angle zeta=0.6"])
def test_the_text_of_a_design_says_it_again(a4d: FlightCondition, text: str) -> None:
    designed = law_for(text, a4d)
    assert law_for(designed.text, a4d).law == designed.law


@pytest.mark.parametrize("text", ["yaw_damper", "pitch_rate_pi", "roll_angle", "yaw_damper zeta=0.3; roll_angle"])
def test_gains_by_hand_show_the_mode_that_the_design_moved(a4d: FlightCondition, text: str) -> None:
    designed = law_for(text, a4d)
    again = law_for(designed.text, a4d)
    for one, other in zip(designed.achieved, again.achieved, strict=True):
        assert (other.designed, other.continuous, other.flown) == pytest.approx(
            (one.designed, one.continuous, one.flown), rel=1e-6
        )


def test_several_loops_are_closed_one_after_the_other(a4d: FlightCondition) -> None:
    designed = law_for("yaw_damper zeta=0.4; roll_rate_damper time_constant=0.3; pitch_rate_damper zeta=0.6", a4d)
    yaw, roll, pitch = designed.achieved
    assert (yaw.designed, roll.designed, pitch.designed) == pytest.approx((0.4, 0.3, 0.6), rel=1e-6)
    assert (roll.continuous, pitch.continuous) == pytest.approx((0.3, 0.6), rel=1e-6)
    assert yaw.continuous != pytest.approx(0.4, rel=1e-6), "the roll damper came later, and moved the Dutch roll"


def test_full_stick_commands_the_pitch_rate_that_it_gave(a4d: FlightCondition) -> None:
    """With the speed held the bare aircraft pitches as fast at full aft stick as the law lets it be told to."""
    rate = law_for("pitch_rate_pi", a4d).gains["pitch_rate_pi"]["full_rate"]
    (A, B), full = a4d.equations("full")[:2], a4d.full_stick.elevator
    w_and_q = np.array(A)[1:3, 1:3]
    assert rate == pytest.approx(-np.linalg.solve(w_and_q, np.array(B)[1:3, 0] * full)[1])


def test_a_law_of_ones_own_is_named_like_the_others(a4d: FlightCondition) -> None:
    designed = law_for("mine gain=0.2; yaw_damper zeta=0.4", a4d, own={"mine": RollRateDamper})
    assert isinstance(designed.law, YawDamper)
    assert designed.law.inner == RollRateDamper(shelf("laws").get("direct")(a4d.full_stick), 0.2)


def test_designed_in_z_the_root_is_where_it_should_be(a4d: FlightCondition) -> None:
    law = law_for("roll_rate_damper time_constant=0.3", a4d, dt=0.02).law
    z = np.linalg.eigvals(close(a4d, law, 0.02).A)
    assert min(abs(z - exp(-0.02 / 0.3))) < 1e-9


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ("", SpecError, "The law '' names no law. Write it like 'yaw_damper gain=0.5'."),
        ("yaw_dampr", NoSuchPart, "There is no law named 'yaw_dampr'. Did you mean 'yaw_damper'?"),
        ("./mine.py gain=1", NoSuchPart, "There is no law named './mine.py'."),
        ("yaw_damper gian=1", NoSuchPart, "There is no setting of yaw_damper named 'gian'. Did you mean 'gain'?"),
        ("yaw_damper 0.5", SpecError, "cannot be read at '0.5'. Write it like 'yaw_damper gain=0.5'."),
        ("yaw_damper gain=", SpecError, "does not say its value after gain=."),
        ("yaw_damper gain=0.5 gain=1", SpecError, "says gain twice."),
        ("yaw_damper gain=0.5 m", SpecError, "'0.5 m' is in m, which is not a unit of this quantity."),
        ("yaw_damper washout=0", SpecError, "The time constant of a washout is 0 s; it must be positive"),
        ("yaw_damper gain=0.5 zeta=0.4", SpecError, "yaw_damper cannot be designed for zeta: its gain is given."),
        ("yaw_damper omega=2", SpecError, "yaw_damper cannot be designed for omega: it can for zeta."),
        ("yaw_damper zeta=1.2", SpecError, "cannot be designed for zeta 1.2: an oscillation has less than 1."),
        ("yaw_damper zeta=-1", SpecError, "cannot be designed for zeta -1: it must be positive."),
        ("yaw_damper; yaw_damper gain=1", SpecError, "says yaw_damper twice; one loop of a kind is enough."),
        ("roll_angle full_bank=45", SpecError, "does not say the unit of full_bank. Write full_bank=45deg"),
        ("roll_angle omega=2 zeta=0.7 tau=1", SpecError, "asked for omega and for time_constant"),
        ("yaw_damper; direct", SpecError, "says direct after another: it has no place for a law inside. Say it first."),
        ("direct zeta=0.4", SpecError, "direct cannot be designed for zeta: FDES knows no design for it."),
    ],
)
def test_says_what_is_wrong_with_a_law(a4d: FlightCondition, text: str, error: type[Exception], words: str) -> None:
    with pytest.raises(error) as found:
        law_for(text, a4d)
    assert words in str(found.value)


@pytest.mark.parametrize(
    ("aircraft", "change"),
    [("A-4D", "Cm_alpha=0.6"), ("A-4D", "Cm_alpha=0; Cm_q=0"), ("B747", "Cm_alpha=0.1"), ("F-16", "")],
)
def test_the_bare_pi_makes_a_pair_of_what_no_longer_swings(aircraft: str, change: str) -> None:
    """Of an aircraft with no static stability, or less, the short period is two real roots, of which one may grow."""
    condition = load(aircraft).at(None)
    condition = edited(condition, change.split("; ")) if change else condition
    designed = law_for("pitch_rate_pi", condition)
    (shown,) = designed.achieved
    assert shown.continuous == pytest.approx(0.8, rel=1e-6)
    assert max(m.eigenvalue.real for m in modes(close(condition, designed.law)) if m.axis == "longitudinal") <= 0.0


def test_full_stick_commands_a_rate_where_the_bare_aircraft_has_none(a4d: FlightCondition) -> None:
    """Without maneuver margin the pitch rate of the bare aircraft at full stick grows without limit."""
    neutral = edited(a4d, ["Cm_alpha=0", "Cm_q=0"])
    assert law_for("pitch_rate_pi", neutral).gains["pitch_rate_pi"]["full_rate"] == FASTEST


@pytest.mark.parametrize("gain", [2.0, 100.0, 1e6])
def test_a_mode_is_followed_to_the_greatest_gain_and_not_mistaken_for_another(
    a4d: FlightCondition, gain: float
) -> None:
    (shown,) = law_for(f"yaw_damper gain={gain}", a4d).achieved
    assert shown.designed == 1.0  # it has become two real roots; the short period's zeta is 0.357


def test_an_aircraft_without_finite_equations_is_refused(a4d: FlightCondition) -> None:
    broken = edited(a4d, ["b=1e300 m"])
    with pytest.raises(SpecError, match=r"A-4D M0.4_SL has no finite equations of motion: a number of it is far too"):
        modes(broken)


def test_behind_slow_sensors_a_mode_is_not_mistaken_for_one_of_the_other_axis(a4d: FlightCondition) -> None:
    """Without the lag this damper leaves the roll mode 0.154 s; the short period's time constant is 0.855 s."""
    (slow,) = law_for("roll_rate_damper gain=0.2825; sensors lag=0.3s", a4d).achieved
    (quick,) = law_for("roll_rate_damper gain=0.2825", a4d).achieved
    assert quick.continuous == pytest.approx(0.154, abs=5e-4)
    assert slow.alone == pytest.approx(quick.continuous, rel=1e-6)


def test_what_any_gain_makes_worse_is_left_alone(a4d: FlightCondition) -> None:
    (note,) = law_for("pitch_rate_pi zeta=0.8; sensors lag=0.3s", a4d).notes
    words = "is out of reach, any gain being worse than the 0.357 of the short period without it: the gain is 0."
    assert note == f"pitch_rate_pi: zeta 0.8 {words}"
