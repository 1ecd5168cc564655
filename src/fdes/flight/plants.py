"""From an aircraft in a flight condition to a plant that flies."""

from fdes.aircraft import FlightCondition, in_a_condition
from fdes.control import exact_hold
from fdes.errors import NoSuchPart
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
    Raises NoSuchPart for a form or an integrator that does not exist, SpecError for what is no flight condition.
    """
    condition = in_a_condition(condition)
    ref = condition.reference
    equations = condition.equations(form)  # type: ignore[arg-type]  # it refuses what is no form
    if integrator == EXACT:
        method = exact_hold(equations, ref, step)
    else:
        try:
            method = shelf("integrators").get(integrator)
        except NoSuchPart:
            raise NoSuchPart("integrator", integrator, integrator_names()) from None
    return SmallPerturbation(ref, equations, condition.trim_throttle, condition.limits, method)
