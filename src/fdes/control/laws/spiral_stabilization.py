"""Yaw rate to ailerons: a spiral mode that comes back."""

from dataclasses import dataclass
from typing import Annotated, Any

from fdes.control.law import Law, Stick, with_loop
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces

__all__ = ["SpiralStabilization"]


@dataclass(frozen=True)
class SpiralStabilization:
    """aileron = what the law inside commands - gain r. A positive gain lessens L_r, the roll due to yaw rate.

    That is what drives the spiral: it is stable where L_beta N_r > N_beta L_r (Nelson, Flight Stability and Automatic
    Control, 2nd ed., section 5.3), and the loop makes L_r - gain L_da of L_r. The stick still moves the ailerons, but
    a steady turn now needs some held into it. Without memory.
    """

    inner: Law
    gain: Annotated[float, "rad/(rad/s)"]

    def start(self, y: Outputs, stick: Stick) -> Any:
        """What the law inside remembers."""
        return self.inner.start(y, stick)

    def step(self, y: Outputs, stick: Stick, memory: Any, dt: float) -> tuple[Surfaces, Any]:
        """Left aileron while turning right."""
        command, memory = self.inner.step(y, stick, memory, dt)
        return command._replace(aileron=command.aileron - self.gain * y.r), memory

    def linear(self, dt: float | None = None) -> LinearModel:
        """One gain more."""
        return with_loop(self.inner.linear(dt), {"r": -self.gain}, "aileron")
