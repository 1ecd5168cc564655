"""One airspeed in all its forms: Mach number, true, equivalent and calibrated airspeed at an altitude.

>>> from fdes.units import KNOT
>>> [round(speed / KNOT, 1) for speed in airspeeds("mach", 0.8, 11000.0)[1:]]
[459.0, 250.5, 265.6]
"""

from math import isfinite
from typing import Annotated, NamedTuple

from fdes.errors import NoSuchPart, SpecError
from fdes.physics.airdata import calibrated_airspeed, equivalent_airspeed, impact_pressure
from fdes.physics.atmosphere import standard_atmosphere
from fdes.units import Meter, MeterPerSecond, Number

FASTEST = 5.0  # Mach number
HALVINGS = 60


class Airspeeds(NamedTuple):
    """The same flight in four words."""

    mach: Annotated[Number, "Mach number"]
    tas: Annotated[MeterPerSecond, "true airspeed"]
    eas: Annotated[MeterPerSecond, "equivalent airspeed"]
    cas: Annotated[MeterPerSecond, "calibrated airspeed: what an indicator without errors shows"]


def airspeeds(kind: str, value: float, h: Meter) -> Airspeeds:
    """All airspeeds in the standard atmosphere at `h` [m], from one: `kind` is ``mach``, ``tas``, ``eas``, ``cas``.

    Raises NoSuchPart for another kind, SpecError for a negative or too high speed, or a height without an atmosphere.
    """
    air = standard_atmosphere(h)
    if kind not in Airspeeds._fields:
        raise NoSuchPart("airspeed", kind, Airspeeds._fields)
    if not (isfinite(value) and value >= 0.0):
        raise SpecError(f"An airspeed is a number from zero up; {value:g} is none.")
    match kind:
        case "mach":
            mach = value
        case "tas":
            mach = value / air.a
        case "eas":
            mach = value / equivalent_airspeed(air.a, air.rho)
        case _:
            mach = _mach_of_calibrated(value, air.p)
    if mach > FASTEST:
        raise SpecError(f"That is Mach {mach:.3g}; the formulas are used up to Mach {FASTEST:g}.")
    V = mach * air.a
    return Airspeeds(mach, V, equivalent_airspeed(V, air.rho), calibrated_airspeed(impact_pressure(mach, air.p)))


def _mach_of_calibrated(cas: MeterPerSecond, p: float) -> float:
    """By halving, for the supersonic formula has no inverse in closed form. Infinite beyond `FASTEST`."""
    low, high = 0.0, FASTEST
    if cas > calibrated_airspeed(impact_pressure(high, p)):
        return float("inf")
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if calibrated_airspeed(impact_pressure(middle, p)) < cas:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
