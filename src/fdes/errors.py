"""The errors of FDES: each says what happened, with values and units, and what to do next.

FdesError
├── AircraftFileError   a file that does not say what an aircraft file must say: file, key, nearest key
├── NoSuchPart          a name that no shelf knows: shelf, name, nearest name
├── SpecError           an impossible or unreadable request (a unit, an input, a step size), and why
├── RecordingError      a file that is not a recording, or one of a version this FDES cannot read
├── TrimError           a steady flight that an aircraft cannot fly: what falls short, and the best point found
└── Departed            a flight that left what its plant can describe: which state, when

The command line prints the text of an FdesError and exits with status 2.
"""

from collections.abc import Iterable, Mapping
from difflib import get_close_matches


class FdesError(Exception):
    """What a user can act on. Its text is complete: no traceback is needed to understand it."""


class AircraftFileError(FdesError):
    """An aircraft file that cannot be used."""


class SpecError(FdesError):
    """A request that cannot be understood or cannot be met."""


class RecordingError(FdesError):
    """A file that cannot be read as a recording."""


class TrimError(FdesError):
    """A steady flight that an aircraft cannot fly. best: the point nearest to it; nearest: a speed that it can."""

    def __init__(self, text: str, best: object, nearest: float | None) -> None:
        self.best, self.nearest = best, nearest
        super().__init__(text)


class Departed(FdesError):
    """A flight that left the range its plant can describe."""

    @classmethod
    def of(cls, t: float, state: str, value: float) -> "Departed":
        """The flight in which `state` reached `value` at `t` [s]."""
        return cls(
            f"The flight departed at t = {t:.3f} s: {state} reached {value:.3g}. Either the aircraft is unstable here, "
            "or the integrator is unstable with this time step: try a smaller one, or the exact hold."
        )


class NoSuchPart(FdesError):
    """A name that a shelf does not hold. `aliases`: other spellings of the known names, for finding the nearest."""

    def __init__(self, shelf: str, name: str, known: Iterable[str], aliases: Mapping[str, str] | None = None) -> None:
        known, aliases = sorted(known), aliases or {}
        near = nearest(name, [*known, *aliases])
        self.shelf, self.name, self.nearest = shelf, name, aliases.get(near, near) if near else None
        hint = f" Did you mean {self.nearest!r}?" if self.nearest else ""
        super().__init__(f"There is no {shelf} named {name!r}.{hint} Known: {', '.join(known)}.")


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name most like `name`, whatever the case, or None where nothing is near."""
    by_fold = {k.casefold(): k for k in known}
    found = get_close_matches(name.casefold(), by_fold, n=1, cutoff=0.5)
    return by_fold[found[0]] if found else None
