"""What the import contracts in pyproject.toml cannot say: what physics may know, how long a module is, what travels."""

import ast
import subprocess
import sys
from importlib.resources import files
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[1] / "src" / "fdes"
MODULES = sorted(SOURCE.rglob("*.py"))
LONGEST = 350  # lines
FOR_EVERYTHING = {"common", "helpers", "misc", "tools", "util", "utils"}
PHYSICS_MAY_IMPORT = {"collections.abc", "fdes.elementary", "fdes.errors", "fdes.units", "typing"}
SLOW = {"fdes.cli", "numba", "numpy", "pandas", "pydantic", "scipy", "starlette", "uvicorn", "xarray"}


def name_of(module: Path) -> str:
    return module.relative_to(SOURCE).as_posix()


def imported_by(module: Path) -> set[str]:
    found: set[str] = set()
    for node in ast.walk(ast.parse(module.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{name_of(module)} imports relatively; write the whole name"
            found.add(node.module or "")
    return found


@pytest.mark.parametrize("module", sorted((SOURCE / "physics").rglob("*.py")), ids=name_of)
def test_physics_knows_only_mathematics(module: Path) -> None:
    """Not even `math`: elementary functions come through fdes.elementary, the one door."""
    outside = {name for name in imported_by(module) if not name.startswith("fdes.physics")}
    assert outside <= PHYSICS_MAY_IMPORT


@pytest.mark.parametrize("module", MODULES, ids=name_of)
def test_modules_are_short_and_named_for_one_subject(module: Path) -> None:
    text = module.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= LONGEST
    assert module.stem not in FOR_EVERYTHING
    assert ast.get_docstring(ast.parse(text))


def test_nothing_is_nested_deeper_than_room_shelf_file() -> None:
    assert [name_of(m) for m in MODULES if len(m.relative_to(SOURCE).parts) > 3] == []


def test_importing_fdes_is_quick() -> None:
    """A script that only reads the version loads no numbers, no server and no command line."""
    code = "import sys, fdes; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not SLOW & set(loaded)


def test_every_data_file_travels_in_the_package() -> None:
    """Pages, aircraft and sources are beside the installed code, wherever that is."""
    installed = Path(str(files("fdes")))
    data = [p.relative_to(SOURCE) for p in SOURCE.rglob("*") if p.is_file() and p.suffix not in {".py", ".pyc"}]
    assert data
    assert [path.as_posix() for path in data if not (installed / path).is_file()] == []
