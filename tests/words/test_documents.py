"""Documents that say what the code says too: they must say the same."""

import re
from pathlib import Path

import pytest

import fdes
from fdes.cockpit import commands
from fdes.physics.derivatives import FORMS, Coefficients
from fdes.physics.signals import Channel, Outputs, channels
from fdes.shelf import SHELVES

ROOT = Path(__file__).parents[2]
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md", *sorted(ROOT.glob("docs/**/*.md"))]
LINK = re.compile(r"\[[^]]+\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)")


def text_of(path: str) -> str:
    return (ROOT / path).read_text(encoding="utf-8")


def anchors(document: Path) -> set[str]:
    """The names by which the headings of a document are linked."""
    headings = re.findall(r"^#+ (.+)$", document.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("channel", channels(Outputs), ids=lambda c: c.name)
def test_every_signal_has_its_row_in_the_symbols(channel: Channel) -> None:
    assert f"| `{channel.name}` | {channel.unit} | {channel.long_name} | " in text_of("docs/symbols.md")


def test_symbols_list_no_signal_that_does_not_exist() -> None:
    section = text_of("docs/symbols.md").split("## Signals")[1].split("\n## ")[0]
    assert re.findall(r"^\| `(\w+)`", section, re.MULTILINE) == [c.name for c in channels(Outputs)]


def test_every_coefficient_can_be_read_from_the_symbols() -> None:
    """A coefficient is a letter for the force or moment and, after it, what it is the derivative to."""
    section = text_of("docs/symbols.md").split("## Aerodynamic coefficients")[1].split("\n## ")[0]
    explained = {symbol for row in re.findall(r"^\| `([^`]+)`", section, re.MULTILINE) for symbol in row.split()}
    parts = {part for name in Coefficients._fields for part in re.findall(r"^C[A-Za-z]|_\w+", name)}
    assert parts <= explained


def test_every_form_is_explained() -> None:
    assert all(f"| `{form}` |" in text_of("docs/symbols.md") for form in FORMS)


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda d: d.name)
def test_links_lead_somewhere(document: Path) -> None:
    for path, anchor in LINK.findall(document.read_text(encoding="utf-8")):
        target = (document.parent / path).resolve() if path else document
        assert target.exists(), f"{path} does not exist"
        assert not anchor or anchor in anchors(target), f"{path} has no heading {anchor!r}"


def test_changelog_has_this_version_on_top() -> None:
    newest = re.search(r"^## \[[^]]*\](.*)$|^## \[(.*)\]", text_of("CHANGELOG.md"), re.MULTILINE)
    assert newest
    assert fdes.__version__ in newest[0]


def test_ci_finds_the_test_command_of_the_readme() -> None:
    """`.ci/run` runs the one line that makes an environment and starts pytest."""
    lines = [line for line in text_of("README.md").splitlines() if "python3 -m venv" in line]
    assert [line for line in lines if "-m pytest" in line] == [
        "python3 -m venv .venv && .venv/bin/python -m pip install '.[test]' && .venv/bin/python -m pytest -n auto"
    ]
    assert "python3 -m venv .venv && .venv/bin/python -m pip install . && .venv/bin/fdes fly" in lines


@pytest.mark.parametrize("package", SHELVES.values())
def test_contributing_says_where_a_part_goes(package: str) -> None:
    assert f"src/{package.replace('.', '/')}/NAME" in text_of("CONTRIBUTING.md")


def test_every_command_of_the_wire_is_described() -> None:
    described = text_of("docs/wire.md")
    assert [name for name in commands.COMMANDS if f"`{name}`" not in described] == []
