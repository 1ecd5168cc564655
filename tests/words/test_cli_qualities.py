"""What `fdes qualities` says: its tables, its JSON, its charts, and what it answers to mistakes."""

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.aircraft import catalogue
from fdes.cli import app

KEYS = ["criterion", "mode", "level", "margin", "value", "unit", "requirement", "reference", "reason"]
CONDITIONS = [(a.id, c.id) for a in catalogue() for c in a.conditions]
ONE = ["--criterion", "mil_f_8785c_short_period", "--category", "C"]


def run(*words: str, status: int = 0) -> Any:
    result = CliRunner().invoke(app, ["qualities", *words], prog_name="fdes", env={"COLUMNS": "80"})
    assert result.exit_code == status, result.output
    return result


def asked(*words: str) -> Any:
    return json.loads(run(*words, "--json").stdout)


def mistake(*words: str) -> str:
    return " ".join(run(*words, status=2).stderr.split())


@pytest.mark.parametrize(("aircraft", "condition"), CONDITIONS)
def test_every_aircraft_fits_80_columns(aircraft: str, condition: str) -> None:
    text = run(aircraft, "--condition", condition).stdout
    assert max(len(line.rstrip()) for line in text.splitlines()) <= 80
    assert "nan" not in text.casefold().split()


def test_the_verdicts_on_an_aircraft_as_json() -> None:
    found = asked("NAVION", "--class", "I", "--category", "B")
    assert [list(verdict) for verdict in found["verdicts"]] == [KEYS] * 7
    assert {v["mode"]: v["level"] for v in found["verdicts"]} == {
        "short_period": 1,
        "phugoid": 1,
        "roll": 1,
        "dutch_roll": 1,
        "spiral": 1,
        "roll_spiral": None,
        "response": None,
    }
    assert (found["class"], found["category"], found["aircraft"], found["units"]) == ("I", "B", "NAVION", "SI")
    assert found["improvements"] == []


def test_what_one_change_would_do() -> None:
    found = asked("A-4D")["improvements"]
    assert [(i["mode"], i["name"], i["level"]) for i in found] == [
        ("dutch_roll", "Cn_beta", 1),
        ("dutch_roll", "Cn_r", 1),
    ]
    assert "dutch roll: Cn_r from -0.35 to -0.691 (x1.97) reaches Level 1" in run("A-4D").stdout
    assert "short period: Cm_q from 0 to -1.18 reaches Level 2" in run("A-4D", "--set", "Cm_q*=0").stdout
    text = " ".join(run("A-4D", "-c", "M0.8_35kft").stdout.split())
    assert "dutch roll: None of Cy_beta, Cl_beta, Cn_beta, Cn_p, Cn_r alone reaches Level 1 within its range." in text


def test_one_criterion_gives_one_verdict_and_says_what_governs() -> None:
    (verdict,) = asked(*ONE, "--omega-sp", "0.95", "--n-alpha", "9", "--zeta-sp", "0.7")["verdicts"]
    assert verdict["level"] == 2
    assert verdict["value"] == pytest.approx(0.95**2 / 9.0)
    assert verdict["margin"] == pytest.approx((0.95**2 / 9.0 - 0.096) / 0.096)
    assert verdict["reason"].startswith("Frequency governs: CAP is 0.100 1/(g s^2)")
    (verdict,) = asked(*ONE, "--omega-sp", "3", "--n-alpha", "9", "--zeta-sp", "0.2")["verdicts"]
    assert (verdict["level"], verdict["value"]) == (3, 0.2)
    assert verdict["reason"].startswith("Damping governs: zeta_sp is 0.2: Level 3.")


def test_what_is_left_out_limits_the_verdict_and_it_says_so() -> None:
    (verdict,) = asked(*ONE, "--zeta-sp", "0.7")["verdicts"]
    assert verdict["level"] == 1
    assert "Without omega_sp and n_alpha the frequency is not judged." in verdict["reason"]
    (verdict,) = asked(*ONE, "--omega-sp", "0.95", "--n-alpha", "9")["verdicts"]
    assert "Without zeta_sp the damping is not judged." in verdict["reason"]
    (verdict,) = asked("--criterion", "mil_f_8785c_dutch_roll", "--zeta-dr", "0.3", "--omega-dr", "2")["verdicts"]
    assert "|phi/beta| is not known" in verdict["reason"]
    (verdict,) = asked("--criterion", "mil_f_8785c_phugoid", "--zeta-ph", "-0.01")["verdicts"]
    assert verdict["level"] is None
    assert "takes t2_ph" in verdict["reason"]


