"""From an aircraft in a flight condition to the nonlinear plant.

Sources of derivatives do not say how an aircraft behaves far from their condition. What is assumed for that is listed
by `assumptions`, and whoever flies the plant should show it.
"""

from fdes.aircraft import FlightCondition
from fdes.errors import SpecError
from fdes.physics.aero import DerivativeAero, derivative_aero, derivative_loads
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.earth import FLAT
from fdes.physics.plant import SixDof, state_at
from fdes.physics.propulsion import JET_LAPSE, assumed_engine
from fdes.physics.rigid_body import Inertia
from fdes.physics.signals import Surfaces
from fdes.shelf import shelf


def six_dof_of(condition: FlightCondition, integrator: str = "rk4") -> SixDof:
    """The nonlinear plant of `condition` over a flat Earth, not trimmed: level, at the condition's angle of attack.

    Raises SpecError where the source gives dimensional derivatives, which hold at one condition alone.
    """
    if not condition.nondimensional:
        raise SpecError(
            f"{condition.aircraft_id} {condition.condition} cannot fly nonlinear: its source gives dimensional "
            "derivatives, which hold at one speed and height alone. Fly the linear plant, or another aircraft."
        )
    ref = condition.reference
    air = standard_atmosphere(ref.h)
    return SixDof(
        inertia=Inertia(ref.m, ref.Ix, ref.Iy, ref.Iz, ref.Ixz),
        aero=derivative_aero(condition.coefficients, ref, ref.V / air.a),
        aerodynamics=derivative_loads,
        earth=FLAT,
        initial=state_at(FLAT, (0.0, 0.0, ref.h), (ref.V, 0.0, 0.0), (0.0, ref.alpha, 0.0)),
        limits=condition.limits,
        integrator=shelf("integrators").get(integrator),
        engine=assumed_engine(ref.T_max, ref.V, air.rho, -ref.alpha, propeller=_has_propeller(condition)),
        rest=Surfaces(throttle=condition.trim_throttle),
    )


def assumptions(condition: FlightCondition, plant: SixDof) -> list[str]:
    """What no source says of this plant, as sentences."""
    aero: DerivativeAero = plant.aero
    engine = (
        "as the density, and as 1/V above half the condition's speed, as of a propeller at constant power"
        if _has_propeller(condition)
        else f"as the density to the power of {JET_LAPSE}, and not with speed, as of a jet"
    )
    lift = f"Assumed: the lift coefficient of the wing ends at {aero.CL_max:.2f}, rounded from 0.9 of that"
    return [
        f"{lift}; beyond, drag grows as that of a flat plate. The derivatives know no stall.",
        f"Assumed: thrust changes {engine}. It acts along the flight path of the condition.",
        f"The drag polar is CD = {aero.CD_0:.4f} + {aero.K:.4f} CL^2, through the condition with its CD_alpha.",
        f"Derivatives hold at Mach {condition.reference.mach:g}: those with Mach act on the difference to it.",
    ]


def _has_propeller(condition: FlightCondition) -> bool:
    return bool(condition.document.get("engine") == "propeller")
