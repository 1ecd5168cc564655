"""The stick moves the surfaces: the aircraft as it is."""

from dataclasses import dataclass

from fdes.control.law import Stick, proportional
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces

__all__ = ["Direct"]


@dataclass(frozen=True)
class Direct:
    """Each surface in proportion to its control. `full_stick` is where full aft, right, right pedal puts them [rad]."""

    full_stick: Surfaces

    def start(self, y: Outputs, stick: Stick) -> None:
        """Nothing to remember."""

    def step(self, y: Outputs, stick: Stick, memory: None, dt: float) -> tuple[Surfaces, None]:
        """Surfaces for this stick."""
        full = self.full_stick
        elevator, aileron, rudder = full.elevator * stick.pitch, full.aileron * stick.roll, full.rudder * stick.yaw
        return Surfaces(elevator, aileron, rudder, stick.throttle), None

    def linear(self, dt: float | None = None) -> LinearModel:
        """Four gains."""
        full = self.full_stick
        return proportional(
            {
                "elevator": ("stick_pitch", full.elevator),
                "aileron": ("stick_roll", full.aileron),
                "rudder": ("stick_yaw", full.rudder),
                "throttle": ("stick_throttle", 1.0),
            },
            dt,
        )
