"""User settings take the place of what is not said, and are explained when they are wrong."""

from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from fdes.cli import app


@pytest.fixture
def settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    path = tmp_path / "settings.toml"
    monkeypatch.setenv("FDES_SETTINGS", str(path))
    return path


def run(*words: str) -> Any:
    return CliRunner().invoke(app, words, env={"COLUMNS": "80"})


def test_a_setting_is_used_and_the_command_line_goes_before_it(settings: Path) -> None:
    settings.write_text('[modes]\nform = "paper"\n')
    assert "form paper" in run("modes", "NAVION").stdout
    assert "form full" in run("modes", "NAVION", "--form", "full").stdout


def test_settings_are_shown(settings: Path) -> None:
    assert "There are none." in run("settings").stdout
    settings.write_text('[fly]\naircraft = "NAVION"\n')
    shown = run("settings").stdout
    assert str(settings) in shown
    assert "aircraft = 'NAVION'" in shown


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('[fyl]\naircraft = "NAVION"', "'fyl', which is no command. Did you mean 'fly'?"),
        ('[fly]\naircaft = "NAVION"', "'aircaft', which is no option of fly. Did you mean 'aircraft'?"),
        ("[fly", "are not TOML"),
        ("fly = 3", "'fly', which is no command."),
    ],
)
def test_says_what_is_wrong_with_settings(settings: Path, text: str, words: str) -> None:
    settings.write_text(text)
    result = run("modes", "NAVION")
    assert result.exit_code == 2
    assert words in result.stderr


def test_a_wrong_value_is_a_mistake_like_any_other(settings: Path) -> None:
    settings.write_text('[modes]\nform = "ful"')
    result = run("modes", "NAVION")
    assert result.exit_code == 2
    assert "Did you mean 'full'?" in result.stderr
