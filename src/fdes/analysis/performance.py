"""What an aircraft can do: speeds, climb, ceiling, turns and the V-n diagram, from flights of the nonlinear plant.

Results are figures with their units and what limits them, and labeled tables. What no source says is in `notes`.

>>> from fdes.aircraft import load
>>> found = performance(load("NAVION").at())
>>> round(found.figure("service ceiling").value, -2)
4800.0
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from fdes.aircraft import FlightCondition
from fdes.analysis.climb import (
    SERVICE,
    Ceiling,
    best_climbs,
    best_excess,
    ceiling,
    highest,
    over_height,
    rate_of_climb,
)
from fdes.analysis.level_flight import (
    STEEPEST,
    Craft,
    Lift,
    Speeds,
    largest_lift,
    least,
    level_speeds,
    reach_of,
)
from fdes.analysis.maneuver import thrust_in
from fdes.analysis.performance_tables import excess_table, height_table, level_table, turn_table, vn_table
from fdes.analysis.turning import Turn, corner, radius_of, rate_of, tightest_of, turns
from fdes.analysis.v_n import VnDiagram, structure_of, vn_diagram
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.nonlinear import assumptions, six_dof_of
from fdes.physics.plant import SixDof
from fdes.physics.terms import ends, term_loads
from fdes.units import FOOT, Meter, MeterPerSecond, Number, Radian

if TYPE_CHECKING:
    import xarray as xr


class Wanted(NamedTuple):
    """What is asked for. What is None is as the aircraft's data say; `full` is the throttle of full thrust."""

    h: Meter | None = None
    full: Number = 1.0
    slowest: Number | None = None
    fastest: Number | None = None
    alpha_max: Radian = STEEPEST
    n_max: Number | None = None
    n_min: Number | None = None


class Figure(NamedTuple):
    """One result [SI unit], the airspeed [m/s] at which it is, and what makes it so, in words."""

    name: str
    value: float
    unit: str
    V: float | None = None
    limit: str = ""


@dataclass(frozen=True)
class Performance:
    """The figures by subject, and the tables they are from.

    level, turn, v_n: over airspeed at `h`. heights, excess: from sea level to the absolute ceiling, or where data end.
    """

    condition: FlightCondition
    h: Meter
    figures: Mapping[str, Sequence[Figure]]
    level: "xr.Dataset"
    heights: "xr.Dataset"
    excess: "xr.Dataset"
    turn: "xr.Dataset"
    v_n: "xr.Dataset"
    diagram: VnDiagram
    notes: Sequence[str]

    def figure(self, name: str) -> Figure:
        """The figure of that name. Raises NoSuchPart."""
        every = {f.name: f for part in self.figures.values() for f in part}
        if name not in every:
            raise NoSuchPart("figure of performance", name, every)
        return every[name]


ALL = Wanted()


def performance(condition: FlightCondition, wanted: Wanted = ALL) -> Performance:
    """All of it. Raises SpecError where the aircraft cannot fly nonlinear, or nothing can be flown at that height."""
    plant = six_dof_of(condition)
    h = condition.reference.h if wanted.h is None else wanted.h
    craft = craft_of(condition, plant, wanted)
    lift = largest_lift(craft)
    service = ceiling(craft, lift, SERVICE)
    absolute = ceiling(craft, lift, 0.0, service.h if service else 0.0)
    speeds = level_speeds(craft, lift, h)
    if speeds is None:
        raise SpecError(_too_high(condition, h, absolute))
    structure = structure_of(condition, craft, speeds, wanted.n_max, wanted.n_min)
    V_corner = corner(craft, lift, speeds, structure.n_max)
    found = turns(craft, lift, speeds, structure.n_max, V_corner)
    diagram = vn_diagram(craft, structure, speeds, (lift, largest_lift(craft, -1.0)))
    rows = over_height(craft, lift, absolute.h if absolute else h)
    figures = {
        "level flight": list(_of_level(craft, lift, speeds)),
        "climb": list(_of_climb(craft, lift, speeds, service, absolute)),
        "turn": list(_of_turn(found, V_corner, plant.earth.g)),
        "V-n (equivalent airspeeds)": list(_of_diagram(diagram, craft)),
    }
    return Performance(
        condition,
        h,
        figures,
        level_table(craft, speeds),
        height_table(rows),
        excess_table(rows),
        turn_table(found, h, plant.earth.g),
        vn_table(diagram),
        diagram,
        [*assumptions(condition, plant), *_assumed(craft)],
    )


def craft_of(condition: FlightCondition, plant: SixDof, wanted: Wanted) -> Craft:
    """What performance is asked of. Raises SpecError for what makes no sense."""
    if not 0.0 < wanted.full <= plant.limits.upper.throttle:
        raise SpecError(
            f"A full throttle of {wanted.full:g} is asked for; it must be more than 0 and at most "
            f"{plant.limits.upper.throttle:g}."
        )
    ref = condition.reference
    reach = reach_of(condition, wanted.slowest, wanted.fastest)
    craft = Craft(plant, reach, wanted.full, ref.V, ref.h, wanted.alpha_max, ref.S, ref.c)
    top, why = highest(craft)
    if wanted.h is not None and not 0.0 <= wanted.h <= top:
        raise SpecError(
            f"Performance at {wanted.h:,.0f} m is asked for; the height must be from 0 m to {top:,.0f} m ({why})."
        )
    return craft


