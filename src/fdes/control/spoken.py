"""Control laws as one says them: "yaw_damper gain=0.5; roll_rate_damper zeta=0.8".

Loops are separated by semicolons, the innermost first. A name is the name of a part on the shelf `laws`, and never a
path: what is said may come from a recording, a link or the network.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, get_type_hints

from fdes.errors import NoSuchPart, SpecError
from fdes.shelf import shelf
from fdes.units import parse

GIVEN = ("inner", "full_stick")  # what a law has from the aircraft and from the law inside, not from words
WISHES = {"zeta": "1", "omega": "rad/s", "time_constant": "s"}
_MEANT = {"omega_n": "omega", "tau": "time_constant", "k": "gain"}


@dataclass(frozen=True)
class Loop:
    """One law as it was said: what it is made of, its settings by field, and what is wished of it. SI and radians."""

    name: str
    part: Any
    settings: Mapping[str, float]
    wishes: Mapping[str, float]


def loops(text: str, own: Mapping[str, Any] | None = None) -> tuple[Loop, ...]:
    """The laws that `text` names. `own` are parts beside those of the shelf, by name.

    Raises NoSuchPart for a name that is not known, SpecError for what cannot be read.
    """
    found = tuple(_loop(said.strip(), own or {}) for said in text.split(";") if said.strip())
    if not found:
        raise SpecError(f"The law {text!r} names no law. Write it like 'yaw_damper gain=0.5'.")
    for loop in found:
        if [other.name for other in found].count(loop.name) > 1:
            raise SpecError(f"The law {text!r} says {loop.name} twice; one loop of a kind is enough.")
    for loop in found[1:]:
        if "inner" not in [f.name for f in fields(loop.part)]:
            raise SpecError(
                f"The law {text!r} says {loop.name} after another: it has no place for a law inside. Say it first."
            )
    return found


def units_of(part: Any) -> dict[str, str]:
    """The settings of a law that words can say, with their units."""
    hints = get_type_hints(part, include_extras=True)
    return {f.name: hints[f.name].__metadata__[0] for f in fields(part) if f.name not in GIVEN}


def _loop(said: str, own: Mapping[str, Any]) -> Loop:
    spoken, *words = said.split()
    if words and "=" not in words[0]:
        raise SpecError(f"The law {said!r} cannot be read at {words[0]!r}. Write it like 'yaw_damper gain=0.5'.")
    name = spoken if spoken in own else spoken.casefold().replace("-", "_")
    if name not in own and name not in shelf("laws").names():
        raise NoSuchPart("law", spoken, [*shelf("laws").names(), *own])
    part = own.get(name) or shelf("laws").get(name)
    units = units_of(part)
    settings: dict[str, float] = {}
    wishes: dict[str, float] = {}
    for key, value in re.findall(r"(\S+?)\s*=\s*([^=]*?)(?=\s+\S+?\s*=|$)", " ".join(words)):
        meant = _MEANT.get(key, key)
        if meant not in units and meant not in WISHES:
            raise NoSuchPart(f"setting of {name}", key, [*units, *WISHES])
        where = settings if meant in units else wishes
        if meant in where:
            raise SpecError(f"The law {said!r} says {key} twice.")
        where[meant] = _number(said, key, value, units.get(meant) or WISHES[meant])
    return Loop(name, part, settings, wishes)


def _number(said: str, key: str, value: str, unit: str) -> float:
    """The value in SI. An angle, and a rate that is no frequency, must say its unit."""
    if not value:
        raise SpecError(f"The law {said!r} does not say its value after {key}=.")
    if key.startswith("full_") and value[-1].isdigit():
        raise SpecError(f"The law {said!r} does not say the unit of {key}. Write {key}={value}deg, or the like.")
    try:
        return parse(value, unit)
    except SpecError as trouble:
        raise SpecError(f"The law {said!r} cannot be read. {trouble}") from trouble
