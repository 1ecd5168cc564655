"""`fdes performance`: what an aircraft can do, from steady flights of the nonlinear plant."""

import math
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fdes.cli.options import Across, AircraftName, AsJson, Changes, ConditionName, PlotFile, VariantName, chosen
from fdes.cli.output import note, number, print_json, screen, table, working
from fdes.units import DEG, FOOT, KNOT, POUND_FORCE, parse, to_si

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr

    from fdes.analysis.performance import Figure, Performance

# What engineers read a figure in, beside SI: by its unit there. A speed up is in ft/min.
SHOWN = {
    "m/s": (("m/s", 1.0), ("kt", 1.0 / KNOT)),
    "m": (("m", 1.0), ("ft", 1.0 / FOOT)),
    "rad": (("deg", 1.0 / DEG), None),
    "rad/s": (("deg/s", 1.0 / DEG), None),
    "1": (("", 1.0), None),
    "N": (("kN", 1e-3), ("lbf", 1.0 / POUND_FORCE)),
    "W": (("kW", 1e-3), ("hp", 1.0 / to_si(1.0, "hp"))),
}
UPWARD = (("m/s", 1.0), ("ft/min", 60.0 / FOOT))


def performance(
    aircraft: AircraftName,
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    changes: Changes = None,
    height: Annotated[
        str | None, typer.Option(metavar="TEXT", help="Of level flight and turns, such as '20000 ft'; the condition's.")
    ] = None,
    throttle: Annotated[
        float, typer.Option(metavar="NUMBER", help="What counts as full, such as 0.77 for no burner.")
    ] = 1.0,
    mach_min: Annotated[float | None, typer.Option(metavar="NUMBER", help="Look from this Mach number on.")] = None,
    mach_max: Annotated[float | None, typer.Option(metavar="NUMBER", help="Look up to this Mach number.")] = None,
    alpha_max: Annotated[
        str | None, typer.Option(metavar="TEXT", help="No larger angle of attack, such as '25 deg'.")
    ] = None,
    n_max: Annotated[
        float | None, typer.Option(metavar="NUMBER", help="The largest load factor of the structure.")
    ] = None,
    n_min: Annotated[float | None, typer.Option(metavar="NUMBER", help="The smallest one, such as -3.")] = None,
    across: Across = None,
    plot: PlotFile = None,
    json: AsJson = False,
) -> None:
    """Performance of the nonlinear plant: speeds, climb, ceiling, turns and V-n diagram.

    Every end names what limits it, and every assumption is said. Of fuel nothing is known, so of range and endurance
    nothing is said but the speeds of least drag and least power.
    """
    from fdes.analysis.level_flight import STEEPEST
    from fdes.analysis.performance import Wanted
    from fdes.analysis.performance import performance as found_by
    from fdes.analysis.performance_charts import drawn
    from fdes.cli.plot import save_plot, target_of

    target = target_of(plot)
    ready = chosen(aircraft, condition, variant, changes, across)
    wanted = Wanted(
        h=None if height is None else parse(height, "m"),
        full=throttle,
        slowest=mach_min,
        fastest=mach_max,
        n_max=n_max,
        n_min=n_min,
        alpha_max=STEEPEST if alpha_max is None else parse(alpha_max, "rad"),
    )
    with working("Flying it at many speeds and heights"):
        found = found_by(ready, wanted)
    if target is not None:
        save_plot(drawn(found, _title(found)), target)
    if json:
        print_json(_as_json(found))
        return
    _show(found)
    for sentence in found.notes:
        note(sentence)
    if plot is not None:
        screen().print(f"{plot} is written.", soft_wrap=True)


def _title(found: "Performance") -> str:
    ready = found.condition
    changes = "".join(f", {change}" for change in ready.changes)
    height = f"{found.h:,.0f} m ({found.h / FOOT:,.0f} ft)"
    return f"{ready.aircraft_name}, {ready.condition}{changes}: performance at {height}"


def _show(found: "Performance") -> None:
    screen().print(_title(found), style="bold", soft_wrap=True)
    for subject, figures in found.figures.items():
        rows = table(subject, "", "", "", "", "at m/s", "kt")
        for figure in figures:
            rows.add_row(figure.name, *_cells(figure))
        screen().print(rows)
    screen().print("What limits it", style="bold")
    for figures in found.figures.values():
        for words, names in _by_limit(figures).items():
            screen().print(f"{', '.join(names)}: {words}.", soft_wrap=True)


def _by_limit(figures: "Sequence[Figure]") -> dict[str, list[str]]:
    names: dict[str, list[str]] = {}
    for figure in figures:
        if figure.limit:
            names.setdefault(figure.limit, []).append(figure.name)
    return names


def _cells(figure: "Figure") -> list[str]:
    upward = figure.name in ("specific excess power", "rate of climb")
    one, other = UPWARD if upward else SHOWN[figure.unit]
    cells = [number(figure.value * one[1]), one[0]]
    cells += ["", ""] if other is None else [number(figure.value * other[1]), other[0]]
    return cells if figure.V is None else [*cells, number(figure.V), number(figure.V / KNOT)]


def _as_json(found: "Performance") -> dict[str, Any]:
    ready = found.condition
    return {
        "aircraft": ready.aircraft_id,
        "condition": ready.condition,
        "variant": ready.variant,
        "changes": [str(change) for change in ready.changes],
        "units": "SI",
        "h": found.h,
        "figures": {subject: [figure._asdict() for figure in figures] for subject, figures in found.figures.items()},
        "level": _columns(found.level),
        "heights": _columns(found.heights),
        "turn": _columns(found.turn),
        "v_n": _columns(found.v_n),
        "notes": list(found.notes),
    }


def _columns(data: "xr.Dataset") -> dict[str, Any]:
    """Its columns with their units, what is not a number as null."""
    return {
        str(name): {
            "unit": column.attrs["units"],
            "values": [None if not math.isfinite(value) else value for value in column.values.tolist()],
        }
        for name, column in data.variables.items()
    }
