"""The check cases as one HTML page: for each flight a table of errors, and plots of the differences."""

from collections.abc import Sequence

from fdes.analysis import report
from fdes.analysis.check_cases import Comparison

INTRODUCTION = (
    "NASA/TM-2015-218675, Check-Cases for Verification of 6-DOF Flight Vehicle Simulations. The report holds no "
    "tolerance; those here are our own. Differences are ours less theirs, in the unit of the column. Where a body has "
    "drag, each simulation's own air density is used, for it is the larger part of the difference; 'as flown' is "
    "without that."
)


def check_cases_page(found: Sequence[Comparison]) -> str:
    """The whole page, which needs no network."""
    parts = [report.paragraph(INTRODUCTION)]
    for scenario in dict.fromkeys(c.scenario for c in found):
        of_case = [c for c in found if c.scenario == scenario]
        parts += [report.heading(f"{of_case[0].title} ({scenario})"), _table(of_case)]
        parts += [
            _plot([c for c in of_case if c.column == column]) for column in dict.fromkeys(c.column for c in of_case)
        ]
    return report.page("NASA's check cases, flown by FDES", parts)


def _table(comparisons: Sequence[Comparison]) -> str:
    columns = ["simulation", "column", "as flown", "error", "allowed", "its density, relative", "verdict"]
    return report.plain_table(
        columns,
        [
            (
                c.simulation,
                c.column,
                f"{c.raw:.2e}",
                f"{c.error:.2e}",
                "" if c.note else f"{c.tolerance:.0e}",
                f"{c.excess:+.1e}" if c.excess else "",
                f"not held: {c.note}" if c.note else "passed" if c.passed else "FAILED",
            )
            for c in comparisons
        ],
    )


def _plot(comparisons: Sequence[Comparison]) -> str:
    """The difference to each simulation over time."""
    from plotly.graph_objects import Figure

    plot = Figure()
    for c in comparisons:
        plot.add_scatter(x=c.t, y=c.difference, name=c.simulation, mode="lines")
    plot.update_layout(
        xaxis={"title": {"text": "time [s]"}},
        yaxis={"title": {"text": f"difference of {comparisons[0].column}"}, "exponentformat": "e"},
        template="plotly_white",
        height=320,
        margin={"l": 90, "r": 20, "t": 20, "b": 50},
        showlegend=True,
    )
    return report.drawing(plot)
