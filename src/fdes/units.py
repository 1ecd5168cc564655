"""Units at the edges: multipliers to SI, reading "15 deg", and the labels that tables carry.

Inside, every number is SI and radians. A unit label is ASCII: ``m/s``, ``rad/s``, ``slug ft^2``.

>>> parse("170 kt", "m/s")
87.45555555555556
>>> 15 * DEG
0.2617993877991494
"""

import math
import re
from collections.abc import Iterable
from typing import Annotated

from fdes.errors import SpecError, nearest

Radian = Annotated[float, "rad"]
RadianPerSecond = Annotated[float, "rad/s"]
RadianPerSecond2 = Annotated[float, "rad/s^2"]
Meter = Annotated[float, "m"]
MeterPerSecond = Annotated[float, "m/s"]
MeterPerSecond2 = Annotated[float, "m/s^2"]
Second = Annotated[float, "s"]
Kilogram = Annotated[float, "kg"]
KilogramMeter2 = Annotated[float, "kg m^2"]
KilogramPerMeter3 = Annotated[float, "kg/m^3"]
Meter2 = Annotated[float, "m^2"]
Newton = Annotated[float, "N"]
Pascal = Annotated[float, "Pa"]
Kelvin = Annotated[float, "K"]
Number = Annotated[float, "1"]
PerRadian = Annotated[float, "1/rad"]

# Exact by definition: international foot and pound (1959), nautical mile (1929), standard gravity (CGPM 1901).
FOOT = 0.3048
POUND_MASS = 0.45359237
G0 = 9.80665
POUND_FORCE = POUND_MASS * G0
SLUG = POUND_FORCE / FOOT
KNOT = 1852.0 / 3600.0
DEG = math.pi / 180.0

# label -> (SI label, multiplier)
_TO_SI: dict[str, tuple[str, float]] = {
    "1": ("1", 1.0),
    "1/rad": ("1/rad", 1.0),
    "1/deg": ("1/rad", 1.0 / DEG),
    "rad": ("rad", 1.0),
    "deg": ("rad", DEG),
    "rad/s": ("rad/s", 1.0),
    "deg/s": ("rad/s", DEG),
    "s": ("s", 1.0),
    "ms": ("s", 1e-3),
    "min": ("s", 60.0),
    "m": ("m", 1.0),
    "km": ("m", 1000.0),
    "ft": ("m", FOOT),
    "nmi": ("m", 1852.0),
    "m/s": ("m/s", 1.0),
    "ft/s": ("m/s", FOOT),
    "ft/min": ("m/s", FOOT / 60.0),
    "kt": ("m/s", KNOT),
    "km/h": ("m/s", 1.0 / 3.6),
    "m/s^2": ("m/s^2", 1.0),
    "ft/s^2": ("m/s^2", FOOT),
    "m^2": ("m^2", 1.0),
    "ft^2": ("m^2", FOOT**2),
    "kg": ("kg", 1.0),
    "lb": ("kg", POUND_MASS),
    "slug": ("kg", SLUG),
    "kg m^2": ("kg m^2", 1.0),
    "slug ft^2": ("kg m^2", SLUG * FOOT**2),
    "kg/m^3": ("kg/m^3", 1.0),
    "slug/ft^3": ("kg/m^3", SLUG / FOOT**3),
    "N": ("N", 1.0),
    "kN": ("N", 1000.0),
    "lbf": ("N", POUND_FORCE),
    "Pa": ("Pa", 1.0),
    "psf": ("Pa", POUND_FORCE / FOOT**2),
    "K": ("K", 1.0),
    "1/s": ("1/s", 1.0),
    "1/s^2": ("1/s^2", 1.0),
    "1/m": ("1/m", 1.0),
    "1/ft": ("1/m", 1.0 / FOOT),
    "1/(m s)": ("1/(m s)", 1.0),
    "1/(ft s)": ("1/(m s)", 1.0 / FOOT),
    "N s/m": ("N s/m", 1.0),
    "N s": ("N s", 1.0),
    "N s^2": ("N s^2", 1.0),
    "N m": ("N m", 1.0),
    "N m s": ("N m s", 1.0),
    "slug ft^2/s": ("N m s", SLUG * FOOT**2),
    "W": ("W", 1.0),
    "rad/rad": ("rad/rad", 1.0),
    "deg/deg": ("rad/rad", 1.0),
    "rad/(rad/s)": ("rad/(rad/s)", 1.0),
    "deg/(deg/s)": ("rad/(rad/s)", 1.0),
    "hp": ("W", 550.0 * POUND_FORCE * FOOT),
}
_ALIASES = {
    "°": "deg",
    "degrees": "deg",
    "kn": "kt",
    "knots": "kt",
    "fps": "ft/s",
    "kts": "kt",
    "feet": "ft",
    "fpm": "ft/min",
    "sec": "s",
}

# What a table shows instead of an SI unit, and the factor from SI: one entry per system of units.
UNIT_SYSTEMS: dict[str, dict[str, tuple[str, float]]] = {
    "si": {},
    "us": {
        "m": ("ft", 1.0 / FOOT),
        "m/s": ("ft/s", 1.0 / FOOT),
        "Pa": ("psf", FOOT**2 / POUND_FORCE),
        "rad": ("deg", 1.0 / DEG),
        "rad/s": ("deg/s", 1.0 / DEG),
        "rad/s^2": ("deg/s^2", 1.0 / DEG),
    },
}

_QUANTITY = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")


def to_si(value: float, unit: str) -> float:
    """`value` [`unit`] in SI. Raises SpecError for an unknown unit."""
    return value * _entry(unit)[1]


def si_unit(unit: str) -> str:
    """The SI label of a unit: ``si_unit("ft/s") == "m/s"``."""
    return _entry(unit)[0]


def units_of(si: str) -> list[str]:
    """The labels of all units that measure the same as the SI unit: ``units_of("m^2") == ["m^2", "ft^2"]``."""
    return [unit for unit, (label, _) in _TO_SI.items() if label == si]


def parse(text: str, si: str) -> float:
    """Read a number with its unit, such as ``"170 kt"``, as SI.

    `si` is the SI label that the quantity must have. A bare number is taken as SI already.
    Raises SpecError when the text is not a number with a unit of that kind, or is not finite.
    """
    match = _QUANTITY.fullmatch(text)
    if match is None:
        kind = "number" if si.startswith("1") else f"number with a unit. Write it like '15 {units_of(si)[-1]}'"
        raise SpecError(f"{text!r} is not a {kind}.")
    number, unit = float(match[1]), match[2] or si
    fitting = units_of(si)
    label, multiplier = _entry(unit, fitting)
    if label != si:
        raise SpecError(
            f"{text!r} is in {unit}, which is not a unit of this quantity. Use one of: {', '.join(fitting)}."
        )
    value = number * multiplier
    if not math.isfinite(value):
        raise SpecError(f"{text!r} is not a finite number.")
    return value


def _entry(unit: str, likely: Iterable[str] = _TO_SI) -> tuple[str, float]:
    label = _ALIASES.get(unit, unit)
    if label not in _TO_SI:
        near = nearest(label, likely)
        hint = f" Did you mean {near!r}?" if near else ""
        known = ", ".join(name for name in likely if name != "1")
        raise SpecError(f"Unknown unit {unit!r}.{hint} " + (f"Known units: {known}." if known else "It has none."))
    return _TO_SI[label]
