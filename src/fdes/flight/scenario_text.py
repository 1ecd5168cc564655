"""Reading the tables of a scenario: quantities with their units, and nothing that is not known."""

from collections.abc import Mapping
from typing import Any

from fdes.errors import SpecError, nearest
from fdes.units import parse

REQUIRED = None
Known = Mapping[str, tuple[str, float | None]]


def table_of(document: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    """The table of that name, empty where there is none. Raises SpecError."""
    found = document.get(name, {})
    if not isinstance(found, dict):
        raise SpecError(f"{name} is {found!r}; it must be a table, under [{name}].")
    return found


def only_known(table: Mapping[str, Any], known: Any, where: str) -> None:
    """Raises SpecError for a key that is not `known`, with the nearest one that is."""
    for key in table:
        if key not in known:
            near = nearest(key, known)
            hint = f"Did you mean {near!r}?" if near else f"Known here: {', '.join(sorted(known))}."
            raise SpecError(f"{where}{key} is not a known key. {hint}")


def quantities(table: Mapping[str, Any], known: Known, where: str) -> dict[str, float]:
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
