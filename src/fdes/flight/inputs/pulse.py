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
        return self.amplitude if self.at <= t < self.at + self.lasting else 0.0
