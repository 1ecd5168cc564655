"""The slopes of the nonlinear derivative by all states and surfaces, compiled, at many points at once.

The text that flies is compiled with dual numbers (`fdes.duals`), so that slopes are exact: they are those of a complex
step to rounding. A point takes about a microsecond, where the complex step of the plain text takes some milliseconds.
"""

from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fdes.analysis.batch import one_kind
from fdes.analysis.compiled_plant import Kind, numbers_of, structure_of
from fdes.errors import SpecError
from fdes.kernel import Jacobian, jacobian
from fdes.physics.plant import SixDof, State
from fdes.physics.signals import Air, Surfaces

COLUMNS = (*State._fields, *Surfaces._fields)


class Slopes(NamedTuple):
    """rates (points, 14): dx/dt. by (points, 14, 18): its slopes by the states and the surfaces, in order `COLUMNS`."""

    rates: NDArray[np.float64]
    by: NDArray[np.float64]


def slopes_at(
    plants: Sequence[SixDof], states: Sequence[State], held: Sequence[Surfaces], air: Air | None = None
) -> Slopes:
    """The derivative and its slopes at many points, each of a plant of its own, all in the same air: still by default.

    SI and radians. The first call for a kind of aircraft compiles it, which takes some 10 s; later processes find that
    on disk. Raises SpecError where the aircraft are of several kinds, or where compiling is switched off.
    """
    kind = one_kind(plants)
    if not len(plants) == len(states) == len(held):
        raise SpecError(
            f"{len(plants)} plants, {len(states)} states and {len(held)} settings of the surfaces were given, and each "
            "point has one of each: give as many of all."
        )
    machine = _machine(kind)
    blowing = list(air or Air())
    x, surfaces = np.array(states, dtype=float), np.array(held, dtype=float)
    numbers = np.array([numbers_of(plant) + blowing for plant in plants])
    rates, by = np.empty(x.shape), np.zeros((len(x), x.shape[1], machine.width))
    machine.fill(x, surfaces, numbers, rates, by.reshape(-1))
    return Slopes(rates, by[:, :, : len(COLUMNS)])


@cache
def _machine(kind: Kind) -> Jacobian:
    structure = structure_of(kind)
    return jacobian(structure.rates_in_air, structure.instead)
