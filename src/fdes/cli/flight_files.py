"""What `fdes simulate` writes: a flight as CSV, NetCDF or MAT, whole or not at all."""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from fdes.cli.output import screen
from fdes.cli.scenario import NAMES, write_s119
from fdes.errors import NoSuchPart, SpecError

if TYPE_CHECKING:
    from fdes.flight import Recording

STDOUT = "-"


def file_wanted(out: str | None, units: str) -> Path | None:
    """The file to write, if one is wanted. Raises SpecError for what cannot be written, before anything is flown."""
    if out is None or out == STDOUT:
        return None
    path = Path(os.path.realpath(out))  # a link stays a link, what it leads to is written
    if path.suffix.lower() not in SAVE:
        raise SpecError(f"{out} cannot be written: let its name end in {', '.join(SAVE)}.")
    if path.is_dir():
        raise SpecError(f"{out} cannot be written: it is a folder.")
    if not path.parent.is_dir():
        raise SpecError(f"{out} cannot be written: there is no folder {path.parent}.")
    if not os.access(path.parent, os.W_OK):
        raise SpecError(f"{out} cannot be written: no permission to write in {path.parent}.")
    if path.suffix.lower() != ".csv" and units != "si":
        raise SpecError(f"{path.suffix} files carry their units and are written in SI. Use .csv with --units.")
    return path


def must_be_written_as(names: str, plant: str, target: Path | None, out: str | None) -> None:
    """Raises SpecError, NoSuchPart for names of columns that cannot be written so."""
    if names not in NAMES:
        raise NoSuchPart("set of column names", names, NAMES)
    if names == "fdes":
        return
    if plant == "linear":
        raise SpecError(f"--names {names} is of flights over an Earth: give --plant nonlinear with it.")
    if out != STDOUT and (target is None or target.suffix.lower() != ".csv"):
        raise SpecError(f"--names {names} are columns of a CSV file: name one with --out, such as --out run.csv.")


def frames_per_row(rate: float | None, dt: float) -> int:
    """How many frames a row stands for. Raises SpecError where that is no whole number."""
    if rate is None:
        return 1
    every = 1.0 / (rate * dt) if rate > 0.0 else 0.0
    if every < 1.0 - 1e-9 or abs(every - round(every)) > 1e-6 * every:
        raise SpecError(
            f"--rate {rate:g} rows a second cannot be taken from frames {dt:g} s apart: let it be {1.0 / dt:g} divided "
            "by a whole number, or choose another --dt."
        )
    return round(every)


def write(response: "Recording", out: str, target: Path | None, units: str, names: str) -> None:
    """To stdout, where `out` says so, or to the file `target`. Raises SpecError."""
    if target is None:
        _save_csv(response, sys.stdout, units, names)
        return
    with whole(target) as part:
        SAVE[target.suffix.lower()](response, part, units, names)
    columns = f", {len(response.columns)} columns" if names == "fdes" else ""
    screen().print(f"{out}: {len(response.data)} rows{columns}", soft_wrap=True)


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """A file that appears at `path` when all of it is written, and not at all otherwise. Raises SpecError."""
    part = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")
    try:
        yield part
        part.replace(path)
    except OSError as trouble:
        raise SpecError(f"{path} cannot be written: {trouble.strerror or trouble}.") from trouble
    finally:
        part.unlink(missing_ok=True)


def _save_csv(response: "Recording", file: TextIO, units: str, names: str) -> None:
    if names == "fdes":
        response.to_csv(file, units)
    else:
        from fdes.physics.earth import EARTHS

        write_s119(EARTHS[response.header["earth"]], response, file)


def _open_csv(response: "Recording", path: Path, units: str, names: str) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as file:
        _save_csv(response, file, units, names)


SAVE: dict[str, Callable[["Recording", Path, str, str], None]] = {
    ".csv": _open_csv,
    ".nc": lambda response, path, *_: response.to_netcdf(path),
    ".mat": lambda response, path, *_: response.to_mat(path),
}
