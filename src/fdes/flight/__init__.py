"""Flying: the loop, the clock, who holds the stick, what is put in, and what is recorded.

Read `simulation` first: `fly` is the whole of it. `plants` makes what flies, `excitation` the test inputs, `recorder`
and `recording` write and read the flight.
"""

from fdes.control import Stick
from fdes.flight.excitation import Excitation, GustyAir
from fdes.flight.pilot import HandsOff, SameStick
from fdes.flight.plants import integrator_names, plant_of
from fdes.flight.recorder import Recorder
from fdes.flight.recording import Recording, list_recordings, open_recording
from fdes.flight.response import simulate
from fdes.flight.simulation import Clock, Edit, Frame, Setup, SteadyAir, fly
from fdes.flight.trajectory import trajectory

__all__ = [
    "Clock",
    "Edit",
    "Excitation",
    "Frame",
    "GustyAir",
    "HandsOff",
    "Recorder",
    "Recording",
    "SameStick",
    "Setup",
    "SteadyAir",
    "Stick",
    "fly",
    "integrator_names",
    "list_recordings",
    "open_recording",
    "plant_of",
    "simulate",
    "trajectory",
]
