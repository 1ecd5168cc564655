"""`fdes verify`: the errors achieved are printed, and one wrong number is seen."""

import copy
import json
from importlib.resources import files
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fdes.analysis import paper
from fdes.cli import app
from fdes.sources import sources

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
    count = int(last.split(" checks: ")[0])
    assert last == f"{count} checks: {count - 1} passed, 1 accepted misprint, 0 failed"
    assert max(len(line) for line in result.stdout.splitlines()) <= 80


def test_one_corrupted_number_makes_it_exit_with_1(tmp_path: Path) -> None:
    folder = copy_of_sources(tmp_path / "sources")
    teper = folder / "teper_1969.toml"
    teper.write_text(teper.read_text("utf-8").replace("omega_n = 3.6083", "omega_n = 3.7083"), "utf-8")
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(folder), "--json"])
    assert result.exit_code == 1
    (failed,) = [c for c in json.loads(result.stdout)["checks"] if c["verdict"] == "failed"]
    assert (failed["item"], failed["quantity"]) == ("NAV_TEPER_MODES", "short_period omega_n")
    text = RUN.invoke(app, ["verify", "textbooks", "--sources", str(folder)]).stdout
    assert "FAILED" in text
    assert text.strip().endswith("1 failed")


def test_a_misprint_is_shown_with_its_evidence_and_what_is_not_held_with_the_reason() -> None:
    text = " ".join(RUN.invoke(app, ["verify", "textbooks"]).stdout.split())
    assert "short_period omega_n 0.9100 0.88036 3.3 % 1 % misprint" in text
    assert "misprint: B747_CL_ALPHADOT: In dispute: NASA CR-2144 has -6.7 in tables IX-2 and IX-4" in text
    assert "dutch_roll zeta 0.1070 0.064574 40 % not held" in text
    assert "not held: Body-axis inertias beside stability-axis coefficients" in text
    said = json.loads(RUN.invoke(app, ["verify", "textbooks", "--json"]).stdout)
    assert (said["misprints"], said["failed"]) == (1, 0)
    assert said["shown"] == sum(check["passed"] is None for check in said["checks"]) > 0
    assert len(said["checks"]) == said["passed"] + said["misprints"] + said["shown"]


def test_a_misprint_that_is_not_recorded_is_a_mistake(tmp_path: Path) -> None:
    folder = copy_of_sources(tmp_path / "sources")
    report = folder / "heffley_jewell_1972.toml"
    report.write_text(report.read_text("utf-8").replace("B747_CL_ALPHADOT", "B747_CD"), "utf-8")
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(folder)])
    assert result.exit_code != 0
    assert "no accepted misprint named 'B747_CD'" in result.stderr


def test_a_folder_without_sources_is_a_mistake(tmp_path: Path) -> None:
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(tmp_path)])
    assert result.exit_code == 2
    assert "nothing to verify" in result.stderr
    result = RUN.invoke(app, ["verify", "textbooks", "--sources", str(tmp_path / "none")])
    assert result.exit_code == 2
    assert "is no folder" in result.stderr


def test_the_paper_flown_again_agrees_with_what_it_shows(tmp_path: Path) -> None:
    result = RUN.invoke(app, ["verify", "paper", "--out", str(tmp_path / "paper.html")])
    assert result.exit_code == 0
    assert result.stdout.strip().endswith("15 passed, 0 failed")
    page = (tmp_path / "paper.html").read_text("utf-8")
    assert [f"Figure {n}:" in page for n in ("7", "8", "10", "11")] == [True] * 4
    assert 'src="http' not in page


def test_one_corrupted_number_of_the_paper_is_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = copy.deepcopy(sources())
    wrong["mansor_perumal"]["execution_times"][0]["rows"][0]["total"] = 9.71
    monkeypatch.setattr(paper, "sources", lambda: wrong)
    result = RUN.invoke(app, ["verify", "paper", "--out", str(tmp_path / "paper.html")])
    assert result.exit_code == 1
    assert "0.003164 in table 5.2: table 5.1 by its loops gives 0.003884" in " ".join(result.stdout.split())


def test_a_report_that_cannot_be_written_is_a_mistake() -> None:
    result = RUN.invoke(app, ["verify", "paper", "--out", "no-such-folder/paper.html"])
    assert result.exit_code == 2
    assert "name a file that ends in .html in a folder that exists" in result.stderr
