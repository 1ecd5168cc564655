"""Level flight at one height: how slow, how fast, at which speeds it costs least, what thrust is left to climb with.

Each end of the range of speeds is named by what ends it. Specific excess power is what full throttle gains: of level
flight, V dV/dt / g. Climbs are steady, at constant true airspeed.

Reference: J. D. Anderson, Aircraft Performance and Design, McGraw-Hill 1999, ch. 5.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.maneuver import (
    ACCELERATING,
    AT_THIS_LIFT,
    CLIMBING,
    PULLING,
    STRAIGHT,
    Maneuver,
    balanced,
    load_factor,
    stop_of,
)
from fdes.errors import SpecError
from fdes.flight.table_ends import table_ends
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.plant import SixDof
from fdes.units import DEG, Meter, Meter2, MeterPerSecond, Number, Radian

SUBSONIC: Number = 0.95  # Mach number up to which derivatives of a subsonic condition are used; assumed
SUPERSONIC: Number = 1.2  # and from which those of a supersonic one are; assumed
FASTER = 1.15  # of its Mach number: how far the derivatives of a faster condition are used; assumed
SHARE = 0.25  # of the lift and drag of the condition: by more, derivatives with Mach may not change them; assumed
STEEPEST = 45.0 * DEG  # angle of attack, where the search for the largest lift ends
STEP = 1.0 * DEG  # of that search
SLOWEST = 0.6  # of the stalling speed: power does not hold an aircraft up below it
START = 1.4  # of the stalling speed, where the search begins
COUNT = 41  # points of a line
COARSE = 24  # of one that is only searched
WITHIN = 1e-4  # of a speed


class Reach(NamedTuple):
    """The Mach numbers between which the aircraft's data are used, and why they end there, in words."""

    slow: Number
    fast: Number
    why_slow: str
    why_fast: str


class Craft(NamedTuple):
    """What performance is asked of: a plant, its throttle at most `full`, where its data reach; V, h: of its condition.

    S, c: of the wing.
    """

    plant: SixDof
    reach: Reach
    full: Number
    V: MeterPerSecond
    h: Meter
    alpha_max: Radian
    S: Meter2
    c: Meter

    def first(self, V: MeterPerSecond, h: Meter, throttle: Number) -> Maneuver:
        """Where a search begins."""
        return Maneuver(V, h, alpha=math.atan2(self.plant.initial.w, self.plant.initial.u), throttle=throttle)


class Lift(NamedTuple):
    """The angle of attack of the largest lift (of the most negative one where `sign` is -1), and what ends it there."""

    alpha: Radian
    sign: float
    limit: str


@dataclass(frozen=True)
class Speeds:
    """The level flights at one height, from the slowest to the fastest, with what limits either end.

    V_stall [m/s]: the slowest with idle throttle, speed falling. line: from slow to fast.
    """

    h: Meter
    V_stall: MeterPerSecond
    line: tuple[Maneuver, ...]
    slow_end: str
    fast_end: str


def reach_of(condition: FlightCondition, slowest: Number | None = None, fastest: Number | None = None) -> Reach:
    """Where the data of that condition are believed, or what is asked for. Raises SpecError where nothing is left."""
    by_mach = sorted([condition, *condition.across], key=lambda c: c.reference.mach)
    slow, _, why_slow, _ = _reach_alone(by_mach[0])
    _, fast, _, why_fast = _reach_alone(by_mach[-1])
    if slowest is not None:
        slow, why_slow = slowest, "no slower was asked for"
    if fastest is not None:
        fast, why_fast = fastest, "no faster was asked for"
    if not 0.0 <= slow < fast:
        raise SpecError(
            f"Performance from Mach {slow:.3g} to Mach {fast:.3g} is asked for: the first must be the smaller."
        )
    return Reach(slow, fast, f"Mach {slow:.3g}: {why_slow}", f"Mach {fast:.3g}: {why_fast}")


def _reach_alone(condition: FlightCondition) -> Reach:
    mach, k = condition.reference.mach, condition.coefficients
    slow, why_slow = (SUPERSONIC, "its derivatives are supersonic") if mach >= SUPERSONIC else (0.0, "")
    fast, why_fast = SUBSONIC, "its data know no transonic drag"
    if mach >= SUBSONIC:
        fast, why_fast = FASTER * mach, f"its derivatives are those of Mach {mach:g}"
    if not condition.tables:
        for name, slope, whole in (("CD_M", k.CD_M, k.CD), ("CL_M", k.CL_M, k.CL)):
            far = SHARE * whole / abs(slope) if slope else math.inf
            why = f"{name} may not be carried further from Mach {mach:g}"
            if mach + far < fast:
                fast, why_fast = mach + far, why
            if mach - far > slow:
                slow, why_slow = mach - far, why
    return Reach(slow, fast, why_slow, why_fast)


