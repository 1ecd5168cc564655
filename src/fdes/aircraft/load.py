"""From a name or a path to an aircraft: finding its file, reading it, and saying what is wrong with it."""

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from fdes.aircraft.across import across as interpolated
from fdes.aircraft.dimensional import DimensionalDerivatives
from fdes.aircraft.explain import explain
from fdes.aircraft.flight_condition import FlightCondition, flight_condition
from fdes.aircraft.number import CONFIDENCES, VARIANTS, Confidence, Variant
from fdes.aircraft.schema import AircraftFile, Derivatives
from fdes.errors import AircraftFileError, FdesError, NoSuchPart, SpecError, nearest

HANGAR = files("fdes.aircraft") / "hangar"
PAPER = ("A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar")  # in the order of Mansor and Perumal's list


@dataclass(frozen=True)
class Condition:
    """One flight condition of an aircraft, as a picker shows it. altitude [m].

    confidence: at least half of the derivatives are this sure to be what the source prints; None where it is not said.
    """

    id: str
    name: str
    mach: float
    altitude: float
    confidence: Confidence | None
    notes: tuple[str, ...]


@dataclass(frozen=True)
class Aircraft:
    """An aircraft as its file describes it.

    source: the work that its numbers are from. sources: all works that the file cites, by their keys.
    document: the content of the file, plain enough for JSON.
    """

    id: str
    name: str
    summary: str
    aliases: tuple[str, ...]
    source: str
    sources: Mapping[str, str]
    conditions: tuple[Condition, ...]
    document: Mapping[str, Any] = field(repr=False)
    _ready: Mapping[tuple[str, Variant], FlightCondition] = field(repr=False)

    def at(
        self,
        condition: str | None = None,
        variant: str = "corrected",
        *,
        across: str | None = None,
        spool: bool = False,
    ) -> FlightCondition:
        """The aircraft in one of its conditions, the first when none is named.

        `variant` is ``corrected``, or ``printed``: the numbers as the source prints them, misprints too.
        across: ``mach``, for a nonlinear plant between this condition and the others of its configuration.
        spool: with an engine that follows the throttle with the lag that is assumed, in the nonlinear plant.
        Raises NoSuchPart for a condition or a variant that the aircraft does not have, SpecError where it has no
        conditions that can be interpolated, or an engine with a lag of its own.
        """
        known = {fold(c.id): c.id for c in self.conditions}
        chosen = self.conditions[0].id if condition is None else known.get(fold(condition))
        if chosen is None:
            raise NoSuchPart(f"flight condition of the {self.id}", str(condition), known.values())
        for each in VARIANTS:
            if each == variant:
                ready = self._ready[chosen, each]
                if across is not None:
                    ready = interpolated(ready, [self._ready[c.id, each] for c in self.conditions], across)
                return spooling(ready) if spool else ready
        raise NoSuchPart("variant", variant, VARIANTS)


def spooling(ready: FlightCondition) -> FlightCondition:
    """`ready` with the assumed lag of its engine. Raises SpecError where that has one of its own."""
    if ready.turbofan:
        raise SpecError(
            f"The engine of the {ready.aircraft_id} follows its throttle with a lag of its own, which always acts. "
            "Leave --spool out."
        )
    return replace(ready, spool=True)


def load(name_or_path: str | Path) -> Aircraft:
    """An aircraft of the hangar by its id, name or alias, or one from a file of your own.

    With the id of one of its conditions after its own, as in ``B747_CR2144_FC9``, that condition comes first.
    Case, spaces, hyphens and underscores in a name do not matter. A path is a Path, ends in ``.toml``, or has a slash.
    Raises NoSuchPart for an unknown name, AircraftFileError for a file that cannot be used.

    >>> load("boeing 747").id
    'B747'
    """
    text = str(name_or_path)
    if isinstance(name_or_path, Path) or text.endswith(".toml") or "/" in text or "\\" in text:
        return _read(Path(name_or_path).expanduser())
    folded = fold(text)
    if folded in _stems():  # a file of the hangar is named by the folded id, so that the others need not be read
        return _of_hangar(folded)
    spellings = {spelling: a.id for a in catalogue() for spelling in (a.id, a.name, *a.aliases)}
    for spelling, known in spellings.items():
        if fold(spelling) == folded:
            return _of_hangar(fold(known))
    for aircraft in catalogue():
        for condition in aircraft.conditions:
            if fold(aircraft.id + condition.id) == folded:
                others = [c for c in aircraft.conditions if c is not condition]
                return replace(aircraft, conditions=(condition, *others))
    raise NoSuchPart("aircraft", text, set(spellings.values()), spellings)


