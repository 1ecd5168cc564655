"""Trim over speed and height: which speeds can be flown, what limits them, and the elevator, angle of attack, throttle
and power that they need.

The specific excess power is that of level flight: (available less required thrust) V / weight, the climb rate that full
throttle would begin. Reference: J. D. Anderson, Aircraft Performance and Design, McGraw-Hill 1999, ch. 5.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from fdes.analysis.drawing import COLORS, LINES, Curve, Drawing, Panel
from fdes.analysis.jacobian import thrust_at
from fdes.analysis.trim import TrimPoint, TrimSpec, shortfalls, solve
from fdes.physics.plant import SixDof
from fdes.physics.propulsion import Thrust
from fdes.units import DEG, FOOT, G0

SLOWEST, FASTEST, STEPS = 0.25, 4.0, 60  # of the speed asked for, where the search looks, in so many equal ratios
WITHIN = 1e-3  # of a speed: how exactly the ends are found
COUNT = 41  # points of a line


@dataclass(frozen=True)
class TrimLine:
    """The steady flights at one height, from the slowest to the fastest, and what keeps them from going further.

    required, available [N]: thrust at each point. slow_end, fast_end: in words; empty where the search itself ended.
    """

    h: float
    points: tuple[TrimPoint, ...]
    required: tuple[float, ...]
    available: tuple[float, ...]
    slow_end: str
    fast_end: str

    @property
    def speeds(self) -> list[float]:
        """True airspeeds [m/s]."""
        return [point.spec.V for point in self.points]

    def excess_power(self) -> list[float]:
        """Specific excess power [m/s] of each point."""
        weight = self.points[0].plant.inertia.m * G0
        pairs = zip(self.speeds, self.required, self.available, strict=True)
        return [V * (have - need) / weight for V, need, have in pairs]


def trim_map(plant: SixDof, spec: TrimSpec, heights: Iterable[float]) -> list[TrimLine]:
    """The lines at those heights [m] at which the flight `spec` can be flown at some speed; others are left out."""
    lines = (_line(plant, spec._replace(h=h)) for h in heights)
    return [line for line in lines if line is not None]


def _line(plant: SixDof, spec: TrimSpec) -> TrimLine | None:
    """Between the ends of the longest run of speeds that can be flown."""
    tried = spec.V * np.geomspace(SLOWEST, FASTEST, STEPS)
    flown = [not _short(plant, spec, float(V)) for V in tried]
    first, last = _longest_run(flown)
    if first is None or last is None:
        return None
    slow, slow_end = _end(plant, spec, float(tried[first]), float(tried[first - 1]) if first else None)
    fast, fast_end = _end(plant, spec, float(tried[last]), float(tried[last + 1]) if last + 1 < STEPS else None)
    points = tuple(solve(plant, spec._replace(V=float(V))) for V in np.linspace(slow, fast, COUNT))
    full = tuple(_size(thrust_at(point, 1.0)) for point in points)
    need = tuple(_size(thrust_at(point, point.surfaces.throttle)) for point in points)
    return TrimLine(spec.h, points, need, full, slow_end, fast_end)


def _size(thrust: Thrust) -> float:
    return math.hypot(thrust.X, thrust.Z)


def _short(plant: SixDof, spec: TrimSpec, V: float) -> str:
    return "; ".join(shortfalls(solve(plant, spec._replace(V=V)), plant.limits))


def _longest_run(flown: Sequence[bool]) -> tuple[int | None, int | None]:
    best: tuple[int | None, int | None] = (None, None)
    length, start = 0, 0
    for k, flies in enumerate([*flown, False]):
        if flies:
            continue
        if k - start > length:
            length, best = k - start, (start, k - 1)
        start = k + 1
    return best


def _end(plant: SixDof, spec: TrimSpec, can: float, cannot: float | None) -> tuple[float, str]:
    """The last speed that can be flown on the way from `can` to `cannot`, and what falls short beyond."""
    if cannot is None:
        return can, ""
    while abs(can - cannot) > WITHIN * can:
        between = 0.5 * (can + cannot)
        can, cannot = (can, between) if _short(plant, spec, between) else (between, cannot)
    return can, _short(plant, spec, cannot)


def drawn(lines: Sequence[TrimLine], title: str) -> Drawing:
    """Elevator, angle of attack, throttle and power over true airspeed, one line for each height."""
    panels = [
        _panel(
            "elevator, from rest [deg]",
            lines,
            [[p.surfaces.elevator / DEG for p in x.points] for x in lines],
            legend=True,
        ),
        _panel("angle of attack [deg]", lines, [[p.alpha / DEG for p in x.points] for x in lines]),
        _panel("throttle", lines, [[p.surfaces.throttle for p in x.points] for x in lines]),
        _panel("power required [kW]", lines, [_power(x) for x in lines]),
        _panel("specific excess power [m/s]", lines, [x.excess_power() for x in lines]),
    ]
    return Drawing(title, tuple(panels), stacked=True, width=8.0, height=11.0)


def _power(line: TrimLine) -> list[float]:
    return [1e-3 * V * T for V, T in zip(line.speeds, line.required, strict=True)]


def _panel(label: str, lines: Sequence[TrimLine], values: Sequence[Sequence[float]], *, legend: bool = False) -> Panel:
    curves = []
    for k, (line, y) in enumerate(zip(lines, values, strict=True)):
        name = f"{line.h:,.0f} m ({line.h / FOOT:,.0f} ft)"
        color, dashes = COLORS[k % len(COLORS)], LINES[k % len(LINES)]
        curves.append(Curve(line.speeds, y, name, color, dashes, in_legend=legend))
    return Panel("true airspeed [m/s]", label, tuple(curves))
