"""The condition that a trim of the F-16 belongs to is flown, and said."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from fdes.cli import app

CONTRACT = ["simulate", "F-16", "--plant", "nonlinear", "--earth", "wgs84", "--trim", "V=565.685 ft/s h=10013 ft"]
SAID = "Flown as M0.53_10kft, the condition nearest in height to the trim. Name another with --condition."


def test_trimmed_stays_trimmed(tmp_path: Path) -> None:
    """With the center of gravity of the sea-level condition, which is unstable, it would be 0.4 ft lower."""
    out = tmp_path / "run.csv"
    done = CliRunner().invoke(
        app, [*CONTRACT, "--duration", "30", "--dt", "0.05", "--rate", "10", "--out", str(out), "--names", "s119"]
    )
    assert done.exit_code == 0, done.output
    assert SAID in " ".join(done.stderr.split())
    header, *rows = out.read_text(encoding="utf-8").splitlines()
    assert len(rows) == 301
    altitude = header.split(",").index("altitudeMsl_ft")
    assert float(rows[-1].split(",")[altitude]) == pytest.approx(10013.0, abs=0.01)


def test_a_named_condition_is_taken() -> None:
    done = CliRunner().invoke(app, [*CONTRACT, "--duration", "0.1", "-c", "V502_SL"])
    assert done.exit_code == 0, done.output
    assert "Flown as" not in done.stderr
