"""What a reader is told when an aircraft file, a name or a condition is wrong: what, where, and what to do."""

from pathlib import Path

import pytest

from fdes.aircraft import load, parse
from fdes.errors import AircraftFileError, FdesError, NoSuchPart

MINE = (Path(__file__).parents[1] / "unit" / "mine.toml").read_text(encoding="utf-8")

MISTAKES = [
    pytest.param(
        "Cl_p = -0.4",
        "Cl_p = -0.4\nCl_pp = -0.4",
        "derivatives.Cl_pp of condition 'slow' is not a known key. Did you mean 'Cl_p'?",
        id="misspelled key",
    ),
    pytest.param(
        "[mass]",
        "[mass]\nzzz = 1",
        "mass.zzz is not a known key. Known here: source, W, cg, Ix, Iy, Iz, Ixz, Ixy, Iyz.",
        id="key unlike any",
    ),
    pytest.param("Cl_p = -0.4", "", "derivatives.Cl_p of condition 'slow' is missing.", id="missing number"),
    pytest.param('id = "slow"', "", "id of condition 1 is missing.", id="condition without a name"),
    pytest.param(
        "Cl_p = -0.4",
        'Cl_p = "-0.4"',
        "derivatives.Cl_p of condition 'slow' is '-0.4'; it must be a number or a table such as { printed = 0.5 }.",
        id="text for a number",
    ),
    pytest.param("mach = 0.15", "mach = true", "mach of condition 'slow' is True; it must be a number.", id="a switch"),
    pytest.param('name = "My aircraft"', "name = 7", "name is 7; it must be text in quotes.", id="number for a text"),
    pytest.param(
        "max_thrust = {",
        "max_thrust = 2 #",
        "assumed.max_thrust is 2; it must be a table of value, unit, reason.",
        id="bare",
    ),
    pytest.param(
        "[[conditions]]",
        "[conditions]",
        "conditions is a table; it must be a list, or tables under [[double brackets]].",
        id="single brackets",
    ),
    pytest.param(
        "Cl_p = -0.4",
        "Cl_p = nan",
        "derivatives.Cl_p.printed of condition 'slow' is nan; it must be a finite number.",
        id="nan",
    ),
    pytest.param(
        "Cl_p = -0.4",
        "Cl_p = { printed = -inf }",
        "derivatives.Cl_p.printed of condition 'slow' is -inf; it must be a finite number.",
        id="infinite",
    ),
    pytest.param(
        'printed = 500, unit = "kg"',
        'printed = -500, unit = "kg"',
        "mass.W is -500 kg, and must be greater than zero.",
        id="negative mass",
    ),
    pytest.param("mach = 0.15", "mach = -1", "mach of condition 'slow' is -1; it must be greater than 0.", id="Mach"),
    pytest.param(
        'unit = "kg" }',
        'unit = "lbf" }',
        "mass.W is in 'lbf', which does not fit here: use one of 'kg', 'lb', 'slug'.",
        id="wrong unit",
    ),
    pytest.param(
        'unit = "kg" }',
        'unit = "kgs" }',
        "mass.W is in 'kgs', which does not fit here: use one of 'kg', 'lb', 'slug'.",
        id="no unit at all",
    ),
    pytest.param(
        ', unit = "kg" }', "}", "mass.W has no unit: add unit = one of 'kg', 'lb', 'slug'.", id="unit left out"
    ),
    pytest.param(
        "Cl_p = -0.4",
        "Cl_p = { printed = -0.4, corrected = -0.5 }",
        "derivatives.Cl_p of condition 'slow' has a corrected value without a reason: add reason = \"...\".",
        id="no reason",
    ),
    pytest.param(
        "Cl_p = -0.4",
        'Cl_p = { printed = -0.4, confidence = "sure" }',
        "derivatives.Cl_p.confidence of condition 'slow' is 'sure'; it must be 'high', 'medium' or 'low'.",
        id="confidence",
    ),
    pytest.param(
        "Cl_p = -0.4",
        'Cl_p = { printed = -0.4, sources = ["MEE"] }',
        "source 'MEE' is cited, but not listed under [sources]. Did you mean 'ME'?",
        id="unlisted source",
    ),
    pytest.param("format = 1", "format = 2", "format is 2; it must be 1.", id="format"),
    pytest.param(
        "max_thrust =",
        "# max_thrust =",
        "[assumed] lacks 'max_thrust', and condition 'slow' does not give its own.",
        id="nothing assumed",
    ),
    pytest.param(
        'value = 2, unit = "kN"',
        'value = 2, unit = "N"',
        "condition 'slow', corrected values: level flight needs 770 N of thrust, but max_thrust is 2 N. "
        "Check the drag, the altitude and the units, or assume more thrust.",
        id="too little thrust",
    ),
    pytest.param(
        "Cl_da = 0.13",
        "Cl_da = -0.13",
        "condition 'slow', corrected values: Cl_da is -0.13 1/rad by the file's aileron_sense, but positive aileron "
        'must roll right. Where the source prints Cl_da < 0, say aileron_sense = "positive rolls left".',
        id="aileron sense",
    ),
    pytest.param(
        "full_stick_elevator = { value = 5",
        "full_stick_elevator = { value = 50",
        "condition 'slow', corrected values: full stick moves the elevator to -50 deg, beyond its limits of -20 and "
        "15 deg. Assume less stick or more travel.",
        id="stick beyond limits",
    ),
    pytest.param(
        "[assumed]",
        '[mass.Ixz]\nprinted = 1000\nunit = "kg m^2"\n[assumed]',
        "condition 'slow', corrected values: Ix, Iz and Ixz are 500, 1,000 and 1,000 kg m^2; no body has such "
        "inertias. Ixz squared must be less than Ix times Iz.",
        id="impossible inertias",
    ),
    pytest.param(
        "[assumed]",
        '[mass.Ixy]\nprinted = 600\nunit = "kg m^2"\n[assumed]',
        "condition 'slow', corrected values: with Ixy = 600 and Iyz = 0 kg m^2, the inertias are those of no body. "
        "Compare them with the source: their unit, and whether it prints the product or its double.",
        id="impossible full inertias",
    ),
    pytest.param(
        'unit = "ft" }',
        'unit = "km" }',
        "condition 'slow', corrected values: The standard atmosphere reaches from -5,000 m to 86,000 m; "
        "height 1,000,000 m is outside it.",
        id="out of the atmosphere",
    ),
    pytest.param(
        "[conditions.derivatives]",
        '[conditions.consistent_mass]\nreason = "wet"\nW = { printed = 900, unit = "lb" }\n[conditions.derivatives]',
        "consistent_mass.W of condition 'slow' is not in kg, as [mass] is.",
        id="mixed units of mass",
    ),
]


