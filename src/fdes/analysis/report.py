"""Reports as one HTML page that opens anywhere: plots, tables and what was found, without a network."""

from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING

from fdes import __version__

if TYPE_CHECKING:
    from plotly.graph_objects import Figure as Plot

    from fdes.analysis.paper import Claim, Figure

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #16202a; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; margin: 1rem 0; }
th, td { border-bottom: 1px solid #cfd9e2; padding: .3rem .8rem; text-align: left; font-variant-numeric: tabular-nums; }
.passed { color: #0b7a4b; } .failed { color: #b3261e; font-weight: 700; }
"""


def page(title: str, parts: Iterable[str]) -> str:
    """A whole page. `parts` are HTML; the drawing library travels inside, once."""
    from plotly.offline import get_plotlyjs

    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        f"<style>{STYLE}</style><script>{get_plotlyjs()}</script></head><body><h1>{escape(title)}</h1>"
        + "".join(parts)
        + f"<p>FDES {__version__}</p></body></html>"
    )


def paragraph(text: str) -> str:
    """A paragraph of plain text."""
    return f"<p>{escape(text)}</p>"


def heading(text: str) -> str:
    """A heading of plain text."""
    return f"<h2>{escape(text)}</h2>"


def plain_table(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table of plain texts."""
    head = "".join(f"<th>{escape(c)}</th>" for c in columns)
    body = "".join("<tr>" + "".join(f"<td>{escape(v)}</td>" for v in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def claims_table(claims: "Iterable[Claim]") -> str:
    """What the source says, what was found, and whether they agree."""
    rows = "".join(
        f"<tr><td>{escape(c.says)}</td><td>{escape(c.found)}</td>"
        f'<td class="{"passed" if c.passed else "failed"}">{"passed" if c.passed else "failed"}</td></tr>'
        for c in claims
    )
    return f"<table><thead><tr><th>The paper</th><th>Found</th><th></th></tr></thead><tbody>{rows}</tbody></table>"


def drawing(plot: "Plot") -> str:
    """A plot, without the library that draws it."""
    return str(plot.to_html(full_html=False, include_plotlyjs=False))


def figure_part(figure: "Figure") -> str:
    """A figure of the paper: solid what the integrator gave, dashed the exact response, as the paper draws them."""
    from plotly.graph_objects import Figure as Plot

    plot = Plot()
    for found in figure.responses:
        plot.add_scatter(x=found.t, y=found.rate, name=found.label, mode="lines")
    exact = figure.exact
    plot.add_scatter(x=exact.t, y=exact.rate, name="exact", mode="lines", line={"dash": "dash", "color": "black"})
    top = 1.6 * float(abs(exact.rate).max())
    plot.update_layout(
        xaxis={"title": {"text": "time [s]"}},
        yaxis={"title": {"text": figure.rate}, "range": [min(-0.2 * top, 1.6 * float(exact.rate.min())), top]},
        template="plotly_white",
        height=380,
        margin={"l": 60, "r": 20, "t": 20, "b": 50},
    )
    return heading(f"Figure {figure.name}: {figure.title}") + drawing(plot) + claims_table(figure.claims)
