"""From an aircraft file to numbers in SI: both variants, signs, mass, air, and where each number is from."""

import json
from dataclasses import FrozenInstanceError
from pathlib import Path
from typing import Any

import pytest

from fdes.aircraft import Aircraft, FlightCondition, catalogue, load, parse
from fdes.physics.atmosphere import standard_atmosphere
from fdes.units import DEG, FOOT, POUND_FORCE, POUND_MASS

PAPER = ["A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar"]
MORE = ["A-7A", "B747_CR2144", "B747_Etkin", "F-16", "NT-33A"]

MINE = Path(__file__).parent / "mine.toml"


def test_numbers_come_out_in_si() -> None:
    navion = load("NAVION").at("M0.158_SL")
    ref = navion.reference
    assert ref.Iy == pytest.approx(3000 * 1.3558179483314004)  # slug ft^2
    assert ref.m == 2750 * POUND_MASS
    assert pytest.approx(184 * FOOT**2) == ref.S
    assert ref.V == 176 * FOOT
    assert ref.rho == pytest.approx(1.2256, rel=1e-4)  # 0.002378 slug/ft^3
    assert ref.g == pytest.approx(32.2 * FOOT)
    assert ref.alpha == pytest.approx(0.6 * DEG)
    assert navion.cg == 0.295


def test_air_is_standard_where_the_file_does_not_say() -> None:
    ref = load("A-4D").at("M0.8_35kft").reference
    air = standard_atmosphere(35000 * FOOT)
    assert ref.rho == air.rho
    assert pytest.approx(0.8 * air.a) == ref.V
    assert ref.g == 9.80665


def test_variants_differ_where_the_book_is_wrong() -> None:
    book, right = (load("A-4D").at("M0.4_SL", variant=v).coefficients for v in ("printed", "corrected"))
    differ = {name: (b, r) for name, b, r in zip(book._fields, book, right, strict=True) if b != r}
    assert differ == {"Cn_da": (0.06, 0.006), "Cl_dr": (-0.105, 0.032), "Cn_dr": (0.032, -0.105)}


def test_corrected_is_the_default() -> None:
    a4d = load("A-4D")
    assert a4d.at() is a4d.at("M0.4_SL", variant="corrected")


def test_aileron_of_the_other_sense_is_reversed() -> None:
    printed = load("NAVION").at(variant="printed")
    assert (printed.coefficients.Cl_da, printed.coefficients.Cn_da) == (0.134, 0.0035)
    assert (printed.provenance["Cl_da"].printed, printed.provenance["Cn_da"].printed) == (-0.134, -0.0035)
    assert load("NAVION").at().coefficients.Cn_da == -0.0035
    assert any("positive aileron rolls left" in note for note in printed.notes)


def test_mass_belongs_to_the_coefficients() -> None:
    b747 = load("B747")
    book, right = b747.at("M0.25_SL", variant="printed"), b747.at("M0.25_SL")
    assert (book.reference.m, right.reference.m) == (636600 * POUND_MASS, 564032 * POUND_MASS)
    qS = 0.5 * right.reference.rho * right.reference.V**2 * right.reference.S
    assert pytest.approx(right.reference.m * right.reference.g / qS, rel=0.01) == right.coefficients.CL
    assert b747.at("M0.90_40kft").reference.m == book.reference.m


def test_weight_alone_may_belong() -> None:
    """The Convair's cruise inertias are not known: those of the book, as corrected, stay."""
    low, high = (load("Convair880").at(c).reference for c in ("M0.25_SL", "M0.8_35kft"))
    assert (low.m, high.m) == (126000 * POUND_MASS, 155000 * POUND_MASS)
    assert low.Ix == high.Ix == pytest.approx(1150000 * 1.3558179483314004)


def test_throttle_holds_level_flight() -> None:
    fc = load("A-4D").at()
    drag = 0.03 * 0.5 * fc.reference.rho * fc.reference.V**2 * fc.reference.S
    assert fc.reference.T_max == pytest.approx(7700 * POUND_FORCE)
    assert fc.trim_throttle * fc.reference.T_max == pytest.approx(drag)


def test_stick_and_limits() -> None:
    fc = load("A-4D").at()
    assert fc.full_stick == pytest.approx((-6 * DEG, 7.5 * DEG, -14 * DEG, 1.0))
    assert fc.limits.lower == pytest.approx((-20 * DEG, -20 * DEG, -20 * DEG, 0.0))
    assert fc.limits.upper == pytest.approx((10 * DEG, 20 * DEG, 20 * DEG, 1.0))


def test_provenance() -> None:
    fc = load("A-4D").at()
    rudder = fc.provenance["Cl_dr"]
    assert (rudder.value, rudder.printed, rudder.corrected, rudder.unverified) == (0.032, -0.105, 0.032, False)
    assert rudder.reason is not None
    assert rudder.reason.startswith("swapped with Cn_dr")
    assert rudder.sources == ("AEROSONDE",)
    assert "Beard and McLain" in load("A-4D").sources["AEROSONDE"]
    weight = load("F-104A").at("M0.257_SL").provenance["W"]
    assert (weight.printed, weight.corrected, weight.unit, weight.si_unit) == (16300, 14126, "lb", "kg")
    assert weight.value == 14126 * POUND_MASS
    assert load("F-104A").at("M0.257_SL", variant="printed").provenance["W"].value == 16300 * POUND_MASS


