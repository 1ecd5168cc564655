"""A frequency sweep: a sine whose frequency grows exponentially, so that every octave gets the same time.

Reference: M. B. Tischler, R. K. Remple, Aircraft and Rotorcraft System Identification, 2nd ed., AIAA, section 5.11.
"""

from dataclasses import dataclass
from math import expm1, log, pi, sin
from typing import Annotated

__all__ = ["Sweep"]


@dataclass(frozen=True)
class Sweep:
    """`amplitude` in the unit of its channel, from the time `at` [s], `lasting` [s] long, from a wave of the period
    `slowest` [s] to one of the period `fastest` [s].
    """

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 60.0
    slowest: Annotated[float, "s"] = 20.0
    fastest: Annotated[float, "s"] = 0.5

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        since = t - self.at
        if not 0.0 <= since < self.lasting:
            return 0.0
        octaves = log(self.slowest / self.fastest)
        if octaves == 0.0:
            cycles = since / self.slowest
        else:
            cycles = self.lasting / (self.slowest * octaves) * expm1(octaves * since / self.lasting)
        return self.amplitude * sin(2.0 * pi * cycles)
