"""`fdes aircraft save`: what is changed on the command line becomes a file that flies the same."""

from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.aircraft import edited, load
from fdes.cli import app


def save(*words: str) -> Any:
    return CliRunner().invoke(app, ["aircraft", "save", "A-4D", *words], env={"COLUMNS": "500"})


def test_writes_a_file_that_flies_the_same(tmp_path: Path) -> None:
    path = tmp_path / "slack.toml"
    assert save(str(path), "--set", "Cm_q*=0.5").exit_code == 0
    assert load(path).at().coefficients == edited(load("A-4D").at(), ["Cm_q*=0.5"]).coefficients


@pytest.mark.parametrize(
    ("name", "words"), [("slack.txt", "does not end in .toml"), ("no/such/slack.toml", "cannot be written")]
)
def test_says_why_it_was_not_written(tmp_path: Path, name: str, words: str) -> None:
    said = save(str(tmp_path / name))
    assert said.exit_code == 2
    assert words in said.stderr
