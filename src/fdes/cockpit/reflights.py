"""What-if in the cockpit: a recording's stick flown again by another process, so that the flights here lose no tick.

The process is `fdes whatif`. What it is told is a file that the server has found itself, and texts that are data: a
variation names parts of shelves and aircraft of the hangar, never a path or code.
"""

import asyncio
import contextlib
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from fdes.analysis.what_if import Variation
from fdes.errors import RecordingError, SpecError
from fdes.flight.recorder import SUFFIX

MOST_VARIATIONS = 6  # of one recording at once
LONGEST = 120.0  # s that a process may take
MOST_WAITING = 4
ONE_CORE = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
SHOWN = ("V", "h", "alpha", "beta", "phi", "theta", "psi", "p", "q", "r", "n_y", "n_z")


class Reflights:
    """One process at a time; `MOST_WAITING` may be asked for and wait."""

    def __init__(self) -> None:
        self._turn = asyncio.Semaphore(1)
        self._asked = 0

    def must_be_possible(self, variations: Sequence[str]) -> None:
        """Raises SpecError for what says nothing that could be different, and where too much is asked for at once."""
        if not 1 <= len(variations) <= MOST_VARIATIONS:
            raise SpecError(
                f"{len(variations)} variations were asked for; 1 to {MOST_VARIATIONS} can be flown at once."
            )
        if self._asked >= MOST_WAITING:
            raise SpecError(f"{self._asked} recordings wait to be flown again, which is the limit. Try again later.")
        for text in variations:
            Variation.parse(text)

    async def fly(self, path: Path, variations: Sequence[str]) -> list[dict[str, Any]]:
        """Fly the recording at `path`, which is absolute, once for each variation, and keep each flight beside it.

        What came of each: its name, its frames, why it departed, and its greatest differences by signal. Raises
        RecordingError with the sentence of the process, or when that takes longer than `LONGEST`.
        """
        self._asked += 1
        try:
            async with self._turn:
                with TemporaryDirectory(prefix=".what-if-", dir=path.parent) as folder:
                    said = await _run(path, variations, Path(folder))
                    return [
                        {
                            **one,
                            "name": _kept(Path(folder) / f"{path.stem}_what_if_{k + 1}{SUFFIX}", path),
                            "differences": {s: d for s, d in one["differences"].items() if s in SHOWN},
                            "same": not one["differences"] and one["departed"] is None,
                        }
                        for k, one in enumerate(said["variations"])
                    ]
        except OSError as trouble:
            raise RecordingError(f"{path.parent} cannot be written: {trouble.strerror or trouble}.") from trouble
        finally:
            self._asked -= 1


async def _run(path: Path, variations: Sequence[str], folder: Path) -> dict[str, Any]:
    """What the process says. Raises RecordingError."""
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        *("-P", "-m", "fdes", "whatif", str(path), "--json", "--out", str(folder)),
        *(f"--try={text}" for text in variations),
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        env=os.environ | ONE_CORE,
    )
    if hasattr(os, "setpriority"):
        with contextlib.suppress(OSError):  # it may have ended already
            os.setpriority(os.PRIO_PROCESS, process.pid, 10)
    try:
        said, trouble = await asyncio.wait_for(process.communicate(), LONGEST)
    except TimeoutError:
        raise RecordingError(
            f"To fly {path.stem} again takes longer than {LONGEST:.0f} s, which is the limit. Use fdes whatif instead."
        ) from None
    finally:
        if process.returncode is None:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            await process.wait()
    if process.returncode != 0:
        words = trouble.decode(errors="replace").strip().removeprefix("Error: ")
        raise RecordingError(words or f"fdes whatif ended with status {process.returncode}.")
    found: dict[str, Any] = json.loads(said)
    return found


def _kept(flown: Path, of: Path) -> str:
    """Move a flight beside the recording `of` under a name that is free; that name."""
    number = 1
    while (target := of.with_name(f"{of.stem}_what_if_{number}{SUFFIX}")).exists():
        number += 1
    flown.rename(target)
    return target.stem
