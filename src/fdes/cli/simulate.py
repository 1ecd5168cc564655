"""`fdes simulate`: the response to test inputs, as a table of numbers."""

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fdes.cli.flight_files import STDOUT, file_wanted, frames_per_row, must_be_written_as, write
from fdes.cli.law import show_law
from fdes.cli.options import (
    FLAG,
    Across,
    Changes,
    ConditionName,
    FormName,
    IntegratorName,
    LawText,
    OnActuators,
    PlotFile,
    Spool,
    VariantName,
    chosen,
    designed_law,
    form_of_equations,
)
from fdes.cli.output import note, number, screen, table, working
from fdes.cli.scenario import fly_and_write, fly_nonlinear, loading_of, note_assumptions, place_of
from fdes.errors import NoSuchPart, SpecError
from fdes.units import DEG, UNIT_SYSTEMS, parse

if TYPE_CHECKING:
    from fdes.aircraft import FlightCondition
    from fdes.flight import Clock, Recording

MOST_FRAMES = 500_000
HONEST_TO = 15.0 * DEG  # from the reference condition: Mansor and Perumal, section 7
SUMMARIZED = ("V", "alpha", "beta", "gamma", "phi", "theta", "psi", "p", "q", "r", "n_y", "n_z", "h")


def simulate(
    aircraft: Annotated[
        str | None,
        typer.Argument(metavar="AIRCRAFT", help="A name, as `fdes aircraft` lists them, or the path of a TOML file."),
    ] = None,
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    form: FormName = "full",
    changes: Changes = None,
    inputs: Annotated[
        list[str] | None,
        typer.Option(
            "--input",
            "-i",
            metavar="TEXT",
            help="An input such as 'step aileron 15deg at 0s' or 'step gust_w -5m/s'. Repeatable.",
        ),
    ] = None,
    initial: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TEXT", help="A perturbation to start with, such as 'beta=5deg' or 'u=+10kt'. Repeatable."
        ),
    ] = None,
    integrator: IntegratorName = "rk4",
    dt: Annotated[float, typer.Option(metavar="SECONDS", help="From row to row.")] = 0.01,
    substeps: Annotated[int, typer.Option(metavar="NUMBER", help="Steps of the integrator from row to row.")] = 1,
    duration: Annotated[float, typer.Option(metavar="SECONDS", help="Of the flight.")] = 10.0,
    limits: Annotated[
        bool,
        typer.Option(
            "--limits", metavar=FLAG, help="Stop the surfaces at their assumed limits; else they go as far as asked."
        ),
    ] = False,
    law: LawText = None,
    actuators: OnActuators = False,
    height: Annotated[
        str | None, typer.Option(metavar="TEXT", help="At the start, such as '1500 ft'; else the condition's.")
    ] = None,
    units: Annotated[str, typer.Option(metavar="si|us", help="SI and radians, or feet and degrees.")] = "si",
    out: Annotated[
        str | None,
        typer.Option(
            "--out",
            "-o",
            metavar="FILE",
            help="A .csv, .nc or .mat file; else a summary is printed; - is CSV on stdout.",
        ),
    ] = None,
    plot: PlotFile = None,
    scenario: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE", help="Instead of an aircraft: a whole flight of the nonlinear plant as TOML."
        ),
    ] = None,
    plant: Annotated[
        str, typer.Option(metavar="linear|nonlinear", help="Small perturbations, or six degrees of freedom.")
    ] = "linear",
    trim: Annotated[
        str | None,
        typer.Option(
            metavar="TEXT", help="Where the nonlinear flight begins, such as 'V=170 kt h=5000 ft turn=3 deg/s'."
        ),
    ] = None,
    earth: Annotated[
        str | None, typer.Option(metavar="flat|round|wgs84", help="Below the nonlinear flight; wgs84 turns.")
    ] = None,
    at: Annotated[
        str | None,
        typer.Option(metavar="TEXT", help="Where there: 'latitude=36 deg longitude=-75 deg heading=45 deg'."),
    ] = None,
    across: Across = None,
    spool: Spool = False,
    rate: Annotated[
        float | None, typer.Option(metavar="HZ", help="Rows a second in what is written; else every one that is flown.")
    ] = None,
    names: Annotated[
        str, typer.Option(metavar="fdes|s119", help="Of the columns of a nonlinear flight: ours, or NASA's.")
    ] = "fdes",
) -> None:
    """Fly test inputs from trim, hands off, and write the response, the unit of every column with it."""
    from fdes.cli.plot import save_plot, target_of
    from fdes.flight import simulate as fly_it

    if units not in UNIT_SYSTEMS:
        raise NoSuchPart("system of units", units, UNIT_SYSTEMS)
    if scenario is not None:
        of_a_flight = (condition, changes, inputs, initial, law, actuators, height, trim, across, spool, earth, at)
        if any((aircraft, plot, rate, *of_a_flight)):
            raise SpecError("A scenario says all of its flight: give with --scenario only --out, --names and --units.")
        fly_and_write(scenario, out, names, units)
        return
    if aircraft is None:
        raise SpecError("There is nothing to fly: name an aircraft, as in fdes simulate A-4D, or give a --scenario.")
    target, picture = file_wanted(out, units), target_of(plot)
    must_be_written_as(names, plant, target, out)
    condition = loading_of(aircraft, condition, None if plant == "linear" else trim)
    ready = chosen(aircraft, condition, variant, changes, across, spool=spool)
    clock, every = _clock(dt, substeps, duration), frames_per_row(rate, dt)
    closed = {} if law is None else _law(law, ready, form, dt, actuators=actuators, quiet=out == STDOUT)
    given = {"integrator": integrator, "initial": initial or (), "limits": limits, **closed}
    start = None if height is None else parse(height, "m")
    if plant == "linear":
        _must_be_nonlinear(trim, earth or at, across, spool=spool)
        response = fly_it(ready, inputs or (), clock=clock, form=form, height=start, actuators=actuators, **given)
    else:
        _no_actuators(actuators)
        place = place_of(earth, at)
        with working(f"Flying {duration:g} s"):
            response = fly_nonlinear(plant, ready, inputs or (), clock, trim, start, given, place)
    if out is None:
        _summarize(response, units)
    else:
        write(replace(response, data=response.data[::every]), out, target, units, names)
    if picture is not None:
        from fdes.analysis.plots import responses

        title = f"{ready.aircraft_name}, {ready.condition}: {'; '.join((*(inputs or ()), *(initial or ())))}"
        with working("Drawing"):
            save_plot(responses(response, title, units), picture)
        if out != STDOUT:
            screen().print(f"{plot} is written.", soft_wrap=True)
    if plant != "linear":
        note_assumptions(response)
        return
    _note_step(ready, form, integrator, dt / substeps)
    _note_limits(response, ready, limits)
    _note_excursion(response)


