"""Aircraft as data: one file each, in the units of its source, with what was corrected, why, and what is only assumed.

`schema` is what a file may say, `load` finds and reads one, `explain` says what is wrong with it, `check` what is
unlikely in it, `flight_condition` is what comes out: numbers in SI, ready to fly. The aircraft themselves are in
`hangar`: lay one beside the book.
"""

from fdes.aircraft.check import Finding, check
from fdes.aircraft.edit import Change, edited
from fdes.aircraft.flight_condition import FlightCondition, Provenance, in_a_condition
from fdes.aircraft.load import Aircraft, Condition, catalogue, load, parse

__all__ = [
    "Aircraft",
    "Change",
    "Condition",
    "Finding",
    "FlightCondition",
    "Provenance",
    "catalogue",
    "check",
    "edited",
    "in_a_condition",
    "load",
    "parse",
]
