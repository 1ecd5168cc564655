"""Charts of flying qualities as data: axes, the boundaries of the Levels, and the aircraft's point.

One description for all who draw: `as_drawing` makes panels for Matplotlib and Plotly of it, and the cockpit's canvas
reads `Chart.as_dict()`.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from fdes.analysis.drawing import COLORS, INK, LINES, Curve, Drawing, Note, Panel
from fdes.analysis.verdict import level_name
from fdes.errors import SpecError


@dataclass(frozen=True)
class ChartAxis:
    """One axis: what it shows, in `unit`, from `low` to `high`; `log` says how."""

    label: str
    unit: str
    low: float
    high: float
    log: bool

    @property
    def title(self) -> str:
        """The label with its unit."""
        return self.label if self.unit == "1" else f"{self.label} [{self.unit}]"


@dataclass(frozen=True)
class Boundary:
    """One boundary of a Level, as a line through the points (x, y)."""

    level: int
    label: str
    x: tuple[float, ...]
    y: tuple[float, ...]


@dataclass(frozen=True)
class Chart:
    """One figure. point: the aircraft, None where it is not known; level: that of its verdict."""

    criterion: str
    title: str
    reference: str
    x: ChartAxis
    y: ChartAxis
    boundaries: tuple[Boundary, ...]
    point: tuple[float, float] | None
    level: int | None

    def as_dict(self) -> dict[str, Any]:
        """The chart as JSON has it."""
        lines = [vars(line) for line in self.boundaries]
        return {**vars(self), "x": vars(self.x), "y": vars(self.y), "boundaries": lines}


def spaced(low: float, high: float, count: int = 41) -> tuple[float, ...]:
    """`count` numbers from `low` to `high`, each the same factor larger than the one before."""
    step = math.log(high / low) / (count - 1)
    return (low, *(low * math.exp(step * k) for k in range(1, count - 1)), high)


def as_drawing(charts: Sequence[Chart], title: str) -> Drawing:
    """All charts side by side. Raises SpecError where there is none."""
    if not charts:
        raise SpecError("None of these criteria has a chart: ask for the short period or the Dutch roll.")
    panels = tuple(_panel(chart, legend=chart is charts[0]) for chart in charts)
    return Drawing(title, panels, stacked=False, width=5.2 * len(panels), height=5.6)


def _panel(chart: Chart, *, legend: bool) -> Panel:
    named: set[int] = set()
    curves = []
    for line in chart.boundaries:
        new = legend and line.level not in named
        named.add(line.level)
        label = f"Level {line.level}" if new else ""
        curves.append(Curve(line.x, line.y, label, COLORS[line.level - 1], LINES[line.level - 1]))
    if chart.point:
        x, y = chart.point
        curves.append(Curve((x,), (y,), "this aircraft" if legend else "", INK, "none"))
    return Panel(
        x_label=chart.x.title,
        y_label=chart.y.title,
        curves=tuple(curves),
        notes=(Note(*chart.point, level_name(chart.level), dx=8.0, dy=8.0),) if chart.point else (),
        x_range=(chart.x.low, chart.x.high),
        y_range=(chart.y.low, chart.y.high),
        title=f"{chart.title.partition(',')[0]}\n{chart.reference}",
        x_log=chart.x.log,
        y_log=chart.y.log,
    )
