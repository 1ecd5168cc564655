"""The nonlinear plant flown from the command line: `fdes simulate --scenario` and `--plant nonlinear`."""

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from fdes.cli.output import note, screen
from fdes.errors import NoSuchPart, SpecError
from fdes.units import parse

if TYPE_CHECKING:
    from collections.abc import Iterable

    from fdes.aircraft import FlightCondition
    from fdes.analysis.nonlinear_response import Place
    from fdes.flight import Clock
    from fdes.flight.recording import Recording
    from fdes.flight.scenario import Scenario
    from fdes.physics.earth import Earth

STDOUT = "-"
NAMES = ("fdes", "s119")
FLAT = "flat"
PLACE = ("latitude", "longitude", "heading")


def fly_nonlinear(
    plant: str,
    ready: "FlightCondition",
    inputs: "Iterable[str]",
    clock: "Clock",
    trim: str | None,
    height: float | None,
    given: dict[str, Any],
    place: "Place | None" = None,
) -> "Recording":
    """The response of the nonlinear plant, from the trim that is asked for, else the condition's. Raises FdesError."""
    if plant != "nonlinear":
        raise NoSuchPart("plant", plant, ("linear", "nonlinear"))
    from fdes.analysis.nonlinear_response import simulate_nonlinear
    from fdes.analysis.trim import TrimSpec, spec_of

    default = TrimSpec(ready.reference.V, ready.reference.h if height is None else height)
    spec = default if trim is None else spec_of(trim, default)
    return simulate_nonlinear(ready, inputs, clock=clock, spec=spec, place=place, **given)


def note_assumptions(flight: "Recording") -> None:
    """Say what no source says of the plant that flew."""
    for sentence in flight.header["assumptions"]:
        note(sentence)


def fly_and_write(name: str, out: str | None, names: str, units: str) -> None:
    """Fly the scenario of that name or file; write CSV to `out`, or the last row to the screen. Raises FdesError."""
    from fdes.flight.scenario import fly_scenario, load_scenario

    if names not in NAMES:
        raise NoSuchPart("set of column names", names, NAMES)
    target = None if out in {None, STDOUT} else Path(str(out))
    if target is not None and (target.suffix != ".csv" or not target.parent.is_dir()):
        raise SpecError(f"{out} cannot be written: name a file that ends in .csv in a folder that exists.")
    scenario = load_scenario(name)
    flight = fly_scenario(scenario)
    if out == STDOUT:
        _write(scenario, flight, names, units, sys.stdout)
    elif target is not None:
        with target.open("w", encoding="utf-8", newline="") as file:
            _write(scenario, flight, names, units, file)
        screen().print(f"{out}: {len(flight.data)} rows", soft_wrap=True)
    else:
        last = {c.name: (value, c.unit) for c, value in zip(flight.columns, flight.data[-1], strict=True)}
        screen().print(f"{scenario.title}: at t = {last['t'][0]:g} s", markup=False)
        for signal in ("V", "mach", "h", "h_dot", "north", "east", "phi", "theta", "psi", "p", "q", "r"):
            value, unit = last[signal]
            screen().print(f"  {signal:8} {value: .8g} {unit}", markup=False)


def _write(scenario: "Scenario", flight: "Recording", names: str, units: str, file: TextIO) -> None:
    if names == "fdes":
        flight.to_csv(file, units)
    else:
        write_s119(scenario.plant.earth, flight, file, scenario.plant.warmer)


def write_s119(earth: "Earth", flight: "Recording", file: TextIO, warmer: float = 0.0) -> None:
    """CSV with the column names and units of NASA's check cases."""
    import numpy as np

    from fdes.flight.s119 import s119_columns

    columns = s119_columns(earth, flight, warmer)
    file.write(",".join(columns) + "\n")
    np.savetxt(file, np.column_stack(list(columns.values())), fmt="%.15g", delimiter=",")


def loading_of(aircraft: str, condition: str | None, trim: str | None) -> str | None:
    """The condition that was said; for a trim without one, that to which it belongs. Raises FdesError."""
    if condition is not None or not trim:
        return condition
    from fdes.aircraft import load
    from fdes.analysis.nearest_condition import nearest_condition

    known = load(aircraft)
    meant = nearest_condition(known, trim)
    if meant is not None and meant != known.conditions[0].id:
        note(f"Flown as {meant}, the condition nearest in height to the trim. Name another with --condition.")
    return meant


def place_of(earth: str | None, at: str | None) -> "Place | None":
    """Where on which Earth a flight begins; None over a flat one. Raises SpecError, NoSuchPart."""
    from fdes.analysis.nonlinear_response import Place
    from fdes.physics.earth import EARTHS

    if earth is not None and earth not in EARTHS:
        raise NoSuchPart("Earth", earth, EARTHS)
    if earth in {None, FLAT}:
        if at is not None:
            raise SpecError("--at is a place on a round Earth: give --earth wgs84 or --earth round with it.")
        return None
    said: dict[str, float] = {}
    for name, value in re.findall(r"(\w+)\s*=\s*([^=]+?)\s*(?=\w+\s*=|$)", at or ""):
        if name not in PLACE:
            raise NoSuchPart("word of --at", name, PLACE)
        if value[-1].isdigit():
            raise SpecError(f"{name}={value} has no unit. Write it like '{name}={value} deg'.")
        said[name] = parse(value, "rad")
    if at is not None and not said:
        raise SpecError(f"--at {at!r} cannot be read. Write it like 'latitude=36 deg heading=45 deg'.")
    return Place(str(earth), **said)