def _must_be_nonlinear(trim: str | None, earth: str | None, across: str | None, *, spool: bool) -> None:
    """Raises SpecError for what the linear plant cannot do."""
    for given, why in (
        (trim, "The linear plant flies about its flight condition: give --trim with --plant nonlinear."),
        (earth, "The linear plant knows no Earth: give --earth and --at with --plant nonlinear."),
        (across, "The linear plant is that of its flight condition: give --across with --plant nonlinear."),
        (spool, "The thrust of the linear plant follows at once: give --spool with --plant nonlinear."),
    ):
        if given:
            raise SpecError(why)


def _no_actuators(actuators: bool) -> None:
    if actuators:
        raise SpecError("The nonlinear plant has no actuators: leave --actuators out, or fly the linear plant.")


def _law(text: str, ready: "FlightCondition", form: str, dt: float, *, actuators: bool, quiet: bool) -> dict[str, Any]:
    """The law as `fdes.simulate` takes it, shown unless the flight itself goes to stdout."""
    designed = designed_law(text, ready, form_of_equations(form), frame=dt, actuators=actuators)
    if not quiet:
        show_law(designed)
    return {"law": designed.law, "said": designed.text}


def _named(aircraft: str | None, names: str) -> str:
    """The aircraft that is to fly. Raises SpecError where there is none, or where only a scenario could be meant."""
    if aircraft is None:
        raise SpecError("There is nothing to fly: name an aircraft, as in fdes simulate A-4D, or give a --scenario.")
    if names != "fdes":
        raise SpecError(f"--names {names} is for a scenario, which says where on Earth it flies: give a --scenario.")
    return aircraft


