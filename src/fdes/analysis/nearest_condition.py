"""Which loading of an aircraft is meant where a flight is asked for, and none of its conditions.

Aerodynamics that are tables hold in all of an aircraft's conditions, which differ in mass and center of gravity. So a
flight that is asked for by speed and height is flown as the condition that has them.
"""

from fdes.aircraft import Aircraft
from fdes.analysis.trim import TrimSpec, spec_of


def nearest_condition(aircraft: Aircraft, text: str) -> str | None:
    """The condition of `aircraft` nearest in height, then in speed, to the trim that `text` asks for.

    None where its derivatives hold near one condition alone, or where its name already said the condition.
    Raises SpecError, NoSuchPart for a text that cannot be read.

    >>> import fdes
    >>> nearest_condition(fdes.load("F-16"), "V=565 ft/s h=10000 ft")
    'M0.53_10kft'
    """
    first = aircraft.at()
    named = aircraft.conditions[0].id != aircraft.document["conditions"][0]["id"]
    if named or not first.tables:
        return None
    asked = spec_of(text, TrimSpec(first.reference.V, first.reference.h))

    def away(condition: str) -> tuple[float, float]:
        reference = aircraft.at(condition).reference
        return abs(reference.h - asked.h), abs(reference.V - asked.V)

    return min((c.id for c in aircraft.conditions), key=away)
