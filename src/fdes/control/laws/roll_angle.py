"""Bank angle commanded by the stick, held by the ailerons."""

from dataclasses import dataclass
from typing import Annotated, Any

from fdes.control.law import Law, Stick, with_loop, with_stick_held
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces
from fdes.units import DEG, Radian

__all__ = ["RollAngle"]


@dataclass(frozen=True)
class RollAngle:
    """aileron = gain (bank wanted - phi) - rate_gain p. Positive gains hold the bank and damp the roll.

    The stick commands a bank angle, `full_bank` at full right stick, and no aileron of its own; centered, it levels the
    wings. Without memory: switched on in a bank with the stick centered, it begins to roll out at once.
    """

    inner: Law
    gain: Annotated[float, "rad/rad"]
    rate_gain: Annotated[float, "rad/(rad/s)"] = 0.0
    full_bank: Radian = 60.0 * DEG

    def start(self, y: Outputs, stick: Stick) -> Any:
        """What the law inside remembers."""
        return self.inner.start(y, stick._replace(roll=0.0))

    def step(self, y: Outputs, stick: Stick, memory: Any, dt: float) -> tuple[Surfaces, Any]:
        """Ailerons toward the bank that is wanted."""
        command, memory = self.inner.step(y, stick._replace(roll=0.0), memory, dt)
        aileron = self.gain * (self.full_bank * stick.roll - y.phi) - self.rate_gain * y.p
        return command._replace(aileron=command.aileron + aileron), memory

    def linear(self, dt: float | None = None) -> LinearModel:
        """Two gains more, and the stick in a new role."""
        inner = with_stick_held(self.inner.linear(dt), "stick_roll")
        gains = {"phi": -self.gain, "p": -self.rate_gain, "stick_roll": self.gain * self.full_bank}
        return with_loop(inner, gains, "aileron")
