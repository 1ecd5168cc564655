"""The documentation site builds without a warning, and asks nothing of other hosts."""

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from pydantic import BaseModel
from typer.main import get_command

from fdes import __all__ as public_names
from fdes.aircraft import schema
from fdes.cli import app

ROOT = Path(__file__).parents[2]
LOADED = re.compile(
    r"""<(?:script|img|iframe)\b[^>]*\bsrc=["']?(?P<src>[^"' >]+)|<link\b[^>]*\bhref=["']?(?P<href>[^"' >]+)"""
)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    run = subprocess.run(  # not --quiet: that would hide the warnings from --strict, too
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", folder],
        cwd=ROOT,
        env=os.environ | {"NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return folder


def test_pages_load_nothing_from_other_hosts(site: Path) -> None:
    pages = list(site.rglob("*.html"))
    assert len(pages) > 10
    for page in pages:
        for found in LOADED.finditer(page.read_text(encoding="utf-8")):
            assert "//" not in (found["src"] or found["href"]), found[0]


def test_every_command_is_in_the_reference(site: Path) -> None:
    page = (site / "reference/command-line.html").read_text(encoding="utf-8")
    for name, command in get_command(app).commands.items():  # type: ignore[attr-defined]  # the app is a group
        for words in [f"{name} {sub}" for sub in getattr(command, "commands", ())] or [name]:
            assert f">fdes {words}<" in page
    assert "--integrator" in page


@pytest.mark.parametrize("page", sorted((ROOT / "docs").rglob("*.md")), ids=lambda page: page.stem)
def test_every_command_in_the_text_exists(page: Path) -> None:
    for words in re.findall(r"`fdes\s+([^`]+)`", page.read_text(encoding="utf-8")):
        command: Any = get_command(app)
        for word in words.split():
            if word in getattr(command, "commands", {}):
                command = command.commands[word]
            elif word.startswith("--"):
                assert any(word in parameter.opts for parameter in command.params) or word == "--version", words
        assert command.name != "fdes" or words.startswith("--"), words


def test_every_public_name_is_in_the_reference(site: Path) -> None:
    page = (site / "reference/python.html").read_text(encoding="utf-8")
    for name in public_names:
        assert re.search(rf'<h\d id="fdes\.[\w.]+\.{name}"', page), name


@pytest.mark.parametrize(
    "part", [part for part in vars(schema).values() if isinstance(part, type) and issubclass(part, BaseModel)]
)
def test_every_key_of_an_aircraft_file_is_in_the_reference(part: type[BaseModel]) -> None:
    page = (ROOT / "docs/reference/aircraft-files.md").read_text(encoding="utf-8")
    missing = [key for key in part.model_fields if not re.search(rf"\b{key}\b", page)]
    assert not missing