def largest_lift(craft: Craft, sign: float = 1.0) -> Lift:
    """Of steady pull-ups at idle throttle, the elevator as far as it must: stops are asked where it is used."""
    plant, h = craft.plant, craft.h
    low, high = table_ends(plant).get("alpha", (-STEEPEST, STEEPEST))
    end = min(high, craft.alpha_max) if sign > 0.0 else low
    guess = craft.first(craft.V, h, plant.limits.lower.throttle)

    def lift(alpha: float) -> float:
        pulled = balanced(plant, guess._replace(alpha=alpha), PULLING)
        return -math.inf if pulled is None else sign * load_factor(plant, pulled)

    angles = np.arange(guess.alpha, end, sign * STEP).tolist()
    if not angles or max(lifts := [lift(alpha) for alpha in angles]) == -math.inf:
        raise SpecError(
            f"The largest lift is not found between {guess.alpha / DEG:.3g} deg and {end / DEG:.3g} deg of angle of "
            "attack: give a larger one with --alpha-max."
        )
    alpha = angles[int(np.argmax(lifts))]
    if alpha == angles[-1] and lift(end) >= max(lifts):
        return Lift(end, sign, f"angle of attack ends at {end / DEG:.3g} deg")
    return Lift(best(lift, alpha - STEP, min(alpha + STEP, STEEPEST), 1e-3), sign, "lift is at its largest")


def at_largest_lift(craft: Craft, lift: Lift, guess: Maneuver, free: Sequence[str]) -> tuple[Maneuver, str] | None:
    """The maneuver with the largest lift that the elevator can hold, and what limits it, in words."""
    plant = craft.plant
    found = balanced(plant, guess._replace(alpha=lift.alpha), free)
    if found is None or stop_of(plant, found) != "elevator":
        return None if found is None else (found, lift.limit)
    low, high = plant.limits
    stop = low.elevator if found.elevator < low.elevator else high.elevator
    swapped = ["alpha" if name == "elevator" else name for name in free]
    held = balanced(plant, found._replace(elevator=stop), swapped)
    return None if held is None else (held, f"the elevator is at its stop, {stop / DEG:.3g} deg")


def stall(craft: Craft, lift: Lift, h: Meter) -> tuple[Maneuver, str] | None:
    """The slowest flight with the weight carried, at idle throttle, its speed falling; and what limits it."""
    V = craft.V * math.sqrt(density(craft.h) / density(h))
    return at_largest_lift(craft, lift, craft.first(V, h, craft.plant.limits.lower.throttle), AT_THIS_LIFT)


def level_speeds(
    craft: Craft, lift: Lift, h: Meter, count: int = COUNT, likely: MeterPerSecond | None = None
) -> Speeds | None:
    """Between the ends of the longest run of speeds that can be flown; None where there are none.

    likely: one that is tried for sure, since below a ceiling those that can be flown lie close together.
    """
    stalled = stall(craft, lift, h)
    ends = searched(craft, stalled, h)
    if stalled is None or ends is None:
        return None
    between = np.geomspace(*ends, COARSE).tolist()
    tried = sorted(between if likely is None else [*between, likely])
    middle = min(range(len(tried)), key=lambda k: abs(tried[k] - START * stalled[0].V))
    first = craft.first(tried[middle], h, craft.full)._replace(alpha=0.5 * lift.alpha)
    found: list[Maneuver | None] = [None] * len(tried)
    found[middle] = balanced(craft.plant, first, STRAIGHT)
    for k in (*range(middle + 1, len(tried)), *range(middle - 1, -1, -1)):
        beside = found[k - 1 if k > middle else k + 1]
        found[k] = beside and balanced(craft.plant, beside._replace(V=tried[k]), STRAIGHT)
    run = _longest_run([m if m is not None and not _short(craft, lift, m) else None for m in found])
    if not run:
        return None
    before, after = [V for V in tried if run[0].V > V], [V for V in tried if run[-1].V < V]
    slow, slow_end = _end(craft, lift, run[0], before[-1]) if before else (run[0], craft.reach.why_slow)
    fast, fast_end = _end(craft, lift, run[-1], after[0]) if after else (run[-1], craft.reach.why_fast)
    line = tuple(along(craft, slow, np.linspace(slow.V, fast.V, count).tolist(), STRAIGHT))
    return Speeds(h, stalled[0].V, line, slow_end, fast_end)


def searched(craft: Craft, stalled: tuple[Maneuver, str] | None, h: Meter) -> tuple[float, float] | None:
    """The speeds between which level flight at `h` is looked for; None where lift ends before they begin."""
    a = standard_atmosphere(h).a
    if stalled is None or craft.reach.fast * a <= stalled[0].V:
        return None
    return max(SLOWEST * stalled[0].V, craft.reach.slow * a), craft.reach.fast * a


