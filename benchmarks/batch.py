"""The nonlinear plant of the NAVION: a compiled batch, one compiled aircraft, and the plain form that flies live.

    python benchmarks/batch.py [--aircraft 2048] [--steps 100]

Millions of aircraft-steps of Runge-Kutta 4 per second of processor time, the best of five rounds.
"""

import argparse
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import load
from fdes.analysis.batch import solver_of
from fdes.analysis.compiled_plant import Given, numbers_of
from fdes.analysis.trim import TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.signals import Air

STEP, ROUNDS = 0.001, 5


def columns(values: tuple[Any, ...], aircraft: int) -> NDArray[np.float64]:
    """A named tuple, flattened, once per aircraft."""

    def flat(part: Any) -> list[float]:
        return [v for inner in part for v in flat(inner)] if isinstance(part, tuple) else [part]

    return np.repeat(np.array(flat(values))[:, None], aircraft, axis=1)


def main(argv: list[str] | None = None) -> dict[str, float]:
    """Measure, print, and return the figures."""
    options = argparse.ArgumentParser(description="The nonlinear plant, compiled and plain.")
    options.add_argument("--aircraft", type=int, default=2048)
    options.add_argument("--steps", type=int, default=100)
    chosen = options.parse_args(argv)
    condition = load("NAVION").at()
    plant = trim(six_dof_of(condition), TrimSpec(condition.reference.V, 500.0)).plant
    figures: dict[str, float] = {}
    for name, aircraft, lanes in (("batch", chosen.aircraft, 8), ("one aircraft", 1, 1)):
        solver = solver_of(plant, lanes)
        tuples = plant.start(), Given(plant.trim(), Air()), tuple(numbers_of(plant))
        steps = chosen.steps * chosen.aircraft // aircraft // (1 if aircraft > 1 else 4)
        for _ in range(ROUNDS):
            x, held, numbers = (columns(t, aircraft) for t in tuples)
            solver.advance(x, held, numbers, STEP, 1)  # compiles
            began = time.process_time()
            solver.advance(x, held, numbers, STEP, steps)
            figures[name] = max(figures.get(name, 0.0), 1e-6 * aircraft * steps / (time.process_time() - began))
    for _ in range(ROUNDS):
        state, began = plant.start(), time.process_time()
        for _ in range(chosen.steps):
            state = plant.advance(state, plant.trim(), Air(), STEP)
        figures["plain"] = max(figures.get("plain", 0.0), 1e-6 * chosen.steps / (time.process_time() - began))
    for name, value in figures.items():
        print(f"{name:14} {value:8.3f} M steps/s")
    return figures


if __name__ == "__main__":
    main()
