"""A law from a file: by its path on the command line and in Python, and by nothing that data could say."""

import ast
from pathlib import Path

import pytest

from fdes.aircraft import load
from fdes.analysis.design import law_for
from fdes.control.own_law import law_from_file, own_laws
from fdes.errors import NoSuchPart, SpecError

SOURCE = Path(__file__).parents[2] / "src/fdes"
SHELF = SOURCE / "control/laws/roll_rate_damper.py"
MAY_RUN_A_FILE = {"cli/options.py"}


def test_a_file_is_a_law(tmp_path: Path) -> None:
    mine = tmp_path / "mine.py"
    mine.write_text(SHELF.read_text(encoding="utf-8"), encoding="utf-8")
    text, own = own_laws(f"{mine} gain=0.2; yaw_damper gain=0.3")
    assert text == "mine gain=0.2; yaw_damper gain=0.3"
    law = law_for(text, load("A-4D").at(), own=own).law
    assert type(law.inner).__name__ == "RollRateDamper"  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "it is no file."),
        ("1 / 0", "cannot be read: ZeroDivisionError: division by zero."),
        ("x = 1", 'must name its law in __all__ = ["TheLaw"]; it names 0.'),
        ('__all__ = ["L"]\nclass L: pass', "is not a law: it lacks start, step, linear. A law is a frozen dataclass"),
    ],
)
def test_says_what_is_wrong_with_a_file(tmp_path: Path, content: str | None, words: str) -> None:
    mine = tmp_path / "mine.py"
    if content is not None:
        mine.write_text(content, encoding="utf-8")
    with pytest.raises(SpecError) as found:
        law_from_file(mine)
    assert words in str(found.value)


@pytest.mark.parametrize("path", ["./mine.py", "/elsewhere/mine.py", "mine.py", "..\\mine.py", "os", "fdes.cli"])
def test_what_data_can_say_never_runs_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, path: str) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text("raise RuntimeError('it ran')", encoding="utf-8")
    with pytest.raises(NoSuchPart):
        law_for(path, load("A-4D").at())


def test_only_the_command_line_may_run_a_file() -> None:
    """The module that runs files is imported by nothing that reads recordings, links or the network."""
    found = set()
    for module in SOURCE.rglob("*.py"):
        for node in ast.walk(ast.parse(module.read_text(encoding="utf-8"))):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            names += [a.name for a in node.names] if isinstance(node, ast.Import) else []
            if "fdes.control.own_law" in names:
                found.add(module.relative_to(SOURCE).as_posix())
    assert found <= MAY_RUN_A_FILE