def beside(craft: Craft, near: Maneuver, V: MeterPerSecond, free: Sequence[str]) -> Maneuver | None:
    """The maneuver at that speed, begun at `near`, or else far from the stall: there lift knows no slope to go by."""
    found = balanced(craft.plant, near._replace(V=V), free)
    if found is not None:
        return found
    alpha = craft.first(V, near.h, near.throttle).alpha
    return balanced(craft.plant, near._replace(V=V, alpha=alpha), free)


def along(craft: Craft, first: Maneuver, speeds: Iterable[float], free: Sequence[str]) -> list[Maneuver]:
    """The maneuvers at those speeds, each begun at the one before; those that are not found are left out."""
    line: list[Maneuver] = []
    for V in speeds:
        found = beside(craft, line[-1] if line else first, V, free)
        if found is not None:
            line.append(found)
    return line


def _short(craft: Craft, lift: Lift, m: Maneuver | None) -> str:
    """What keeps the aircraft from that level flight, in words; nothing where it can."""
    if m is None or m.alpha > lift.alpha:
        return lift.limit
    if m.throttle > craft.full:
        return f"thrust: it needs the throttle at {m.throttle:.3f}, and it goes to {craft.full:g}"
    stopped = stop_of(craft.plant, m)
    return f"the {stopped} would go beyond its stop" if stopped else ""


def _longest_run(flights: Sequence[Maneuver | None]) -> list[Maneuver]:
    runs: list[list[Maneuver]] = [[]]
    for m in flights:
        if m is not None:
            runs[-1].append(m)
        elif runs[-1]:
            runs.append([])
    return max(runs, key=len)


def _end(craft: Craft, lift: Lift, can: Maneuver, cannot: float) -> tuple[Maneuver, str]:
    """The last flight on the way from `can` to the speed `cannot`, and what falls short beyond."""
    while abs(can.V - cannot) > WITHIN * can.V:
        V = 0.5 * (can.V + cannot)
        between = balanced(craft.plant, can._replace(V=V), STRAIGHT)
        if between is None or _short(craft, lift, between):
            cannot = V
        else:
            can = between
    return can, _short(craft, lift, balanced(craft.plant, can._replace(V=cannot), STRAIGHT))


def excess_power(craft: Craft, near: Maneuver, V: MeterPerSecond) -> float:
    """What full throttle gains at that speed [m/s], in level flight."""
    found = beside(craft, near._replace(throttle=craft.full, V_dot=0.0), V, ACCELERATING)
    return -math.inf if found is None else V * found.V_dot / craft.plant.earth.g


def steady_climb(craft: Craft, near: Maneuver) -> Maneuver | None:
    """The climb at full throttle that keeps the speed of `near`; None where thrust is more than weight and drag."""
    angle = excess_power(craft, near, near.V) / near.V
    guess = near._replace(throttle=craft.full, gamma=math.asin(min(max(angle, -1.0), 0.95)))
    found = balanced(craft.plant, guess, CLIMBING)
    return found if found is not None and abs(found.gamma) < 0.5 * math.pi else None


def least(craft: Craft, speeds: Speeds, cost: Callable[[Maneuver], float]) -> Maneuver:
    """The level flight of least cost: of thrust, or of power."""
    k = min(range(len(speeds.line)), key=lambda k: cost(speeds.line[k]))
    near = speeds.line[k]
    low, high = (speeds.line[min(max(j, 0), len(speeds.line) - 1)].V for j in (k - 1, k + 1))

    def gain(V: float) -> float:
        found = balanced(craft.plant, near._replace(V=V), STRAIGHT)
        return -math.inf if found is None else -cost(found)

    V = best(gain, low, high)
    return balanced(craft.plant, near._replace(V=V), STRAIGHT) or near


def density(h: Meter) -> float:
    """Of the standard day [kg/m^3]."""
    return standard_atmosphere(h).rho


def best(f: Callable[[float], float], low: float, high: float, within: float = WITHIN) -> float:
    """Where `f` is largest between the ends, by the golden section, to a share of the larger."""
    golden = 0.5 * (math.sqrt(5.0) - 1.0)
    x, y = high - golden * (high - low), low + golden * (high - low)
    fx, fy = f(x), f(y)
    while high - low > within * max(abs(low), abs(high)):
        if fx > fy:
            high, y, fy = y, x, fx
            x = high - golden * (high - low)
            fx = f(x)
        else:
            low, x, fx = x, y, fy
            y = low + golden * (high - low)
            fy = f(y)
    return 0.5 * (low + high)
