"""A whole flight as one file: the body that flies, over which Earth, from where, through which wind, for how long.

A scenario is TOML; every quantity is a text with its unit. docs/reference/scenarios.md has the format. The files in the
folder `scenarios` are NASA's check cases; your own may lie anywhere.
"""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from fdes import __version__
from fdes.control.laws.direct import Direct
from fdes.errors import NoSuchPart, SpecError, nearest
from fdes.flight.pilot import HandsOff
from fdes.flight.recorder import columns_of, row_of
from fdes.flight.recording import Recording, frames_to_recording
from fdes.flight.simulation import Clock, Setup, SteadyAir, fly
from fdes.physics.aero import SimpleBody, simple_body_loads
from fdes.physics.earth import EARTHS
from fdes.physics.plant import SixDof, State, state_at
from fdes.physics.rigid_body import Inertia
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.physics.wind import Wind
from fdes.shelf import shelf
from fdes.units import parse

FORMAT = 1
SHIPPED = files("fdes.flight") / "scenarios"
REQUIRED = None

# What each table may say: the unit it must have, and what holds where it is not said.
TOP = {"format", "title", "source", "earth", "integrator", "rates_from", "duration", "step", "row"}
TABLES = {"body", "initial", "air"}
TIMES = {"duration": ("s", REQUIRED), "step": ("s", 0.01), "row": ("s", 0.1)}
INERTIA = {
    "mass": ("kg", REQUIRED),
    "Ix": ("kg m^2", REQUIRED),
    "Iy": ("kg m^2", REQUIRED),
    "Iz": ("kg m^2", REQUIRED),
    "Ixz": ("kg m^2", 0.0),
    "Ixy": ("kg m^2", 0.0),
    "Iyz": ("kg m^2", 0.0),
}
AERO = {
    "S": ("m^2", 0.0),
    "b": ("m", 1.0),
    "c": ("m", 1.0),
    "CD": ("1", 0.0),
    "Cl_p": ("1", 0.0),
    "Cm_q": ("1", 0.0),
    "Cn_r": ("1", 0.0),
}
ROUND_PLACE = {"latitude": ("rad", REQUIRED), "longitude": ("rad", REQUIRED), "height": ("m", REQUIRED)}
FLAT_PLACE = {"north": ("m", 0.0), "east": ("m", 0.0), "height": ("m", REQUIRED)}
MOTION = {
    "v_north": ("m/s", 0.0),
    "v_east": ("m/s", 0.0),
    "v_down": ("m/s", 0.0),
    "phi": ("rad", 0.0),
    "theta": ("rad", 0.0),
    "psi": ("rad", 0.0),
    "p": ("rad/s", 0.0),
    "q": ("rad/s", 0.0),
    "r": ("rad/s", 0.0),
}
AIR = {
    "wind_north": ("m/s", 0.0),
    "wind_east": ("m/s", 0.0),
    "wind_down": ("m/s", 0.0),
    "shear_north": ("1/s", 0.0),
    "shear_east": ("1/s", 0.0),
    "warmer": ("K", 0.0),
}
Known = Mapping[str, tuple[str, float | None]]


@dataclass(frozen=True)
class Scenario:
    """A flight that is ready to be flown."""

    title: str
    source: str
    earth: str
    plant: SixDof
    clock: Clock


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
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as trouble:
        raise SpecError(f"{text} is not TOML: {trouble}.") from trouble
    try:
        return scenario_of(document)
    except SpecError as mistake:
        raise SpecError(f"{text} cannot be used: {mistake}") from mistake


