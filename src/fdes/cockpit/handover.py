"""Bumpless handover: where a law takes over, the surfaces go from where they were to where it wants them, not at once.

What the old law commanded more than the new one is added to the command and faded out within `LASTING`; where actuators
are switched off, so is what the surfaces were behind the command. It counts as something put in, like a test input, so
that a recording holds it and a flight flown again has it too.
"""

from typing import NamedTuple

from fdes.control import Law
from fdes.control.law import alike
from fdes.flight import Frame
from fdes.physics.signals import Surfaces

LASTING = 0.5  # s
NOTHING = Surfaces()


class Handover(NamedTuple):
    """`offset` [rad] at `begin` [s], faded out along a straight line."""

    begin: float
    offset: Surfaces

    def __call__(self, t: float) -> Surfaces:
        """What is left of the offset at `t` [s]."""
        left = 1.0 - (t - self.begin) / LASTING
        if left <= 0.0:
            return NOTHING
        elevator, aileron, rudder, _ = self.offset
        return Surfaces(left * elevator, left * aileron, left * rudder)


def handover(last: Frame, before: Law, law: Law, fading: Surfaces, dt: float, left: Surfaces | None = None) -> Handover:
    """From what was commanded in the `last` frame, by the law `before`, to what `law` would have commanded there.

    `fading` is what remained in that frame of another handover; `dt` [s] is the length of a frame. `left` is where the
    surfaces are, if not at that command, as actuators that are switched off leave them.
    """
    y, stick = last.outputs, last.stick
    memory = last.memory if alike(law, before) else law.start(y, stick)
    wanted, _ = law.step(y, stick, memory, dt)
    offset = (
        command - put_in + more - want
        for command, put_in, more, want in zip(left or last.command, last.excitation, fading, wanted, strict=True)
    )
    return Handover(last.t + dt, Surfaces(*offset))


OVER = Handover(-LASTING, NOTHING)
