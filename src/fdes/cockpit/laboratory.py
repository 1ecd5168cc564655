"""The laboratory in the cockpit: what edits of aircraft and law ask for, and what those who watch are told of them."""

from dataclasses import replace
from typing import Any, NamedTuple

from fdes.aircraft.role import Role, role_of
from fdes.cockpit import commands
from fdes.cockpit.craft import Craft
from fdes.cockpit.flight_control import Control, laws_message
from fdes.cockpit.history import History
from fdes.errors import SpecError

Editing = (
    commands.Edit
    | commands.Undo
    | commands.Redo
    | commands.Judge
    | commands.Engage
    | commands.UseActuators
    | commands.ChoosePlant
)


class Wanted(NamedTuple):
    """What a command leaves of a craft, and what it changes."""

    changes: tuple[str, ...]
    role: Role
    control: Control
    plant: str


def wanted(command: Editing, flown: Craft, past: History) -> Wanted:
    """What a command asks for. Raises SpecError where there is nothing to undo or redo."""
    now = Wanted(flown.changes, flown.role, flown.fit.control, flown.plant)
    match command:
        case commands.Edit(changes):
            return now._replace(changes=changes)
        case commands.Undo():
            if (before := past.before()) is None:
                raise SpecError("There is no edit to undo.")
            return now._replace(changes=before)
        case commands.Redo():
            if (after := past.after()) is None:
                raise SpecError("There is no undone edit to make again.")
            return now._replace(changes=after)
        case commands.Judge(airplane_class, category, phase):
            own = role_of(flown.base.document, flown.base.condition)
            return now._replace(role=own.but(airplane_class, category, phase))
        case commands.Engage(text, sampled):
            return now._replace(control=now.control.asked(text, sampled=sampled))
        case commands.UseActuators(on):
            return now._replace(control=replace(now.control, actuators=on))
        case commands.ChoosePlant(plant):
            return now._replace(plant=plant)


def ready(flown: Craft, asked: Wanted) -> Craft:
    """The craft with all that is told of it, so that telling costs nothing more. Raises NoSuchPart, SpecError."""
    same = asked._replace(role=flown.role) == Wanted(flown.changes, flown.role, flown.fit.control, flown.plant)
    craft = replace(flown, role=asked.role) if same else flown.but(**asked._asdict())
    laboratory(craft, History())
    return craft


def laboratory(craft: Craft, past: History, *, whole: bool = True) -> list[dict[str, Any]]:
    """The wire's KNOBS and LAWS (for a `whole` new aircraft), STABILITY, CONTROL and QUALITIES."""
    undo, redo = past.depth
    return [
        *([{"type": "knobs", "knobs": craft.knobs}, laws_message()] if whole else []),
        {"type": "stability", **craft.stability, "undo": undo, "redo": redo},
        craft.control,
        {"type": "qualities", **craft.qualities},
    ]
