"""The contract of a control law: from stick and outputs to surfaces, once per frame, memory passed through.

A law is a frozen dataclass without state of its own. What it remembers it hands back and is handed again, so that a
flight can be reset, branched and replayed by keeping a value.
"""

from typing import Annotated, Any, NamedTuple, Protocol

from fdes.physics.signals import Outputs, Surfaces
from fdes.units import Number


class Stick(NamedTuple):
    """The pilot's controls, in no aircraft's units: -1 to 1, throttle 0 to 1."""

    pitch: Annotated[Number, "stick, aft positive"] = 0.0
    roll: Annotated[Number, "stick, right positive"] = 0.0
    yaw: Annotated[Number, "pedals, right positive"] = 0.0
    throttle: Annotated[Number, "throttle lever"] = 0.0


class Law(Protocol):
    """What a control law offers."""

    def start(self, y: Outputs, stick: Stick) -> Any:
        """The memory with which the law takes over at outputs `y` without a bump."""
        ...

    def step(self, y: Outputs, stick: Stick, memory: Any, dt: float) -> tuple[Surfaces, Any]:
        """The surfaces to command for the frame of length `dt` [s] that begins now, and the memory for the next."""
        ...
