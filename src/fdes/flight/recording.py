"""Recordings on disk: what is there, what they hold, and how they leave as CSV or as a labelled dataset."""

import json
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from html import escape
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, TextIO

import numpy as np
from numpy.typing import NDArray

from fdes.errors import RecordingError
from fdes.flight.recorder import CHUNK, FORMAT, MAGIC, SUFFIX, chunk
from fdes.physics.signals import Channel
from fdes.units import UNIT_SYSTEMS

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, repr=False)
class Recording:
    """A flight as it was: `data` is (frames, columns) in SI; `complete` is False when its end is missing."""

    header: dict[str, Any]
    columns: tuple[Channel, ...]
    data: NDArray[np.float64]
    edits: tuple[dict[str, Any], ...]
    complete: bool

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """One column by name."""
        return self.data[:, [c.name for c in self.columns].index(name)]

    def __repr__(self) -> str:
        return f"<Recording {self._caption()}>"

    def _caption(self) -> str:
        title = " ".join(str(self.header[key]) for key in ("aircraft", "condition", "started") if key in self.header)
        t = self.data[:, 0]
        return f"{title or 'Flight'}: " + (f"{len(t)} rows, {t[0]:g} to {t[-1]:g} s" if len(t) else "no rows")

    def _repr_html_(self) -> str:
        """What was flown, and how far each signal went, as a table for notebooks."""
        head = "<tr><th>column</th><th>unit</th><th>least</th><th>greatest</th><th>what</th></tr>"
        moved = [
            (c, v.min(), v.max()) for c, v in zip(self.columns, self.data.T, strict=True) if len(v) and np.ptp(v) > 0.0
        ]
        rows = "".join(
            f"<tr><td>{c.name}</td><td>{c.unit}</td><td>{low:.4g}</td><td>{high:.4g}</td><td>{c.long_name}</td></tr>"
            for c, low, high in moved
        )
        still = f"{len(self.columns) - len(moved)} columns that did not change are not shown"
        caption = escape(f"{self._caption()}; {still}" + ("" if self.complete else "; its end is missing"))
        return f"<table><caption>{caption}</caption>{head}{rows}</table>"

    def to_dataset(self) -> "xarray.Dataset":
        """The flight as a labelled dataset over `t`, with units and long names, and the header as attributes."""
        import xarray

        time, *signals = self.columns
        described = {c.name: {"units": c.unit, "long_name": c.long_name} for c in self.columns}
        header = {k: v if isinstance(v, (str, int, float)) else json.dumps(v) for k, v in self.header.items()}
        return xarray.Dataset(
            {c.name: ("t", self.data[:, i + 1], described[c.name]) for i, c in enumerate(signals)},
            coords={"t": ("t", self.data[:, 0], described[time.name])},
            attrs=header | {"edits": json.dumps(self.edits)},
        )

    def save(self, path: Path) -> None:
        """Write it as a recording at `path`, which must not exist, as the recorder would have written it.

        Raises FileExistsError, OSError.
        """
        started = datetime.now(UTC).isoformat(timespec="seconds")
        said = {"started": started, **self.header, "format": FORMAT, "columns": [c._asdict() for c in self.columns]}
        times = self.data[:, 0]
        begun = 0
        with path.open("xb") as file:
            file.write(MAGIC + chunk(b"HEAD", json.dumps(said).encode()))
            for edit in self.edits:
                until = int(np.searchsorted(times, edit["t"]))
                file.write(chunk(b"ROWS", self.data[begun:until].astype("<f8").tobytes()) if until > begun else b"")
                file.write(chunk(b"EDIT", json.dumps(edit).encode()))
                begun = until
            file.write(chunk(b"ROWS", self.data[begun:].astype("<f8").tobytes()))
            if self.complete:
                file.write(chunk(b"DONE", json.dumps({"reason": "saved", "frames": len(self.data)}).encode()))

    def to_csv(self, file: TextIO, units: str = "si") -> None:
        """Write as CSV, the unit of each column in its header: ``q [rad/s]``. `units` is ``si`` or ``us``."""
        write_csv(file, self.columns, self.data, units)

    def to_netcdf(self, path: Path) -> None:
        """Write the labelled dataset as NetCDF 3, which every reader of NetCDF can read."""
        self.to_dataset().to_netcdf(path, engine="scipy", format="NETCDF3_64BIT")

    def to_mat(self, path: Path) -> None:
        """Write for MATLAB, version 5: one column vector per signal, and `units`, a struct of its unit by name."""
        from scipy.io import savemat

        signals = {c.name: self.data[:, i] for i, c in enumerate(self.columns)}
        savemat(
            path, {**signals, "units": {c.name: c.unit for c in self.columns}}, oned_as="column", do_compression=True
        )


