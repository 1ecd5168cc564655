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
from fdes.analysis.jacobian import moved_by, must_be_straight, rates_along_stability_axes
from fdes.analysis.linearize import INPUTS, STATES
from fdes.analysis.trim import FREE, TINY, TrimPoint
from fdes.control import LinearModel
from fdes.errors import SpecError
from fdes.kernel import Jacobian, jacobian
from fdes.physics.plant import SixDof, State
from fdes.physics.signals import Air, Surfaces, channels
from fdes.physics.small_perturbation import PerturbationState

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


def linear_models(points: Sequence[TrimPoint]) -> list[LinearModel]:
    """The linear models of many trimmed flights of one kind of aircraft, as `linearized` gives them, without outputs.

    Raises SpecError as `slopes_at` does, and where a flight turns or sideslips.
    """
    for point in points:
        must_be_straight(point)
    plants = [point.plant._replace(limits=FREE) for point in points]
    found = slopes_at(plants, [point.state for point in points], [plant.trim() for plant in plants])
    return [_model(plant, point, by) for plant, point, by in zip(plants, points, found.by, strict=True)]


def _model(plant: SixDof, point: TrimPoint, by: NDArray[np.float64]) -> LinearModel:
    """By the chain rule: from perturbations to states and surfaces, on to dx/dt, and to the rates of perturbations."""
    size, columns = len(STATES) + len(INPUTS), []
    for k in range(size):
        z = [complex(0.0, TINY if i == k else 0.0) for i in range(size)]
        x, held = moved_by(plant, point, z)
        rates = by @ [v.imag / TINY for v in (*map(complex, x), *map(complex, held))]
        unit = [float(i == k) for i in range(size)]
        columns.append(rates_along_stability_axes(point, State(*rates.tolist()), unit))
    both = np.array(columns, dtype=float).T
    units = {c.name: c.unit for c in (*channels(PerturbationState), *channels(Surfaces))}
    return LinearModel(
        A=both[:, : len(STATES)],
        B=both[:, len(STATES) :],
        states=STATES,
        inputs=INPUTS,
        units={name: units[name] for name in (*STATES, *INPUTS)},
        point={**point.spec.flight(), "alpha": point.alpha, "theta": point.theta, **point.surfaces._asdict()},
    )


@cache
def _machine(kind: Kind) -> Jacobian:
    structure = structure_of(kind)
    return jacobian(structure.rates_in_air, structure.instead)
