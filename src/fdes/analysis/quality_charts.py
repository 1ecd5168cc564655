"""Charts of flying qualities as data: axes, the boundaries of the Levels, and the aircraft's point.

One description for all who draw: `draw` for files, by Matplotlib or Plotly, and the cockpit's canvas, which reads
`Chart.as_dict()`.
"""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from html import escape
from pathlib import Path
from typing import Any

from fdes.analysis.verdict import level_name
from fdes.errors import SpecError, nearest

COLORS = {1: "#0b7a4b", 2: "#b07400", 3: "#b3261e"}  # of the boundary of a Level
PICTURES = ("html", "pdf", "png", "svg")


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
        return asdict(self)


def spaced(low: float, high: float, count: int = 41) -> tuple[float, ...]:
    """`count` numbers from `low` to `high`, each the same factor larger than the one before."""
    step = math.log(high / low) / (count - 1)
    return (low, *(low * math.exp(step * k) for k in range(1, count - 1)), high)


def draw(charts: Sequence[Chart], path: str | Path, title: str) -> None:
    """Draw all charts into one file, by its ending: html (Plotly), or png, svg, pdf (Matplotlib). Raises SpecError."""
    target = Path(path)
    kind = target.suffix.lstrip(".").lower()
    if kind not in PICTURES:
        near = nearest(kind, PICTURES)
        hint = f" Did you mean {near!r}?" if near else ""
        raise SpecError(f"A chart cannot be written as {target.name!r}.{hint} End it in one of: {', '.join(PICTURES)}.")
    if not charts:
        raise SpecError("None of the criteria asked for has a chart: ask for the short period or the Dutch roll.")
    try:
        if kind == "html":
            _as_page(charts, target, title)
        else:
            _as_picture(charts, target, title)
    except OSError as error:
        raise SpecError(f"{target} cannot be written: {error.strerror or error}.") from None


def _as_picture(charts: Sequence[Chart], path: Path, title: str) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.6 * len(charts), 5.2), layout="constrained")
    FigureCanvasAgg(figure)
    figure.suptitle(title)
    for chart, axes in zip(charts, figure.subplots(1, len(charts), squeeze=False)[0], strict=True):
        for line in chart.boundaries:
            axes.plot(line.x, line.y, color=COLORS[line.level], lw=1.6, label=line.label)
        if chart.point:
            axes.plot(*chart.point, "o", color="black", ms=7, label=f"this aircraft: {level_name(chart.level)}")
        axes.set(xlabel=chart.x.title, ylabel=chart.y.title, xlim=(chart.x.low, chart.x.high))
        axes.set(ylim=(chart.y.low, chart.y.high), xscale="log" if chart.x.log else "linear")
        axes.set_yscale("log" if chart.y.log else "linear")
        axes.set_title(f"{chart.title}\n{chart.reference}", fontsize=9)
        axes.grid(visible=True, which="both", alpha=0.25)
        axes.legend(fontsize=8)
    figure.savefig(path, dpi=150)


def _as_page(charts: Sequence[Chart], path: Path, title: str) -> None:
    from fdes.analysis.report import drawing, heading, page

    parts = []
    for chart in charts:
        parts += [heading(chart.title), f"<p>{escape(chart.reference)}</p>", drawing(plotly_figure(chart))]
    path.write_text(page(title, parts), encoding="utf-8")


def plotly_figure(chart: Chart) -> Any:
    """The chart as a Plotly figure."""
    from plotly.graph_objects import Figure

    plot = Figure()
    for line in chart.boundaries:
        plot.add_scatter(x=line.x, y=line.y, name=line.label, mode="lines", line={"color": COLORS[line.level]})
    if chart.point:
        name = f"this aircraft: {level_name(chart.level)}"
        x, y = chart.point
        plot.add_scatter(x=[x], y=[y], name=name, mode="markers", marker={"color": "black", "size": 11})
    plot.update_layout(
        xaxis=_plotly_axis(chart.x), yaxis=_plotly_axis(chart.y), template="plotly_white", height=520, showlegend=True
    )
    return plot


def _plotly_axis(axis: ChartAxis) -> dict[str, Any]:
    ends = (axis.low, axis.high)
    return {
        "title": {"text": axis.title},
        "type": "log" if axis.log else "linear",
        "range": [math.log10(end) for end in ends] if axis.log else list(ends),
    }
