"""A 3-2-1-1: four alternating pulses whose lengths are as 3, 2, 1, 1, the classical input for identification.

Reference: R. V. Jategaonkar, Flight Vehicle System Identification, AIAA 2006, section 2.3.
"""

from dataclasses import dataclass
from typing import Annotated

__all__ = ["ThreeTwoOneOne"]


@dataclass(frozen=True)
class ThreeTwoOneOne:
    """`amplitude` in the unit of its channel, from `at` [s] on; all seven units together are `lasting` [s] long."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 7.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        # Rounded, so that an edge that is meant for a frame falls on it: 0.1 + 0.2 > 0.3 in floating point.
        units = round(7.0 * (t - self.at) / self.lasting, 9)
        if not 0.0 <= units < 7.0:
            return 0.0
        return self.amplitude if units < 3.0 or 5.0 <= units < 6.0 else -self.amplitude
