"""Variable stability in the cockpit: what an edit asks for, and what those who watch are told of it."""

from dataclasses import replace
from typing import Any

from fdes.aircraft.role import Role, role_of
from fdes.cockpit import commands
from fdes.cockpit.craft import Craft
from fdes.cockpit.history import History
from fdes.errors import SpecError

Editing = commands.Edit | commands.Undo | commands.Redo | commands.Judge


def wanted(command: Editing, flown: Craft, past: History) -> tuple[tuple[str, ...], Role]:
    """The changes and the role that a command asks for. Raises SpecError where there is nothing to undo or redo."""
    match command:
        case commands.Edit(changes):
            return changes, flown.role
        case commands.Undo():
            if (before := past.before()) is None:
                raise SpecError("There is no edit to undo.")
            return before, flown.role
        case commands.Redo():
            if (after := past.after()) is None:
                raise SpecError("There is no undone edit to make again.")
            return after, flown.role
        case commands.Judge(airplane_class, category, phase):
            own = role_of(flown.base.document, flown.base.condition)
            return flown.changes, own.but(airplane_class, category, phase)


def ready(flown: Craft, changes: tuple[str, ...], role: Role) -> Craft:
    """The craft with all that is told of it, so that telling costs nothing more. Raises NoSuchPart, SpecError."""
    craft = replace(flown, role=role) if changes == flown.changes else flown.edited(changes, role)
    laboratory(craft, History())
    return craft


def laboratory(craft: Craft, past: History, *, whole: bool = True) -> list[dict[str, Any]]:
    """The wire's KNOBS (for a `whole` new aircraft), STABILITY and QUALITIES."""
    undo, redo = past.depth
    return [
        *([{"type": "knobs", "knobs": craft.knobs}] if whole else []),
        {"type": "stability", **craft.stability, "undo": undo, "redo": redo},
        {"type": "qualities", **craft.qualities},
    ]