@pytest.mark.parametrize(
    ("zeta", "says"), [("0.2", "Level 1 at best"), ("0.1", "Level 2 at best"), ("-0.1", "worse than Level 3")]
)
def test_damping_without_its_frequency_says_what_it_can_be(zeta: str, says: str) -> None:
    (verdict,) = asked("--criterion", "mil_f_8785c_dutch_roll", "--zeta-dr", zeta)["verdicts"]
    assert verdict["level"] is None
    assert verdict["reason"].startswith(f"Without omega_dr the damping is not judged; zeta_dr {zeta} is {says}.")


def test_an_omitted_class_takes_the_strictest() -> None:
    found = asked("--criterion", "mil_f_8785c_roll_mode", "--tau-roll", "1.2", "--category", "C")
    assert (found["class"], found["verdicts"][0]["level"]) == ("IV", 2)
    assert found["chosen"] == "C as asked for; the rest: the default, because it is the strictest"
    found = asked("--criterion", "mil_f_8785c_roll_mode", "--tau-roll", "1.2", "--category", "C", "--class", "III")
    assert found["verdicts"][0]["level"] == 1


@pytest.mark.parametrize(
    ("words", "level"),
    [
        (["--zeta-dr", "0.3", "--omega-dr", "2", "--phase", "CO"], 2),
        (["--zeta-dr", "0.3", "--omega-dr", "2"], 1),
        (["--zeta-dr", "0.1", "--omega-dr", "3", "--phi-beta", "4", "--category", "B"], 2),
        (["--t2-spiral", "15"], 1),
        (["--t2-spiral", "15", "--category", "B"], 2),
        (["--t2-spiral", "inf"], 1),
        (["--zeta-ph", "0.05"], 1),
        (["--t2-ph", "60"], 3),
        (["--t2-speed", "5"], 4),
        (["--damping-rs", "0.4", "--category", "C"], 2),
        (["--delay", "0.3"], 4),
    ],
)
def test_numbers_alone_find_their_criterion(words: list[str], level: int) -> None:
    (verdict,) = asked(*words)["verdicts"]
    assert verdict["level"] == level


def test_an_edited_aircraft_is_judged() -> None:
    levels = [asked("A-4D", "--set", f"Cm_q*={factor}")["verdicts"][0]["level"] for factor in (1, 0.5, 0)]
    assert levels == [1, 2, 3]


def test_a_closed_loop_is_judged_and_its_gain_may_be_what_to_change() -> None:
    found = asked("A-4D", "--law", "yaw_damper gain=0.05")
    assert found["law"]["gains"]["yaw_damper"]["gain"] == 0.05
    dutch_roll = next(v for v in found["verdicts"] if v["mode"] == "dutch_roll")
    assert dutch_roll["value"] > next(v for v in asked("A-4D")["verdicts"] if v["mode"] == "dutch_roll")["value"]
    assert "yaw_damper gain" in [i["name"] for i in found["improvements"]]
    response = next(v for v in asked("A-4D", "--actuators")["verdicts"] if v["mode"] == "response")
    assert (response["level"], response["value"]) == (1, pytest.approx(0.05))


def test_delay_goes_with_an_aircraft() -> None:
    verdicts = {v["mode"]: v for v in asked("A-4D", "--delay", "0.15")["verdicts"]}
    assert verdicts["response"]["level"] == 2


