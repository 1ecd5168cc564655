"""A figure as data, and the two ways to draw it: Matplotlib for PNG and SVG, Plotly for a page that opens anywhere.

Both libraries are imported when something is drawn. Colors are those of M. Okabe and K. Ito, Color Universal Design
(2008), which color-blind people can tell apart; curves of one panel differ by their dashes too.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, log10
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from plotly.graph_objects import Figure as PlotlyFigure

COLORS = (
    "#0072B2",
    "#D55E00",
    "#009E73",
    "#CC79A7",
    "#56B4E9",
    "#E69F00",
)  # blue, vermilion, green, purple, sky, orange
INK, GRID = "#16202a", "#b9c4ce"
Line = Literal["solid", "dash", "dot", "dashdot", "none"]
LINES: tuple[Line, ...] = ("solid", "dash", "dot", "dashdot")
FORMATS = (".png", ".svg", ".html")
DOTS = 150  # per inch, of a PNG
TITLE_SIZE = 11  # pixels, of a panel on a page
PIXELS = 96  # per inch, of a page


@dataclass(frozen=True)
class Curve:
    """A line, or crosses where `line` is none. Without a label, or said not to be, it is not in the legend."""

    x: Sequence[float]
    y: Sequence[float]
    label: str = ""
    color: str = COLORS[0]
    line: Line = "solid"
    width: float = 1.6
    in_legend: bool = True


@dataclass(frozen=True)
class Note:
    """A few words in a panel: `dx`, `dy` in points from (x, y); `anchor` is the side held there."""

    x: float
    y: float
    words: str
    dx: float = 0.0
    dy: float = 0.0
    anchor: Literal["left", "center", "right"] = "left"
    color: str = INK
    size: float = 9.0


@dataclass(frozen=True)
class Panel:
    """One pair of axes. With `equal` one unit is as long on both."""

    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    notes: tuple[Note, ...] = ()
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None
    title: str = ""
    equal: bool = False
    x_log: bool = False
    y_log: bool = False


@dataclass(frozen=True)
class Drawing:
    """Panels, side by side or stacked, `width` by `height` inches.

    common_x: stacked over one x axis; else each has its own, two in a row of a picture, each on its own on a page.
    """

    title: str
    panels: tuple[Panel, ...]
    stacked: bool = True
    common_x: bool = True
    width: float = 9.0
    height: float = 5.0


def save(drawing: Drawing, path: Path) -> None:
    """Write the drawing in the format that the suffix says, one of `FORMATS`."""
    if path.suffix.lower() == ".html":
        from fdes.analysis.report import drawing as as_html
        from fdes.analysis.report import page

        path.write_text(page(drawing.title, [as_html(to_plotly(drawing))]), encoding="utf-8")
    else:
        _save_with_matplotlib(drawing, path)


def _save_with_matplotlib(drawing: Drawing, path: Path) -> None:
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    styles = {"solid": "-", "dash": "--", "dot": ":", "dashdot": "-.", "none": "none"}
    with rc_context({"svg.fonttype": "none", "font.size": 9, "svg.hashsalt": "fdes"}):
        figure = Figure(figsize=(drawing.width, drawing.height), layout="constrained")
        FigureCanvasAgg(figure)
        figure.suptitle(fill(drawing.title, int(10.0 * drawing.width)), fontsize=11)
        n = len(drawing.panels)
        common_x = drawing.stacked and drawing.common_x
        grid = figure.subplots(*_rows_and_columns(drawing), squeeze=False, sharex=common_x)
        for axes, panel in zip(grid.flat[:n], drawing.panels, strict=True):
            for curve in panel.curves:
                axes.plot(
                    curve.x,
                    curve.y,
                    linestyle=styles[curve.line],
                    color=curve.color,
                    linewidth=curve.width,
                    marker="x" if curve.line == "none" else None,
                    markersize=8,
                    markeredgewidth=2,
                    label=(curve.in_legend and curve.label) or "_nolegend_",
                )
            for note in panel.notes:
                axes.annotate(
                    note.words,
                    (note.x, note.y),
                    (note.dx, note.dy),
                    textcoords="offset points",
                    ha=note.anchor,
                    va="center",
                    color=note.color,
                    fontsize=note.size,
                    annotation_clip=False,
                )
            axes.set(ylabel=panel.y_label, title=panel.title)
            axes.set_xscale("log" if panel.x_log else "linear")
            axes.set_yscale("log" if panel.y_log else "linear")
            axes.set(**{k: v for k, v in (("xlim", panel.x_range), ("ylim", panel.y_range)) if v is not None})
            if panel.equal:
                axes.set_aspect("equal")
            else:
                axes.grid(visible=True, color=GRID, linewidth=0.5)
            if drawing.stacked and any(curve.label and curve.in_legend for curve in panel.curves):
                beside = {"frameon": False, "loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}
                axes.legend(**(beside if drawing.common_x else {"framealpha": 0.8, "edgecolor": "none"}))
        for axes, panel in zip(grid.flat[:n], drawing.panels, strict=True):
            if not common_x or panel is drawing.panels[-1]:
                axes.set_xlabel(panel.x_label)
        if not drawing.stacked:
            figure.legend(frameon=False, loc="outside lower center", ncols=len(LINES))
        figure.align_ylabels()
        figure.savefig(path, dpi=DOTS, metadata={"Title": drawing.title})


def _rows_and_columns(drawing: Drawing) -> tuple[int, int]:
    n = len(drawing.panels)
    if not drawing.stacked:
        return 1, n
    return (n, 1) if drawing.common_x else (ceil(n / 2), 2)


def to_plotly(drawing: Drawing) -> "PlotlyFigure":
    """The drawing for a page; every curve says its numbers when it is pointed at."""
    from plotly.subplots import make_subplots

    n = len(drawing.panels)
    rows, columns = (n, 1) if drawing.stacked else (1, n)
    inches = drawing.height if drawing.common_x else drawing.height * n / ceil(n / 2)
    gap = (0.35 if drawing.common_x else 1.0) / inches if drawing.stacked else 0.09
    titles = [panel.title.replace("\n", "<br>") for panel in drawing.panels]
    plot = make_subplots(
        rows,
        columns,
        shared_xaxes=drawing.stacked and drawing.common_x,
        vertical_spacing=gap if rows > 1 else 0.0,
        horizontal_spacing=gap if columns > 1 else 0.0,
        subplot_titles=titles if any(titles) else None,
    )
    plot.update_annotations(font_size=TITLE_SIZE)
    height = int(inches * PIXELS)
    for k, panel in enumerate(drawing.panels):
        row, column = (k + 1, 1) if drawing.stacked else (1, k + 1)
        number = str(k + 1) if k else ""
        for curve in panel.curves:
            crosses = curve.line == "none"
            plot.add_scatter(
                x=list(curve.x),
                y=list(curve.y),
                name=curve.label,
                showlegend=bool(curve.label) and curve.in_legend,
                legend=f"legend{number}" if drawing.stacked else "legend",
                mode="markers" if crosses else "lines",
                line=None if crosses else {"color": curve.color, "dash": curve.line, "width": curve.width},
                marker={"symbol": "x-thin", "size": 9, "line": {"width": 2.5, "color": curve.color}}
                if crosses
                else None,
                hoverinfo=None if curve.label or crosses else "skip",
                row=row,
                col=column,
            )
        for note in panel.notes:
            plot.add_annotation(
                x=log10(note.x) if panel.x_log else note.x,
                y=log10(note.y) if panel.y_log else note.y,
                text=note.words,
                showarrow=False,
                xanchor=note.anchor,
                yanchor="middle",
                xshift=note.dx * PIXELS / 72.0,
                yshift=note.dy * PIXELS / 72.0,
                font={"size": note.size * PIXELS / 72.0, "color": note.color},
                row=row,
                col=column,
            )
        last = not (drawing.stacked and drawing.common_x) or k == n - 1
        plot.update_xaxes(title_text=panel.x_label if last else None, range=panel.x_range, row=row, col=column)
        plot.update_yaxes(title_text=panel.y_label, range=panel.y_range, row=row, col=column)
        _logarithmic(plot, panel, row, column)
        if panel.equal:
            plot.update_xaxes(constrain="domain", showgrid=False, zeroline=False, row=row, col=column)
            plot.update_yaxes(
                scaleanchor=f"x{number}", constrain="domain", showgrid=False, zeroline=False, row=row, col=column
            )
        if drawing.stacked:
            top = plot.layout[f"yaxis{number}"].domain[1]
            plot.update_layout({f"legend{number}": {"x": 1.01, "y": top, "yanchor": "top"}})
    if not drawing.stacked:
        plot.update_layout(legend={"orientation": "h", "x": 0.5, "xanchor": "center", "y": -0.13, "yanchor": "top"})
    plot.update_layout(
        template="plotly_white", height=height, margin={"l": 70, "r": 30, "t": 40, "b": 70}, font={"color": INK}
    )
    plot.update_xaxes(showline=True, linecolor=GRID, ticks="outside", mirror=True)
    plot.update_yaxes(showline=True, linecolor=GRID, ticks="outside", mirror=True)
    return plot


def _logarithmic(plot: "PlotlyFigure", panel: Panel, row: int, column: int) -> None:
    """Plotly wants the ends of a logarithmic axis as exponents."""
    for log, ends, update in (
        (panel.x_log, panel.x_range, plot.update_xaxes),
        (panel.y_log, panel.y_range, plot.update_yaxes),
    ):
        if log:
            update(type="log", range=ends and [log10(end) for end in ends], row=row, col=column)
