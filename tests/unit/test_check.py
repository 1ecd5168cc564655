"""Every rule of the linter fires on a planted mistake, and the hangar is clean or says why not."""

import copy
import re
import tomllib
from collections.abc import Callable
from dataclasses import replace
from math import radians
from pathlib import Path
from typing import Any

import pytest

from fdes.aircraft import Finding, catalogue, check, load, parse
from fdes.aircraft.check import RULES, findings
from fdes.aircraft.expectations import GOVERNING, RANGES, SIGNS, Range, Sign
from fdes.analysis import modes
from fdes.physics.derivatives import Coefficients
from fdes.units import DEG

MINE = tomllib.loads((Path(__file__).parent / "mine.toml").read_text(encoding="utf-8"))
MINE["conditions"][0]["trim_alpha"] = {"printed": 1, "unit": "deg"}
MINE["conditions"][0]["derivatives"]["CL"] = 0.32  # what carries its weight
Change = Callable[[dict[str, Any]], None]


def found_after(change: Change) -> list[Finding]:
    document = copy.deepcopy(MINE)
    change(document)
    return check(parse(document, "a mutated document"))


def after(derivative: str, value: Any) -> list[Finding]:
    def change(document: dict[str, Any]) -> None:
        document["conditions"][0]["derivatives"][derivative] = value

    return found_after(change)


def test_a_small_plain_file_is_clean() -> None:
    assert check(parse(MINE, "mine")) == []


@pytest.mark.parametrize("expected", [s for s in SIGNS if s.derivative != "Cl_da"], ids=lambda s: s.derivative)
def test_a_reversed_sign(expected: Sign) -> None:
    k = parse(MINE, "mine").at().coefficients
    for value in (-getattr(k, expected.derivative), 0.0):
        (finding,) = after(expected.derivative, {"printed": value, "unit": "1/rad"})
        assert (finding.rule, finding.severity) == (f"sign_{expected.derivative}", "error")
        assert finding.what.startswith(f"{expected.derivative} is {value:.4g} 1/rad; it must be ")
        assert (finding.meaning, finding.condition, finding.waived) == (expected.meaning, "slow", None)


def test_a_reversed_aileron_is_refused_by_the_file_and_found_in_a_condition() -> None:
    ready = parse(MINE, "mine").at()
    (finding,) = findings(replace(ready, aerodynamics=ready.coefficients._replace(Cl_da=-0.13)))
    assert (finding.rule, finding.meaning) == ("sign_Cl_da", "Right stick rolls left.")


@pytest.mark.parametrize("expected", RANGES, ids=lambda r: r.derivative)
def test_an_implausible_size(expected: Range) -> None:
    ready = parse(MINE, "mine").at()
    margin = 0.01 * (expected.high - expected.low)
    just_below = expected.low - min(margin, 0.1 * abs(expected.low) or margin)
    just_above = expected.high + min(margin, 0.1 * abs(expected.high) or margin)
    for value, meaning in ((just_below, expected.below), (just_above, expected.above)):
        coefficients = ready.coefficients._replace(**{expected.derivative: value})
        rules = {f.rule: f for f in findings(replace(ready, aerodynamics=coefficients))}
        if f"sign_{expected.derivative}" in rules:
            assert f"range_{expected.derivative}" not in rules  # one mistake, one finding
        else:
            finding = rules[f"range_{expected.derivative}"]
            assert (finding.severity, finding.meaning) == ("warning", meaning)
            assert finding.what.startswith(f"{expected.derivative} is {value:.4g}")


def test_every_coefficient_has_a_plausible_range_that_its_sign_fits() -> None:
    by_name = {r.derivative: r for r in RANGES}
    assert tuple(by_name) == Coefficients._fields
    assert all(by_name[s.derivative].low * by_name[s.derivative].high > 0.0 for s in SIGNS)
    assert all((by_name[s.derivative].low > 0.0) == s.positive for s in SIGNS)
    assert set(GOVERNING) <= set(by_name)


@pytest.mark.parametrize("derivative", [s.derivative for s in SIGNS])
@pytest.mark.parametrize("aircraft", ["NAVION", "F-104A", "A-4D"])
def test_per_degree_taken_for_per_radian(derivative: str, aircraft: str) -> None:
    ready = load(aircraft).at()
    value = getattr(ready.coefficients, derivative)
    wrong = replace(ready, aerodynamics=ready.coefficients._replace(**{derivative: value * DEG}))
    (finding,) = (f for f in findings(wrong) if f.severity == "error")
    assert finding.rule == "per_degree"
    assert finding.what == f"Out by 57: {derivative} {value * DEG:.3g} 1/rad, as if per degree."
    assert "57 times too weakly" in finding.meaning


