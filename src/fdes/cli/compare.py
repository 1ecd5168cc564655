"""`fdes compare`: the same input on the linear plant and on the nonlinear one, and where they part company."""

from typing import TYPE_CHECKING, Annotated

import typer

from fdes.cli.options import Across, AircraftName, AsJson, Changes, ConditionName, PlotFile, VariantName, chosen
from fdes.cli.output import note, number, print_json, screen, table, working
from fdes.units import UNIT_SYSTEMS

if TYPE_CHECKING:
    from fdes.analysis.parting import Apart, Parting


def compare(
    aircraft: AircraftName,
    inputs: Annotated[
        list[str],
        typer.Option("--input", "-i", metavar="TEXT", help="An input such as 'step aileron 1deg'. Repeatable."),
    ],
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    changes: Changes = None,
    across: Across = None,
    allowed: Annotated[
        float, typer.Option(metavar="SHARE", help="Of the linear excursion: beyond it, the two have parted.")
    ] = 0.1,
    dt: Annotated[float, typer.Option(metavar="SECONDS", help="The step of both.")] = 0.02,
    duration: Annotated[float, typer.Option(metavar="SECONDS", help="Of the flights.")] = 10.0,
    units: Annotated[
        str, typer.Option(metavar="si|us", help="Of the plot: SI and radians, or feet and degrees.")
    ] = "us",
    plot: PlotFile = None,
    json: AsJson = False,
) -> None:
    """Fly the same input on the linear plant and on the nonlinear one, and find the amplitude at which they part.

    The differences are shares of the linear plant's largest excursion, of the signals that the input moves; rates are
    along the stability axes of the trim. Surfaces have no stops here.
    """
    from fdes.analysis.parting import apart, parting
    from fdes.cli.plot import save_plot, target_of
    from fdes.flight import Clock
    from fdes.flight.nonlinear import assumptions, six_dof_of

    target = target_of(plot)
    ready = chosen(aircraft, condition, variant, changes, across)
    clock = Clock(dt, duration=duration)
    with working("Flying both plants"):
        here = apart(ready, inputs, clock)
        there = parting(ready, inputs, clock, allowed)
    said = assumptions(ready, six_dof_of(ready))
    if target is not None:
        from fdes.analysis.plots import overlay

        title = f"{ready.aircraft_name}, {ready.condition}: {'; '.join(inputs)}"
        with working("Drawing"):
            save_plot(overlay([("linear", here.linear), ("nonlinear", here.nonlinear)], title, units), target)
    if json:
        print_json(_as_json(inputs, here, there, allowed) | {"aircraft": ready.aircraft_id, "notes": said})
        return
    screen().print(f"{ready.aircraft_name}, {ready.condition}: {'; '.join(inputs)}", style="bold", markup=False)
    drawn = table("signal", "unit", "linear, farthest", "difference", "share", "at parting")
    drawn.columns[1].justify = "left"
    for name, share in here.shares.items():
        factor, unit = _shown(here, name)
        far = float(abs(here.linear[name] - here.linear[name][0]).max())
        at_parting = f"{100.0 * there.flights.shares[name]:.1f} %" if _is_there(there) else ""
        drawn.add_row(
            name, unit, number(far * factor), number(share * far * factor), f"{100.0 * share:.1f} %", at_parting
        )
    screen().print(drawn)
    screen().print(_in_words(inputs, there, allowed), soft_wrap=True, markup=False)
    for sentence in (*([f"The nonlinear flight ended early. {here.departed}"] if here.departed else []), *said):
        note(sentence)
    if target is not None:
        screen().print(f"{plot} is written.", soft_wrap=True)


def _is_there(there: "Parting") -> bool:
    return 0.0 < there.scale < float("inf")


def _shown(here: "Apart", name: str) -> tuple[float, str]:
    (unit,) = (c.unit for c in here.linear.columns if c.name == name)
    shown, factor = UNIT_SYSTEMS["us"].get(unit, (unit, 1.0))
    return factor, shown


def _amplitudes(inputs: list[str], scale: float) -> str:
    """As one says them: "elevator 3.1 deg, rudder 5 deg"."""
    from fdes.analysis.parting import amplitude
    from fdes.flight.excitation import UNITS

    said = []
    for channel, size in amplitude(inputs, scale):
        unit, factor = UNIT_SYSTEMS["us"].get(UNITS[channel], (UNITS[channel], 1.0))
        said.append(f"{channel} {number(abs(size) * factor, 3)}{'' if unit == '1' else ' ' + unit}")
    return ", ".join(said)


def _in_words(inputs: list[str], there: "Parting", allowed: float) -> str:
    share = f"{100.0 * allowed:g} %"
    if there.scale == 0.0:
        least = _amplitudes(inputs, there.flights.scale)
        return f"Linear and nonlinear differ by more than {share} even at {least}: not by their amplitude."
    if not _is_there(there):
        return f"Linear and nonlinear stay within {share} up to {_amplitudes(inputs, there.flights.scale)}."
    size = _amplitudes(inputs, there.scale)
    if there.beyond.departed:
        return f"Linear and nonlinear stay within {share} up to {size}; beyond, the nonlinear flight ends early."
    worst = max(there.beyond.shares, key=lambda name: there.beyond.shares[name])
    return f"Linear and nonlinear part company, by {share} in {worst}, at {size}."


def _as_json(inputs: list[str], here: "Apart", there: "Parting", allowed: float) -> dict[str, object]:
    from fdes.analysis.parting import amplitude

    found = _is_there(there)
    return {
        "inputs": inputs,
        "shares": dict(here.shares),
        "departed": here.departed or None,
        "allowed": allowed,
        "parting": {
            "scale": there.scale if found else None,
            "looked_at": there.flights.scale,
            "amplitudes": [{"channel": c, "SI": a} for c, a in amplitude(inputs, there.scale)] if found else None,
            "shares": dict(there.flights.shares),
        },
        "units": "SI",
    }
