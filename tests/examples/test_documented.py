"""Every example that a document or a docstring shows runs as it is written."""

import doctest
import re
import shlex
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from fdes.aircraft import load
from fdes.control.laws.direct import Direct
from fdes.flight import Clock, HandsOff, Recorder, Setup, SteadyAir, fly, open_recording, plant_of

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src"


def blocks(document: str, language: str) -> list[str]:
    """The fenced blocks of a document in one language."""
    return re.findall(
        rf"^```{language}\n(.*?)^```", (ROOT / document).read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
    )


def modules_with_examples() -> list[str]:
    paths = [path for path in SOURCE.rglob("*.py") if ">>> " in path.read_text(encoding="utf-8")]
    names = (".".join(path.relative_to(SOURCE).with_suffix("").parts).removesuffix(".__init__") for path in paths)
    return sorted(names)


def commands() -> list[str]:
    """The command lines of README.md that only print or write a file."""
    lines = [line.split(" #")[0].strip() for block in blocks("README.md", "bash") for line in block.splitlines()]
    return [line for line in lines if line.startswith("fdes ")]


@pytest.mark.parametrize("name", modules_with_examples())
def test_docstrings(name: str) -> None:
    result = doctest.testmod(import_module(name))
    assert result.attempted > 0
    assert result.failed == 0


@pytest.mark.parametrize("code", blocks("README.md", "python"))
def test_python_of_the_readme(code: str, tmp_path: Path) -> None:
    run = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "phugoid" in run.stdout


@pytest.mark.parametrize("command", commands())
def test_commands_of_the_readme(command: str, fdes_command: str, tmp_path: Path) -> None:
    _, *arguments = shlex.split(command)
    run = subprocess.run([fdes_command, *arguments], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert run.stdout or list(tmp_path.iterdir())


def test_reader_of_the_recording_format(tmp_path: Path) -> None:
    """Whoever reads a recording without FDES, by the dozen lines of its description, reads the same."""
    condition = load("A-4D").at()
    plant = plant_of(condition)
    path = tmp_path / "flight.fdes"
    recorder = Recorder(path, type(plant.start()), {"dt": 0.01})
    setup = Setup(plant, Direct(condition.full_stick))
    for frame in fly(plant.start(), setup, HandsOff(condition.trim_throttle), SteadyAir(), Clock(0.01, duration=0.1)):
        recorder.append(frame)
    recorder.close()
    described: dict[str, Any] = {}
    (code,) = blocks("docs/recording-format.md", "python")
    exec(code, described)
    names, data = described["read"](path)
    recording = open_recording(path)
    assert names == [column.name for column in recording.columns]
    assert (data == recording.data).all()
