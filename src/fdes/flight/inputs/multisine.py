"""A multisine: the harmonics of one period together, their phases chosen so that the peaks stay low.

Reference: M. R. Schroeder, IEEE Trans. Information Theory IT-16 (1970) 85-89, eq. 11 for a flat spectrum.
"""

from dataclasses import dataclass
from functools import cache
from math import cos, pi
from typing import Annotated

__all__ = ["Multisine"]

HARMONICS = 8


@dataclass(frozen=True)
class Multisine:
    """`amplitude`, the largest value, in the unit of its channel; from the time `at` [s], `lasting` [s] long, with the
    `period` [s] of the lowest of eight harmonics.
    """

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 10.0
    period: Annotated[float, "s"] = 10.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        since = t - self.at
        if not 0.0 <= since < self.lasting:
            return 0.0
        zero, peak = _zero_and_peak()
        return self.amplitude * _wave(since / self.period + zero) / peak


def _wave(turns: float) -> float:
    return sum(cos(2.0 * pi * k * turns - pi * k * (k - 1) / HARMONICS) for k in range(1, HARMONICS + 1))


@cache
def _zero_and_peak() -> tuple[float, float]:
    """Where in its period the wave crosses zero, so that it starts without a jump, and its largest value."""
    n = 4096
    samples = [_wave(i / n) for i in range(n)]
    low = next(i for i in range(n - 1) if samples[i] < 0.0 <= samples[i + 1]) / n
    high = low + 1.0 / n
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _wave(middle) < 0.0 else (low, middle)
    return high, max(abs(s) for s in samples) * (1.0 + 1e-5)
