"""What `fdes performance` prints, and what it says of mistakes."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fdes.cli import app

run = CliRunner().invoke


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> tuple[str, str, Path]:
    picture = tmp_path_factory.mktemp("performance") / "navion.svg"
    done = run(app, ["performance", "NAVION", "--plot", str(picture)], env={"COLUMNS": "80"})
    assert done.exit_code == 0, done.output
    return done.stdout, " ".join(done.stderr.split()), picture


def test_figures_name_their_limits(drawn: tuple[str, str, Path]) -> None:
    said = " ".join(drawn[0].split())
    assert "Ryan NAVION, M0.158_SL: performance at 0 m (0 ft)" in said
    assert "stall at idle throttle, slowest: lift is at its largest." in said
    assert "fastest: thrust: it needs the throttle at 1.000, and it goes to 1." in said
    assert "largest load factor, smallest load factor: assumed: FAR 23.337, normal category." in said
    assert "V_C = 33 sqrt(W/S) kt and V_D = 1.4 V_C of FAR 23.335(a)(1) and (b)(2)" in said
    assert all(len(line) <= 80 for line in drawn[0].splitlines() if "─" in line)


def test_assumptions_stand_beside(drawn: tuple[str, str, Path]) -> None:
    assert "Assumed: the lift coefficient of the wing ends at 1.20" in drawn[1]
    assert "as of a propeller at constant power" in drawn[1]
    assert "Assumed: thrust at the full throttle of 1 is 2,277 N in the flight condition." in drawn[1]
    assert "Its data are used to Mach 0.95: its data know no transonic drag." in drawn[1]


def test_the_sheet_has_all_panels(drawn: tuple[str, str, Path]) -> None:
    svg = drawn[2].read_text(encoding="utf-8")
    for title in ("level flight at 0 m", "speed-height envelope", "climb at full throttle", "turns", "V-n diagram"):
        assert title in svg
    assert "the elevator is at its stop, 15 deg" in svg


def test_as_a_page(tmp_path: Path) -> None:
    page = tmp_path / "f16.html"
    done = run(app, ["performance", "F-16", "--n-max", "9", "--alpha-max", "25 deg", "--plot", str(page), "--json"])
    assert done.exit_code == 0, done.output
    assert "V-n diagram" in page.read_text(encoding="utf-8")
    found = json.loads(done.stdout)
    assert found["level"]["V"]["unit"] == "m/s"
    assert max(found["turn"]["n"]["values"]) == 9.0
    assert any("know no Mach number" in sentence for sentence in found["notes"])
    stall = next(f for f in found["figures"]["level flight"] if f["name"] == "stall at idle throttle")
    assert stall["limit"] == "angle of attack ends at 25 deg"
    assert found["heights"].keys() == {"h", "V_stall", "V_slow", "V_fast", "V_climb", "excess_power", "time"}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["A-7A"], "cannot fly nonlinear: its source gives dimensional derivatives"),
        (
            ["NAVION", "--height", "20000 ft"],
            "cannot fly level at 6,096 m at any speed that its data know: its",
        ),
        (["F-16", "--height", "60000 ft"], "must be from 0 m to 15,240 m (the tables of its engine end there)."),
        (["NAVION", "--height", "-5 m"], "must be from 0 m to 85,000 m (the atmosphere ends there)."),
        (["NAVION", "--throttle", "0"], "A full throttle of 0 is asked for; it must be more than 0 and at most 1."),
        (["NAVION", "--n-max", "0.5"], "A largest load factor of 0.5 is asked for; it must be more than 1."),
        (["NAVION", "--n-min", "1"], "A smallest load factor of 1 is asked for; it must be less than 0."),
        (["NAVION", "--mach-min", "0.5", "--mach-max", "0.2"], "from Mach 0.5 to Mach 0.2 is asked for"),
        (["NAVION", "--alpha-max", "-5 deg"], "give a larger one with --alpha-max"),
        (["NAVION", "--height", "5000 knots"], "which is not a unit of this quantity"),
        (["NAVION", "--plot", "navion.gif"], "let its name end in .png, .svg, .html"),
        (["NAVIN"], "Did you mean 'NAVION'?"),
    ],
)
def test_mistakes(words: list[str], said: str) -> None:
    done = run(app, ["performance", *words])
    assert done.exit_code == 2, done.output
    assert said in " ".join(done.stderr.split())
