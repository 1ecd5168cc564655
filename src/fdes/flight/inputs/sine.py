"""A sine wave."""

from dataclasses import dataclass
from math import inf, pi, sin
from typing import Annotated

__all__ = ["Sine"]


@dataclass(frozen=True)
class Sine:
    """`amplitude` in the unit of its channel, of the `period` [s], from `at` [s] on, `lasting` [s] long or for good."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    period: Annotated[float, "s"] = 1.0
    lasting: Annotated[float, "s"] = inf

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        since = t - self.at
        return self.amplitude * sin(2.0 * pi * since / self.period) if 0.0 <= since < self.lasting else 0.0
