"""Pitch rate to elevator: the simple pitch damper."""

from dataclasses import dataclass
from typing import Annotated, Any

from fdes.control.law import Law, Stick, with_loop
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces

__all__ = ["PitchRateDamper"]


@dataclass(frozen=True)
class PitchRateDamper:
    """elevator = what the law inside commands + gain q. A positive gain adds to -M_q and damps the short period.

    The stick still moves the elevator; the damper opposes the pitch rate that the pilot asks for as well, so that a
    steady pull-up needs more stick. Without memory: switched on while the aircraft pitches, it moves the elevator by
    gain q at once.
    """

    inner: Law
    gain: Annotated[float, "rad/(rad/s)"]

    def start(self, y: Outputs, stick: Stick) -> Any:
        """What the law inside remembers."""
        return self.inner.start(y, stick)

    def step(self, y: Outputs, stick: Stick, memory: Any, dt: float) -> tuple[Surfaces, Any]:
        """Elevator down while the nose goes up."""
        command, memory = self.inner.step(y, stick, memory, dt)
        return command._replace(elevator=command.elevator + self.gain * y.q), memory

    def linear(self, dt: float | None = None) -> LinearModel:
        """One gain more."""
        return with_loop(self.inner.linear(dt), {"q": self.gain}, "elevator")
