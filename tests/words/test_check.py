"""`fdes check`: what is said of a doubtful aircraft, to people and to programs, and with which status."""

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.aircraft.check import RULES
from fdes.cli import app

MINE = (Path(__file__).parents[1] / "unit" / "mine.toml").read_text(encoding="utf-8")
CLEAN = MINE.replace("CL = 0.5", "CL = 0.32").replace(
    "mach = 0.15", 'mach = 0.15\ntrim_alpha = { printed = 1, unit = "deg" }'
)


def run(*words: str) -> Any:
    return CliRunner().invoke(app, ["check", *words], prog_name="fdes", env={"COLUMNS": "80"})


def written(folder: Path, text: str) -> str:
    path = folder / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def lines(text: str) -> list[str]:
    return [line.rstrip() for line in text.rstrip().splitlines()]


def test_a_clean_file(tmp_path: Path) -> None:
    result = run(written(tmp_path, CLEAN))
    assert result.exit_code == 0
    last = f"{len(RULES)} rules, 1 condition: 0 errors, 0 warnings, 0 waived"
    assert lines(result.stdout) == ["mine slow: clean", "", last]


def test_findings_say_what_they_mean_in_flight_and_what_to_do(tmp_path: Path) -> None:
    text = CLEAN.replace("Cn_dr = -0.07", "Cn_dr = 0.07").replace("CD = 0.05", "CD = 0.126")
    text += '\n[[waivers]]\nrule = "trim_throttle"\nreason = "a glider with a small engine"\n'
    result = run(written(tmp_path, text))
    assert result.exit_code == 1
    assert lines(result.stdout) == [
        "mine slow",
        "  error    sign_Cn_dr",
        "           Cn_dr is 0.07 1/rad; it must be less than 0.",
        "           In flight: Right pedal yaws left.",
        "           To do: Compare the source's sign and sense with docs/symbols.md; mend",
        "           a misprint with corrected = ... and a reason.",
        "  waived   trim_throttle",
        "           The throttle for level flight is 0.970 of max_thrust, 2,000 N.",
        "           In flight: It can neither climb nor accelerate: the throttle is all",
        "           but open in level flight.",
        "           Reason: a glider with a small engine",
        "",
        f"{len(RULES)} rules, 1 condition: 1 error, 0 warnings, 1 waived",
    ]


def test_a_warning_alone_is_a_finding_too(tmp_path: Path) -> None:
    result = run(written(tmp_path, CLEAN + '\n[[waivers]]\nrule = "range_CD"\nreason = "so"\n'))
    assert result.exit_code == 1
    assert "mine, whole file\n  warning  idle_waiver" in result.stdout
    assert "1 condition: 0 errors, 1 warning, 0 waived" in result.stdout


def test_the_whole_hangar_in_80_columns() -> None:
    result = run()
    assert result.exit_code == 0, result.stdout
    assert max(map(len, lines(result.stdout))) <= 80
    assert lines(result.stdout)[-1].startswith(f"{len(RULES)} rules, 27 conditions: 0 errors, 0 warnings, ")
    assert "NAVION M0.158_SL: clean" in result.stdout


def test_one_aircraft_by_any_name() -> None:
    result = run("convair 880")
    assert result.exit_code == 0
    assert "  waived   inertia_triangle" in result.stdout
    assert "A-4D" not in result.stdout


def test_json(tmp_path: Path) -> None:
    result = run(written(tmp_path, CLEAN.replace("Cn_dr = -0.07", "Cn_dr = 0.07")), "--json")
    assert result.exit_code == 1
    said = json.loads(result.stdout)
    assert list(said) == ["findings", "rules", "conditions", "errors", "warnings", "waived"]
    (finding,) = said["findings"]
    assert finding | {"what": "", "advice": ""} == {
        "aircraft": "mine",
        "rule": "sign_Cn_dr",
        "condition": "slow",
        "variant": "corrected",
        "severity": "error",
        "what": "",
        "meaning": "Right pedal yaws left.",
        "advice": "",
        "waived": None,
    }
    assert (said["rules"], said["conditions"], said["errors"]) == (len(RULES), 1, 1)
    hangar = run("--json")
    assert hangar.exit_code == 0
    assert all(f["waived"] for f in json.loads(hangar.stdout)["findings"])


@pytest.mark.parametrize(
    ("waiver", "words"),
    [
        (
            'rule = "sign_Cl_bta"\nreason = "so"',
            "waivers.0.rule is 'sign_Cl_bta', which is no rule of fdes check. Did you mean 'sign_Cl_beta'?",
        ),
        (
            'rule = "zzz"\nreason = "so"',
            "waivers.0.rule is 'zzz', which is no rule of fdes check. Take the name that fdes check shows.",
        ),
        ('rule = "sign_Cl_beta"', "waivers.0.reason is missing."),
        ('rule = "sign_Cl_beta"\nreason = ""', "waivers.0.reason is empty."),
        (
            'rule = "sign_Cl_beta"\nreason = "so"\ncondition = "slw"',
            "sign_Cl_beta is waived for an unknown condition 'slw'. Did you mean 'slow'?",
        ),
        (
            'rule = "sign_Cl_beta"\nreason = "so"\ncondition = "zzz"',
            "sign_Cl_beta is waived for an unknown condition 'zzz'. Known: slow.",
        ),
    ],
)
def test_a_waiver_that_cannot_be(tmp_path: Path, waiver: str, words: str) -> None:
    path = written(tmp_path, f"{CLEAN}\n[[waivers]]\n{waiver}\n")
    result = run(path)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr == f"Error: {path} cannot be used:\n  {words}\n"


def test_an_unusable_file(tmp_path: Path) -> None:
    for path in (written(tmp_path, "format = 2"), str(tmp_path / "none.toml"), "skyhwak"):
        result = run(path)
        assert result.exit_code == 2
        assert result.stderr.startswith("Error: ")
