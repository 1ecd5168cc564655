"""Pitch rate commanded by the stick, held by a proportional and integral controller on the elevator."""

from dataclasses import dataclass
from math import inf
from typing import Annotated, Any, NamedTuple

from fdes.control.blocks import PI
from fdes.control.law import Law, Stick, with_loop, with_stick_held
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces
from fdes.units import Radian, RadianPerSecond

__all__ = ["PitchRatePi"]


class Memory(NamedTuple):
    """What the law inside remembers, and the integral's part of the elevator [rad]."""

    inner: Any
    integral: float


@dataclass(frozen=True)
class PitchRatePi:
    """elevator = (gain + integral_gain / s) (q - q wanted). Positive gains damp, and hold the rate that is wanted.

    The stick commands a pitch rate, `full_rate` at full aft stick, and no elevator of its own; centered, it holds the
    attitude. The integral stops while the elevator is at `lower` or `upper`. It starts with the elevator where it is,
    where no law inside moves that too.
    """

    inner: Law
    gain: Annotated[float, "rad/(rad/s)"]
    integral_gain: Annotated[float, "rad/rad"]
    full_rate: RadianPerSecond
    lower: Radian = -inf
    upper: Radian = inf

    def start(self, y: Outputs, stick: Stick) -> Memory:
        """The integral takes over the elevator that is."""
        return Memory(
            self.inner.start(y, _without_pitch(stick)), self._controller().start(self._error(y, stick), y.elevator)
        )

    def step(self, y: Outputs, stick: Stick, memory: Memory, dt: float) -> tuple[Surfaces, Memory]:
        """Elevator down while the nose goes up faster than wanted."""
        command, inner = self.inner.step(y, _without_pitch(stick), memory.inner, dt)
        elevator, integral = self._controller().step(self._error(y, stick), memory.integral, dt)
        return command._replace(elevator=command.elevator + elevator), Memory(inner, integral)

    def linear(self, dt: float | None = None) -> LinearModel:
        """Two gains and one state more, and the stick in a new role."""
        inner = with_stick_held(self.inner.linear(dt), "stick_pitch")
        error = {"q": 1.0, "stick_pitch": -self.full_rate}
        return with_loop(inner, error, "elevator", self._controller().linear(dt), {"pitch_integral": "rad"})

    def _controller(self) -> PI:
        return PI(self.gain, self.integral_gain, self.lower, self.upper)

    def _error(self, y: Outputs, stick: Stick) -> float:
        return y.q - self.full_rate * stick.pitch


def _without_pitch(stick: Stick) -> Stick:
    return stick._replace(pitch=0.0)
