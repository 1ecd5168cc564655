"""The discrete gust of MIL-F-8785C: half a cosine up to its amplitude, and there it stays.

Reference: MIL-F-8785C, 3.7.1.3. Half its wavelength, d_m there, is `lasting` times the airspeed.
"""

from dataclasses import dataclass
from math import cos, pi
from typing import Annotated

__all__ = ["OneMinusCosine"]


@dataclass(frozen=True)
class OneMinusCosine:
    """`amplitude` in the unit of its channel, begun at the time `at` [s] and reached `lasting` [s] later."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 1.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        risen = min(max((t - self.at) / self.lasting, 0.0), 1.0)
        return self.amplitude * 0.5 * (1.0 - cos(pi * risen))
