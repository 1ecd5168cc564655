"""MIL-F-8785C, number by number: both sides of each boundary, and what public implementations got wrong.

The limits are typed here again from the pages of the specification, so that a slip in one place shows.
"""

import math
from typing import Any

import pytest

from fdes.aircraft.role import Role
from fdes.analysis.measured import LN2, Measured
from fdes.analysis.qualities import judge
from fdes.analysis.verdict import Verdict

CLOSE = 1e-6  # relative, to either side of a limit
LIMITS_OF_CAP = {"A": (0.28, 0.16, 0.16), "B": (0.085, 0.038, 0.038), "C": (0.16, 0.096, 0.096)}  # figures 1 to 3
ROOMY: dict[str, Any] = {"n_alpha": 30.0, "zeta_sp": 0.7}  # where nothing but CAP governs


def verdict(
    criterion: str, category: str, airplane_class: str = "IV", phase: str | None = None, **known: Any
) -> Verdict:
    role = Role("IV", "A", None, "").but(airplane_class, category, phase)
    (only,) = judge(Measured(**known), role, [f"mil_f_8785c_{criterion}"])
    return only


def levels(
    criterion: str, category: str, name: str, limit: float, airplane_class: str = "IV", **known: Any
) -> list[Any]:
    """The Levels just below, at, and just above a limit."""
    values: tuple[Any, ...] = (limit * (1.0 - CLOSE), limit, limit * (1.0 + CLOSE))
    return [verdict(criterion, category, airplane_class, **known, **{name: v}).level for v in values]


@pytest.mark.parametrize("category", ["A", "B", "C"])
def test_short_period_damping_table_4(category: str) -> None:
    first, second = (0.30, 0.20) if category == "B" else (0.35, 0.25)
    assert levels("short_period", category, "zeta_sp", first) == [2, 1, 1]
    assert levels("short_period", category, "zeta_sp", second) == [3, 2, 2]
    assert levels("short_period", category, "zeta_sp", 0.15) == [4, 3, 3]
    assert levels("short_period", category, "zeta_sp", 2.0)[2] == 3
    if category == "B":
        assert levels("short_period", category, "zeta_sp", 2.0) == [1, 1, 3]
    else:
        assert levels("short_period", category, "zeta_sp", 1.30) == [1, 1, 2]


@pytest.mark.parametrize("category", ["A", "B", "C"])
def test_short_period_frequency_figures_1_to_3(category: str) -> None:
    first, second, third = LIMITS_OF_CAP[category]
    for limit, below, above in ((first, 2, 1), (second, 4, 2), (third, 4, 2), (3.6, 1, 2), (10.0, 2, 3)):
        found = [
            verdict("short_period", category, omega_sp=math.sqrt(30.0 * limit * (1.0 + side)), **ROOMY).level
            for side in (-CLOSE, CLOSE)
        ]
        assert found == [below, above], limit


@pytest.mark.parametrize(
    ("category", "airplane_class", "limit", "below", "above"),
    [
        ("A", "IV", 1.0, 2, 1),
        ("A", "IV", 0.6, 3, 2),
        ("C", "IV", 0.87, 2, 1),
        ("C", "II-C", 0.87, 2, 1),
        ("C", "I", 0.6, 4, 2),
        ("C", "III", 0.7, 2, 1),
        ("C", "II-L", 0.4, 3, 2),
    ],
)
def test_least_short_period_frequency(category: str, airplane_class: str, limit: float, below: int, above: int) -> None:
    # At this n/alpha CAP is between its limits, and n/alpha above its own.
    n_alpha = max(limit * limit / 0.3, 1.0) if category == "A" else limit * limit / 0.17
    bound: dict[str, Any] = {"n_alpha": n_alpha, "zeta_sp": 0.7}
    found = levels("short_period", category, "omega_sp", limit, airplane_class, **bound)
    if category == "A":
        assert found == [below, above, above]
    else:
        assert found[0] >= below
        parts = verdict("short_period", category, airplane_class, omega_sp=limit, **bound).parts
        (floor,) = (part for part in parts if part.requirement.startswith("omega_sp"))
        assert floor.level == above


@pytest.mark.parametrize(
    ("airplane_class", "limit", "below", "above"),
    [("IV", 2.7, 2, 1), ("IV", 1.7, 3, 2), ("III", 2.0, 2, 1), ("II-L", 1.0, 3, 2)],
)
def test_least_n_alpha_figure_3(airplane_class: str, limit: float, below: int, above: int) -> None:
    known: dict[str, Any] = {"omega_sp": 1.4, "zeta_sp": 0.7}
    assert levels("short_period", "C", "n_alpha", limit, airplane_class, **known) == [below, above, above]


def test_phugoid() -> None:
    assert levels("phugoid", "A", "zeta_ph", 0.04) == [2, 1, 1]
    assert verdict("phugoid", "A", zeta_ph=0.0).level == 2
    assert levels("phugoid", "A", "t2_ph", 55.0) == [4, 3, 3]
    assert levels("phugoid", "A", "t2_speed", 6.0, zeta_ph=0.1) == [4, 3, 3]  # 3.2.1.1


