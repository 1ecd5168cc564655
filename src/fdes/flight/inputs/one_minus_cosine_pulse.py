"""The discrete gust of the certification rules: a whole cosine, from zero to its amplitude and back.

Reference: 14 CFR 25.341(a)(2). Twice its gradient distance, 2H there, is `lasting` times the airspeed.
"""

from dataclasses import dataclass
from math import cos, pi
from typing import Annotated

__all__ = ["OneMinusCosinePulse"]


@dataclass(frozen=True)
class OneMinusCosinePulse:
    """`amplitude`, the value in the middle, in the unit of its channel; from `at` [s] on, `lasting` [s] long."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 1.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        passed = (t - self.at) / self.lasting
        return self.amplitude * 0.5 * (1.0 - cos(2.0 * pi * passed)) if 0.0 <= passed < 1.0 else 0.0
