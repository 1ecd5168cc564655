"""What an aircraft can do: range of speeds, climb and ceiling, from steady flights of the nonlinear plant.

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
    AtHeight,
    Ceiling,
    best_climbs,
    ceiling,
    highest,
    over_height,
    rate_of_climb,
    times_to_climb,
)
from fdes.analysis.level_flight import (
    STEEPEST,
    Craft,
    Lift,
    Speeds,
    excess_power,
    largest_lift,
    least,
    level_speeds,
    reach_of,
)
from fdes.analysis.maneuver import thrust_in
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.nonlinear import assumptions, six_dof_of
from fdes.physics.plant import SixDof
from fdes.units import Meter, Number, Radian

if TYPE_CHECKING:
    import xarray as xr


class Wanted(NamedTuple):
    """What is asked for. What is None is as the aircraft's data say; `full` is the throttle of full thrust."""

    h: Meter | None = None
    full: Number = 1.0
    slowest: Number | None = None
    fastest: Number | None = None
    alpha_max: Radian = STEEPEST


class Figure(NamedTuple):
    """One result [SI unit]; `limit` is what makes it so, in words, where that is not the name itself."""

    name: str
    value: float
    unit: str
    limit: str = ""


@dataclass(frozen=True)
class Performance:
    """The figures by subject, and the tables they are from.

    level: over true airspeed at `h`. heights: from sea level to the absolute ceiling, or where the data end.
    """

    condition: FlightCondition
    h: Meter
    figures: Mapping[str, Sequence[Figure]]
    level: "xr.Dataset"
    heights: "xr.Dataset"
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
    rows = over_height(craft, lift, absolute.h if absolute else h)
    return Performance(
        condition,
        h,
        {
            "level flight": list(_of_level(craft, lift, speeds)),
            "climb": list(_of_climb(craft, speeds, service, absolute)),
        },
        _level_table(craft, speeds),
        _height_table(rows),
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
    craft = Craft(plant, reach, wanted.full, ref.V, ref.h, wanted.alpha_max)
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
    yield Figure("stall at idle throttle", speeds.V_stall, "m/s", lift.limit)
    yield Figure("slowest", speeds.line[0].V, "m/s", speeds.slow_end)
    power = least(craft, speeds, lambda m: thrust_in(craft.plant, m) * m.V)
    yield Figure("least power", power.V, "m/s")
    drag = least(craft, speeds, lambda m: thrust_in(craft.plant, m))
    yield Figure("least drag", drag.V, "m/s")
    yield Figure("weight over least thrust", weight / thrust_in(craft.plant, drag), "1")
    yield Figure("fastest", speeds.line[-1].V, "m/s", speeds.fast_end)


def _of_climb(craft: Craft, speeds: Speeds, service: Ceiling | None, absolute: Ceiling | None) -> Iterator[Figure]:
    climbs = best_climbs(craft, speeds)
    gains = [(excess_power(craft, m, m.V), m.V) for m in speeds.line]
    best, V = max(gains)
    yield Figure("largest specific excess power", best, "m/s")
    yield Figure("at a speed of", V, "m/s")
    if climbs.fastest is not None and climbs.steepest is not None:
        yield Figure("best rate of climb", rate_of_climb(climbs.fastest), "m/s")
        yield Figure("its speed", climbs.fastest.V, "m/s")
        yield Figure("best angle of climb", climbs.steepest.gamma, "rad")
        yield Figure("speed of best angle", climbs.steepest.V, "m/s")
    for name, found in (("service ceiling", service), ("absolute ceiling", absolute)):
        if found is not None:
            yield Figure(name, found.h, "m", found.limit)


def _assumed(craft: Craft) -> Iterator[str]:
    slow, fast = craft.reach.why_slow, craft.reach.why_fast
    between = f"to {fast}" if craft.reach.slow == 0.0 else f"from {slow}, to {fast}"
    yield f"Its data are used {between}. No limit of pressure, flutter or buffet is known."
    engine = craft.plant.engine
    if hasattr(engine, "T_max"):
        T = craft.full * engine.T_max
        yield f"Assumed: thrust at the full throttle of {craft.full:g} is {T:,.0f} N in the flight condition."


def _level_table(craft: Craft, speeds: Speeds) -> "xr.Dataset":
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


def _height_table(rows: Sequence[AtHeight]) -> "xr.Dataset":
    nan = float("nan")
    return labeled(
        ("h", [r.h for r in rows], "m", "height"),
        ("V_stall", [r.V_stall for r in rows], "m/s", "stall at idle throttle"),
        ("V_slow", [r.speeds.line[0].V if r.speeds else nan for r in rows], "m/s", "slowest level flight"),
        ("V_fast", [r.speeds.line[-1].V if r.speeds else nan for r in rows], "m/s", "fastest level flight"),
        ("V_climb", [r.V_climb for r in rows], "m/s", "speed of the largest specific excess power"),
        ("excess_power", [r.excess for r in rows], "m/s", "largest specific excess power"),
        ("time", times_to_climb(rows), "s", "time to climb at the largest specific excess power"),
    )


def labeled(
    axis: tuple[str, Sequence[float], str, str], *columns: tuple[str, Sequence[float], str, str], **said: str
) -> "xr.Dataset":
    """A table of columns over the first one: each its name, values, unit, and what it is in words."""
    import xarray as xr

    dim, values, unit, words = axis
    data = {name: (dim, list(column), {"units": u, "long_name": w}) for name, column, u, w in columns}
    return xr.Dataset(data, {dim: (dim, list(values), {"units": unit, "long_name": words})}, said)
