"""Performance drawn: thrust and power over speed, the envelope, climb over height, turns, and the V-n diagram."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

import numpy as np

from fdes.analysis.drawing import COLORS, GRID, INK, Curve, Drawing, Line, Note, Panel
from fdes.analysis.performance import Figure, Performance
from fdes.analysis.turning import rate_of
from fdes.units import DEG, G0

if TYPE_CHECKING:
    import xarray as xr

BLUE, VERMILION, GREEN, PURPLE, SKY, ORANGE = COLORS
SPEED = "true airspeed [m/s]"
LOAD_FACTORS = (1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
FINER = 8  # rows of a contour, for each that was computed
LEVELS = 6  # lines of specific excess power, about
NEAR = 0.15  # of the range of speeds: closer to the axis, a word would lie over it
ROOM = 1.08  # beyond the largest value


def drawn(found: Performance, title: str) -> Drawing:
    """All of it on one sheet, in SI."""
    panels = (
        _required_and_available(found, "thrust", "kN"),
        _required_and_available(found, "power", "kW"),
        _envelope(found),
        _climb(found),
        _turn(found),
        _v_n(found),
    )
    return Drawing(title, panels, stacked=True, common_x=False, width=13.0, height=15.0)


def _values(data: "xr.Dataset", name: str, factor: float = 1.0) -> list[float]:
    values: list[float] = (data[name].to_numpy() * factor).tolist()
    return values


def _curve(data: "xr.Dataset", x: str, y: str, factor: float, label: str, color: str, line: Line = "solid") -> Curve:
    return Curve(_values(data, x), _values(data, y, factor), label, color, line)


def _required_and_available(found: Performance, what: str, unit: str) -> Panel:
    """Thrust or power in level flight over speed, in thousands of its unit, and the least that is required."""
    need = _curve(found.level, "V", f"{what}_required", 1e-3, "required", BLUE)
    have = _curve(found.level, "V", f"{what}_available", 1e-3, "available", VERMILION, "dash")
    least = found.figure(f"least {what}")
    return Panel(
        SPEED,
        f"{what} [{unit}]",
        (need, have),
        _mark(found, least, f"least {what}"),
        y_range=(0.0, ROOM * max(*need.y, *have.y)),
        title=f"level flight at {found.h:,.0f} m",
    )


def _mark(found: Performance, least: Figure, words: str) -> tuple[Note, ...]:
    """Above the curve, and not over the axis where the slowest flight is the cheapest."""
    if least.V is None:
        return ()
    slow, fast = (float(found.level["V"][k]) for k in (0, -1))
    anchor: Literal["left", "center"] = "left" if slow + NEAR * (fast - slow) > least.V else "center"
    return (Note(least.V, 1e-3 * least.value, words, dy=9.0, anchor=anchor),)


def _envelope(found: Performance) -> Panel:
    rows = found.heights
    h = _values(rows, "h", 1e-3)
    lines: tuple[tuple[str, str, str, Line], ...] = (
        ("V_stall", "stall, idle throttle", PURPLE, "dashdot"),
        ("V_slow", "slowest", BLUE, "solid"),
        ("V_fast", "fastest", VERMILION, "solid"),
        ("V_climb", "largest excess power", GREEN, "dash"),
    )
    curves = [Curve(_values(rows, name), h, label, color, line) for name, label, color, line in lines]
    notes = []
    for level in _levels(max(_values(rows, "excess_power"))):
        for V, H in _contour(found, level):
            label = "" if len(curves) > len(lines) else "specific excess power [m/s]"
            curves.append(Curve(V, [0.001 * x for x in H], label, INK, "solid", 0.7))
            top = max(range(len(H)), key=lambda j: H[j])
            notes.append(Note(V[top], 0.001 * H[top], f"{level:g}", dy=5.0, anchor="center", size=7.5))
    ends = 0.0, ROOM * max(x for x in curves[2].x if math.isfinite(x))
    return Panel(SPEED, "height [km]", tuple(curves), tuple(notes), x_range=ends, title="speed-height envelope")


def _levels(most: float) -> list[float]:
    """Multiples of 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(most / LEVELS))
    step = next(f * power for f in (1.0, 2.0, 5.0, 10.0) if f * power >= most / LEVELS)
    return [step * k for k in range(1, int(most / step) + 1)]


def _contour(found: Performance, level: float) -> Iterator[tuple[list[float], list[float]]]:
    """Where the specific excess power is `level`: the slower branch and the faster one, which meet at the top."""
    heights, best, V_best = (_between(_values(found.heights, name)) for name in ("h", "excess_power", "V_climb"))
    speeds, gains = (
        list(zip(*(_between(column) for column in found.excess[name].to_numpy().T.tolist()), strict=True))
        for name in ("V", "excess_power")
    )
    slower: list[tuple[float, float]] = []
    faster: list[tuple[float, float]] = []
    for h, peak, V_peak, V, gain in zip(heights, best, V_best, speeds, gains, strict=True):
        if peak < level:
            break
        points = sorted([*((a, b) for a, b in zip(V, gain, strict=True) if math.isfinite(b)), (V_peak, peak)])
        up = [x for x in _crossings(points, level) if x <= V_peak]
        down = [x for x in _crossings(points, level) if x > V_peak]
        slower += [(up[-1], h)] if up else []
        faster += [(down[0], h)] if down else []
    top = _top(heights, best, V_best, level)
    if faster and slower:
        path = [*slower, *top, *reversed(faster)]
        yield [x for x, _ in path], [y for _, y in path]
    elif branch := slower or faster:
        path = [*branch, *top]
        yield [x for x, _ in path], [y for _, y in path]


