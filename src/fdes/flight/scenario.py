"""A whole flight as one file: what flies, over which Earth, from where, through which wind, for how long.

A scenario is TOML; every quantity is a text with its unit. docs/reference/scenarios.md has the format. The files in the
folder `scenarios` are NASA's check cases; your own may lie anywhere.
"""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib.resources import files
from itertools import islice
from pathlib import Path
from typing import Any

from fdes import __version__
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.excitation import GustyAir
from fdes.flight.pilot import HandsOff
from fdes.flight.recorder import columns_of, row_of
from fdes.flight.recording import Recording, frames_to_recording
from fdes.flight.scenario_text import REQUIRED, Known, only_known, quantities, table_of
from fdes.flight.scenario_vehicle import (
    HANDS_OFF,
    HELD,
    Flown,
    airframe,
    flown_with,
    held_at_start,
    in_trim,
    is_trimmed,
)
from fdes.flight.simulation import Clock, Setup, fly
from fdes.flight.trim_over_earth import Over
from fdes.physics.aero import SimpleBody, simple_body_loads
from fdes.physics.earth import EARTHS
from fdes.physics.plant import SixDof, State, state_at
from fdes.physics.rigid_body import Inertia
from fdes.physics.signals import Air, Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.physics.wind import Wind
from fdes.shelf import shelf
from fdes.units import DEG

FORMAT = 1
SHIPPED = files("fdes.flight") / "scenarios"
# What each table may say: the unit it must have, and what holds where it is not said.
TOP = {"format", "title", "source", "earth", "integrator", "rates_from", "duration", "step", "row"}
TABLES = {"body", "vehicle", "initial", "air", "law"}
LISTS = {"inputs", "commands"}
TIMES: Known = {"duration": ("s", REQUIRED), "step": ("s", 0.01), "row": ("s", 0.1)}
INERTIA: Known = {
    "mass": ("kg", REQUIRED),
    "Ix": ("kg m^2", REQUIRED),
    "Iy": ("kg m^2", REQUIRED),
    "Iz": ("kg m^2", REQUIRED),
    "Ixz": ("kg m^2", 0.0),
    "Ixy": ("kg m^2", 0.0),
    "Iyz": ("kg m^2", 0.0),
}
AERO: Known = {
    "S": ("m^2", 0.0),
    "b": ("m", 1.0),
    "c": ("m", 1.0),
    "CD": ("1", 0.0),
    "Cl_p": ("1", 0.0),
    "Cm_q": ("1", 0.0),
    "Cn_r": ("1", 0.0),
}
ROUND_PLACE: Known = {"latitude": ("rad", REQUIRED), "longitude": ("rad", REQUIRED), "height": ("m", REQUIRED)}
FLAT_PLACE: Known = {"north": ("m", 0.0), "east": ("m", 0.0), "height": ("m", REQUIRED)}
VELOCITY: Known = {"v_north": ("m/s", 0.0), "v_east": ("m/s", 0.0), "v_down": ("m/s", 0.0)}
FOUND = {"phi", "psi", "p", "q", "r"}  # by a trim
MOTION: Known = {
    **VELOCITY,
    "phi": ("rad", 0.0),
    "theta": ("rad", 0.0),
    "psi": ("rad", 0.0),
    "p": ("rad/s", 0.0),
    "q": ("rad/s", 0.0),
    "r": ("rad/s", 0.0),
}
AIR: Known = {
    "wind_north": ("m/s", 0.0),
    "wind_east": ("m/s", 0.0),
    "wind_down": ("m/s", 0.0),
    "shear_north": ("1/s", 0.0),
    "shear_east": ("1/s", 0.0),
    "warmer": ("K", 0.0),
}


@dataclass(frozen=True)
class Scenario:
    """A flight that is ready to be flown."""

    title: str
    source: str
    earth: str
    plant: SixDof
    clock: Clock
    flown: Flown = HANDS_OFF

    @property
    def row(self) -> float:
        """From row to row of its recording [s]."""
        return self.clock.dt * self.flown.every


