"""A step: from zero to its amplitude, and there it stays."""

from dataclasses import dataclass
from typing import Annotated

__all__ = ["Step"]


@dataclass(frozen=True)
class Step:
    """`amplitude` in the unit of its channel, from the time `at` [s] on."""

    amplitude: float
    at: Annotated[float, "s"] = 0.0

    def __call__(self, t: float) -> float:
        """The value at `t` [s]."""
        return self.amplitude if t >= self.at else 0.0
