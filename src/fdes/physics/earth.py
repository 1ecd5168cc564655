"""The Earth: flat, round, or the rotating ellipsoid WGS-84 with J2. One set of equations serves all three.

The Earth frame turns with the Earth. Of a round Earth it has its origin at the center, z through the north pole and x
through latitude and longitude zero; of a flat one it is north, east, down from a point at sea level. Nothing here
divides by the cosine of a latitude, so that position and attitude are right at the poles, and at the date line.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 1.6; NIMA TR8350.2,
World Geodetic System 1984, 3rd ed.; the figures of WGS-84 are those of NASA/TM-2015-218675, table 73.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import atan2, cos, sin, sqrt, where
from fdes.errors import SpecError
from fdes.physics.attitude import Quaternion, Rotation, Three, product
from fdes.units import G0, Meter, MeterPerSecond2, Number, Radian, RadianPerSecond


class Earth(NamedTuple):
    """The numbers of an Earth. `g` is the uniform gravity of a flat one; where it is zero, the Earth is round."""

    a: Meter
    flattening: Number
    GM: Annotated[float, "m^3/s^2"]
    J2: Number
    Omega: RadianPerSecond
    g: MeterPerSecond2


FLAT = Earth(a=0.0, flattening=0.0, GM=0.0, J2=0.0, Omega=0.0, g=G0)
ROUND = Earth(a=6371007.1809, flattening=0.0, GM=3.986004418e14, J2=0.0, Omega=0.0, g=0.0)
WGS84 = Earth(
    a=6378137.0, flattening=1.0 / 298.257223563, GM=3.986004418e14, J2=1.08262982e-3, Omega=7.292115e-5, g=0.0
)
EARTHS = {"flat": FLAT, "round": ROUND, "wgs84": WGS84}

SAME_AXES = Rotation(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


class Place(NamedTuple):
    """Where a point is: its height over sea level, and the rotation from north-east-down to the Earth frame."""

    h: Meter
    local: Rotation


def place(earth: Earth, x: Meter, y: Meter, z: Meter) -> Place:
    """The height of a point of the Earth frame, and its local axes."""
    return flat_place(earth, x, y, z) if earth.g else round_place(earth, x, y, z)


def flat_place(earth: Earth, x: Meter, y: Meter, z: Meter) -> Place:
    """That of a flat Earth."""
    return Place(-z, SAME_AXES)


def round_place(earth: Earth, x: Meter, y: Meter, z: Meter) -> Place:
    """That of a round Earth.

    B. R. Bowring, Survey Review 23 (1976) 323-327, in two rounds: to 1e-9 m from 10 km below to 1000 km above the
    ellipsoid, by sines and cosines, which do not know a pole.
    """
    a, f = earth.a, earth.flattening
    b, e2 = a * (1.0 - f), f * (2.0 - f)
    level = sqrt(x * x + y * y)
    s, c = z * a, level * b  # of the reduced latitude, but for a factor
    sin_lat, cos_lat = _direction(z + e2 / (1.0 - e2) * b * _cubed_sine(s, c), level - e2 * a * _cubed_sine(c, s))
    s, c = sin_lat * (1.0 - f), cos_lat
    sin_lat, cos_lat = _direction(z + e2 / (1.0 - e2) * b * _cubed_sine(s, c), level - e2 * a * _cubed_sine(c, s))
    h = level * cos_lat + z * sin_lat - a * sqrt(1.0 - e2 * sin_lat * sin_lat)
    away = where(level.real > 0.0, level, 1.0)
    cos_lon, sin_lon = where(level.real > 0.0, x / away, 1.0), y / away
    return Place(
        h,
        Rotation(
            -sin_lat * cos_lon, -sin_lon, -cos_lat * cos_lon,
            -sin_lat * sin_lon, cos_lon, -cos_lat * sin_lon,
            cos_lat, 0.0, -sin_lat,
        ),
    )  # fmt: skip


def _direction(s: float, c: float) -> tuple[float, float]:
    size = sqrt(s * s + c * c)
    return s / size, c / size


def _cubed_sine(s: float, c: float) -> float:
    squared = s * s + c * c
    cubed: float = s * s * s / (squared * sqrt(squared))
    return cubed


def gravitation(earth: Earth, x: Meter, y: Meter, z: Meter) -> Three:
    """The pull of the Earth at rest [m/s^2], in the Earth frame: the gradient of its potential. Sec. 1.6."""
    return flat_gravitation(earth, x, y, z) if earth.g else round_gravitation(earth, x, y, z)


def flat_gravitation(earth: Earth, x: Meter, y: Meter, z: Meter) -> Three:
    """That of a flat Earth."""
    return 0.0, 0.0, earth.g


def round_gravitation(earth: Earth, x: Meter, y: Meter, z: Meter) -> Three:
    """That of a round Earth."""
    r2 = x * x + y * y + z * z
    pull = -earth.GM / (r2 * sqrt(r2))
    bulge = 1.5 * earth.J2 * earth.a * earth.a / r2
    level = pull * (1.0 - bulge * (5.0 * z * z / r2 - 1.0))
    return level * x, level * y, pull * z * (1.0 - bulge * (5.0 * z * z / r2 - 3.0))


def potential(earth: Earth, x: Meter, y: Meter, z: Meter) -> Annotated[float, "m^2/s^2"]:
    """That of gravitation, growing upward [m^2/s^2]. Sec. 1.6."""
    if earth.g:
        return -earth.g * z
    r2 = x * x + y * y + z * z
    r = sqrt(r2)
    found: float = -earth.GM / r * (1.0 - 0.5 * earth.J2 * earth.a * earth.a / r2 * (3.0 * z * z / r2 - 1.0))
    return found


def geodetic(earth: Earth, x: Meter, y: Meter, z: Meter) -> tuple[Radian, Radian, Meter]:
    """Latitude, longitude from -pi to pi, and height. Raises SpecError for a flat Earth, which has no latitude."""
    _must_be_round(earth)
    h, local = place(earth, x, y, z)
    return atan2(-local.zz, local.zx), atan2(-local.xy, local.yy), h


def position(earth: Earth, latitude: Radian, longitude: Radian, h: Meter) -> Three:
    """The point of the Earth frame at that latitude, longitude and height. Sec. 1.6. Raises SpecError as `geodetic`."""
    _must_be_round(earth)
    e2 = earth.flattening * (2.0 - earth.flattening)
    N = earth.a / sqrt(1.0 - e2 * sin(latitude) * sin(latitude))
    level = (N + h) * cos(latitude)
    return level * cos(longitude), level * sin(longitude), (N * (1.0 - e2) + h) * sin(latitude)


def local_quaternion(latitude: Radian, longitude: Radian) -> Quaternion:
    """The rotation from north-east-down to the Earth frame: about z by the longitude, then about y."""
    half = -0.5 * (latitude + 0.5 * 3.141592653589793)
    about_z = Quaternion(cos(0.5 * longitude), 0.0, 0.0, sin(0.5 * longitude))
    return product(about_z, Quaternion(cos(half), 0.0, sin(half), 0.0))


def _must_be_round(earth: Earth) -> None:
    if earth.g:
        raise SpecError("A flat Earth has no latitude and longitude: use north and east in meters, or another Earth.")
