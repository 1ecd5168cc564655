"""What a step of each plant costs in the plain form, by aircraft, and how many pilots a core carries.

    python benchmarks/plants.py

CPU time, the best of several runs. A tick of the cockpit is a step, the outputs, the law and, every other time, a frame
for the page; recording and the network come on top.
"""

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from fdes.aircraft import load
from fdes.cockpit.craft import DT, Craft, make_craft
from fdes.cockpit.session import Session
from fdes.physics.signals import Air

AIRCRAFT = ("A-4D", "F-104A", "NAVION", "Convair880", "B747", "Jetstar", "F-16")
RUNS, TIMES = 5, 300


def main() -> None:
    """Measure and print the table."""
    print(f"{'aircraft':12}{'plant':12}{'step, us':>9}{'tick, us':>9}{'pilots a core':>15}")
    for name in AIRCRAFT:
        for plant in ("linear", "nonlinear"):
            craft = make_craft(load(name).at(), plant=plant)
            step, tick = least(stepping(craft)), least(ticking(craft))
            print(f"{name:12}{plant:12}{1e6 * step:9.0f}{1e6 * tick:9.0f}{DT / tick:15.0f}")


def stepping(craft: Craft) -> Callable[[], object]:
    """One step of the integrator from undisturbed flight."""
    plant, air = craft.setup.plant, Air()
    held = plant.trim()
    return lambda: plant.advance(craft.start, held, air, DT, 1)


def ticking(craft: Craft) -> Callable[[], object]:
    """One tick of a session that is watched."""
    session = Session("benchmark", craft, Path(tempfile.gettempdir()), record=False)
    session.watched = True
    numbers = iter(range(RUNS * TIMES))
    return lambda: session.tick(next(numbers), late=False)


def least(work: Callable[[], object]) -> float:
    """CPU time of one call [s]."""
    found = []
    for _ in range(RUNS):
        began = time.process_time()
        for _ in range(TIMES):
            work()
        found.append((time.process_time() - began) / TIMES)
    return min(found)


if __name__ == "__main__":
    main()
