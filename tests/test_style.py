"""Lint, format, types and imports, so that one command checks all."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TOOLS = Path(sys.executable).parent


@pytest.mark.parametrize("command", ["ruff check", "ruff format --check", "mypy", "lint-imports"])
def test_style(command: str) -> None:
    tool, *options = command.split()
    environment = os.environ | {"PYTHONUTF8": "1"}  # import-linter draws boxes, which other encodings lack
    run = subprocess.run(
        [TOOLS / tool, *options], cwd=ROOT, env=environment, capture_output=True, encoding="utf-8", check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