@pytest.mark.parametrize(
    ("category", "airplane_class", "phase", "zeta", "product", "omega"),
    [
        ("A", "IV", "CO", 0.4, 0.0, 1.0),
        ("A", "IV", "GA", 0.4, 0.0, 1.0),
        ("A", "IV", None, 0.19, 0.35, 1.0),
        ("A", "I", None, 0.19, 0.35, 1.0),
        ("A", "II-L", None, 0.19, 0.35, 0.4),
        ("A", "III", None, 0.19, 0.35, 0.4),
        ("B", "IV", None, 0.08, 0.15, 0.4),
        ("B", "III", None, 0.08, 0.15, 0.4),
        ("C", "I", None, 0.08, 0.15, 1.0),
        ("C", "II-C", None, 0.08, 0.15, 1.0),
        ("C", "IV", None, 0.08, 0.15, 1.0),
        ("C", "II-L", None, 0.08, 0.10, 0.4),
        ("C", "III", None, 0.08, 0.10, 0.4),
    ],
)
def test_dutch_roll_table_6(
    category: str, airplane_class: str, phase: str | None, zeta: float, product: float, omega: float
) -> None:
    def level(zeta_dr: float, omega_dr: float) -> int | None:
        return verdict("dutch_roll", category, airplane_class, phase, zeta_dr=zeta_dr, omega_dr=omega_dr).level

    quick, slow = 10.0, max(omega, 0.9 * product / zeta)
    assert (level(zeta * (1 - CLOSE), quick), level(zeta, quick)) == (2, 1)
    asked = max(zeta, product / slow)
    assert (level(asked * (1 - CLOSE), slow), level(asked * (1 + CLOSE), slow)) == (2, 1)
    assert (level(1.0, omega * (1 - CLOSE)), level(1.0, omega)) == (2 if omega > 0.4 else 4, 1)
    assert (level(0.02 * (1 - CLOSE), quick), level(0.02, quick)) == (3, 2)
    assert (level(0.05 * (1 - CLOSE), 1.0), level(0.05 * (1 + CLOSE), 1.0)) == (3, 2)
    assert (level(-1e-9, quick), level(0.0, quick)) == (4, 3)
    assert (level(1.0, 0.4 * (1 - CLOSE)), level(0.7, 0.4) in {1, 2}) == (4, True)


@pytest.mark.parametrize(("level", "product", "more"), [(1, 0.15, 0.014), (2, 0.05, 0.009), (3, 0.0, 0.005)])
def test_a_dutch_roll_that_rolls_needs_more_damping(level: int, product: float, more: float) -> None:
    """Paragraph 3.3.1.1: above omega^2 |phi/beta| = 20, and not at it."""
    omega, ratio = 3.0, 4.0
    asked = (product + more * (omega * omega * ratio - 20.0)) / omega
    known: dict[str, Any] = {"omega_dr": omega, "phi_beta": ratio}
    assert levels("dutch_roll", "B", "zeta_dr", asked, **known)[::2] == [level + 1, level]
    at_the_limit: dict[str, Any] = {"omega_dr": 2.0, "phi_beta": 5.0, "zeta_dr": 0.08}
    assert verdict("dutch_roll", "B", **at_the_limit).level == 1


def test_no_more_than_0_7_is_required_of_class_3() -> None:
    known: dict[str, Any] = {"omega_dr": 3.0, "phi_beta": 18.0}  # for which the table asks 0.713
    assert levels("dutch_roll", "B", "zeta_dr", 0.7, "III", **known) == [2, 1, 1]
    assert verdict("dutch_roll", "B", "IV", zeta_dr=0.7, **known).level == 2


@pytest.mark.parametrize(
    ("category", "airplane_class", "limits"),
    [
        ("A", "I", (1.0, 1.4, 10.0)),
        ("A", "IV", (1.0, 1.4, 10.0)),
        ("A", "II-L", (1.4, 3.0, 10.0)),
        ("A", "II-C", (1.4, 3.0, 10.0)),
        ("A", "III", (1.4, 3.0, 10.0)),
        ("B", "I", (1.4, 3.0, 10.0)),
        ("B", "III", (1.4, 3.0, 10.0)),
        ("C", "I", (1.0, 1.4, 10.0)),
        ("C", "II-C", (1.0, 1.4, 10.0)),
        ("C", "IV", (1.0, 1.4, 10.0)),
        ("C", "II-L", (1.4, 3.0, 10.0)),
        ("C", "III", (1.4, 3.0, 10.0)),
    ],
)
def test_roll_mode_table_7(category: str, airplane_class: str, limits: tuple[float, ...]) -> None:
    for level, limit in enumerate(limits, start=1):
        assert levels("roll_mode", category, "tau_roll", limit, airplane_class) == [level, level, level + 1]


