"""Climb and ceiling: what full throttle gains at each height, how long it takes to get there, and where it ends.

Reference: J. D. Anderson, Aircraft Performance and Design, McGraw-Hill 1999, sec. 5.10 to 5.12.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from fdes.analysis.level_flight import (
    COARSE,
    Craft,
    Lift,
    Speeds,
    beside,
    best,
    excess_power,
    level_speeds,
    searched,
    stall,
    steady_climb,
)
from fdes.analysis.maneuver import ACCELERATING, Maneuver
from fdes.flight.table_ends import table_ends
from fdes.physics.atmosphere import TOP
from fdes.units import FOOT, Meter, MeterPerSecond, Second

SERVICE: MeterPerSecond = 100.0 * FOOT / 60.0  # rate of climb at the service ceiling: Anderson, sec. 5.11
HIGHEST: Meter = TOP - 1000.0
UP: Meter = 2000.0  # from height to height, where the search for a ceiling goes up
WITHIN: Meter = 2.0
HEIGHTS = 15  # between sea level and the ceiling
STEP = 0.05  # of a speed, from one to the next
FINE = 1e-3  # of a speed
MUCH = 1e-6  # of a rate of climb: what differs by less is the same


@dataclass(frozen=True)
class BestClimbs:
    """The steady climbs at full throttle from one height that gain height fastest and steepest."""

    fastest: Maneuver
    steepest: Maneuver


@dataclass(frozen=True)
class AtHeight:
    """What one height allows. excess [m/s] is the largest specific excess power, at the speed `V_climb`.

    tried: speeds, and the specific excess power at each. speeds: None above the absolute ceiling.
    """

    h: Meter
    V_stall: MeterPerSecond
    V_climb: MeterPerSecond
    excess: MeterPerSecond
    tried: tuple[tuple[float, float], ...]
    speeds: Speeds | None


@dataclass(frozen=True)
class Ceiling:
    """The height at which the largest specific excess power has fallen to `climb`, or lift ends; `limit` in words."""

    h: Meter
    climb: MeterPerSecond
    limit: str


def best_climbs(craft: Craft, speeds: Speeds) -> BestClimbs | None:
    """Of all speeds of level flight at one height; None where thrust is more than weight and drag at one of them."""
    climbs = [m for m in (steady_climb(craft, m) for m in speeds.line) if m is not None]
    if len(climbs) < len(speeds.line):
        return None

    def refined(k: int, gain: Callable[[Maneuver], float]) -> Maneuver:
        near = speeds.line[k]

        def at(V: float) -> float:
            found = steady_climb(craft, near._replace(V=V))
            return -math.inf if found is None else gain(found)

        V = best(at, speeds.line[max(k - 1, 0)].V, speeds.line[min(k + 1, len(climbs) - 1)].V, FINE)
        return steady_climb(craft, near._replace(V=V)) or climbs[k]

    fastest = max(range(len(climbs)), key=lambda k: rate_of_climb(climbs[k]))
    steepest = max(range(len(climbs)), key=lambda k: climbs[k].gamma)
    return BestClimbs(refined(fastest, rate_of_climb), refined(steepest, lambda m: m.gamma))


def rate_of_climb(m: Maneuver) -> MeterPerSecond:
    """Of a steady climb."""
    return m.V * math.sin(m.gamma)


def best_excess(craft: Craft, lift: Lift, h: Meter) -> AtHeight | None:
    """The largest specific excess power at `h` between the stalling speed and the last that is believed."""
    stalled = stall(craft, lift, h)
    ends = searched(craft, stalled, h)
    if stalled is None or ends is None:
        return None
    slow, fast = max(ends[0], stalled[0].V), ends[1]
    begin = craft.first(slow, h, craft.full)._replace(alpha=stalled[0].alpha)
    near: list[Maneuver] = []
    for V in np.geomspace(slow, fast, 2 + int(math.log(fast / slow) / STEP)).tolist():
        found = beside(craft, near[-1] if near else begin, V, ACCELERATING)
        if found is None:
            continue
        slower = bool(near) and found.V_dot < near[-1].V_dot
        near.append(found)
        if slower and found.V_dot < 0.0:
            break
    if not near:
        return None
    k = max(range(len(near)), key=lambda k: near[k].V * near[k].V_dot)
    low, high = near[max(k - 1, 0)].V, near[min(k + 1, len(near) - 1)].V
    V = best(lambda V: excess_power(craft, near[k], V), low, high, FINE)
    tried = tuple((m.V, m.V * m.V_dot / craft.plant.earth.g) for m in near)
    return AtHeight(h, stalled[0].V, V, excess_power(craft, near[k], V), tried, None)


def ceiling(craft: Craft, lift: Lift, climb: MeterPerSecond, low: Meter = 0.0) -> Ceiling | None:
    """Where the largest specific excess power is `climb`, above `low`; None where there is less from there on."""

    def left(h: Meter) -> float:
        found = best_excess(craft, lift, h)
        return -math.inf if found is None else found.excess - climb

    top, why_top = highest(craft)
    high = low
    while left(high) >= 0.0:
        if high >= top:
            return Ceiling(top, climb, why_top)
        low, high = high, min(high + UP, top)
    if high == low:
        return None
    while high - low > WITHIN:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if left(middle) >= 0.0 else (low, middle)
    why = "thrust" if best_excess(craft, lift, high) is not None else f"lift, at {craft.reach.why_fast}"
    return Ceiling(low, climb, why)


def highest(craft: Craft) -> tuple[Meter, str]:
    """The last height of which the aircraft's data and the atmosphere say something, and which of them ends there."""
    end = table_ends(craft.plant).get("h", (0.0, math.inf))[1]
    return (end, "the tables of its engine end there") if end < HIGHEST else (HIGHEST, "the atmosphere ends there")


def over_height(craft: Craft, lift: Lift, top: Meter, count: int = HEIGHTS) -> list[AtHeight]:
    """What each height allows, from sea level to `top`; heights at which nothing flies are left out."""
    rows = []
    for h in np.linspace(0.0, top, count).tolist():
        found = best_excess(craft, lift, h)
        if found is not None:
            speeds = level_speeds(craft, lift, h, COARSE, found.V_climb)
            rows.append(replace(found, speeds=speeds))
    return rows


def times_to_climb(rows: Sequence[AtHeight]) -> list[Second]:
    """From the first of those heights to each, at the largest specific excess power, which is straight between them.

    Not a number from where it is less than at the service ceiling. What changing speed on the way takes is left out.
    """
    times = [0.0]
    for one, other in pairwise(rows):
        a, b = one.excess, other.excess
        if min(a, b) < SERVICE:
            times.append(math.nan)
            continue
        mean = (a - b) / math.log(a / b) if abs(a - b) > MUCH * a else a
        times.append(times[-1] + (other.h - one.h) / mean)
    return times
