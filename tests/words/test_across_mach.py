"""What is said of an aircraft interpolated across Mach, and to whoever asks for one that cannot be."""

import json

import pytest
from typer.testing import CliRunner

from fdes.aircraft import load, parse
from fdes.cli import app
from fdes.errors import SpecError

NO_AIRCRAFT_BETWEEN = "Between two configurations there is no aircraft; leave --across out."


def refusal(*arguments: str) -> str:
    result = CliRunner().invoke(app, [*arguments])
    assert result.exit_code == 2, result.output
    return " ".join(result.output.split())


def notes(*arguments: str) -> list[str]:
    result = CliRunner().invoke(app, [*arguments, "--json"])
    assert result.exit_code == 0, result.output
    said: list[str] = json.loads(result.stdout)["notes"]
    return said


@pytest.mark.parametrize(
    ("aircraft", "chosen", "other"),
    [
        ("F-104A", "M0.257_SL", "M1.8_55kft"),
        ("B747", "M0.25_SL", "M0.90_40kft"),
        ("Convair880", "M0.25_SL", "M0.8_35kft"),
        ("JetStar", "M0.20_SL", "M0.80_40kft"),
    ],
)
def test_conditions_of_two_configurations(aircraft: str, chosen: str, other: str) -> None:
    assert (
        f"{aircraft} {chosen} cannot be interpolated across Mach: it is power approach, and {other} is clean. "
        f"{NO_AIRCRAFT_BETWEEN}"
    ) in refusal("trim", aircraft, "--across", "mach")


@pytest.mark.parametrize(
    ("aircraft", "said"),
    [
        ("NAVION", "NAVION M0.158_SL cannot be interpolated across Mach: its file has no other condition. Leave"),
        ("F-16", "F-16 V502_SL is not interpolated across Mach: its aerodynamics are tables. Leave --across out."),
        ("A-7A", "its source gives dimensional derivatives, which hold at one speed and height alone."),
    ],
)
def test_what_cannot_be_interpolated(aircraft: str, said: str) -> None:
    assert said in refusal("trim", aircraft, "--across", "mach")


def test_what_else_is_refused() -> None:
    assert "There is no quantity to interpolate across named 'match'. Did you mean 'mach'?" in refusal(
        "linearize", "A-4D", "--across", "match"
    )
    linear = "The linear plant is that of its flight condition: give --across with --plant nonlinear."
    assert linear in refusal("simulate", "A-4D", "--across", "mach")


def test_a_file_that_does_not_say_its_configuration() -> None:
    document = dict(load("A-4D").document)
    document["conditions"] = [
        {k: v for k, v in c.items() if k != "configuration"} if c["id"] == "M0.8_35kft" else c
        for c in document["conditions"]
    ]
    with pytest.raises(SpecError) as refused:
        parse(document, "the file").at(across="mach")
    assert str(refused.value) == (
        "A-4D M0.4_SL cannot be interpolated across Mach: its file does not say in which configuration M0.8_35kft is, "
        'with flaps and gear in or out. Where you know it, say it there: configuration = { name = "clean", '
        'reason = "..." }.'
    )


def test_two_conditions_at_one_mach_number() -> None:
    document = dict(load("A-4D").document)
    document["conditions"] = [{**c, "mach": 0.8} for c in document["conditions"]]
    with pytest.raises(SpecError, match=r"two of its conditions are at Mach 0\.8"):
        parse(document, "the file").at(across="mach")


def test_what_is_assumed_and_where_it_ends() -> None:
    said = notes("trim", "A-4D", "mach=0.6 h=15000 ft", "--across", "mach")
    assert said[0] == (
        "Derivatives are interpolated from Mach 0.4 to 0.8, between M0.4_SL and M0.8_35kft; beyond, they are those of "
        "the nearest. Mass (7,973 kg), inertias and engine are those of M0.4_SL."
    )
    assert said[3] == (
        "At Mach 0.8 the Mach derivatives are the printed ones, and in brackets what the straight line from Mach 0.4 "
        "to 0.8 would have: CL_M 0.15 (0.103), CD_M 0.03 (0.0244), Cm_M -0.05 (-0.00585)."
    )
    assert said[4].startswith("Presumed: M0.8_35kft flies at 4.3 deg angle of attack in the axes of M0.4_SL")
    (slow,) = [n for n in notes("linearize", "A-4D", "mach=0.3 h=0 ft", "--across", "mach") if "beyond its" in n]
    assert slow == (
        "mach is beyond its conditions: it reaches 0.3, and they end at 0.4. What is computed there is no longer the "
        "source's."
    )
