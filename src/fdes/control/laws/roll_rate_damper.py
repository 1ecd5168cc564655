"""Roll rate to ailerons: the roll damper."""

from dataclasses import dataclass
from typing import Annotated, Any

from fdes.control.law import Law, Stick, with_loop
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces

__all__ = ["RollRateDamper"]


@dataclass(frozen=True)
class RollRateDamper:
    """aileron = what the law inside commands - gain p. A positive gain adds to -L_p and quickens the roll mode.

    Rolling alone, the time constant becomes 1 / (-L_p + gain L_da). The stick still moves the ailerons; the steady roll
    rate it gives becomes smaller by the same factor as the time constant. Without memory.
    """

    inner: Law
    gain: Annotated[float, "rad/(rad/s)"]

    def start(self, y: Outputs, stick: Stick) -> Any:
        """What the law inside remembers."""
        return self.inner.start(y, stick)

    def step(self, y: Outputs, stick: Stick, memory: Any, dt: float) -> tuple[Surfaces, Any]:
        """Left aileron while rolling right."""
        command, memory = self.inner.step(y, stick, memory, dt)
        return command._replace(aileron=command.aileron - self.gain * y.p), memory

    def linear(self, dt: float | None = None) -> LinearModel:
        """One gain more."""
        return with_loop(self.inner.linear(dt), {"p": -self.gain}, "aileron")
