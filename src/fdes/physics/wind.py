"""Wind that blows steadily, or grows linearly with height.

`Air` carries the wind of one frame; a `Wind` is what a scenario says of it. Components are those of the velocity of the
air over the ground: wind from the west has a positive east component.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import cos, sin
from fdes.units import Meter, MeterPerSecond, Radian

PerSecond = Annotated[float, "1/s"]


class Wind(NamedTuple):
    """The velocity at sea level, and how much of it each meter of height adds."""

    north: MeterPerSecond = 0.0
    east: MeterPerSecond = 0.0
    down: MeterPerSecond = 0.0
    shear_north: PerSecond = 0.0
    shear_east: PerSecond = 0.0


def wind_at(wind: Wind, h: Meter) -> tuple[MeterPerSecond, MeterPerSecond, MeterPerSecond]:
    """North, east and down at height `h`."""
    return wind.north + wind.shear_north * h, wind.east + wind.shear_east * h, wind.down


def wind_from(direction: Radian, speed: MeterPerSecond, shear: PerSecond = 0.0) -> Wind:
    """The wind that blows from `direction`, with `speed` at sea level and `shear` more for each meter of height."""
    north, east = -cos(direction), -sin(direction)
    return Wind(speed * north, speed * east, 0.0, shear * north, shear * east)
