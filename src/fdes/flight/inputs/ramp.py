"""A ramp: from zero to its amplitude at a steady rate, and there it stays."""

from dataclasses import dataclass
from typing import Annotated

__all__ = ["Ramp"]


@dataclass(frozen=True)
class Ramp:
    """`amplitude` in the unit of its channel, begun at the time `at` [s] and reached `lasting` [s] later."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0
    lasting: Annotated[float, "s"] = 1.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        return self.amplitude * min(max((t - self.at) / self.lasting, 0.0), 1.0)