def scenario_names() -> list[str]:
    """The scenarios that come with FDES."""
    return sorted(f.name.removesuffix(".toml") for f in SHIPPED.iterdir() if f.name.endswith(".toml"))


def load_scenario(name_or_path: str | Path) -> Scenario:
    """A scenario that comes with FDES, by name, or one from a file of your own.

    Raises NoSuchPart for an unknown name, SpecError for a file that cannot be used.
    """
    text = str(name_or_path)
    own = isinstance(name_or_path, Path) or text.endswith(".toml") or "/" in text or "\\" in text
    if not own and text not in scenario_names():
        raise NoSuchPart("scenario", text, scenario_names())
    path = Path(name_or_path).expanduser() if own else SHIPPED / f"{text}.toml"
    try:
        document = tomllib.loads(path.read_text("utf-8"))
    except OSError as trouble:
        raise SpecError(f"{text} cannot be read: {trouble.strerror}.") from trouble
    except UnicodeDecodeError:
        raise SpecError(f"{text} cannot be used: it is not text in UTF-8.") from None
    except tomllib.TOMLDecodeError as trouble:
        raise SpecError(f"{text} is not TOML: {trouble}.") from trouble
    try:
        return scenario_of(document)
    except SpecError as mistake:
        raise SpecError(f"{text} cannot be used: {mistake}") from mistake


def scenario_of(document: Mapping[str, Any]) -> Scenario:
    """A scenario from the content of a file. Raises SpecError, NoSuchPart, TrimError."""
    only_known(document, TOP | TABLES | LISTS, "")
    if document.get("format") != FORMAT:
        raise SpecError(f"format is {document.get('format')!r}; this FDES reads format = {FORMAT}.")
    name = str(document.get("earth", "wgs84"))
    if name not in EARTHS:
        raise NoSuchPart("Earth", name, EARTHS)
    earth, is_vehicle = EARTHS[name], "vehicle" in document
    if is_vehicle == ("body" in document):
        raise SpecError("A scenario flies either a [body] or a [vehicle]: give one of the two.")
    integrator = str(document.get("integrator", "rk4"))
    bare = airframe(document, integrator) if is_vehicle else _simple_body(document, integrator)
    only_known(table_of(document, "air"), AIR, "air.")
    *wind, warmer = quantities(table_of(document, "air"), AIR, "air.").values()
    plant = _under_way(bare._replace(earth=earth, wind=Wind(*wind), warmer=warmer), document, is_vehicle=is_vehicle)
    times = quantities({k: v for k, v in document.items() if k in TIMES}, TIMES, "")
    for name in ("step", "row"):
        if times[name] <= 0.0:
            raise SpecError(f'{name} is {times[name]:g} s; it must be more than zero, such as "0.01 s".')
    every = max(1, round(times["row"] / times["step"]))
    said = (str(document.get("title", "")), str(document.get("source", "")), name, plant)
    if is_vehicle:  # its law runs once a step, and not only once a row
        clock = Clock(times["row"] / every, 1, times["duration"])
        return Scenario(*said, clock, flown_with(document, plant, every))
    for key in ("law", "inputs", "commands"):
        if key in document:
            raise SpecError(f"{key} is for a [vehicle]: a [body] has no surfaces.")
    return Scenario(*said, Clock(times["row"], every, times["duration"]))


def _simple_body(document: Mapping[str, Any], integrator: str) -> SixDof:
    """A body with drag and damping, not yet anywhere."""
    body = table_of(document, "body")
    only_known(body, {**INERTIA, **AERO}, "body.")
    inertia = Inertia(*quantities(body, INERTIA, "body.").values())
    _must_exist(inertia)
    return SixDof(
        inertia=inertia,
        aero=SimpleBody(**quantities(body, AERO, "body.")),
        aerodynamics=simple_body_loads,
        earth=EARTHS["flat"],
        initial=State(*[0.0] * len(State._fields)),
        limits=Limits(Surfaces(), Surfaces()),
        integrator=shelf("integrators").get(integrator),
    )


