"""Tables of one or two variables, interpolated linearly, of floats and of complex numbers.

Where a value lies is found from its real part, so that the imaginary part of a complex step passes through as the
slope. At a breakpoint the slope is that of the interval above it. Beyond its ends a table is held, as the sources of
the hangar hold theirs, or goes on straight: the table's axis says which.
"""

from typing import NamedTuple

Row = tuple[float, ...]


class Axis(NamedTuple):
    """One variable of a table: two or more breakpoints in rising order. held: not extrapolated beyond its ends."""

    breakpoints: Row
    held: bool = True


class Spot(NamedTuple):
    """Where a value lies on an axis: the interval, and how far into it, from 0 to 1 within the axis."""

    k: int
    t: float


def spot(axis: Axis, x: float) -> Spot:
    """Where `x` lies."""
    b = axis.breakpoints
    real = x.real
    if axis.held and not b[0] <= real <= b[-1]:
        return Spot(0, 0.0) if real < b[0] else Spot(len(b) - 2, 1.0)
    k = 0
    while k < len(b) - 2 and real >= b[k + 1]:
        k += 1
    return Spot(k, (x - b[k]) / (b[k + 1] - b[k]))


def row_at(values: Row, at: Spot) -> float:
    """The value of a table of one variable."""
    low = values[at.k]
    return low + at.t * (values[at.k + 1] - low)


def grid_at(values: tuple[Row, ...], row: Spot, column: Spot) -> float:
    """The value of a table of two variables: interpolated along the rows' variable last."""
    low, high = row_at(values[row.k], column), row_at(values[row.k + 1], column)
    return low + row.t * (high - low)
