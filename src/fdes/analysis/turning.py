"""Level turns at one height: the tightest for an instant, and the tightest that full throttle keeps up.

Reference: J. D. Anderson, Aircraft Performance and Design, McGraw-Hill 1999, sec. 6.2 and 6.3, with the corner speed;
D. P. Raymer, Aircraft Design: A Conceptual Approach, AIAA, sec. 17.6.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fdes.analysis.level_flight import COUNT, Craft, Lift, Speeds, at_largest_lift, excess_power
from fdes.analysis.maneuver import KEPT_TURNING, TURNING, Maneuver, balanced, load_factor
from fdes.units import Meter, MeterPerSecond, Number, RadianPerSecond

GENTLE: Number = 1.02  # load factor of the first guess: the search for a turn does not begin in straight flight
REFINED = 30  # halvings of a speed


@dataclass(frozen=True)
class Turn:
    """The turns at one speed. n: load factors, at most that of the structure; rates of the heading in rad/s.

    limit: what ends the instantaneous turn, in words. sustained: not a number where not even level flight is kept up.
    """

    V: MeterPerSecond
    n: Number
    n_sustained: Number
    limit: str


def turns(
    craft: Craft, lift: Lift, speeds: Speeds, n_max: Number, V_corner: MeterPerSecond | None, count: int = COUNT
) -> list[Turn]:
    """From the stalling speed, or the slowest level flight if that is faster, to the fastest; the corner among them."""
    found = []
    tried = np.linspace(max(speeds.V_stall, speeds.line[0].V), speeds.line[-1].V, count).tolist()
    for V in sorted(tried if V_corner is None else [*tried, V_corner]):
        near = min(speeds.line, key=lambda m: abs(m.V - V))
        tight = tightest(craft, lift, near, V, speeds.V_stall)
        if tight is not None:
            kept = sustained(craft, near, tight[0])
            n = load_factor(craft.plant, tight[0])
            limit = tight[1] if n < n_max else "the structure's load factor"
            found.append(Turn(V, min(n, n_max), min(kept, n_max), limit))
    return found


def tightest(
    craft: Craft, lift: Lift, near: Maneuver, V: MeterPerSecond, V_stall: MeterPerSecond
) -> tuple[Maneuver, str] | None:
    """The level turn with the largest lift, at full throttle, whatever becomes of the speed; and what limits it."""
    g = craft.plant.earth.g
    n = max(GENTLE, (V / V_stall) ** 2)
    bank = math.acos(1.0 / n)
    guess = near._replace(V=V, phi=bank, turn=g * math.tan(bank) / V, throttle=craft.full, V_dot=0.0)
    found = at_largest_lift(craft, lift, guess, TURNING)
    return found if found is not None and found[0].turn > 0.0 else None


def sustained(craft: Craft, near: Maneuver, tight: Maneuver) -> Number:
    """The load factor of the level turn that full throttle keeps up; not a number where it does not keep level flight.

    It begins where drag, which grows as the square of the load factor, would use up what is left of thrust.
    """
    plant, g, V = craft.plant, craft.plant.earth.g, tight.V
    most = load_factor(plant, tight)
    if tight.V_dot >= 0.0:
        return most
    straight = excess_power(craft, near, V) * g / V
    if straight < 0.0:
        return math.nan
    n = math.sqrt(1.0 + (most * most - 1.0) * straight / (straight - tight.V_dot))
    bank = math.acos(1.0 / max(n, GENTLE))
    share = (n - 1.0) / max(most - 1.0, 1e-9)
    alpha = near.alpha + share * (tight.alpha - near.alpha)
    guess = tight._replace(alpha=alpha, phi=bank, turn=g * math.tan(bank) / V, V_dot=0.0)
    found = balanced(plant, guess, KEPT_TURNING)
    return math.nan if found is None or found.alpha > tight.alpha else load_factor(plant, found)


def corner(craft: Craft, lift: Lift, speeds: Speeds, n_max: Number) -> MeterPerSecond | None:
    """The slowest speed at which lift carries the structure's load factor; None where no level flight is so fast."""

    def enough(V: MeterPerSecond) -> bool:
        near = min(speeds.line, key=lambda m: abs(m.V - V))
        tight = tightest(craft, lift, near, V, speeds.V_stall)
        return tight is not None and load_factor(craft.plant, tight[0]) >= n_max

    slow, fast = speeds.line[0].V, speeds.line[-1].V
    if not enough(fast):
        return None
    for _ in range(REFINED):
        middle = 0.5 * (slow + fast)
        slow, fast = (slow, middle) if enough(middle) else (middle, fast)
        if fast - slow < 1e-4 * fast:
            break
    return fast


def rate_of(n: Number, V: MeterPerSecond, g: float) -> RadianPerSecond:
    """Of a level turn: g sqrt(n^2 - 1) / V. Anderson, eq. 6.11."""
    return g * math.sqrt(max(n * n - 1.0, 0.0)) / V if math.isfinite(n) else math.nan


def radius_of(n: Number, V: MeterPerSecond, g: float) -> Meter:
    """Of a level turn: V^2 / (g sqrt(n^2 - 1)); infinite in straight flight. Anderson, eq. 6.9."""
    return V * V / (g * math.sqrt(n * n - 1.0)) if n > 1.0 else math.inf


def tightest_of(found: Sequence[Turn], g: float, *, kept: bool) -> Turn:
    """The one of the highest turn rate, for an instant or kept up."""
    return max(found, key=lambda t: _or_none(rate_of(t.n_sustained if kept else t.n, t.V, g)))


def _or_none(rate: float) -> float:
    return rate if math.isfinite(rate) else -1.0