def _under_way(plant: SixDof, document: Mapping[str, Any], *, is_vehicle: bool) -> SixDof:
    """The plant where and as its flight begins: as the file says, or in trim."""
    earth, initial = plant.earth, table_of(document, "initial")
    where = FLAT_PLACE if earth.g else ROUND_PLACE
    only_known(initial, {**where, **MOTION, **(HELD if is_vehicle else {})}, "initial.")
    rates_from = document.get("rates_from", "earth")
    if rates_from not in ("earth", "inertial"):
        raise SpecError(
            f'rates_from is {rates_from!r}; it must be "earth" or "inertial": what p, q, r are relative to.'
        )
    first, second, third = quantities(initial, where, "initial.").values()
    if not earth.g and abs(first) > 90.0 * DEG:
        raise SpecError(f"initial.latitude is {first / DEG:g} deg; it must be between -90 and 90 deg.")
    if is_vehicle and is_trimmed(initial):
        for key in (*FOUND, *HELD):
            if key in initial:
                raise SpecError(f'initial.{key} is found where theta is "trim": leave it out.')
        if plant.wind != Wind():
            raise SpecError('initial.theta = "trim" is for calm air: leave the wind out, or say theta itself.')
        north, east, down = quantities(initial, VELOCITY, "initial.").values()
        return in_trim(plant, earth, Over(first, second, third, north, east, down))
    north, east, down, phi, theta, psi, p, q, r = quantities(initial, MOTION, "initial.").values()
    start = state_at(
        earth,
        (first, second, third),
        (north, east, down),
        (phi, theta, psi),
        (p, q, r),
        inertial=rates_from == "inertial",
    )
    if not is_vehicle:
        return plant._replace(initial=start)
    held = held_at_start(plant, initial)
    return held._replace(initial=start._replace(power=held.settled(held.engine, held.rest.throttle)))


def fly_scenario(scenario: Scenario) -> Recording:
    """Its recording. Raises Departed."""
    plant, clock, flown = scenario.plant, scenario.clock, scenario.flown
    weather = GustyAir(flown.excitation.gusts, plant.observe(plant.start(), plant.trim(), Air()).V)
    frames = fly(
        plant.start(),
        Setup(plant, flown.law),
        HandsOff(flown.throttle),
        weather,
        clock,
        flown.excitation,
        flown.edits(),
    )
    header = {
        "fdes": __version__,
        "engine": "plain",
        "scenario": scenario.title,
        "earth": scenario.earth,
        "dt": scenario.row,
        "substeps": clock.substeps * flown.every,
    }
    return frames_to_recording(header, columns_of(State), map(row_of, islice(frames, 0, None, flown.every)))


def with_drag(scenario: Scenario, factor: float) -> Scenario:
    """The same flight with `factor` times the drag, which is what so much more density would make."""
    aero = scenario.plant.aero
    return replace(scenario, plant=scenario.plant._replace(aero=aero._replace(CD=aero.CD * factor)))


def _must_exist(body: Inertia) -> None:
    """No moment of inertia is larger than the sum of the others, about whatever axes."""
    for name, value in zip(("mass", "Ix", "Iy", "Iz"), body[:4], strict=True):
        if value <= 0.0:
            raise SpecError(f"body.{name} is {value:g} {INERTIA[name][0]}; it must be greater than zero.")
    largest = max(body.Ix, body.Iy, body.Iz)
    if 2.0 * largest > body.Ix + body.Iy + body.Iz:
        raise SpecError(
            f"No body has such moments of inertia: {largest:g} kg m^2 is more than the sum of the other two. Check Ix, "
            "Iy, Iz and their units."
        )
