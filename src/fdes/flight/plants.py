"""From an aircraft in a flight condition to a plant that flies."""

from typing import get_args

from fdes.aircraft import FlightCondition
from fdes.control import exact_hold
from fdes.errors import NoSuchPart
from fdes.physics.derivatives import Form
from fdes.physics.small_perturbation import SmallPerturbation
from fdes.shelf import shelf

EXACT = "exact"


def integrator_names() -> list[str]:
    """The integrators of the shelf, and the exact hold that only the linear plant has."""
    return [EXACT, *shelf("integrators").names()]


def plant_of(
    condition: FlightCondition, form: str = "full", integrator: str = "rk4", step: float = 1.0 / 120.0
) -> SmallPerturbation:
    """The linear plant of `condition`: its equations in `form`, solved by `integrator`.

    `step` [s] is the integrator's step; only ``exact`` needs to know it beforehand.
    Raises NoSuchPart for a form or an integrator that does not exist.
    """
    if form not in get_args(Form):
        raise NoSuchPart("form of the linear equations", form, get_args(Form))
    named: Form = form  # type: ignore[assignment]  # just checked
    ref = condition.reference
    equations = condition.equations(named)
    if integrator == EXACT:
        method = exact_hold(equations, ref, step)
    else:
        try:
            method = shelf("integrators").get(integrator)
        except NoSuchPart:
            raise NoSuchPart("integrator", integrator, integrator_names()) from None
    return SmallPerturbation(ref, equations, condition.trim_throttle, condition.limits, method)
