"""Shelves: families of parts, one file each, found by name. Nothing has to be registered.

A shelf is a package. The file's name is the part's name, and the one name in its ``__all__`` is the part. Another
distribution may add to a shelf through an entry point of the group ``fdes.<shelf>``, for example ``fdes.laws``.

>>> sorted(shelf("integrators").names())[:2]
['dopri5', 'euler']
"""

from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.metadata import entry_points
from pkgutil import iter_modules
from typing import Any

from fdes.errors import NoSuchPart

SHELVES = {
    "integrators": "fdes.physics.integrators",
    "laws": "fdes.control.laws",
    "inputs": "fdes.flight.inputs",
    "criteria": "fdes.analysis.criteria",
}


@dataclass(frozen=True)
class Shelf:
    """One family of parts."""

    name: str
    package: str

    def names(self) -> list[str]:
        """The names of all parts, sorted."""
        return sorted({*_own(self.package), *_foreign(self.name)})

    def get(self, name: str) -> Any:
        """The part called `name`. Raises NoSuchPart with the nearest name."""
        if name in _own(self.package):
            module = import_module(f"{self.package}.{name}")
            (part,) = module.__all__
            return getattr(module, part)
        foreign = _foreign(self.name)
        if name in foreign:
            return foreign[name].load()
        one = "criterion" if self.name == "criteria" else self.name.removesuffix("s")
        raise NoSuchPart(one, name, self.names())


@cache  # the cockpit asks in flight
def _own(package: str) -> tuple[str, ...]:
    return tuple(m.name for m in iter_modules(import_module(package).__path__))


@cache  # looking through what is installed takes some 10 ms
def _foreign(name: str) -> dict[str, Any]:
    return {e.name: e for e in entry_points(group=f"fdes.{name}")}


@cache
def shelf(name: str) -> Shelf:
    """The shelf of that name: one of `SHELVES`."""
    if name not in SHELVES:
        raise NoSuchPart("shelf", name, SHELVES)
    return Shelf(name, SHELVES[name])