@pytest.mark.parametrize("suffix", ["png", "svg", "html"])
def test_charts_are_written(suffix: str, tmp_path: Path) -> None:
    target = tmp_path / f"levels.{suffix}"
    assert f"{target} is written." in run("A-4D", "--plot", str(target)).stdout
    assert target.stat().st_size > 10_000
    if suffix == "html":
        text = target.read_text(encoding="utf-8")
        assert "MIL-F-8785C, figure 1, page 14" in text
        assert '"type":"log"' in text


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["A4E"], "There is no aircraft named 'A4E'."),
        ([], "There is nothing to judge: name an aircraft, or give what a criterion reads"),
        (["--criterion", "mil_f_8785c_spiral"], "give what a criterion reads: --t2-spiral."),
        (["A-4D", "--class", "V"], "There is no Class of MIL-F-8785C named 'V'."),
        (["A-4D", "--category", "D"], "There is no Category of MIL-F-8785C named 'D'."),
        (["A-4D", "--phase", "PP"], "There is no Flight Phase of MIL-F-8785C named 'PP'. Did you mean 'PA'?"),
        (["A-4D", "--phase", "PA", "--category", "A"], "belongs to Category C, not to Category A. Leave one"),
        (["A-4D", "--criterion", "mil_f_8785c_rol_mode"], "Did you mean 'mil_f_8785c_roll_mode'?"),
        (["A-4D", "--zeta-sp", "0.3"], "--zeta-sp cannot be given with A-4D, of which it is computed."),
        (
            ["--criterion", "mil_f_8785c_spiral", "--zeta-sp", "0.2"],
            "mil_f_8785c_spiral does not read --zeta-sp. It reads: --t2-spiral.",
        ),
        (
            ["--zeta-sp", "0.3", "--set", "Cm_q=0"],
            "--set, --law, --actuators and --sampled need an aircraft: name one.",
        ),
        (["A-4D", "--set", "Cm_z=0"], "There is no number of the A-4D named 'Cm_z'."),
        (["--zeta-sp", "nan"], "--zeta-sp is nan; it must be a finite number."),
        (["--omega-sp", "0", "--n-alpha", "9"], "--omega-sp is 0; it must be greater than zero."),
        (["--delay", "-1"], "--delay is -1; it must not be negative."),
        (["A-4D", "--plot", "levels.bmp"], "levels.bmp cannot be written: let its name end in .png, .svg, .html."),
        (["--t2-spiral", "15", "--plot", "levels.png"], "has a chart: ask for the short period or the Dutch roll."),
    ],
)
def test_mistakes_are_explained(words: list[str], says: str) -> None:
    assert says in mistake(*words)


@pytest.mark.parametrize(
    ("words", "value", "says"),
    [
        (["--actuators"], 0.05, "0.05 s of the slowest actuator: Level 1."),
        (["--law", "yaw_damper gain=0.3", "--sampled", "20"], 0.025, "0.025 s of half a frame: Level 1."),
        (
            ["--law", "yaw_damper gain=0.3; sensors delay=90ms", "--sampled", "5", "--actuators"],
            0.15,
            "0.05 s of the slowest actuator and 0.1 s of half a frame: Level 2.",
        ),
    ],
)
def test_response_delay_is_made_of_actuators_and_half_a_frame(words: list[str], value: float, says: str) -> None:
    """MIL-F-8785C, 3.5.3, is about what follows the stick: sensors, in the feedback, are not in its way."""
    (verdict,) = asked("A-4D", "--criterion", "mil_f_8785c_response_delay", *words)["verdicts"]
    assert verdict["value"] == pytest.approx(value)
    assert verdict["reason"].endswith(says)


def test_without_anything_between_there_is_no_delay_to_judge() -> None:
    (verdict,) = asked("A-4D", "--criterion", "mil_f_8785c_response_delay")["verdicts"]
    assert verdict["level"] is None


def test_sensors_cost_the_loop_its_damping_in_the_verdict() -> None:
    law = "yaw_damper gain=0.8; sensors lag=50ms delay=200ms"
    late, prompt = (
        asked("A-4D", "--criterion", "mil_f_8785c_dutch_roll", "--law", text)["verdicts"][0]
        for text in (law, law.rpartition(";")[0])
    )
    assert (prompt["level"], late["level"]) == (1, 4)


def test_a_loop_that_makes_a_mode_grow_is_noted() -> None:
    result = CliRunner().invoke(app, ["qualities", "A-4D", "--law", "yaw_damper gain=100"], prog_name="fdes")
    assert result.exit_code == 0
    assert "Note: With these gains the closed loop has a mode that grows faster than any" in result.stderr
