"""The guide and the page for lecturers do what they say: each is followed from top to bottom, as a reader would.

Lines after `$` are run and lines after `>>>` executed, in one folder per page; what is shown below them must come out,
`...` standing for what is left out. A block titled with a file's name is saved as that file; a diff mends its lines.
"""

import doctest
import os
import re
import subprocess
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from fdes.flight import Excitation
from fdes.shelf import shelf

ROOT = Path(__file__).parents[2]
PAGES = [*sorted((ROOT / "docs/guide").glob("*.md")), ROOT / "docs/class.md"]
BLOCK = re.compile(
    r'^( *)```(console|diff|pycon|python|toml)(?: title="([^"]+)")?\n(.*?)^ *```$', re.DOTALL | re.MULTILINE
)
LENIENT = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


class Block(NamedTuple):
    """A fenced block of a page."""

    language: str
    title: str
    text: str


def blocks(page: Path) -> list[Block]:
    found = BLOCK.findall(page.read_text(encoding="utf-8"))
    return [Block(language, title, textwrap.dedent(text)) for _, language, title, text in found]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_page(
    page: Path, fdes_command: str, serve: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for block in blocks(page):
        if block.language == "console":
            for command, shown in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block.text, re.MULTILINE):
                run(command, shown, fdes_command, serve)
        elif block.language == "pycon":
            follow(block.text, names, page.name)
        elif block.language == "python" and not block.title:
            exec(block.text, {})
        else:
            save(block)


def run(command: str, shown: str, fdes_command: str, serve: Callable[..., Any]) -> None:
    """Run a line of the terminal. It fails if, and only if, it is shown to report an error."""
    program, *words = (word.strip('"') for word in re.findall(r'"[^"]*"|\S+', command))
    assert program == "fdes"
    if words[0] == "fly":
        assert serve(*words[1:]).url.startswith("http://")
        return
    environment = os.environ | {"COLUMNS": "80"}
    done = subprocess.run(
        [fdes_command, *words], env=environment, stdout=-1, stderr=subprocess.STDOUT, encoding="utf-8", check=False
    )
    pieces = (r"\s+".join(map(re.escape, piece.split())) for piece in shown.split("..."))
    matches = re.fullmatch(r"\s*" + r"\s*.*?\s*".join(pieces) + r"\s*", done.stdout, re.DOTALL)
    assert not shown or matches, f"{command}\nis shown to answer\n{shown}\nand answers\n{done.stdout}"
    assert (done.returncode != 0) == bool(re.search(r"\berror\b", shown, re.IGNORECASE)), done.stdout


def follow(text: str, names: dict[str, Any], page: str) -> None:
    """Execute a Python session; names live on to the next one of the page."""
    test = doctest.DocTestParser().get_doctest(text, names, page, page, 0)
    said: list[str] = []
    result = doctest.DocTestRunner(optionflags=LENIENT).run(test, out=said.append, clear_globs=False)
    names.update(test.globs)
    assert result.attempted > 0
    assert result.failed == 0, "".join(said)


def save(block: Block) -> None:
    """Save a file, or mend lines of it as a diff shows them."""
    path = Path(block.title)
    if block.language != "diff":
        path.write_text(block.text, encoding="utf-8")
        return
    signed = [(line[0], line[1:].strip()) for line in block.text.splitlines()]
    old, new = ("\n".join(line for sign, line in signed if sign == which) for which in "-+")
    text = path.read_text(encoding="utf-8")
    assert text.count(f"\n{old}\n") == 1
    path.write_text(text.replace(f"\n{old}\n", f"\n{new}\n"), encoding="utf-8")


def test_every_input_shape_has_an_example_that_can_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("run.csv").write_text("t,stick [deg]\n0,0\n1,2\n", encoding="utf-8")
    text = (ROOT / "docs/reference/command-line.md").read_text(encoding="utf-8")
    examples = re.findall(r"^\| `(.+?)` \|", text.split("### Inputs")[1].split("\n## ")[0], re.MULTILINE)
    shapes = {type(shape) for _, shape in Excitation.parse(examples, files=True).parts}
    assert shapes == {shelf("inputs").get(name) for name in shelf("inputs").names()}
