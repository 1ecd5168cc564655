"""The Jacobian of the nonlinear derivative, 14 states by 18: compiled dual numbers, and the plain text's complex step.

    python benchmarks/jacobian.py [--points 1000]

Microseconds of processor time for a point, the least of many rounds; the largest error relative to 1 + the size of a
slope; and what a whole linear model costs, of which the matrices are made by the chain rule in NumPy.
"""

import argparse
import time
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import load
from fdes.analysis.compiled_plant import kind_of, numbers_of, structure_of
from fdes.analysis.jacobian import linearized
from fdes.analysis.jacobians import COLUMNS, linear_models, slopes_at
from fdes.analysis.trim import TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.kernel import jacobian
from fdes.physics.plant import SixDof, State
from fdes.physics.signals import Air, Surfaces

ROUNDS = 30
TINY = 1e-30
FLIGHTS = {"NAVION": 500.0, "F-16": 3000.0}  # and the height [m]


def main(argv: list[str] | None = None) -> dict[str, dict[str, float]]:
    """Measure, print, and return the figures."""
    options = argparse.ArgumentParser(description="The Jacobian of the nonlinear derivative, compiled and plain.")
    options.add_argument("--points", type=int, default=1000)
    chosen = options.parse_args(argv)
    found = {}
    for name, h in FLIGHTS.items():
        condition = load(name).at()
        point = trim(six_dof_of(condition), TrimSpec(condition.reference.V, h))
        plant = point.plant
        x, held = plant.start()._replace(v=3.0, p=0.1, q=0.05, r=-0.02), plant.trim()._replace(aileron=0.05)
        wanted = by_complex_step(plant, x, held)
        error = np.abs(slopes_at([plant], [x], [held]).by[0] - wanted) / (1.0 + np.abs(wanted))
        found[name] = {
            "compiled, in a batch": filled(plant, x, held, chosen.points),
            "compiled, one point": filled(plant, x, held, 1),
            "plain, complex step": least(partial(by_complex_step, plant, x, held), 1),
            "linear model of a batch": least(partial(linear_models, [point] * 20), 20),
            "linear model, plain": least(partial(linearized, point), 1),
        }
        for form, value in found[name].items():
            print(f"{name:8}{form:26}{value:10.2f} us")
        print(f"{name:8}{'error':26}{error.max():10.1e}")
        found[name]["error"] = float(error.max())
    return found


def filled(plant: SixDof, x: State, held: Surfaces, points: int) -> float:
    """Of the compiled kernel, called from Python."""
    structure = structure_of(kind_of(plant))
    machine = jacobian(structure.rates_in_air, structure.instead)
    row = [x, held, numbers_of(plant) + list(Air())]
    states, surfaces, numbers = (np.repeat(np.array([part]), points, axis=0) for part in row)
    rates, by = np.empty(states.shape), np.zeros(states.size * machine.width)
    return least(lambda: machine.fill(states, surfaces, numbers, rates, by), points, 1 if points > 1 else 1000)


def by_complex_step(plant: SixDof, x: State, held: Surfaces) -> NDArray[np.float64]:
    """Of the text as it stands."""
    columns = []
    for k in range(len(COLUMNS)):
        z = [complex(v, TINY if i == k else 0.0) for i, v in enumerate([*x, *held])]
        rate = plant.derivative(State(*z[: len(x)]), Surfaces(*z[len(x) :]), Air())  # type: ignore[arg-type]
        columns.append([v.imag / TINY for v in rate])
    return np.array(columns).T


def least(work: Callable[[], object], points: int, times: int = 1) -> float:
    """Microseconds a point."""
    work()  # compiles
    found = []
    for _ in range(ROUNDS):
        began = time.process_time()
        for _ in range(times):
            work()
        found.append(1e6 * (time.process_time() - began) / (times * points))
    return min(found)


if __name__ == "__main__":
    main()
