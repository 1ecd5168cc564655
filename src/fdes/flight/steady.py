"""What every search for a steady flight works with: still air, surfaces without stops, and slopes by complex step.

Reference: W. Squire, G. Trapp, SIAM Review 40 (1998) 110-112, for the complex step.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.physics.signals import Air, Surfaces
from fdes.physics.small_perturbation import Limits

FREE = Limits(Surfaces(*[-1e9] * 4), Surfaces(*[1e9] * 4))  # stops are asked of what is found, not of the search
CALM = Air()
TINY = 1e-30  # a complex step: nothing is subtracted, so nothing is lost


def slopes(
    equations: Callable[[Sequence[Any]], Sequence[Any]], z: Sequence[float], chosen: Iterable[int] | None = None
) -> NDArray[np.float64]:
    """The derivatives of all `equations` at `z`, a column for each unknown, or for those that are `chosen`."""
    columns = []
    for k in range(len(z)) if chosen is None else chosen:
        stepped: list[Any] = list(z)
        stepped[k] = complex(stepped[k], TINY)
        columns.append([v.imag / TINY for v in equations(stepped)])
    return np.array(columns).T
