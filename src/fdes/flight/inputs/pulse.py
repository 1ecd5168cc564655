"""A pulse: its amplitude for a while, then nothing."""

from dataclasses import dataclass
from typing import Annotated

__all__ = ["Pulse"]


@dataclass(frozen=True)
class Pulse:
    """`amplitude` in the unit of its channel, from the time `at` [s], `lasting` [s] long."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 1.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        # Rounded, so that an edge that is meant for a frame falls on it: 0.1 + 0.2 > 0.3 in floating point.
        return self.amplitude if self.at <= t < round(self.at + self.lasting, 9) else 0.0
