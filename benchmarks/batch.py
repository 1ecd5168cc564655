"""The nonlinear plant of the NAVION and of the F-16: a compiled batch, one compiled aircraft, and the plain form.

    python benchmarks/batch.py [--aircraft 2048] [--steps 100]

Millions of aircraft-steps of Runge-Kutta 4 per second of processor time, the best of five rounds, and how much faster
that is than the plain form, which flies live.
"""

import argparse
import time

import numpy as np

from fdes.aircraft import load
from fdes.analysis.batch import columns_of, solver_of
from fdes.analysis.compiled_plant import Given, numbers_of
from fdes.analysis.trim import TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.plant import SixDof
from fdes.physics.signals import Air

STEP, ROUNDS = 0.001, 5
FLIGHTS = {"NAVION": 500.0, "F-16": 3000.0}  # and the height [m]


def main(argv: list[str] | None = None) -> dict[str, dict[str, float]]:
    """Measure, print, and return the figures."""
    options = argparse.ArgumentParser(description="The nonlinear plant, compiled and plain.")
    options.add_argument("--aircraft", type=int, default=2048)
    options.add_argument("--steps", type=int, default=100)
    chosen = options.parse_args(argv)
    found = {}
    for name, h in FLIGHTS.items():
        condition = load(name).at()
        plant = trim(six_dof_of(condition), TrimSpec(condition.reference.V, h)).plant
        found[name] = figures(plant, chosen.aircraft, chosen.steps)
        for form, value in found[name].items():
            print(f"{name:8}{form:14}{value:9.3f} M steps/s{value / found[name]['plain']:8.0f} x plain")
    return found


def figures(plant: SixDof, aircraft: int, steps: int) -> dict[str, float]:
    """Millions of aircraft-steps per second."""
    found = {
        "batch": best(plant, aircraft, steps, lanes=8),
        "one aircraft": best(plant, 1, max(aircraft * steps // 8, 1), lanes=1),
        "plain": 0.0,
    }
    for _ in range(ROUNDS):
        state, began = plant.start(), time.process_time()
        for _ in range(steps):
            state = plant.advance(state, plant.trim(), Air(), STEP)
        found["plain"] = max(found["plain"], 1e-6 * steps / (time.process_time() - began))
    return found


def best(plant: SixDof, aircraft: int, steps: int, lanes: int) -> float:
    """Of the compiled solver."""
    solver, fastest = solver_of(plant, lanes), 0.0
    for _ in range(ROUNDS):
        rows = plant.start(), Given(plant.trim(), Air()), numbers_of(plant)
        x, held, numbers = (np.repeat(columns_of([row]), aircraft, axis=1) for row in rows)
        solver.advance(x, held, numbers, STEP, 1)  # compiles
        began = time.process_time()
        solver.advance(x, held, numbers, STEP, steps)
        fastest = max(fastest, 1e-6 * aircraft * steps / (time.process_time() - began))
    return fastest


if __name__ == "__main__":
    main()