def test_per_radian_called_per_degree_and_a_whole_column() -> None:
    (finding,) = after("Cl_p", {"printed": -0.4, "unit": "1/deg"})
    assert finding.what == "Out by 57: Cl_p -22.9 1/rad, as if per radian called per degree."

    def whole_column(document: dict[str, Any]) -> None:
        derivatives = document["conditions"][0]["derivatives"]
        for name, value in derivatives.items():
            if isinstance(value, float) and name not in {"CL", "CD"}:
                derivatives[name] = value * DEG

    (finding, *_) = (f for f in found_after(whole_column) if f.severity == "error")
    assert finding.what.endswith("1/rad, as if per degree; and 7 more.")


def _inertia(name: str, value: float) -> Change:
    return lambda document: document["mass"].update({name: {"printed": value, "unit": "kg m^2"}})


def _in_condition(**values: Any) -> Change:
    return lambda document: document["conditions"][0].update(values)


def _derivative(name: str, value: Any) -> Change:
    return lambda document: document["conditions"][0]["derivatives"].update({name: value})


PLANTED = [
    ("inertia_triangle", _inertia("Ix", 50), "Ix + Iy is 650 kg m^2, less than Iz, 1,000 kg m^2", "roll mode"),
    ("inertia_triangle", _inertia("Iy", 5000), "Ix + Iz is 1,500 kg m^2, less than Iy, 5,000", "another"),
    (
        "inertia_product",
        _inertia("Ixz", 200),
        "Ixz is 200 kg m^2; with these Ix, Iy, Iz no body has more than 166",
        "Dutch",
    ),
    ("weight_and_lift", _derivative("CL", 0.5), "W/(qS) is 0.319, but CL is 0.500.", "flies too light"),
    ("weight_and_lift", _derivative("CL", 0.2), "W/(qS) is 0.319, but CL is 0.200.", "flies too heavy"),
    ("trim_throttle", _derivative("CD", 0.126), "is 0.970 of max_thrust, 2,000 N.", "neither climb"),
    ("reference_axes", lambda d: d["conditions"][0].pop("trim_alpha"), "trim_alpha is not given", "Dutch roll"),
    (
        "reference_axes",
        _in_condition(trim_alpha={"printed": 2, "unit": "deg", "confidence": "low"}),
        "trim_alpha is 2 deg with low confidence; each degree would add -9 kg m^2",
        "Dutch roll",
    ),
    (
        "low_confidence",
        _derivative("Cm_q", {"printed": -10, "confidence": "low"}),
        "Of low confidence: Cm_q.",
        "handling",
    ),
    (
        "unverified_correction",
        lambda d: d["mass"]["W"].update({"corrected": 501, "unverified": True, "reason": "a guess"}),
        "Corrected, but in no source: W 501 for 500 kg.",
        "guess",
    ),
    (
        "elevator_arm",
        _derivative("Cm_de", -0.205),
        "-Cm_de/CL_de is 0.683 mean chords; plausible is 0.7 to 7.",
        "stick",
    ),
    ("rudder_arm", _derivative("Cy_dr", 0.04), "-Cn_dr/Cy_dr is 1.75 spans", "pedals"),
    ("aileron_yaw", _derivative("Cn_da", -0.079), "-Cn_da/Cl_da is 0.608 of the rolling moment", "turn"),
]


@pytest.mark.parametrize(("rule", "change", "what", "meaning"), PLANTED)
def test_a_planted_mistake(rule: str, change: Change, what: str, meaning: str) -> None:
    (finding,) = found_after(change)
    assert finding.rule == rule
    assert what in finding.what
    assert meaning in finding.meaning
    assert finding.advice.endswith(".")


def test_every_rule_was_tried() -> None:
    tried = {rule for rule, *_ in PLANTED} | {"per_degree"}
    tried |= {f"sign_{s.derivative}" for s in SIGNS} | {f"range_{r.derivative}" for r in RANGES}
    assert tried == set(RULES)


def test_ixz_squared_beyond_ix_times_iz() -> None:
    ready = parse(MINE, "mine").at()
    (finding,) = findings(replace(ready, reference=ready.reference._replace(Ixz=-800.0)))
    assert (finding.rule, finding.severity) == ("inertia_product", "error")


