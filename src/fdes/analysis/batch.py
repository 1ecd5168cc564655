"""Many aircraft at once: the nonlinear derivative that flies, compiled for a batch in lanes.

Each aircraft has its own state, surfaces, air and numbers: a Monte Carlo over any derivative, inertia or center of
gravity is one batch. Tables are shared. The plain text in `fdes.physics` is what is compiled; tests/compiled holds the
two together.
"""

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from fdes.analysis.compiled_plant import Given, Kind, kind_of, numbers_of, structure_of
from fdes.errors import SpecError
from fdes.kernel import LANES, Batch, batch
from fdes.physics.plant import SixDof, State
from fdes.physics.runge_kutta import Tableau


def solver_of(plant: SixDof, lanes: int = LANES) -> Batch:
    """A compiled solver, by the plant's own integrator, for aircraft of the kind of `plant`.

    Columns are aircraft; rows of its three arrays are `states`, `inputs` and `parameters`. The quaternion is not made
    a unit again: over a flight of minutes it stays one to the order of the integrator. Heights are not checked.
    Raises SpecError where compiling is switched off.
    """
    return _solver(kind_of(plant), plant.integrator, lanes)


@cache
def _solver(kind: Kind, integrator: Tableau, lanes: int) -> Batch:
    structure = structure_of(kind)
    return batch(structure.rates, integrator, lanes, structure.instead)


def fly_many(
    plants: Sequence[SixDof], starts: Sequence[State], given: Sequence[Given], h: float, steps: int
) -> list[State]:
    """The states of many aircraft after so many steps of `h` [s], surfaces and air held.

    The first call for a kind of aircraft compiles it, which takes some 15 s; later processes find that on disk. Raises
    SpecError where the aircraft are of several kinds, or where compiling is switched off.
    """
    one_kind(plants)
    solver = solver_of(plants[0])
    x, held, numbers = columns_of(starts), columns_of(given), columns_of([numbers_of(plant) for plant in plants])
    solver.advance(x, held, numbers, h, steps)
    return [State(*column) for column in x.T.tolist()]


def one_kind(plants: Sequence[SixDof]) -> Kind:
    """The kind of all of them. Raises SpecError where they are of several."""
    kind = kind_of(plants[0])
    odd = next((k for k, plant in enumerate(plants) if kind_of(plant) != kind), None)
    if odd is not None:
        raise SpecError(
            f"Aircraft {odd + 1} of {len(plants)} flies by other functions, other tables or over another Earth than "
            "the first one, and what is compiled has one of each. Make a batch of each kind."
        )
    return kind


def columns_of(rows: Sequence[Sequence[object]]) -> NDArray[np.float64]:
    """One column for each aircraft, of all numbers in its named tuple."""
    return np.array([_flat(row) for row in rows]).T.copy()


def _flat(values: Sequence[object]) -> list[object]:
    return [v for part in values for v in (_flat(part) if isinstance(part, tuple) else [part])]