def test_what_is_presumed_or_missing_is_noted() -> None:
    high = load("A-4D").at("M0.8_35kft")
    assert "Presumed corrections, found in no source: Cn_da." in high.notes
    assert any("trim angle of attack is not known" in note for note in high.notes)
    assert high.reference.alpha == 0.0
    assert "Not tabulated, taken as zero: CD_de, Cy_p, Cy_r, Cy_da." in high.notes
    assert not any("Presumed" in note for note in load("A-4D").at("M0.8_35kft", variant="printed").notes)


def test_what_is_assumed_says_so() -> None:
    thrust = load("A-4D").at().assumed["max_thrust"]
    assert thrust == {"value": 7700, "unit": "lbf", "reason": "sea-level static rating of one Wright J65-W-16A"}


def test_confidence_of_a_condition() -> None:
    assert [c.confidence for a in catalogue() for c in a.conditions] == [
        *("high", "low"),  # A-4D
        *("medium", "high"),  # F-104A
        "high",  # NAVION
        *("low", "high"),  # Convair 880
        *("high", "high"),  # B747
        *("low", "low"),  # JetStar
        "medium",  # A-7A
        *("medium", "high", *["medium"] * 6, "high", "high"),  # B747_CR2144
        "high",  # B747_Etkin
        *("high", "high"),  # F-16
        *("high", "high"),  # NT-33A
    ]


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("a4d", "A-4D"),
        ("A-4D", "A-4D"),
        ("a4", "A-4D"),
        ("a-4 skyhawk", "A-4D"),
        ("Douglas A-4D Skyhawk", "A-4D"),
        ("f104", "F-104A"),
        ("F_104 a", "F-104A"),
        ("starfighter", "F-104A"),
        ("navion", "NAVION"),
        ("NAVION (general aviation airplane)", "NAVION"),
        ("Convair 880", "Convair880"),
        ("cv-880", "Convair880"),
        ("Boeing 747", "B747"),
        ("747", "B747"),
        ("jumbo", "B747"),
        ("Lockheed JetStar", "JetStar"),
        ("c-140", "JetStar"),
        ("nt33a", "NT-33A"),
        ("A7", "A-7A"),
        ("b747 etkin", "B747_Etkin"),
    ],
)
def test_names(name: str, known: str) -> None:
    assert load(name).id == known


def test_conditions_by_any_spelling() -> None:
    assert load("A-4D").at("m0.4 sl").condition == "M0.4_SL"


def test_catalogue_is_in_the_order_of_the_paper() -> None:
    assert [a.id for a in catalogue()] == PAPER + MORE


def test_a_file_of_your_own() -> None:
    for fc in (load(MINE).at("slow"), load(str(MINE)).at()):
        assert fc.aircraft_id == "mine"
        assert fc.coefficients.CL_alpha == pytest.approx(0.08 / DEG)
        assert fc.provenance["CL_alpha"].unit == "1/deg"
        assert fc.reference.Ixz == 0.0
        assert fc.provenance["CL"].confidence is None
        assert fc.cg is None
    assert load(MINE).conditions[0].confidence is None


def test_the_document_is_plain_and_makes_the_same_aircraft() -> None:
    for aircraft in catalogue():
        again: Aircraft = parse(json.loads(json.dumps(aircraft.document)), "a recording")
        for condition in aircraft.conditions:
            assert again.at(condition.id) == aircraft.at(condition.id)


def test_nothing_can_be_changed() -> None:
    fc: Any = load("A-4D").at()
    with pytest.raises(FrozenInstanceError):
        fc.trim_throttle = 0.0
    with pytest.raises(AttributeError):
        fc.coefficients.CL = 0.0


def test_level_flight_lift_is_near_the_weight() -> None:
    """Where the derivatives have their own mass, CL carries it; the others are of the book's making."""
    for aircraft in catalogue():
        for condition in aircraft.conditions:
            fc: FlightCondition = aircraft.at(condition.id)
            if not fc.nondimensional:
                continue
            ref = fc.reference
            carried = fc.coefficients.CL * 0.5 * ref.rho * ref.V**2 * ref.S
            assert carried == pytest.approx(ref.m * ref.g, rel=0.05), (aircraft.id, condition.id)


def test_inertia_tensor_may_be_full(tmp_path: Path) -> None:
    lopsided = '[mass.Ixy]\nprinted = 40\nunit = "kg m^2"\n[mass.Iyz]\nprinted = -30\nunit = "kg m^2"\n[assumed]'
    (tmp_path / "mine.toml").write_text(MINE.read_text().replace("[assumed]", lopsided, 1))
    ready = load(tmp_path / "mine.toml").at()
    assert (ready.provenance["Ixy"].value, ready.provenance["Iyz"].value) == (40.0, -30.0)
    assert "Ixy and Iyz: given, and left out of the linear equations, which are symmetric." in ready.notes