def _between(rows: Sequence[float]) -> list[float]:
    """The same with straight lines between the rows, so that a contour is not broken at each."""
    at = np.linspace(0.0, len(rows) - 1.0, FINER * (len(rows) - 1) + 1)
    between: list[float] = np.interp(at, range(len(rows)), rows).tolist()
    return between


def _crossings(points: Sequence[tuple[float, float]], level: float) -> list[float]:
    found = []
    for (x, y), (x_next, y_next) in pairwise(points):
        if (y - level) * (y_next - level) < 0.0:
            found.append(x + (level - y) / (y_next - y) * (x_next - x))
    return found


def _top(h: Sequence[float], best: Sequence[float], V: Sequence[float], level: float) -> list[tuple[float, float]]:
    for k in range(len(h) - 1):
        if best[k] >= level > best[k + 1]:
            share = (best[k] - level) / (best[k] - best[k + 1])
            return [(V[k] + share * (V[k + 1] - V[k]), h[k] + share * (h[k + 1] - h[k]))]
    return []


def _climb(found: Performance) -> Panel:
    """The time that it takes stands at some of the heights."""
    rows = found.heights
    h, gain = _values(rows, "h", 1e-3), _values(rows, "excess_power")
    timed = [(x, y, t / 60.0) for x, y, t in zip(gain, h, _values(rows, "time"), strict=True) if math.isfinite(t)]
    notes = [Note(x, y, f"{t:.1f} min", dx=7.0, size=8.0) for x, y, t in timed[2::3]]
    return Panel(
        "largest specific excess power [m/s]",
        "height [km]",
        (Curve(gain, h, "with the time to climb", GREEN),),
        tuple(notes),
        x_range=(0.0, ROOM * max(gain)),
        title="climb at full throttle",
    )


def _turn(found: Performance) -> Panel:
    turn = found.turn
    V, rate = _values(turn, "V"), _values(turn, "rate", 1.0 / DEG)
    top = ROOM * max(rate)
    curves = [
        Curve(V, rate, "for an instant", VERMILION),
        Curve(V, _values(turn, "rate_sustained", 1.0 / DEG), "kept up", BLUE, "dash"),
    ]
    notes = []
    for n in (n for n in LOAD_FACTORS if n <= 1.05 * max(_values(turn, "n"))):
        rates = [rate_of(n, x, G0) / DEG for x in V]
        curves.append(Curve(V, rates, color=GRID, width=0.8))
        notes.append(Note(V[-1], rates[-1], f"n {n:g}", dx=3.0, size=7.5))
    return Panel(
        SPEED,
        "turn rate [deg/s]",
        tuple(curves),
        tuple(notes),
        (0.0, ROOM * V[-1]),
        (0.0, top),
        f"turns at {found.h:,.0f} m",
    )


def _v_n(found: Performance) -> Panel:
    bounds, diagram = found.v_n, found.diagram
    structure, V = diagram.structure, _values(bounds, "V")
    up, down = _values(bounds, "n_upper"), _values(bounds, "n_lower")
    begins = [k / FINER for k in range(FINER)]  # of the first speed; there n grows as its square
    outline = (
        [*(k * V[0] for k in begins), *V, *reversed(V), *(k * V[0] for k in reversed(begins))],
        [*(k * k * up[0] for k in begins), *up, *reversed(down), *(k * k * down[0] for k in reversed(begins))],
    )
    curves = [
        Curve(V, _values(bounds, "n_lift_up"), diagram.limits[0], PURPLE, "dot"),
        Curve(V, _values(bounds, "n_lift_down"), diagram.limits[1], PURPLE, "dashdot"),
        Curve(*outline, "maneuvers", BLUE),
    ]
    loading = found.condition.reference.m * G0 / found.condition.reference.S
    most, least = structure.n_max, structure.n_min
    colors = dict(zip(("V_C", "V_D"), (VERMILION, ORANGE), strict=True))
    for name, gust, ends in diagram.gusts:
        n = diagram.gust_load(gust, ends, loading)
        most, least = max(most, n), min(least, 2.0 - n)
        curves.append(Curve((0.0, ends), (1.0, n), f"gust of {gust:.3g} m/s at {name}", colors[name], "dash"))
        curves.append(Curve((0.0, ends), (1.0, 2.0 - n), color=colors[name], line="dash"))
    named = [("V_S", diagram.V_stall, 1.0), ("V_A", diagram.V_A, structure.n_max)]
    named += [("V_C", structure.V_C, 0.0), ("V_D", structure.V_D, 0.0)]
    return Panel(
        "equivalent airspeed [m/s]",
        "load factor",
        tuple(curves),
        tuple(Note(x, y, name, dx=-3.0, dy=6.0, anchor="right") for name, x, y in named if x is not None),
        y_range=(ROOM * least - 0.2, ROOM * most + 0.2),
        title=f"V-n diagram at {found.h:,.0f} m",
    )