def scenario_of(document: Mapping[str, Any]) -> Scenario:
    """A scenario from the content of a file. Raises SpecError, NoSuchPart."""
    _only_known(document, TOP | TABLES, "")
    if document.get("format") != FORMAT:
        raise SpecError(f"format is {document.get('format')!r}; this FDES reads format = {FORMAT}.")
    name = document.get("earth", "wgs84")
    if name not in EARTHS:
        raise NoSuchPart("Earth", str(name), EARTHS)
    earth = EARTHS[name]
    body, initial = _table(document, "body"), _table(document, "initial")
    where = FLAT_PLACE if earth.g else ROUND_PLACE
    for table, known, called in ((body, INERTIA | AERO, "body."), (initial, where | MOTION, "initial.")):
        _only_known(table, known, called)
    rates_from = document.get("rates_from", "earth")
    if rates_from not in {"earth", "inertial"}:
        raise SpecError(
            f'rates_from is {rates_from!r}; it must be "earth" or "inertial": what p, q, r are relative to.'
        )
    first, second, third = _quantities(initial, where, "initial.").values()
    north, east, down, phi, theta, psi, p, q, r = _quantities(initial, MOTION, "initial.").values()
    start = state_at(
        earth,
        (first, second, third),
        (north, east, down),
        (phi, theta, psi),
        (p, q, r),
        inertial=rates_from == "inertial",
    )
    _only_known(_table(document, "air"), AIR, "air.")
    *wind, warmer = _quantities(_table(document, "air"), AIR, "air.").values()
    inertia = Inertia(*_quantities(body, INERTIA, "body.").values())
    _must_exist(inertia)
    times = _quantities({k: v for k, v in document.items() if k in TIMES}, TIMES, "")
    plant = SixDof(
        inertia=inertia,
        aero=SimpleBody(**_quantities(body, AERO, "body.")),
        aerodynamics=simple_body_loads,
        earth=earth,
        initial=start,
        limits=Limits(Surfaces(), Surfaces()),
        integrator=shelf("integrators").get(str(document.get("integrator", "rk4"))),
        wind=Wind(*wind),
        warmer=warmer,
    )
    substeps = max(1, round(times["row"] / times["step"]))
    clock = Clock(times["row"], substeps, times["duration"])
    return Scenario(str(document.get("title", "")), str(document.get("source", "")), name, plant, clock)


def fly_scenario(scenario: Scenario) -> Recording:
    """Its recording. Raises Departed."""
    setup = Setup(scenario.plant, Direct(Surfaces()))
    frames = fly(scenario.plant.start(), setup, HandsOff(0.0), SteadyAir(), scenario.clock)
    header = {
        "fdes": __version__,
        "engine": "plain",
        "scenario": scenario.title,
        "earth": scenario.earth,
        "dt": scenario.clock.dt,
        "substeps": scenario.clock.substeps,
    }
    return frames_to_recording(header, columns_of(State), map(row_of, frames))


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


def _table(document: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = document.get(name, {})
    if not isinstance(found, dict):
        raise SpecError(f"{name} is {found!r}; it must be a table, under [{name}].")
    return found


def _only_known(table: Mapping[str, Any], known: Any, where: str) -> None:
    for key in table:
        if key not in known:
            near = nearest(key, known)
            hint = f"Did you mean {near!r}?" if near else f"Known here: {', '.join(sorted(known))}."
            raise SpecError(f"{where}{key} is not a known key. {hint}")


def _quantities(table: Mapping[str, Any], known: Known, where: str) -> dict[str, float]:
    """Each known quantity in SI, in the order of `known`; those of other tables are passed over."""
    found = {}
    for name, (unit, default) in known.items():
        said = table.get(name, default)
        if said is REQUIRED:
            raise SpecError(f"{where}{name} is missing: give it with a unit of the kind of {unit}.")
        if isinstance(said, str):
            found[name] = _read(said, unit, where + name)
        elif isinstance(said, bool) or not isinstance(said, int | float):
            raise SpecError(f"{where}{name} is {said!r}; it must be a number with a unit, in quotes.")
        elif unit != "1" and name in table:
            raise SpecError(f'{where}{name} is {said:g} without a unit. Write it like "{said:g} {unit}".')
        else:
            found[name] = float(said)
    return found


def _read(text: str, unit: str, name: str) -> float:
    try:
        return parse(text, unit)
    except SpecError as mistake:
        raise SpecError(f"{name}: {mistake}") from mistake
