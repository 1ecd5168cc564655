"""The plant that flies, linear or nonlinear, from an aircraft and what a recording's header says of its equations."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from fdes.aircraft import FlightCondition
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.plants import EXACT, plant_of
from fdes.physics.derivatives import Form

if TYPE_CHECKING:
    from fdes.physics.plant import SixDof
    from fdes.physics.small_perturbation import SmallPerturbation

LINEAR, NONLINEAR = "linear", "nonlinear"
PLANTS = (LINEAR, NONLINEAR)


@dataclass(frozen=True)
class Trimmed:
    """The nonlinear plant in steady level flight: `V` [m/s], `h` [m], angles [rad], and what is assumed of it.

    stall: the angles of attack [rad] between which lift still grows, where that is assumed.
    """

    plant: "SixDof"
    V: float
    h: float
    alpha: float
    theta: float
    throttle: float
    stall: tuple[float, float] | None
    assumptions: tuple[str, ...]


def must_be_a_plant(name: str, integrator: str) -> None:
    """Raises NoSuchPart for a plant that does not exist, SpecError for the exact hold of the nonlinear one."""
    if name not in PLANTS:
        raise NoSuchPart("plant", name, PLANTS)
    if name == NONLINEAR and integrator == EXACT:
        raise SpecError(
            "The exact hold solves linear equations, and those of the nonlinear plant are not. "
            "Take another integrator with it, such as rk4."
        )


def trimmed(condition: FlightCondition, integrator: str, V: float, h: float, **more: float) -> Trimmed:
    """The nonlinear plant of `condition`, trimmed at `V` [m/s], `h` [m] and what `more` a `TrimSpec` has.

    Raises SpecError, TrimError, NoSuchPart.
    """
    from fdes.analysis.trim import TrimSpec, trim
    from fdes.flight.nonlinear import assumptions, six_dof_of
    from fdes.physics.across_mach import AcrossMach, Between, conditions_of
    from fdes.physics.aero import DerivativeAero

    must_be_a_plant(NONLINEAR, integrator)
    plant = six_dof_of(condition, integrator)
    point = trim(plant, TrimSpec(V, h, **more))
    stall = _stall(plant.aero) if isinstance(plant.aero, DerivativeAero) else None
    if isinstance(plant.aero, Between | AcrossMach):
        downs, ups = zip(*map(_stall, conditions_of(plant.aero)), strict=True)
        stall = max(downs), min(ups)  # at any Mach number
    said = tuple(assumptions(condition, plant))
    return Trimmed(point.plant, V, h, point.alpha, point.theta, point.surfaces.throttle, stall, said)


def _stall(aero: Any) -> tuple[float, float]:
    """Where the straight line of lift reaches its assumed largest, up and down."""
    up, down = aero.CL_max - aero.k.CL, -aero.CL_max - aero.k.CL
    return aero.alpha_0 + down / aero.k.CL_alpha, aero.alpha_0 + up / aero.k.CL_alpha


def is_nonlinear(header: Mapping[str, Any]) -> bool:
    """Whether the flight of that header was one of the nonlinear plant."""
    return NONLINEAR in {header.get("plant"), header.get("form")}


def form_in(header: Mapping[str, Any]) -> Form:
    """The form of the linear equations that a header says; `full` where it says the nonlinear plant in its place."""
    said: Form = header["form"]
    return "full" if said == NONLINEAR else said


def plant_in(header: Mapping[str, Any], condition: FlightCondition) -> "SmallPerturbation | SixDof":
    """The plant that the header says, of `condition`; the nonlinear one trimmed as it was. Raises FdesError."""
    if not is_nonlinear(header):
        return plant_of(condition, header["form"], header["integrator"], header["dt"] / header.get("substeps", 1))
    ref = condition.reference
    return trimmed(condition, header["integrator"], **{"V": ref.V, "h": ref.h, **header.get("trim", {})}).plant
