"""The tables of performance: labeled xarray Datasets with units, long names and what limits them.

Speeds are true airspeeds, but for the V-n diagram, whose speeds are equivalent.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from fdes.analysis.climb import AtHeight, times_to_climb
from fdes.analysis.level_flight import Craft, Speeds, excess_power
from fdes.analysis.maneuver import thrust_in
from fdes.analysis.turning import Turn, radius_of, rate_of
from fdes.analysis.v_n import VnDiagram
from fdes.units import Meter

if TYPE_CHECKING:
    import xarray as xr

NOTHING = 0.05  # m/s: where specific excess power is less, it is that of the absolute ceiling


def level_table(craft: Craft, speeds: Speeds) -> "xr.Dataset":
    """Level flight over true airspeed: what it needs, and what full throttle has."""
    line = speeds.line
    need = [thrust_in(craft.plant, m) for m in line]
    have = [thrust_in(craft.plant, m._replace(throttle=craft.full)) for m in line]
    return labeled(
        ("V", [m.V for m in line], "m/s", "true airspeed"),
        ("alpha", [m.alpha for m in line], "rad", "angle of attack"),
        ("elevator", [m.elevator for m in line], "rad", "elevator"),
        ("throttle", [m.throttle for m in line], "1", "throttle"),
        ("thrust_required", need, "N", "thrust required"),
        ("thrust_available", have, "N", "thrust available"),
        ("power_required", [T * m.V for T, m in zip(need, line, strict=True)], "W", "power required"),
        ("power_available", [T * m.V for T, m in zip(have, line, strict=True)], "W", "power available"),
        ("excess_power", [excess_power(craft, m, m.V) for m in line], "m/s", "specific excess power"),
        h=f"{speeds.h:g} m",
    )


def height_table(rows: Sequence[AtHeight]) -> "xr.Dataset":
    """Speeds and the climb at full throttle over height. At the absolute ceiling one speed is left."""
    ends = [_ends(r) for r in rows]
    return labeled(
        ("h", [r.h for r in rows], "m", "height"),
        ("V_stall", [r.V_stall for r in rows], "m/s", "stall at idle throttle"),
        ("V_slow", [slow for slow, _ in ends], "m/s", "slowest level flight"),
        ("V_fast", [fast for _, fast in ends], "m/s", "fastest level flight"),
        ("V_climb", [r.V_climb for r in rows], "m/s", "speed of the largest specific excess power"),
        ("excess_power", [r.excess for r in rows], "m/s", "largest specific excess power"),
        ("time", times_to_climb(rows), "s", "time to climb at the largest specific excess power"),
    )


def _ends(r: AtHeight) -> tuple[float, float]:
    if r.speeds is not None:
        return r.speeds.line[0].V, r.speeds.line[-1].V
    return (r.V_climb, r.V_climb) if abs(r.excess) < NOTHING else (math.nan, math.nan)


def excess_table(rows: Sequence[AtHeight]) -> "xr.Dataset":
    """Specific excess power over height, and at each height over as many speeds."""
    import xarray as xr

    most = max(len(r.tried) for r in rows)
    pairs = [[*r.tried, *[(math.nan, math.nan)] * (most - len(r.tried))] for r in rows]
    grid = ("h", "k")
    return xr.Dataset(
        {
            "V": (grid, [[V for V, _ in row] for row in pairs], {"units": "m/s", "long_name": "true airspeed"}),
            "excess_power": (
                grid,
                [[gain for _, gain in row] for row in pairs],
                {"units": "m/s", "long_name": "specific excess power"},
            ),
        },
        {
            "h": ("h", [r.h for r in rows], {"units": "m", "long_name": "height"}),
            "k": ("k", list(range(most)), {"units": "1", "long_name": "number of the speed"}),
        },
    )


def turn_table(found: Sequence[Turn], h: Meter, g: float) -> "xr.Dataset":
    """Level turns over true airspeed: the tightest for an instant, and the tightest that is kept up."""
    at, kept = [(t.n, t.V, g) for t in found], [(t.n_sustained, t.V, g) for t in found]
    return labeled(
        ("V", [t.V for t in found], "m/s", "true airspeed"),
        ("n", [t.n for t in found], "1", "instantaneous load factor"),
        ("n_sustained", [t.n_sustained for t in found], "1", "sustained load factor"),
        ("rate", [rate_of(*x) for x in at], "rad/s", "instantaneous turn rate"),
        ("rate_sustained", [rate_of(*x) for x in kept], "rad/s", "sustained turn rate"),
        ("radius", [radius_of(*x) for x in at], "m", "instantaneous turn radius"),
        ("radius_sustained", [radius_of(*x) for x in kept], "m", "sustained turn radius"),
        h=f"{h:g} m",
    )


def vn_table(diagram: VnDiagram) -> "xr.Dataset":
    """The maneuver boundary over equivalent airspeed."""
    bounds, structure = diagram.bounds, diagram.structure
    return labeled(
        ("V", [b.V for b in bounds], "m/s", "equivalent airspeed"),
        ("n_lift_up", [b.lift_up for b in bounds], "1", "load factor of the largest lift"),
        ("n_lift_down", [b.lift_down for b in bounds], "1", "load factor of the most negative lift"),
        ("n_upper", [b.upper for b in bounds], "1", "upper maneuver boundary"),
        ("n_lower", [b.lower for b in bounds], "1", "lower maneuver boundary"),
        load_factors=structure.why_n,
        speeds=structure.why_V,
    )


def labeled(
    axis: tuple[str, Sequence[float], str, str], *columns: tuple[str, Sequence[float], str, str], **said: str
) -> "xr.Dataset":
    """A table of columns over the first one: each its name, values, unit, and what it is in words."""
    import xarray as xr

    dim, values, unit, words = axis
    data = {name: (dim, list(column), {"units": u, "long_name": w}) for name, column, u, w in columns}
    return xr.Dataset(data, {dim: (dim, list(values), {"units": unit, "long_name": words})}, said)
