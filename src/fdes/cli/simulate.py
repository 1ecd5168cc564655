"""`fdes simulate`: the response to test inputs, as a table of numbers."""

import os
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TextIO, TypeVar

import typer

from fdes.cli.options import FLAG, AircraftName, ConditionName, FormName, IntegratorName, VariantName
from fdes.cli.output import aside, note, number, screen, table
from fdes.errors import NoSuchPart, SpecError
from fdes.units import DEG, UNIT_SYSTEMS, parse

if TYPE_CHECKING:
    from fdes.aircraft import FlightCondition
    from fdes.flight import Clock, Excitation, Recording

T = TypeVar("T")

STDOUT = "-"
MOST_FRAMES = 500_000
PATIENCE = 2.0  # s after which the wait is shown
HONEST_TO = 15.0 * DEG  # from the reference condition: Mansor and Perumal, section 7
SUMMARIZED = ("V", "alpha", "beta", "gamma", "phi", "theta", "psi", "p", "q", "r", "n_y", "n_z", "h")


def simulate(
    aircraft: AircraftName,
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    form: FormName = "full",
    inputs: Annotated[
        list[str] | None,
        typer.Option(
            "--input", "-i", metavar="TEXT", help="A test input such as 'step aileron 15deg at 0s'. Repeatable."
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
    height: Annotated[
        str | None, typer.Option(metavar="TEXT", help="At the start, such as '1500 ft'; else the condition's.")
    ] = None,
    units: Annotated[str, typer.Option(metavar="si|us", help="SI and radians, or feet and degrees.")] = "si",
    out: Annotated[
        str | None, typer.Option("--out", "-o", metavar="FILE.csv", help="Else a summary is printed; - is stdout.")
    ] = None,
) -> None:
    """Fly test inputs from trim, hands off, and write the response as CSV, the unit of each column in its header."""
    from fdes.aircraft import load
    from fdes.flight import Excitation

    if units not in UNIT_SYSTEMS:
        raise NoSuchPart("system of units", units, UNIT_SYSTEMS)
    target = _target(out)
    excitation = Excitation.parse(inputs or ())
    start = None if height is None else parse(height, "m")
    clock = _clock(dt, substeps, duration)
    ready = load(aircraft).at(condition, variant)
    response = _response(ready, form, integrator, clock, excitation, start, limits)
    if out == STDOUT:
        response.to_csv(sys.stdout, units)
    elif target is not None:
        with _whole(target) as file:
            response.to_csv(file, units)
        rows, columns = response.data.shape
        screen().print(f"{out}: {rows} rows, {columns} columns", soft_wrap=True)
    else:
        _summarize(response, units)
    _note_limits(response, ready, limits)
    _note_excursion(response)


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


def _response(
    ready: "FlightCondition",
    form: str,
    integrator: str,
    clock: "Clock",
    excitation: "Excitation",
    height: float | None,
    limits: bool,
) -> "Recording":
    """The flight from trim, hands off."""
    from fdes.control.laws.direct import Direct
    from fdes.flight import HandsOff, Setup, SteadyAir, fly, plant_of
    from fdes.flight.recorder import columns_of, row_of
    from fdes.flight.recording import frames_to_recording
    from fdes.physics.signals import Surfaces
    from fdes.physics.small_perturbation import Limits

    if not limits:
        ready = replace(ready, limits=Limits(Surfaces(-inf, -inf, -inf, -inf), Surfaces(inf, inf, inf, inf)))
    plant = plant_of(ready, form, integrator, clock.dt / clock.substeps)
    start = plant.start(height)
    setup = Setup(plant, Direct(ready.full_stick))
    frames = fly(start, setup, HandsOff(ready.trim_throttle), SteadyAir(), clock, excitation)
    rows = (row_of(frame) for frame in _watched(frames, sum(1 for _ in clock)))
    return frames_to_recording({}, columns_of(type(start)), rows)


def _watched(frames: Iterable[T], total: int) -> Iterator[T]:
    """The same frames; when they take long, a bar on stderr shows how far they are."""
    frames = iter(frames)
    begun = time.monotonic()
    done = 0
    for frame in frames:
        yield frame
        done += 1
        if time.monotonic() - begun > PATIENCE:
            break
    else:
        return
    from rich.progress import Progress

    console = aside()
    with Progress(console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task("Flying", total=total, completed=done)
        for frame in frames:
            yield frame
            bar.advance(task)


def _target(out: str | None) -> Path | None:
    """The file to write, if one is wanted. Raises SpecError for what cannot be written, before anything is flown."""
    if out is None or out == STDOUT:
        return None
    path = Path(os.path.realpath(out))  # a link stays a link, what it leads to is written
    if path.suffix.lower() != ".csv":
        raise SpecError(f"{out} cannot be written: the response is written as CSV. Let its name end in .csv.")
    if path.is_dir():
        raise SpecError(f"{out} cannot be written: it is a folder.")
    if not path.parent.is_dir():
        raise SpecError(f"{out} cannot be written: there is no folder {path.parent}.")
    if not os.access(path.parent, os.W_OK):
        raise SpecError(f"{out} cannot be written: no permission to write in {path.parent}.")
    return path


@contextmanager
def _whole(path: Path) -> Iterator[TextIO]:
    """A file that appears at `path` when all of it is written, and not at all otherwise. Raises SpecError."""
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        with part.open("w", encoding="utf-8", newline="\n") as file:
            yield file
        part.replace(path)
    except OSError as trouble:
        raise SpecError(f"{path} cannot be written: {trouble.strerror or trouble}.") from trouble
    finally:
        part.unlink(missing_ok=True)


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
        note("Nothing moved: the aircraft stays in trim. Put something in with --input 'step elevator -1deg at 1s'.")
        return
    screen().print(drawn)


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
