"""What a recording says first: all that it takes to make what flew once more."""

from typing import Any

from fdes.aircraft import FlightCondition
from fdes.aircraft.across import MACH
from fdes.flight.simulation import Clock


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
        **({"across": MACH} if condition.across else {}),
        "form": form,
        "integrator": integrator,
        "dt": clock.dt,
        "substeps": clock.substeps,
        "law": law,
        **more,
        "document": condition.document,
    }
