"""What a recording says first: all that it takes to make what flew once more."""

from collections.abc import Mapping
from typing import Any

from fdes.aircraft import Aircraft, FlightCondition
from fdes.aircraft.across import MACH
from fdes.flight.simulation import Clock


def condition_in(aircraft: Aircraft, header: Mapping[str, Any]) -> FlightCondition:
    """The condition of `aircraft` that a header says, without its changes. Raises FdesError, KeyError."""
    across, spool = header.get("across"), header.get("spool", False)
    return aircraft.at(header["condition"], header["variant"], across=across, spool=spool)


def how_at(condition: FlightCondition) -> dict[str, Any]:
    """What `Aircraft.at` was asked for beside the names of `condition`: interpolation across Mach, an engine's lag."""
    return ({"across": MACH} if condition.across else {}) | ({"spool": True} if condition.spool else {})


def header_of(
    condition: FlightCondition, form: str, integrator: str, clock: Clock, law: str = "direct", **more: Any
) -> dict[str, Any]:
    """The header of a flight of `condition`, plain enough for JSON. `more` is what else there is to say.

    The aircraft's own file is in it, and the changes that were made to it, as text (`fdes.aircraft.edit`).
    """
    return {
        "aircraft": condition.aircraft_id,
        "condition": condition.condition,
        "variant": condition.variant,
        "changes": [str(change) for change in condition.changes],
        **how_at(condition),
        "form": form,
        "integrator": integrator,
        "dt": clock.dt,
        "substeps": clock.substeps,
        "law": law,
        **more,
        "document": condition.document,
    }