def _clock(dt: float, substeps: int, duration: float) -> "Clock":
    """The clock, if the flight makes a table. Raises SpecError."""
    from fdes.flight import Clock

    clock = Clock(dt, substeps, duration)
    if dt > duration > 0.0:
        raise SpecError(f"The time step of {dt:g} s is longer than the flight of {duration:g} s.")
    if duration / dt > MOST_FRAMES:
        raise SpecError(
            f"{duration:g} s in steps of {dt:g} s are {duration / dt:,.0f} rows; at most {MOST_FRAMES:,} fit. "
            "Take a larger --dt, with --substeps to keep the integrator's steps small."
        )
    return clock


def _summarize(response: "Recording", units: str) -> None:
    """Print what moved: where it started, how far it went and when, where it ended."""
    import numpy as np

    time_of = response["t"]
    drawn = table("signal", "unit", "at the start", "farthest", "at t [s]", "at the end")
    drawn.columns[1].justify = "left"
    for channel in response.columns:
        if channel.name not in SUMMARIZED:
            continue
        signal = response[channel.name]
        away = np.abs(signal - signal[0])
        k = int(np.argmax(away))
        if away[k] <= 1e-9 * max(1.0, abs(signal[0])):
            continue
        unit, factor = UNIT_SYSTEMS[units].get(channel.unit, (channel.unit, 1.0))
        first, farthest, last = (number(float(v) * factor) for v in (signal[0], signal[k], signal[-1]))
        drawn.add_row(channel.name, unit, first, farthest, f"{time_of[k]:.2f}", last)
    if not drawn.row_count:
        note("Nothing moved: the aircraft stays in trim. Put in something that begins before the end, with --input.")
        return
    screen().print(drawn)


def _note_step(ready: "FlightCondition", form: str, integrator: str, step: float) -> None:
    """Say when the integrator makes a stable mode grow."""
    from fdes.analysis import modes
    from fdes.analysis.step_limit import step_limit
    from fdes.flight import plant_of

    found = step_limit(plant_of(ready, form, integrator, step).integrator, modes(ready, form_of_equations(form)))
    if found and step > found[0]:
        limit, mode = found
        note(
            f"A step of {step:g} s is beyond the stability limit of {integrator} here, {limit:.3g} s, set by the "
            f"{mode.name.replace('_', ' ')}: what grows is the integrator's doing, not the aircraft's."
        )


def _note_limits(response: "Recording", ready: "FlightCondition", limits: bool) -> None:
    """Say which surface was asked to go where it could not."""
    for name, low, high in zip(ready.limits.lower._fields, ready.limits.lower, ready.limits.upper, strict=True):
        asked = response[f"command_{name}"]
        lowest, highest = float(asked.min()), float(asked.max())
        if low <= lowest and highest <= high:
            continue
        value, limit = (highest, high) if highest > high else (lowest, low)
        said, stop = (
            (f"{value:.3g}", f"{limit:.3g}")
            if name == "throttle"
            else (f"{value / DEG:.3g} deg", f"the assumed limit of {limit / DEG:.3g} deg")
        )
        happens = "and stops there" if limits else "and goes there all the same: --limits would stop it"
        note(f"The {name} is asked for {said}, beyond {stop}, {happens}.")


def _note_excursion(response: "Recording") -> None:
    """Say from when on the linear equations are only a guide."""
    beyond = response["excursion"] > HONEST_TO
    if beyond.any():
        when = float(response["t"][beyond.argmax()])
        note(
            f"From t = {when:.4g} s on the flight is more than {HONEST_TO / DEG:.0f} deg from its reference condition; "
            "the linear equations are only a guide there."
        )
