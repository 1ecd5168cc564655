"""The V-n diagram: which load factors lift can make, which the structure is assumed to bear, and which gusts bring.

The maneuver boundary is that of steady pull-ups and push-overs at idle throttle. Of the structure no source of
derivatives says anything: its limits are those that a rule asks for, or what is asked for here.

References: FAR 23.333, 23.335, 23.337 and 23.341 as of amendment 23-48; FAR 25.335 and 25.337; D. P. Raymer, Aircraft
Design: A Conceptual Approach, AIAA, table 14.2.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.aircraft.role import role_of
from fdes.analysis.level_flight import Craft, Lift, Speeds, at_largest_lift, density
from fdes.analysis.maneuver import PULLING, Maneuver, load_factor, state_of
from fdes.elementary import cos, sin
from fdes.errors import SpecError
from fdes.flight.steady import CALM, FREE, TINY
from fdes.physics.atmosphere import RHO0, standard_atmosphere
from fdes.physics.plant import instant
from fdes.physics.signals import Surfaces
from fdes.units import FOOT, KNOT, POUND_FORCE, Meter, MeterPerSecond, Number, PerRadian

NORMAL, TRANSPORT_LEAST = 3.8, 2.5  # FAR 23.337(a)(1), FAR 25.337(b)
FIGHTER, FIGHTER_DOWN = 6.5, -3.0  # Raymer, table 14.2: fighters from 6.5 to 9, and from -3 to -6; the least of both
GUST_C, GUST_D = 50.0 * FOOT, 25.0 * FOOT  # m/s, up to 20,000 ft: FAR 23.333(c)
GUST_BEGINS_TO_FALL, GUST_HALF = 20000.0 * FOOT, 50000.0 * FOOT  # where it is the half: FAR 23.333(c)
CRUISE_OF_DIVE = 0.8  # V_C over V_D at most: FAR 25.335(b)(1)
FROM = 0.4  # of the stalling speed, where the boundary is begun: below it, lift is next to nothing
COUNT = 60


class Structure(NamedTuple):
    """Limit load factors, and design speeds [m/s, equivalent], with where each is from."""

    n_max: Number
    n_min: Number
    V_C: MeterPerSecond
    V_D: MeterPerSecond
    why_n: str
    why_V: str
    gusts: bool


class Bound(NamedTuple):
    """Load factors at one equivalent airspeed: what lift can make, and what the boundary allows of it."""

    V: MeterPerSecond
    lift_up: Number
    lift_down: Number
    upper: Number
    lower: Number


@dataclass(frozen=True)
class VnDiagram:
    """The maneuver boundary over equivalent airspeed, and the gust lines: the name, gust and speed of each.

    limits: what ends lift upward and downward at V_C, in words. V_A: where lift makes the limit load factor.
    """

    structure: Structure
    bounds: Sequence[Bound]
    limits: tuple[str, str]
    V_stall: MeterPerSecond
    V_A: MeterPerSecond | None
    lift_slope: PerRadian
    alleviation: Number
    gusts: Sequence[tuple[str, MeterPerSecond, MeterPerSecond]]

    def gust_load(self, gust: MeterPerSecond, V: MeterPerSecond, loading: float) -> Number:
        """n = 1 + K_g U_de V a rho_0 / (2 W/S), W/S in Pa: FAR 23.341(c) in SI."""
        return 1.0 + self.alleviation * RHO0 * gust * V * self.lift_slope / (2.0 * loading)


def structure_of(
    condition: FlightCondition, craft: Craft, speeds: Speeds, n_max: Number | None, n_min: Number | None
) -> Structure:
    """What the class of the aircraft lets one assume, unless it is asked for. Raises SpecError for wrong signs."""
    if n_max is not None and not n_max > 1.0:
        raise SpecError(f"A largest load factor of {n_max:g} is asked for; it must be more than 1.")
    if n_min is not None and not n_min < 0.0:
        raise SpecError(f"A smallest load factor of {n_min:g} is asked for; it must be less than 0.")
    role = role_of(condition.document, condition.condition)
    up, down, why = load_factors(role.airplane_class, craft.plant.inertia.m * craft.plant.earth.g)
    if n_max is not None or n_min is not None:
        why = "asked for" if n_max is not None and n_min is not None else f"asked for; the other {why}"
    fastest = equivalent(speeds.line[-1].V, speeds.h)
    if role.airplane_class == "I":
        loading = _loading(craft) * FOOT**2 / POUND_FORCE
        V_C = 33.0 * math.sqrt(loading) * KNOT
        said = "V_C = 33 sqrt(W/S) kt and V_D = 1.4 V_C of FAR 23.335(a)(1) and (b)(2), normal category"
        V_D = 1.4 * V_C
    else:
        V_D = fastest
        V_C = CRUISE_OF_DIVE * V_D
        said = "V_D is the fastest level flight at this height, and V_C is 0.8 V_D, after FAR 25.335(b)(1)"
    known = equivalent(craft.reach.fast * standard_atmosphere(speeds.h).a, speeds.h)
    V_D = min(V_D, known)
    return Structure(
        up if n_max is None else n_max,
        down if n_min is None else n_min,
        min(V_C, V_D),
        V_D,
        why,
        said,
        role.airplane_class != "IV",
    )


def load_factors(airplane_class: str, weight: float) -> tuple[Number, Number, str]:
    """Limit load factors that are assumed for a Class of MIL-F-8785C, and by which rule; weight in N."""
    pounds = weight / POUND_FORCE
    of_weight = 2.1 + 24000.0 / (pounds + 10000.0)
    if airplane_class == "I":
        n = min(of_weight, NORMAL)
        return n, -0.4 * n, "FAR 23.337, normal category"
    if airplane_class == "IV":
        return FIGHTER, FIGHTER_DOWN, "the least of fighters, Raymer's table 14.2"
    return min(max(of_weight, TRANSPORT_LEAST), NORMAL), -1.0, "FAR 25.337"


def equivalent(V: MeterPerSecond, h: Meter) -> MeterPerSecond:
    """The equivalent airspeed of a true one."""
    return V * math.sqrt(density(h) / RHO0)


def vn_diagram(
    craft: Craft, structure: Structure, speeds: Speeds, lifts: tuple[Lift, Lift], count: int = COUNT
) -> VnDiagram:
    """The diagram at the height of `speeds`; lifts: the largest, and the most negative."""
    h, true = speeds.h, math.sqrt(RHO0 / density(speeds.h))
    bounds: list[Bound] = []
    V_A = None
    for V in np.linspace(FROM * equivalent(speeds.V_stall, h), structure.V_D, count).tolist():
        up, down = (_of_lift(craft, lift, speeds.line[0], V * true)[0] for lift in lifts)
        if not (math.isfinite(up) and math.isfinite(down)):
            continue
        for crossed in _crossings(bounds[-1], V, up, down, structure) if bounds else ():
            V_A = crossed.V if V_A is None and crossed.lift_up == structure.n_max else V_A
            bounds.append(crossed)
        bounds.append(_bound(structure, V, up, down))
    level = min(speeds.line, key=lambda m: abs(m.V - structure.V_C * true))
    at_V_C = [_of_lift(craft, lift, level, level.V)[1] for lift in lifts]
    slope = lift_slope(craft, level)
    mu = 2.0 * _loading(craft) / (density(h) * craft.plant.earth.g * craft.c * slope)
    gusts = [("V_C", fallen(GUST_C, h), structure.V_C), ("V_D", fallen(GUST_D, h), structure.V_D)]
    return VnDiagram(
        structure,
        bounds,
        (at_V_C[0], at_V_C[1]),
        equivalent(speeds.V_stall, h),
        V_A,
        slope,
        0.88 * mu / (5.3 + mu),
        gusts if structure.gusts else [],
    )


def lowest(structure: Structure, V: MeterPerSecond) -> Number:
    """The negative limit: up to V_C, from there straight to zero at V_D. FAR 23.333(b), 25.337(c)."""
    if V <= structure.V_C or not structure.gusts:
        return structure.n_min
    return structure.n_min * (structure.V_D - V) / (structure.V_D - structure.V_C)


def fallen(gust: MeterPerSecond, h: Meter) -> MeterPerSecond:
    """A gust at that height: full up to 20,000 ft, half at 50,000 ft and, so taken here, above. FAR 23.333(c)."""
    share = (h - GUST_BEGINS_TO_FALL) / (GUST_HALF - GUST_BEGINS_TO_FALL)
    return gust * (1.0 - 0.5 * min(max(share, 0.0), 1.0))


def lift_slope(craft: Craft, level: Maneuver) -> PerRadian:
    """d CL / d alpha of the whole aircraft in that flight, surfaces held, by complex step."""
    plant = craft.plant._replace(limits=FREE, rest=Surfaces())
    stepped = level._replace(alpha=complex(level.alpha, TINY))  # type: ignore[arg-type]
    flow = instant(plant, state_of(plant, stepped), level.surfaces, CALM).flow
    loads = plant.aerodynamics(plant.aero, flow, level.surfaces)
    lift = loads.X * sin(stepped.alpha) - loads.Z * cos(stepped.alpha)
    return float(lift.imag / TINY / (flow.qbar.real * craft.S))


def _of_lift(craft: Craft, lift: Lift, near: Maneuver, V: MeterPerSecond) -> tuple[Number, str]:
    idle = craft.plant.limits.lower.throttle
    guess = Maneuver(V, near.h, alpha=lift.alpha, elevator=near.elevator, throttle=idle)
    found = at_largest_lift(craft, lift, guess, PULLING)
    return (math.nan, "") if found is None else (load_factor(craft.plant, found[0]), found[1])


def _bound(structure: Structure, V: MeterPerSecond, up: Number, down: Number) -> Bound:
    return Bound(V, up, down, min(up, structure.n_max), max(down, lowest(structure, V)))


def _crossings(before: Bound, V: MeterPerSecond, up: Number, down: Number, structure: Structure) -> list[Bound]:
    """Where lift, which grows as the square of the speed, comes to the structure's limits on the way to V."""
    found = []
    for n_before, n, wanted in (
        (before.lift_up, up, structure.n_max),
        (before.lift_down, down, structure.n_min),
    ):
        share = (wanted - n_before) / (n - n_before) if n != n_before else -1.0
        if 0.0 < share <= 1.0:
            at = [x + share * (y - x) for x, y in ((before.lift_up, up), (before.lift_down, down))]
            at = [wanted if abs(x - wanted) < 1e-9 else x for x in at]
            found.append(_bound(structure, math.sqrt(before.V**2 + share * (V**2 - before.V**2)), at[0], at[1]))
    return sorted(found)


def _loading(craft: Craft) -> float:
    return craft.plant.inertia.m * craft.plant.earth.g / craft.S
