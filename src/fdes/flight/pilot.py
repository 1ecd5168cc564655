"""Who holds the stick. A pilot is anything that gives a Stick for a time; these are the simple ones."""

from collections.abc import Sequence
from dataclasses import dataclass

from fdes.control import Stick


@dataclass(frozen=True)
class HandsOff:
    """Stick and pedals centered, the throttle lever where it is."""

    throttle: float

    def __call__(self, t: float) -> Stick:
        """The same stick at every `t`."""
        return Stick(throttle=self.throttle)


@dataclass(frozen=True)
class SameStick:
    """A stick flown before, frame by frame, `dt` [s] apart: what a recording is flown again with."""

    sticks: Sequence[Stick]
    dt: float

    def __call__(self, t: float) -> Stick:
        """The stick of the frame at `t` [s]; after the last one, the last."""
        return self.sticks[min(round(t / self.dt), len(self.sticks) - 1)]