@dataclass(frozen=True)
class Listed:
    """One recording in a folder, known by its header and its size alone."""

    name: str
    path: Path
    header: dict[str, Any]
    seconds: float
    bytes: int


def frames_to_recording(
    header: dict[str, Any], columns: tuple[Channel, ...], rows: Iterable[tuple[float, ...]]
) -> Recording:
    """A flight that was never on disk, as a recording."""
    data = np.fromiter(chain.from_iterable(rows), np.float64).reshape(-1, len(columns))
    return Recording(header, columns, data, (), True)


def write_csv(file: TextIO, columns: tuple[Channel, ...], data: NDArray[np.float64], units: str = "si") -> None:
    """Rows of SI numbers as CSV in the wanted system of units."""
    system = UNIT_SYSTEMS[units]
    shown = [system.get(c.unit, (c.unit, 1.0)) for c in columns]
    file.write(",".join(f"{c.name} [{unit}]" for c, (unit, _) in zip(columns, shown, strict=True)) + "\n")
    np.savetxt(file, data * [factor for _, factor in shown], fmt="%.15g", delimiter=",")


def open_recording(path: str | Path) -> Recording:
    """Read a recording. A tail cut off by a crash is left out. Raises RecordingError when the file is no recording."""
    path = Path(path)
    header: dict[str, Any] = {}
    blocks: list[bytes] = []
    edits: list[dict[str, Any]] = []
    complete = False
    with _opened(path) as file:
        header = _header(file, path)
        for kind, payload in _chunks(file):
            if kind == b"ROWS":
                blocks.append(payload)
            elif kind == b"EDIT":
                edits.append(json.loads(payload))
            elif kind == b"DONE":
                complete = True
    columns = tuple(Channel(**c) for c in header["columns"])
    data = np.frombuffer(b"".join(blocks), dtype="<f8").reshape(-1, len(columns))
    return Recording(header, columns, data, tuple(edits), complete)


def list_recordings(folder: Path) -> list[Listed]:
    """The recordings in a folder, newest first. Files that are none are passed over."""
    found = []
    for path in folder.glob(f"*{SUFFIX}"):
        try:
            with _opened(path) as file:
                header = _header(file, path)
                rows = sum(length for kind, length in _lengths(file) if kind == b"ROWS") // (8 * len(header["columns"]))
        except RecordingError:
            continue
        found.append(Listed(path.stem, path, header, max(0, rows - 1) * header["dt"], path.stat().st_size))
    return sorted(found, key=lambda r: (r.header["started"], r.name), reverse=True)


def _opened(path: Path) -> BinaryIO:
    try:
        return path.open("rb")
    except OSError as trouble:
        raise RecordingError(f"{path} cannot be read: {trouble.strerror}.") from trouble


def _header(file: BinaryIO, path: Path) -> dict[str, Any]:
    if file.read(len(MAGIC)) != MAGIC:
        raise RecordingError(f"{path.name} is not an FDES recording: it does not begin as one.")
    first = next(_chunks(file), None)
    if first is None or first[0] != b"HEAD":
        raise RecordingError(f"{path.name} is damaged: its header cannot be read, so neither can the rest.")
    header: dict[str, Any] = json.loads(first[1])
    if header.get("format") != FORMAT:
        raise RecordingError(
            f"{path.name} has format {header.get('format')} and was written by FDES {header.get('fdes')}; "
            f"this FDES reads format {FORMAT}. Install a newer FDES."
        )
    return header


def _chunks(file: BinaryIO) -> Iterator[tuple[bytes, bytes]]:
    while len(head := file.read(CHUNK.size)) == CHUNK.size:
        kind, length, crc = CHUNK.unpack(head)
        payload = file.read(length)
        if len(payload) < length or zlib.crc32(payload) != crc:
            return
        yield kind, payload


def _lengths(file: BinaryIO) -> Iterator[tuple[bytes, int]]:
    end = file.seek(0, 2)
    file.seek(len(MAGIC))
    while len(head := file.read(CHUNK.size)) == CHUNK.size:
        kind, length, _ = CHUNK.unpack(head)
        if file.seek(length, 1) > end:
            return
        yield kind, length
