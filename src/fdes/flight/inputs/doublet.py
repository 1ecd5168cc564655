"""A doublet: its amplitude one way, then as long the other way, then nothing."""

from dataclasses import dataclass
from typing import Annotated

__all__ = ["Doublet"]


@dataclass(frozen=True)
class Doublet:
    """`amplitude` in the unit of its channel, from the time `at` [s]; both halves together are `lasting` [s] long."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 2.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        # Rounded, so that an edge that is meant for a frame falls on it: 0.1 + 0.2 > 0.3 in floating point.
        middle, end = round(self.at + 0.5 * self.lasting, 9), round(self.at + self.lasting, 9)
        if self.at <= t < middle:
            return self.amplitude
        return -self.amplitude if middle <= t < end else 0.0
