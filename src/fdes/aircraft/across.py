"""The other conditions of an aircraft, from which its aerodynamics are interpolated in Mach.

Only conditions of one configuration go together: between flaps out and flaps in there is no Mach number at which they
are half out. The loading, the height and the engine stay those of the condition that was chosen.
"""

from collections.abc import Iterable
from dataclasses import replace

from fdes.aircraft.edit import Change, edited
from fdes.aircraft.flight_condition import FlightCondition
from fdes.errors import NoSuchPart, SpecError

MACH = "mach"


def across(chosen: FlightCondition, ready: Iterable[FlightCondition], what: str) -> FlightCondition:
    """`chosen`, with the conditions of `ready` that it can be interpolated with across `what`, which is ``mach``.

    Their moments are taken about its center of gravity. Raises NoSuchPart, and SpecError where there are none.
    """
    if what != MACH:
        raise NoSuchPart("quantity to interpolate across", what, [MACH])
    name = f"{chosen.aircraft_id} {chosen.condition}"
    if chosen.tables:
        raise SpecError(f"{name} is not interpolated across Mach: its aerodynamics are tables. Leave --across out.")
    if not chosen.nondimensional:
        raise SpecError(
            f"{name} cannot be interpolated across Mach: its source gives dimensional derivatives, which hold at one "
            "speed and height alone. Fly the linear plant, or another aircraft."
        )
    others = [c for c in ready if c.condition != chosen.condition and c.nondimensional]
    if not others:
        raise SpecError(
            f"{name} cannot be interpolated across Mach: its file has no other condition. Leave --across out."
        )
    unsaid = [c.condition for c in (chosen, *others) if c.configuration is None]
    if unsaid:
        raise SpecError(
            f"{name} cannot be interpolated across Mach: its file does not say in which configuration {unsaid[0]} is, "
            "with flaps and gear in or out. Where you know it, say it there: "
            'configuration = { name = "clean", reason = "..." }.'
        )
    alike = [c for c in others if c.configuration == chosen.configuration]
    if not alike:
        found = ", ".join(f"{c.condition} is {c.configuration}" for c in others)
        raise SpecError(
            f"{name} cannot be interpolated across Mach: it is {chosen.configuration}, and {found}. Between two "
            "configurations there is no aircraft; leave --across out."
        )
    ends = tuple(_about_its_cg(chosen, c) for c in alike)
    machs = [c.reference.mach for c in (chosen, *ends)]
    if len(set(machs)) < len(machs):
        twice = next(m for m in machs if machs.count(m) > 1)
        raise SpecError(
            f"{name} cannot be interpolated across Mach: two of its conditions are at Mach {twice:g}. Leave --across "
            "out, or make a file with one of the two."
        )
    return replace(chosen, across=ends)


def _about_its_cg(chosen: FlightCondition, other: FlightCondition) -> FlightCondition:
    if chosen.cg is None or other.cg is None or chosen.cg == other.cg:
        return other
    return edited(other, [Change("cg", "=", chosen.cg, "1")])
