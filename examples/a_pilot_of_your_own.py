"""A pilot is anything that gives a stick for a time: this one banks, holds the bank, and rolls out."""

from math import degrees
from pathlib import Path

import fdes
from fdes.control.laws.direct import Direct
from fdes.flight import Clock, Recorder, Setup, SteadyAir, Stick

navion = fdes.load("NAVION").at()


def pilot(t: float) -> Stick:
    """Half right stick for a second, and four seconds later half left stick."""
    roll = 0.5 if 1.0 <= t < 2.0 else -0.5 if 6.0 <= t < 7.0 else 0.0
    return Stick(roll=roll, throttle=navion.trim_throttle)


plant = fdes.plant_of(navion)
recorder = Recorder(Path("banked.fdes"), type(plant.start()), {"dt": 1 / 120, "aircraft": navion.aircraft_id})
setup = Setup(plant, Direct(navion.full_stick))
for frame in fdes.fly(plant.start(), setup, pilot, SteadyAir(), Clock(1 / 120, duration=10.0)):
    recorder.append(frame)
recorder.close()
flight = fdes.open_recording("banked.fdes")
print(f"bank at 5 s {degrees(flight['phi'][600]):.1f} deg, heading at the end {degrees(flight['psi'][-1]):.1f} deg")
