"""`fdes check LAW.py`: what does not hold of a law of one's own is found, and said in words that help."""

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.analysis.law_check import RULES, law_findings
from fdes.cli import app
from fdes.shelf import shelf

GOOD = """
from dataclasses import dataclass
from typing import Annotated, Any

from fdes.control.blocks import Washout, StateSpace
from fdes.control.law import Law, with_loop

__all__ = ["Mine"]
SEEN = []


@dataclass(frozen=True)
class Mine:
    inner: Law
    gain: Annotated[float, "rad/(rad/s)"]
    washout: Annotated[float, "s"] = 2.0

    def start(self, y, stick):
        return (self.inner.start(y, stick), Washout(self.washout).start(y.p))

    def step(self, y, stick, memory, dt):
        command, inner = self.inner.step(y, stick, memory[0], dt)
        p, washed = Washout(self.washout).step(y.p, memory[1], dt)
        return command._replace(aileron=command.aileron - self.gain * p), (inner, washed)

    def linear(self, dt=None):
        A, B, C, D = Washout(self.washout).linear(dt)
        loop = StateSpace(A, B, -self.gain * C, -self.gain * D)
        return with_loop(self.inner.linear(dt), {"p": 1.0}, "aileron", loop, {"washed": "rad/s"})
"""
HELPER = """

def WithoutUnits(*parts):
    return replace(with_loop(*parts), units={})
"""
GOOD = GOOD.replace("import dataclass\n", "import dataclass, replace\n") + HELPER
SIGN = ("-self.gain * C, -self.gain * D", "-self.gain * C, self.gain * D")


def run(*words: str) -> Any:
    return CliRunner().invoke(app, ["check", *words], prog_name="fdes", env={"COLUMNS": "80"})


def written(folder: Path, *mistake: str) -> str:
    path = folder / "mine.py"
    old, new = mistake or ("", "")
    assert old in GOOD
    path.write_text(GOOD.replace(old, new) if old else GOOD, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("name", shelf("laws").names())
def test_every_law_of_the_shelf_is_clean(name: str) -> None:
    assert law_findings(shelf("laws").get(name)) == ()


def test_a_good_law_is_clean(tmp_path: Path) -> None:
    result = run(written(tmp_path))
    assert result.stdout == f"Mine: clean\n{len(RULES)} rules: 0 errors\n"
    assert result.exit_code == 0


@pytest.mark.parametrize(
    ("mistake", "rule", "words"),
    [
        (("frozen=True", ""), "frozen", "It can be changed while it flies."),
        (
            (
                "        p, washed",
                "        SEEN.append(1)\n        y = y._replace(p=y.p + len(SEEN))\n        p, washed",
            ),
            "pure",
            "another answer",
        ),
        (("gain * p)", "gain * p / 0.0)"), "surfaces", "ZeroDivisionError"),
        (("gain * p)", "gain * float('nan'))"), "surfaces", "step commands Surfaces("),
        (("gain * p)", "gain * p * (1.0 if y.p > -1e-3 else float('nan')))"), "flight", ""),
        (
            ("- self.gain * p)", "- self.gain * p - y.phi)"),
            "measures",
            "phi moves surfaces, and is no input of linear()",
        ),
        (("return with_loop(", "return WithoutUnits("), "units", "linear() does not say the unit of "),
        (SIGN, "jacobian", "p moves aileron by -0.299"),
        (
            ("Washout(self.washout).linear(dt)", "Washout(self.washout).linear(dt or 0.1)"),
            "continuous",
            "away from what",
        ),
        (("(inner, washed)", "(inner, washed, 1.0)"), "jacobian", "It remembers 2 numbers, and linear() has 1 states."),
    ],
    ids=lambda value: value if isinstance(value, str) and value in RULES else "",
)
def test_each_mistake_is_found(tmp_path: Path, mistake: tuple[str, str], rule: str, words: str) -> None:
    result = run(written(tmp_path, *mistake), "--json")
    assert result.exit_code == 1, result.output
    said = json.loads(result.stdout)
    assert (said["law"], said["rules"]) == ("Mine", len(RULES))
    found = {finding["rule"]: finding["what"] for finding in said["findings"]}
    assert words in found[rule]


def test_in_words(tmp_path: Path) -> None:
    result = run(written(tmp_path, *SIGN))
    assert result.exit_code == 1
    lines = [line.rstrip() for line in result.stdout.splitlines()]
    assert lines[:2] == ["Mine", "  error    jacobian"]
    assert lines[2].startswith("           p moves aileron by -0.29")
    assert "           To do: Let both say the same; look at signs first." in lines
    assert lines[-1] == f"{len(RULES)} rules: {len([x for x in lines if 'error  ' in x])} errors".replace(
        "1 errors", "1 error"
    )
    assert max(map(len, lines)) <= 80


def test_a_file_without_a_law_is_a_mistake(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_text("x = 1\n", encoding="utf-8")
    for name in (str(path), str(tmp_path / "none.py")):
        result = run(name)
        assert result.exit_code == 2
        assert result.stderr.startswith("Error: ")


def test_shelves_show_the_settings_of_laws_with_units() -> None:
    text = CliRunner().invoke(app, ["shelves"], prog_name="fdes", env={"COLUMNS": "80"}).stdout
    assert "gain [rad/(rad/s)], washout [s]" in text
    said = json.loads(CliRunner().invoke(app, ["shelves", "--json"], prog_name="fdes").stdout)
    assert said["settings_of_laws"]["sensors"] == {"lag": "s", "delay": "s"}
    assert said["settings_of_laws"]["direct"] == {}
    assert set(said["settings_of_laws"]) == set(said["laws"])
