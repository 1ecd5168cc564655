"""Washed-out yaw rate to rudder: the yaw damper."""

from dataclasses import dataclass
from typing import Annotated, Any, NamedTuple

from fdes.control.blocks import StateSpace, Washout
from fdes.control.law import Law, Stick, with_loop
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces
from fdes.units import Second

__all__ = ["YawDamper"]


class Memory(NamedTuple):
    """What the law inside remembers, and the washout."""

    inner: Any
    washout: float


@dataclass(frozen=True)
class YawDamper:
    """rudder = what the law inside commands + gain r, r washed out. A positive gain damps the Dutch roll.

    A steady turn has a steady yaw rate, which a damper must not fight: the washout forgets what lasts longer than its
    time constant, 3 s unless said otherwise. Started in a turn it takes the turn for steady, and the rudder stays
    where it is. The pedals still move the rudder.
    """

    inner: Law
    gain: Annotated[float, "rad/(rad/s)"]
    washout: Second = 3.0

    def start(self, y: Outputs, stick: Stick) -> Memory:
        """At rest at the present yaw rate."""
        return Memory(self.inner.start(y, stick), Washout(self.washout).start(y.r))

    def step(self, y: Outputs, stick: Stick, memory: Memory, dt: float) -> tuple[Surfaces, Memory]:
        """Left rudder while the nose goes right."""
        command, inner = self.inner.step(y, stick, memory.inner, dt)
        swing, washout = Washout(self.washout).step(y.r, memory.washout, dt)
        return command._replace(rudder=command.rudder + self.gain * swing), Memory(inner, washout)

    def linear(self, dt: float | None = None) -> LinearModel:
        """One gain and one state more."""
        A, B, C, D = Washout(self.washout).linear(dt)
        swing = StateSpace(A, B, self.gain * C, self.gain * D)
        return with_loop(self.inner.linear(dt), {"r": 1.0}, "rudder", swing, {"yaw_washout": "rad/s"})
