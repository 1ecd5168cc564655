"""Sums of terms as straight-line text: what an aircraft's [terms] say, without a loop over them, to be compiled.

A compiler packs the numbers of several aircraft into one instruction only where nothing loops over terms or parts at a
branch. So the structure of a `TermAero` becomes the text of a function, and its breakpoints and tables become arrays.
The arithmetic is that of `fdes.physics.terms.body_coefficients`, number for number; a test holds the two together.
"""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from fdes.physics.tables import Axis, grid_at, row_at
from fdes.physics.terms import SIGNALS, BodyCoefficients, Term, TermAero


class LaneAxis(NamedTuple):
    """An `Axis` as arrays: the breakpoints between intervals, filled up with infinity; where each begins, its width."""

    inner: NDArray[np.float64]
    starts: NDArray[np.float64]
    widths: NDArray[np.float64]
    low: float
    high: float
    held: bool


def arrays_of(value: Any, longest: int) -> Any:
    """The same with each row or table of numbers as an array, and each axis in a form for `longest` breakpoints."""
    if isinstance(value, Axis):
        b = np.array(value.breakpoints)
        inner = np.append(b[1:-1], [np.inf] * (longest - len(b)))
        return LaneAxis(inner, b[:-1], np.diff(b), value.breakpoints[0], value.breakpoints[-1], value.held)
    if not isinstance(value, tuple):
        return value
    if hasattr(value, "_fields"):
        kind: Any = type(value)
        return kind._make(arrays_of(part, longest) for part in value)
    parted = any(hasattr(part, "_fields") for part in value)
    return tuple(arrays_of(part, longest) for part in value) if parted else np.array(value, dtype=float)


def longest_axis(value: Any) -> int:
    """How many breakpoints the longest axis in `value` has; at least three."""
    if isinstance(value, Axis):
        return len(value.breakpoints)
    return max(map(longest_axis, value), default=3) if isinstance(value, tuple) else 3


def spot_text(longest: int) -> str:
    """The text of `fdes.physics.tables.spot` for a `LaneAxis`: it counts the breakpoints passed, and does not part."""
    passed = " + ".join(f"(1 if x.real >= axis.inner[{i}] else 0)" for i in range(longest - 2))
    return f"""
def spot(axis, x):
    k = {passed}
    t = (x - axis.starts[k]) / axis.widths[k]
    if axis.held:
        t = where(x.real < axis.low, 0.0, where(x.real > axis.high, 1.0, t))
    return Spot(k, t)
"""


def term_text(a: TermAero) -> str:
    """The text of `body_coefficients(a, signals)`; it asks for the names of `term_names`."""
    lines = ["def body_coefficients(a, signals):"]
    for k, axis in enumerate(a.axes):
        x = f"{'-' if axis.sign < 0.0 else ''}signals.{SIGNALS[axis.signal]}"
        if axis.mirrored:
            lines += [f"    x{k} = {x}", f"    side{k} = where(x{k}.real < 0.0, -1.0, 1.0)"]
            x = f"side{k} * x{k}"
        lines.append(f"    at{k} = spot(AXIS_{k}, {x})")
    for k, (axes, _) in enumerate(a.tables):
        read = "row_at" if len(axes) == 1 else "grid_at"
        places = ", ".join(f"at{i}" for i in axes)
        lines.append(f"    table{k} = {_times([*_sides(a, axes), f'{read}(TABLE_{k}, {places})'])}")
    lines.append(f"    return BodyCoefficients({', '.join(_sum(terms) for terms in a.sums)})")
    return "\n".join([*lines, ""])


def term_names(a: TermAero, longest: int) -> dict[str, Any]:
    """What the text of `term_text` is given, beside `spot`."""
    names = {f"AXIS_{k}": arrays_of(axis.axis, longest) for k, axis in enumerate(a.axes)}
    names |= {f"TABLE_{k}": arrays_of(table.values, longest) for k, table in enumerate(a.tables)}
    return names | {f.__name__: f for f in (BodyCoefficients, grid_at, row_at)}


def _sides(a: TermAero, axes: Iterable[int]) -> Iterator[str]:
    """Tables over a mirrored axis change sign with its signal."""
    return (f"side{k}" for k in axes if a.axes[k].mirrored)


def _sum(terms: tuple[Term, ...]) -> str:
    return " + ".join(_product(term) for term in terms) or "0.0"


def _product(term: Term) -> str:
    gain = [repr(term.gain)] if term.gain != 1.0 or term.table is None else []
    table = [] if term.table is None else [f"table{term.table}"]
    return _times([*gain, *table, *(f"signals.{SIGNALS[k]}" for k in term.signals)])


def _times(factors: Iterable[str]) -> str:
    return " * ".join(factors)