@pytest.mark.parametrize(("line", "mistake", "words"), MISTAKES)
def test_a_mistake_in_a_file(tmp_path: Path, line: str, mistake: str, words: str) -> None:
    path = tmp_path / "mine.toml"
    assert line in MINE
    path.write_text(MINE.replace(line, mistake), encoding="utf-8")
    with pytest.raises(AircraftFileError) as caught:
        load(path)
    assert str(caught.value) == f"{path} cannot be used:\n  {words}"
    assert caught.value.__cause__ is None


def test_many_mistakes_are_cut_short(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(MINE.replace("\nC", "\nX"), encoding="utf-8")
    with pytest.raises(AircraftFileError) as caught:
        load(path)
    lines = str(caught.value).splitlines()
    assert len(lines) == 7
    assert lines[-1] == "  ... and 35 more."


def test_not_toml(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("format = 1\nid = mine", encoding="utf-8")
    with pytest.raises(AircraftFileError, match=r"mine.toml cannot be used: it is not TOML\. .* line 2, column \d+"):
        load(path)
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(AircraftFileError, match=r"mine.toml cannot be used: it is not text in UTF-8\."):
        load(path)


def test_no_file(tmp_path: Path) -> None:
    (tmp_path / "glider.toml").touch()
    for name, hint in (
        ("glidr.toml", "Did you mean 'glider.toml'?"),
        ("none.toml", "An aircraft of the hangar goes by its name alone, such as A-4D."),
    ):
        with pytest.raises(AircraftFileError) as caught:
            load(tmp_path / name)
        assert str(caught.value) == f"There is no aircraft file {tmp_path / name}. {hint}"
    with pytest.raises(AircraftFileError, match="Nor is there a folder"):
        load(tmp_path / "nowhere" / "glider.toml")
    with pytest.raises(AircraftFileError, match="cannot be read"):
        load(tmp_path)


def test_a_document_names_its_owner() -> None:
    with pytest.raises(AircraftFileError, match=r"^The recording a.fdes cannot be used:\n  format is missing\."):
        parse({}, "The recording a.fdes")


def ask(aircraft: str, condition: str | None = None, variant: str = "corrected") -> str:
    with pytest.raises(NoSuchPart) as caught:
        load(aircraft).at(condition, variant)
    assert isinstance(caught.value, FdesError)
    return str(caught.value)


def test_unknown_names() -> None:
    known = "Known: A-4D, A-7A, B747, B747_CR2144, B747_Etkin, Convair880, F-104A, F-16, JetStar, NAVION, NT-33A."
    assert ask("skyhwak") == f"There is no aircraft named 'skyhwak'. Did you mean 'A-4D'? {known}"
    assert ask("Nawion") == f"There is no aircraft named 'Nawion'. Did you mean 'NAVION'? {known}"
    assert ask("xyz") == f"There is no aircraft named 'xyz'. {known}"
    assert ask("A-4D", "M0.8") == (
        "There is no flight condition of the A-4D named 'M0.8'. Did you mean 'M0.8_35kft'? Known: M0.4_SL, M0.8_35kft."
    )
    assert ask("A-4D", None, "print") == (
        "There is no variant named 'print'. Did you mean 'printed'? Known: corrected, printed."
    )
