"""A measured time history, from a CSV file or from arrays: what somebody else did with the stick, or met in the air."""

import csv
import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Annotated

from fdes.errors import SpecError, nearest
from fdes.units import parse

__all__ = ["Measured"]

_HEADER = re.compile(r"\s*([^\[\]]*?)\s*(?:\[\s*([^\[\]]*?)\s*\])?\s*")


@dataclass(frozen=True)
class Measured:
    """`values` in the unit of its channel at `times` [s], straight lines between them; the first row falls on `at` [s].

    Whatever clock the times were taken from, only their differences count. Before the first row and after the last
    one it is zero: nothing is known there. Raises SpecError for numbers that are no time history.

    >>> Measured((10.0, 12.0), (0.0, 1.0), at=3.0)(4.0)
    0.5
    """

    times: tuple[float, ...]
    values: tuple[float, ...]
    at: Annotated[float, "s"] = 0.0

    def __post_init__(self) -> None:
        _must_be_a_history(self.times, self.values)

    @property
    def lasting(self) -> float:
        """From the first row to the last [s]."""
        return self.times[-1] - self.times[0]

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        # Rounded, so that a row that is meant for a frame falls on it: 0.1 + 0.2 > 0.3 in floating point.
        since = round(t - self.at, 9)
        if not 0.0 <= since <= round(self.lasting, 9):
            return 0.0
        moment = since + self.times[0]
        k = min(max(bisect_right(self.times, moment), 1), len(self.times) - 1)
        (before, after), (low, high) = self.times[k - 1 : k + 1], self.values[k - 1 : k + 1]
        return low + (high - low) * min(max((moment - before) / (after - before), 0.0), 1.0)

    @classmethod
    def read(cls, file: str, column: str, unit: str) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Times [s] and values, in the SI `unit`, of a `column` of a CSV file with a column ``t``.

        A header says its unit, ``elevator [deg]``, as the files of `fdes simulate` do. Nothing but numbers is read.
        Raises SpecError.
        """
        head, rows = _table(file)
        names, units = zip(*(_name_and_unit(h) for h in head), strict=True)
        columns = [_found(file, name, names) for name in ("t", column)]
        factors = [_factor(file, names[c], units[c], si) for c, si in zip(columns, ("s", unit), strict=True)]
        read: list[list[float]] = [[], []]
        for line, row in rows:
            for numbers, c, factor in zip(read, columns, factors, strict=True):
                numbers.append(_number(file, line, names[c], row[c] if c < len(row) else "") * factor)
        times, values = map(tuple, read)
        try:
            _must_be_a_history(times, values)
        except SpecError as trouble:
            raise SpecError(f"{file}: {trouble}") from trouble
        return times, values


def _must_be_a_history(times: Sequence[float], values: Sequence[float]) -> None:
    if len(times) != len(values):
        raise SpecError(f"A measured input has {len(times)} times and {len(values)} values; it needs as many of both.")
    if len(times) < 2:
        raise SpecError(
            f"A measured input needs at least two rows; there {'is' if len(times) == 1 else 'are'} {len(times)}."
        )
    for row, (t, value) in enumerate(zip(times, values, strict=True), start=1):
        if not (isfinite(t) and isfinite(value)):
            raise SpecError(
                f"Row {row} of a measured input holds a number that is not finite (t = {t:g} s, {value:g})."
            )
        if row > 1 and t <= times[row - 2]:
            raise SpecError(
                f"The time of a measured input must grow from row to row; row {row} goes from {times[row - 2]:.9g} s "
                f"to {t:.9g} s. Sort the rows, and leave out those that are there twice."
            )


def _table(file: str) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """The header, and the rows that are not empty with their line numbers."""
    try:
        with Path(file).open(encoding="utf-8-sig", newline="") as opened:
            reader = csv.reader(opened)
            lines = [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except FileNotFoundError:
        raise SpecError(
            f"There is no file {file}. Name it from the folder you are in, or with its whole path."
        ) from None
    except OSError as trouble:
        raise SpecError(f"{file} cannot be read: {trouble.strerror or trouble}.") from trouble
    except UnicodeDecodeError:
        raise SpecError(f"{file} is not a CSV file: it is not text in UTF-8. Save it as CSV in UTF-8.") from None
    except (csv.Error, ValueError) as trouble:
        raise SpecError(f"{file} is not a CSV file: {trouble}.") from trouble
    if not lines:
        raise SpecError(f"{file} is empty. Its first line should name the columns, such as 't [s],elevator [deg]'.")
    return lines[0][1], lines[1:]


def _name_and_unit(header: str) -> tuple[str, str | None]:
    match = _HEADER.fullmatch(header)
    return (header.strip(), None) if match is None else (match[1], match[2])


def _found(file: str, name: str, names: Sequence[str]) -> int:
    if name in names:
        return names.index(name)
    near = nearest(name, names)
    hint = f" Did you mean {near!r}?" if near else ""
    some = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    raise SpecError(f"{file} has no column {name!r}.{hint} It has: {some}.")


def _factor(file: str, name: str, unit: str | None, si: str) -> float:
    """From the unit of a column to SI. Time without a unit is in seconds, a pure number has none to say."""
    if unit is None and (name == "t" or si == "1"):
        return 1.0
    if unit is None:
        example = "deg" if si == "rad" else si
        raise SpecError(
            f"The column {name!r} of {file} does not say its unit. Write it into its header: {name} [{example}]."
        )
    try:
        return parse(f"1 {unit}", si)
    except SpecError as trouble:
        raise SpecError(f"The column {name!r} of {file} cannot be used. {trouble}") from trouble


def _number(file: str, line: int, name: str, cell: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        said = repr(cell.strip()[:40]) if cell.strip() else "empty"
        raise SpecError(f"Line {line} of {file}: {name} is {said}, not a number.") from None
    if not isfinite(value):
        raise SpecError(f"Line {line} of {file}: {name} is {cell.strip()}; only finite numbers can be flown.")
    return value