@pytest.mark.parametrize(("category", "limits"), [("A", (12, 8, 4)), ("B", (20, 8, 4)), ("C", (12, 8, 4))])
def test_spiral_table_8(category: str, limits: tuple[float, ...]) -> None:
    for level, limit in enumerate(limits, start=1):
        assert levels("spiral", category, "t2_spiral", limit) == [level + 1, level, level]
    for stable in (-5.0, math.inf):
        assert verdict("spiral", category, t2_spiral=stable).level == 1


@pytest.mark.parametrize("category", ["B", "C"])
def test_coupled_roll_spiral(category: str) -> None:
    for level, limit in enumerate((0.5, 0.3, 0.15), start=1):
        assert levels("coupled_roll_spiral", category, "damping_rs", limit) == [level + 1, level, level]
    assert verdict("coupled_roll_spiral", "A", damping_rs=9.0).level == 4


def test_response_delay_table_14() -> None:
    for level, limit in enumerate((0.10, 0.20, 0.25), start=1):
        assert levels("response_delay", "A", "delay", limit) == [level, level, level + 1]


def test_vectors_that_were_worked_by_hand() -> None:
    assert verdict("short_period", "B", zeta_sp=0.25).level == 2
    assert verdict("short_period", "A", omega_sp=2.0, n_alpha=10.0).level == 1
    assert verdict("short_period", "A", omega_sp=2.0, n_alpha=10.0).value == pytest.approx(0.40)
    assert verdict("short_period", "C", omega_sp=0.9, n_alpha=9.0).level == 4
    assert verdict("short_period", "C", omega_sp=0.95, n_alpha=9.0).level == 2
    assert verdict("dutch_roll", "A", "I", zeta_dr=0.19, omega_dr=1.5).level == 2
    assert verdict("dutch_roll", "A", "I", zeta_dr=0.2334, omega_dr=1.5).level == 1
    assert verdict("dutch_roll", "A", "IV", "CO", zeta_dr=0.3, omega_dr=2.0).level == 2
    assert verdict("spiral", "A", t2_spiral=15.0).level == 1
    assert verdict("spiral", "B", t2_spiral=15.0).level == 2
    assert verdict("roll_mode", "C", "I", tau_roll=1.2).level == 2
    assert verdict("roll_mode", "C", "III", tau_roll=1.2).level == 1
    assert verdict("dutch_roll", "B", zeta_dr=0.1, omega_dr=3.0, phi_beta=4.0).level == 2
    assert verdict("dutch_roll", "B", zeta_dr=0.374 / 3.0 + CLOSE, omega_dr=3.0, phi_beta=4.0).level == 1


def test_known_errors_of_others_are_not_repeated() -> None:
    """Category C has 0.096, not 0.036; Category B Level 3 damping is 0.15, not 0.10; CO asks 0.4 of Class IV."""
    assert verdict("short_period", "C", omega_sp=math.sqrt(0.05 * 30.0), **ROOMY).level == 4
    assert verdict("short_period", "B", zeta_sp=0.12).level == 4
    assert verdict("dutch_roll", "A", "IV", "GA", zeta_dr=0.39, omega_dr=3.0).level == 2
    assert verdict("dutch_roll", "A", "IV", zeta_dr=0.39, omega_dr=3.0).level == 1


@pytest.mark.parametrize(
    ("criterion", "known", "margin"),
    [
        ("short_period", {"zeta_sp": 0.25}, 0.25),  # Category B: above 0.20, by a quarter of it
        ("short_period", {"zeta_sp": 1.9}, 0.05),  # below 2.00
        ("short_period", {"zeta_sp": 0.12}, -0.2),  # below 0.15
        ("phugoid", {"zeta_ph": 0.06}, 0.5),
        ("phugoid", {"zeta_ph": 0.01}, 0.25),  # the limit is zero: divided by that of Level 1
        ("phugoid", {"t2_ph": 44.0}, -0.2),
        ("roll_mode", {"tau_roll": 0.7}, 0.5),
        ("roll_mode", {"tau_roll": 12.0}, -0.2),
        ("spiral", {"t2_spiral": 30.0}, 0.5),
        ("spiral", {"t2_spiral": -20.0}, 2.0),  # the root is as far on the other side of zero as the limit
        ("response_delay", {"delay": 0.15}, 0.25),
    ],
)
def test_margins(criterion: str, known: dict[str, Any], margin: float) -> None:
    assert verdict(criterion, "B", **known).margin == pytest.approx(margin)


def test_a_diverging_roll_is_worse_than_a_slow_one() -> None:
    slow, diverging = verdict("roll_mode", "B", tau_roll=1e9), verdict("roll_mode", "B", tau_roll=-1e9)
    assert (slow.level, diverging.level) == (4, 4)
    assert diverging.margin == pytest.approx(-1.0)
    assert verdict("roll_mode", "B", tau_roll=-1.0).margin == pytest.approx(-11.0)


def test_the_value_of_a_stable_spiral_is_its_root() -> None:
    found = verdict("spiral", "B", t2_spiral=-20.0)
    assert (found.value, found.unit) == (pytest.approx(-LN2 / 20.0), "1/s")