def catalogue() -> list[Aircraft]:
    """All aircraft of the hangar: those of the paper in its order, then the others by name."""
    found = [_of_hangar(stem) for stem in _stems()]
    return sorted(found, key=lambda a: (PAPER.index(a.id) if a.id in PAPER else len(PAPER), a.id))


def parse(document: Mapping[str, Any], where: str) -> Aircraft:
    """An aircraft from the content of a file, such as the one a recording carries; `where` says whose, in errors.

    Raises AircraftFileError.
    """
    plain = dict(document)
    try:
        file = AircraftFile.model_validate(plain)
    except ValidationError as error:
        raise AircraftFileError(f"{where} cannot be used:\n{explain(error, plain)}") from None
    ready: dict[tuple[str, Variant], FlightCondition] = {}
    for condition in file.conditions:
        for variant in VARIANTS:
            try:
                ready[condition.id, variant] = flight_condition(file, condition, variant, plain)
            except FdesError as error:
                place = f"condition {condition.id!r}, {variant} values"
                raise AircraftFileError(f"{where} cannot be used:\n  {place}: {error}") from None
    return Aircraft(
        id=file.id,
        name=file.name,
        summary=file.summary,
        aliases=file.aliases,
        source=file.sources[file.conditions[0].source],
        sources=file.sources,
        conditions=tuple(
            Condition(c.id, c.name, c.mach, c.altitude.si("corrected"), _confidence(c.table), c.notes)
            for c in file.conditions
        ),
        document=plain,
        _ready=ready,
    )


def _stems() -> list[str]:
    return [f.name.removesuffix(".toml") for f in HANGAR.iterdir() if f.name.endswith(".toml")]


@cache
def _of_hangar(stem: str) -> Aircraft:
    return _read(HANGAR / f"{stem}.toml")


def aircraft_of(text: str, where: str) -> Aircraft:
    """An aircraft from the text of a file; `where` says whose, in errors. Raises AircraftFileError."""
    try:
        document = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise AircraftFileError(f"{where} cannot be used: it is not TOML. {error}.") from None
    return parse(document, where)


def _read(path: Traversable) -> Aircraft:
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise AircraftFileError(f"There is no aircraft file {path}. {_beside(path)}") from None
    except UnicodeDecodeError:
        raise AircraftFileError(f"{path} cannot be used: it is not text in UTF-8.") from None
    except OSError as error:
        raise AircraftFileError(f"{path} cannot be read: {error.strerror or error}.") from None
    return aircraft_of(text, str(path))


def _beside(path: Traversable) -> str:
    """What could have been meant by a path that leads nowhere."""
    folder = Path(str(path)).parent
    if not folder.is_dir():
        return f"Nor is there a folder {folder}."
    found = nearest(path.name.removesuffix(".toml"), [f.stem for f in folder.glob("*.toml")])
    return (
        f"Did you mean '{found}.toml'?" if found else "An aircraft of the hangar goes by its name alone, such as A-4D."
    )


def _confidence(table: Derivatives | DimensionalDerivatives) -> Confidence | None:
    numbers = table.numbers().items() if isinstance(table, DimensionalDerivatives) else table
    said = [number.confidence for _, number in numbers if number and number.confidence]
    best_first = sorted(said, key=CONFIDENCES.index)
    return best_first[(len(best_first) - 1) // 2] if best_first else None


def fold(name: str) -> str:
    """A name without what does not matter in it: ``fold("A-4D Skyhawk") == "a4dskyhawk"``."""
    return re.sub(r"[\s_-]+", "", name.casefold())
