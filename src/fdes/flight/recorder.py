"""The flight recorder: a versioned, append-only file that survives a crash but for its last second.

The file is the eight bytes ``FDESREC\\n`` and then chunks, each

    4 bytes kind · u32 length of the payload · u32 CRC-32 of the payload · payload        (little-endian)

    HEAD   JSON: format version, FDES version, engine, aircraft, condition, equations, integrator, step, columns
    ROWS   float64 rows, one per frame, as many columns as HEAD names
    EDIT   JSON: what was changed in flight, and when; before the first row, what the law remembers there
    DONE   JSON: how the recording ended; absent when the program was killed

A chunk that is cut off or fails its checksum ends the reading: everything before it counts.
docs/recording-format.md describes it for those who read it without FDES.
"""

import json
import platform
import struct
import threading
import zlib
from collections import deque
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, BinaryIO

from fdes import __version__
from fdes.control import Stick
from fdes.flight.actuated import recorded_state
from fdes.flight.simulation import Frame
from fdes.physics.signals import Air, Channel, Outputs, Surfaces, channels

MAGIC = b"FDESREC\n"
FORMAT = 1
SUFFIX = ".fdes"
CHUNK = struct.Struct("<4sII")
FLUSH_EVERY = 1.0  # s
# What computes: on another engine, version or machine a flight is the same to rounding only.
ENGINE = f"plain, {platform.python_implementation()} {platform.python_version()}, {platform.machine()}"


def columns_of(state: type) -> tuple[Channel, ...]:
    """The columns of a recording of a plant whose state is the named tuple `state`, in order."""
    return (
        Channel("t", "s", "time"),
        *channels(Outputs),
        *channels(Stick, "stick_"),
        *channels(Surfaces, "excitation_"),
        *channels(Surfaces, "held_"),
        *channels(Surfaces, "command_"),
        *channels(state, "state_"),
        *channels(Air, "air_"),
    )


def row_of(frame: Frame, state: type | None = None) -> tuple[float, ...]:
    """A frame as one row of those columns; with the deflections of the surfaces where `state` has them."""
    x = frame.state if state is None or state is type(frame.state) else recorded_state(frame)
    return (
        frame.t,
        *frame.outputs,
        *frame.stick,
        *frame.excitation,
        *frame.held,
        *frame.command,
        *x,
        *frame.air,
    )


def chunk(kind: bytes, payload: bytes) -> bytes:
    """One chunk of the file."""
    return CHUNK.pack(kind, len(payload), zlib.crc32(payload)) + payload


class Recorder:
    """Writes frames to a file from a thread of its own, so that flying never waits for a disk."""

    def __init__(self, path: Path, state: type, header: dict[str, Any]) -> None:
        """Start a recording at `path`, which must not exist. `header` says what is flown; it must be JSON.

        `state` is what the plant's state is, or `recorded_type` of it where actuators may be switched in flight.
        """
        self.path, self._state = path, state
        columns = columns_of(state)
        self._row = struct.Struct(f"<{len(columns)}d")
        self._waiting: deque[bytes | dict[str, Any]] = deque()  # rows, and the edits before them
        self._wake = threading.Event()
        self._ending: dict[str, Any] | None = None
        self.frames = 0
        self.trouble: str | None = None
        self._file: BinaryIO = path.open("xb")
        head = {
            "format": FORMAT,
            "fdes": __version__,
            "engine": ENGINE,
            "started": datetime.now(UTC).isoformat(timespec="seconds"),
            **header,
            "columns": [c._asdict() for c in columns],
        }
        self._file.write(MAGIC + chunk(b"HEAD", json.dumps(head).encode()))
        self._file.flush()
        self._thread = threading.Thread(target=self._write, name=f"recorder {path.name}", daemon=True)
        self._thread.start()

    def append(self, frame: Frame) -> None:
        """Take one frame. Returns at once.

        What waits is its bytes: thousands of frames kept as they are would take the processor's memory from flying.
        """
        note = {} if frame.edit is None else dict(frame.edit.note)
        if self.frames == 0 and frame.memory not in (None, ()):
            note["memory"] = frame.memory
        if note or frame.edit is not None:
            self._waiting.append({"t": frame.t, **note})
        self._waiting.append(self._row.pack(*row_of(frame, self._state)))
        self.frames += 1

    def close(self, reason: str = "stopped") -> None:
        """Write what is waiting and end the file."""
        if self._ending is None:
            self._ending = {"reason": reason}
            self._wake.set()
        self._thread.join()

    def _write(self) -> None:
        try:
            while self._ending is None:
                self._wake.wait(FLUSH_EVERY)
                self._flush()
            self._flush()
            self._file.write(chunk(b"DONE", json.dumps({**self._ending, "frames": self.frames}).encode()))
        except Exception as trouble:  # noqa: BLE001  a full disk or worse: the flight goes on, and the cockpit says why
            self.trouble = f"{self.path.name} could not be written: {getattr(trouble, 'strerror', None) or trouble}."
        finally:
            self._file.close()

    def _flush(self) -> None:
        rows: list[bytes] = []
        while self._waiting:
            waiting = self._waiting.popleft()
            if isinstance(waiting, bytes):
                rows.append(waiting)
            else:
                self._put(rows)
                rows = []
                self._file.write(chunk(b"EDIT", json.dumps(waiting).encode()))
        self._put(rows)
        self._file.flush()

    def _put(self, rows: list[bytes]) -> None:
        if rows:
            self._file.write(chunk(b"ROWS", b"".join(rows)))
