"""Linear tables: values, ends, and slopes by complex step."""

from typing import Any

import numpy as np
import pytest

from fdes.physics.tables import Axis, grid_at, row_at, spot

AXIS = Axis((-1.0, 0.0, 2.0, 5.0))
FREE = AXIS._replace(held=False)
VALUES = (3.0, 1.0, 2.0, -4.0)
GRID = ((1.0, 2.0, 4.0, 8.0), (0.0, -1.0, 5.0, 2.0))
ROWS = Axis((0.0, 10.0))


@pytest.mark.parametrize("x", [-1.0, -0.3, 0.0, 0.7, 2.0, 4.9, 5.0])
def test_between_breakpoints_it_is_straight(x: float) -> None:
    assert row_at(VALUES, spot(AXIS, x)) == pytest.approx(np.interp(x, AXIS.breakpoints, VALUES), abs=1e-15)


def test_two_variables_are_interpolated_one_after_the_other() -> None:
    for x in (0.0, 2.5, 10.0):
        for y in (-1.0, 1.1, 5.0):
            rows = [np.interp(y, AXIS.breakpoints, row) for row in GRID]
            expected = np.interp(x, ROWS.breakpoints, rows)
            assert grid_at(GRID, spot(ROWS, x), spot(AXIS, y)) == pytest.approx(expected, abs=1e-15)


def test_beyond_its_ends_it_is_held_or_goes_on() -> None:
    assert row_at(VALUES, spot(AXIS, -3.0)) == 3.0
    assert row_at(VALUES, spot(AXIS, 9.0)) == -4.0
    assert row_at(VALUES, spot(FREE, -3.0)) == 3.0 + 2.0 * 2.0
    assert row_at(VALUES, spot(FREE, 9.0)) == -4.0 - 2.0 * 4.0


@pytest.mark.parametrize(("x", "slope"), [(-0.5, -2.0), (0.0, 0.5), (1.0, 0.5), (2.0, -2.0), (4.0, -2.0), (7.0, 0.0)])
def test_the_imaginary_part_is_the_slope(x: float, slope: float) -> None:
    """At a breakpoint that of the interval above; beyond the ends, where the table is held, none."""
    asked: Any = complex(x, 1e-30)
    found = row_at(VALUES, spot(AXIS, asked))
    assert found.imag / 1e-30 == pytest.approx(slope, abs=1e-15)
    assert found.real == row_at(VALUES, spot(AXIS, x))