def test_the_hangar_is_clean_or_says_why_not() -> None:
    found = [(a.id, f) for a in catalogue() for f in check(a)]
    assert [(of, f) for of, f in found if not f.waived] == []
    assert {(of, f.rule) for of, f in found if f.severity == "error"} == {
        ("Convair880", "inertia_triangle"),
        ("F-16", "sign_Cm_alpha"),
    }
    assert {(of, f.rule) for of, f in found if f.rule.startswith("range_")} == {
        ("JetStar", "range_CD_M"),
        ("JetStar", "range_Cm_M"),
        ("F-16", "range_CL_q"),
    }


def test_the_misprints_of_the_book_would_have_been_found() -> None:
    def rules(aircraft: str, condition: str) -> list[str]:
        return [f.rule for f in findings(load(aircraft).at(condition, "printed")) if not f.waived]

    assert rules("A-4D", "M0.4_SL") == ["sign_Cn_dr", "range_Cl_dr", "aileron_yaw"]  # rudder swapped, Cn_da slipped
    assert rules("F-104A", "M1.8_55kft") == ["range_Cm_de", "elevator_arm"]
    assert rules("NAVION", "M0.158_SL") == ["range_Cl_dr"]  # repeats Cl_r
    assert rules("B747", "M0.25_SL") == ["weight_and_lift"]  # the mass of another loading
    assert rules("B747", "M0.90_40kft") == ["range_Cn_p"]
    assert rules("JetStar", "M0.80_40kft") == ["range_Cm_q", "range_Cn_p", "aileron_yaw"]  # decimals


def _waive(**waiver: str) -> Change:
    def change(document: dict[str, Any]) -> None:
        document["waivers"] = [waiver]
        document["conditions"][0]["derivatives"]["Cl_beta"] = 0.07

    return change


@pytest.mark.parametrize("where", [{}, {"condition": "slow"}])
def test_a_waived_finding_stays_and_is_shown_in_flight(where: dict[str, str]) -> None:
    document = copy.deepcopy(MINE)
    _waive(rule="sign_Cl_beta", reason="wings bent down", **where)(document)
    mine = parse(document, "mine")
    (finding,) = check(mine)
    assert (finding.rule, finding.waived) == ("sign_Cl_beta", "wings bent down")
    said = "Waived: Cl_beta is 0.07 1/rad; it must be less than 0. Wings bent down."
    assert mine.at().notes[-1] == said
    assert mine.at(variant="printed").notes[-1] == said


def test_a_waiver_of_nothing_is_found() -> None:
    waived, idle = found_after(
        lambda d: d.update(
            waivers=[
                {"rule": "sign_Cl_beta", "reason": "so"},
                {"rule": "range_CD", "condition": "slow", "reason": "so"},
            ],
            conditions=[d["conditions"][0] | {"derivatives": d["conditions"][0]["derivatives"] | {"Cl_beta": 0.07}}],
        )
    )
    assert waived.waived == "so"
    assert (idle.rule, idle.condition, idle.severity, idle.waived) == ("idle_waiver", "slow", "warning", None)
    assert "range_CD" in idle.what


def test_a_condition_has_no_waiver_of_another() -> None:
    document = copy.deepcopy(MINE)
    document["conditions"].append(copy.deepcopy(document["conditions"][0]) | {"id": "fast"})
    for condition in document["conditions"]:
        condition["derivatives"]["Cl_beta"] = 0.07
    document["waivers"] = [{"rule": "sign_Cl_beta", "condition": "fast", "reason": "so"}]
    assert [(f.condition, f.waived) for f in check(parse(document, "mine"))] == [("slow", None), ("fast", "so")]


def test_the_convair_says_in_flight_what_is_waived() -> None:
    notes = " ".join(load("Convair880").at().notes)
    assert (
        "Waived: Ix + Iy is 4,880,945 kg m^2, less than Iz, 5,518,179 kg m^2; no body is so. The book prints" in notes
    )


@pytest.mark.parametrize(
    ("aircraft", "condition", "reason"),
    [
        pytest.param(a, f.condition, f.waived, id=f"{a.id} {f.condition}")
        for a in catalogue()
        for f in check(a)
        if f.rule == "reference_axes"
    ],
)
def test_the_damping_that_a_waiver_speaks_of(aircraft: Any, condition: str, reason: str) -> None:
    numbers = re.search(r"from (\d+) to (\d+) deg, .* from (-?[\d.]+) to ([\d.]+)", reason)
    assert numbers
    ready = aircraft.at(condition)
    for alpha, damping in ((numbers[1], numbers[3]), (numbers[2], numbers[4])):
        turned = replace(ready, reference=ready.reference._replace(alpha=radians(float(alpha))))
        (dutch_roll,) = (m for m in modes(turned) if m.name == "dutch_roll")
        assert dutch_roll.zeta == pytest.approx(float(damping), abs=6e-4)
