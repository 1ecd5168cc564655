"""How long a trim of the nonlinear plant takes, warm, in plain Python: straight, turning and pulling up.

    python benchmarks/trim.py [--repeats 200]

Prints the shortest of so many for each aircraft and condition, beside the demand. On one core of an AMD EPYC, Python
3.11, aircraft of derivatives take 0.3 ms in straight flight and 0.5 ms in a turn, the F-16 0.6 and 0.9 ms. How trims of
random requests end is asked by tests/properties/test_random_trims.py, with FDES_TRIMS=1000 of each condition.
"""

import argparse
import math
import time

from fdes.aircraft import FlightCondition, catalogue
from fdes.analysis.trim import TrimSpec, solve
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.plant import SixDof
from fdes.units import DEG

DEMAND = 1.0  # ms
KINDS = {"straight": {}, "turn, 30 deg of bank": {"bank": 30.0 * DEG}, "pull-up, n = 1.2": {"n": 1.2}}


def main(argv: list[str] | None = None) -> dict[tuple[str, str], list[float]]:
    """Measure, print the table, and return it: milliseconds of each kind."""
    options = argparse.ArgumentParser(description="How long a trim takes.")
    options.add_argument("--repeats", type=int, default=200)
    repeats = options.parse_args(argv).repeats
    found = {}
    print("".ljust(24), *(kind.rjust(22) for kind in KINDS), "   [ms], demand", DEMAND)
    for aircraft in catalogue():
        for one in aircraft.conditions:
            condition = aircraft.at(one.id)
            if condition.nondimensional:
                times = found[aircraft.id, one.id] = of(condition, repeats)
                print(f"{aircraft.id} {one.id}".ljust(24), *(f"{ms:.2f}".rjust(22) for ms in times))
    return found


def of(condition: FlightCondition, repeats: int) -> list[float]:
    """Milliseconds of each kind at the speed and height of the condition."""
    plant = six_dof_of(condition)
    spec = TrimSpec(condition.reference.V, condition.reference.h)
    return [shortest(plant, spec._replace(**kind), repeats) for kind in KINDS.values()]


def shortest(plant: SixDof, spec: TrimSpec, repeats: int) -> float:
    """Of so many trims, in milliseconds: what else the computer does makes them only longer."""
    best = math.inf
    for _ in range(repeats):
        began = time.perf_counter()
        solve(plant, spec)
        best = min(best, 1e3 * (time.perf_counter() - began))
    return best


if __name__ == "__main__":
    main()
