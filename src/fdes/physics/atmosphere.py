"""The US Standard Atmosphere 1976, to 86 km, and days that are warmer or colder.

Reference: U.S. Standard Atmosphere, 1976, NOAA-S/T 76-1562, part 1, tables 3 and 4 and equations 18, 33a, 33b, 42, 50.
"""

from typing import NamedTuple

from fdes.elementary import exp, pow, sqrt, where
from fdes.errors import SpecError
from fdes.units import Kelvin, KilogramPerMeter3, Meter, MeterPerSecond, Pascal

R_AIR = 8314.32 / 28.9644  # J/(kg K), eq. 33a constants: R* and M0
GAMMA_AIR = 1.4  # eq. 50
G_STANDARD = 9.80665  # m/s^2
R_EARTH = 6356766.0  # m, the radius that the standard uses for geopotential height, eq. 18
P0: Pascal = 101325.0
T0: Kelvin = 288.15
RHO0: KilogramPerMeter3 = P0 / (R_AIR * T0)
A0: MeterPerSecond = sqrt(GAMMA_AIR * R_AIR * T0)

# Table 4: geopotential height at the base of the layer [m], temperature gradient in it [K/m].
_LAYERS = (
    (0.0, -0.0065),
    (11000.0, 0.0),
    (20000.0, 0.001),
    (32000.0, 0.0028),
    (47000.0, 0.0),
    (51000.0, -0.0028),
    (71000.0, -0.002),
)
BOTTOM: Meter = -5000.0
TOP: Meter = 86000.0


class Atmosphere(NamedTuple):
    """Still air at one height."""

    T: Kelvin
    p: Pascal
    rho: KilogramPerMeter3
    a: MeterPerSecond


def standard_atmosphere(h: Meter, warmer: Kelvin = 0.0) -> Atmosphere:
    """The air at geometric height `h` above mean sea level, -5 km to 86 km. Raises SpecError outside.

    On a day that is not standard the temperature is higher by `warmer` at all heights, and the pressure at a height is
    that of the standard day, as for the pressure altitudes of ISO 2533 and of flight manuals.
    """
    if not BOTTOM <= h.real <= TOP:
        raise SpecError(f"The standard atmosphere reaches from -5,000 m to 86,000 m; height {h:,.0f} m is outside it.")
    return air_at(h, warmer)


def _at_bases() -> tuple[tuple[float, float, float, float], ...]:
    """Height, gradient, temperature and pressure at the base of each layer, from one to the next."""
    rows = [(*_LAYERS[0], T0, P0)]
    for base, lapse in _LAYERS[1:]:
        air = _in_layer(*rows[-1], base)
        rows.append((base, lapse, air[0], air[1]))
    return tuple(rows)


def _in_layer(base: Meter, lapse: float, T_base: Kelvin, p_base: Pascal, H: Meter) -> tuple[Kelvin, Pascal]:
    """Temperature and pressure at the geopotential height `H`; both kinds of layer are computed, and one is taken."""
    T = T_base + lapse * (H - base)
    even = exp(-G_STANDARD * (H - base) / (R_AIR * T_base))  # eq. 33b
    gradient = where(lapse == 0.0, 1.0, lapse)
    sloped = pow(T_base / T, G_STANDARD / (R_AIR * gradient))  # eq. 33a
    return T, p_base * where(lapse == 0.0, even, sloped)


_BASES = _at_bases()


def air_at(h: Meter, warmer: Kelvin) -> Atmosphere:
    """As `standard_atmosphere`, unchecked and without a branch, so that many aircraft can be computed at once."""
    H = R_EARTH * h / (R_EARTH + h)  # eq. 18, geopotential height
    base, lapse, T, p = _BASES[0]
    for row in _BASES[1:]:
        above = H.real >= row[0]
        base, lapse = where(above, row[0], base), where(above, row[1], lapse)
        T, p = where(above, row[2], T), where(above, row[3], p)
    T, p = _in_layer(base, lapse, T, p, H)
    T += warmer
    return Atmosphere(T, p, p / (R_AIR * T), sqrt(GAMMA_AIR * R_AIR * T))  # eq. 42, 50
