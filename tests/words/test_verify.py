"""`fdes verify`: the errors achieved are printed, and one wrong number is seen."""

import json
from importlib.resources import files
from pathlib import Path

from typer.testing import CliRunner

from fdes.cli import app

RUN = CliRunner()


def copy_of_sources(folder: Path) -> Path:
    folder.mkdir()
    for file in files("fdes.sources").iterdir():
        if file.name.endswith(".toml"):
            (folder / file.name).write_text(file.read_text("utf-8"), "utf-8")
    return folder


def test_all_published_numbers_pass_and_are_counted() -> None:
    result = RUN.invoke(app, ["verify", "textbooks"])
    assert result.exit_code == 0
    *_, last = result.stdout.strip().splitlines()
    count = last.split(" checks: ")[0]
    assert last == f"{count} checks: {count} passed, 0 failed"
    assert max(len(line) for line in result.stdout.splitlines()) <= 80


def test_one_corrupted_number_makes_it_exit_with_1(tmp_path: Path) -> None:
    folder = copy_of_sources(tmp_path / "sources")
    teper = folder / "teper_1969.toml"
    teper.write_text(teper.read_text("utf-8").replace("omega_n = 3.6083", "omega_n = 3.7083"), "utf-8")
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(folder), "--json"])
    assert result.exit_code == 1
    (failed,) = [c for c in json.loads(result.stdout)["checks"] if not c["passed"]]
    assert (failed["item"], failed["quantity"]) == ("NAV_TEPER_MODES", "short_period omega_n")
    text = RUN.invoke(app, ["verify", "textbooks", "--sources", str(folder)]).stdout
    assert "FAILED" in text
    assert text.strip().endswith("1 failed")


def test_a_folder_without_sources_is_a_mistake(tmp_path: Path) -> None:
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(tmp_path)])
    assert result.exit_code == 2
    assert "nothing to verify" in result.stderr
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(tmp_path / "none")])
    assert result.exit_code == 2
    assert "is no folder" in result.stderr