def _too_high(condition: FlightCondition, h: Meter, absolute: Ceiling | None) -> str:
    at = f"{condition.aircraft_id} {condition.condition} cannot fly level at {h:,.0f} m at any speed that its data know"
    if absolute is None:
        return f"{at}, nor at sea level. Ask for more thrust, less weight or another condition."
    return f"{at}: its absolute ceiling is {absolute.h:,.0f} m ({absolute.limit}). Ask for a lower height."


def _of_level(craft: Craft, lift: Lift, speeds: Speeds) -> Iterator[Figure]:
    weight = craft.plant.inertia.m * craft.plant.earth.g
    yield Figure("stall at idle throttle", speeds.V_stall, "m/s", limit=lift.limit)
    yield Figure("slowest", speeds.line[0].V, "m/s", limit=speeds.slow_end)
    power = least(craft, speeds, lambda m: thrust_in(craft.plant, m) * m.V)
    drag = least(craft, speeds, lambda m: thrust_in(craft.plant, m))
    thrust = thrust_in(craft.plant, drag)
    yield Figure("least power", thrust_in(craft.plant, power) * power.V, "W", power.V)
    yield Figure("least thrust", thrust, "N", drag.V)
    yield Figure("weight over least thrust", weight / thrust, "1", drag.V)
    yield Figure("fastest", speeds.line[-1].V, "m/s", limit=speeds.fast_end)


def _of_climb(
    craft: Craft, lift: Lift, speeds: Speeds, service: Ceiling | None, absolute: Ceiling | None
) -> Iterator[Figure]:
    at = best_excess(craft, lift, speeds.h)
    if at is not None:
        yield Figure("specific excess power", at.excess, "m/s", at.V_climb)
    climbs = best_climbs(craft, speeds)
    if climbs is not None:
        yield Figure("rate of climb", rate_of_climb(climbs.fastest), "m/s", climbs.fastest.V)
        yield Figure("angle of climb", climbs.steepest.gamma, "rad", climbs.steepest.V)
    for name, found in (("service ceiling", service), ("absolute ceiling", absolute)):
        if found is not None:
            yield Figure(name, found.h, "m", limit=found.limit)


def _of_turn(found: Sequence[Turn], V_corner: MeterPerSecond | None, g: float) -> Iterator[Figure]:
    for words, kept in (("instantaneous", False), ("sustained", True)):
        best = tightest_of(found, g, kept=kept)
        n = best.n_sustained if kept else best.n
        if n > 1.0:
            yield Figure(f"{words} turn rate", rate_of(n, best.V, g), "rad/s", best.V, "" if kept else best.limit)
            yield Figure("its load factor", n, "1", best.V)
            yield Figure("its radius", radius_of(n, best.V, g), "m", best.V)
    most = max(found, key=lambda t: max(0.0, t.n_sustained))
    yield Figure("sustained load factor", most.n_sustained, "1", most.V)
    if V_corner is not None:
        yield Figure("corner speed", V_corner, "m/s")


def _of_diagram(diagram: VnDiagram, craft: Craft) -> Iterator[Figure]:
    structure = diagram.structure
    yield Figure("largest load factor", structure.n_max, "1", limit=_assumed_or_asked(structure.why_n))
    yield Figure("smallest load factor", structure.n_min, "1", limit=_assumed_or_asked(structure.why_n))
    yield Figure("V_S", diagram.V_stall, "m/s", limit=f"upward, {diagram.limits[0]}; downward, {diagram.limits[1]}")
    if diagram.V_A is not None:
        yield Figure("V_A", diagram.V_A, "m/s")
    yield Figure("V_C", structure.V_C, "m/s", limit=_assumed_or_asked(structure.why_V))
    yield Figure("V_D", structure.V_D, "m/s", limit=_assumed_or_asked(structure.why_V))
    loading = craft.plant.inertia.m * craft.plant.earth.g / craft.S
    for name, gust, V in diagram.gusts:
        words = f"FAR 23.341: {gust:.3g} m/s ({gust / FOOT:.3g} ft/s), alleviated by {diagram.alleviation:.3f}"
        yield Figure(f"load factor of a gust at {name}", diagram.gust_load(gust, V, loading), "1", V, words)


def _assumed_or_asked(why: str) -> str:
    return why if why.startswith("asked") else f"assumed: {why}"


def _assumed(craft: Craft) -> Iterator[str]:
    slow, fast = craft.reach.why_slow, craft.reach.why_fast
    between = f"to {fast}" if craft.reach.slow == 0.0 else f"from {slow}, to {fast}"
    yield f"Its data are used {between}. No limit of pressure, flutter or buffet is known."
    plant, engine = craft.plant, craft.plant.engine
    if plant.aerodynamics is term_loads and "mach" not in ends(plant.aero):
        yield "Its aerodynamic tables know no Mach number: far above that of their source, drag is not theirs."
    if hasattr(engine, "T_max"):
        T = craft.full * engine.T_max
        yield f"Assumed: thrust at the full throttle of {craft.full:g} is {T:,.0f} N in the flight condition."
