"""From an aircraft in a flight condition to the nonlinear plant.

Sources of derivatives do not say how an aircraft behaves far from their condition. What is assumed for that is listed
by `assumptions`, and whoever flies the plant should show it.
"""

from fdes.aircraft import FlightCondition
from fdes.aircraft.terms import Terms
from fdes.errors import SpecError
from fdes.physics.aero import DerivativeAero, derivative_aero, derivative_loads
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Coefficients
from fdes.physics.earth import FLAT
from fdes.physics.plant import SixDof, state_at
from fdes.physics.propulsion import JET_LAPSE, Engine, assumed_engine
from fdes.physics.rigid_body import Inertia
from fdes.physics.signals import Surfaces
from fdes.physics.terms import term_loads
from fdes.physics.turbofan import commanded_power, turbofan
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
    if condition.tables:
        return _of_tables(condition, condition.tables, integrator)
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


def _of_tables(condition: FlightCondition, tables: Terms, integrator: str) -> SixDof:
    """The plant whose aerodynamics are tables; its engine too, where the file has such."""
    changed = [change.name for change in condition.changes if change.name in Coefficients._fields]
    if changed:
        raise SpecError(
            f"{condition.aircraft_id} cannot fly nonlinear with {changed[0]} changed: there its aerodynamics are "
            "tables, not derivatives. Leave that change out, or fly the linear plant."
        )
    ref = condition.reference
    engine = condition.turbofan
    plant = SixDof(
        inertia=Inertia(ref.m, ref.Ix, ref.Iy, ref.Iz, ref.Ixz),
        aero=tables.aero(ref.S, ref.b, ref.c, condition.cg or 0.0),
        aerodynamics=term_loads,
        earth=FLAT._replace(g=ref.g),
        initial=state_at(FLAT, (0.0, 0.0, ref.h), (ref.V, 0.0, 0.0), (0.0, ref.alpha, 0.0)),
        limits=condition.limits,
        integrator=shelf("integrators").get(integrator),
        engine=Engine(T_max=ref.T_max),
        rest=Surfaces(throttle=condition.trim_throttle),
    )
    if engine is None:
        return plant
    return plant._replace(
        inertia=plant.inertia._replace(Hx=engine.angular_momentum.si(condition.variant)),
        engine=engine.engine(),
        propulsion=turbofan,
        settled=commanded_power,
    )


def assumptions(condition: FlightCondition, plant: SixDof) -> list[str]:
    """What no source says of this plant, as sentences."""
    if condition.tables:
        return _of_tables_sentences(condition, condition.tables)
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


def _of_tables_sentences(condition: FlightCondition, tables: Terms) -> list[str]:
    ends = ", ".join(
        f"{name} from {axis.breakpoints[0]:g} to {axis.breakpoints[-1]:g} {axis.unit}"
        for name, axis in tables.axes.items()
        if not axis.mirrored
    )
    beyond = "held" if tables.beyond == "hold" else "extrapolated"
    thrust = "" if condition.turbofan else " Assumed: thrust does not change with speed or height."
    return [
        f"Aerodynamics are tables: {ends}; beyond these they are {beyond}.{thrust}",
        f"Lineage of the tables: {tables.lineage}.",
    ]


def _has_propeller(condition: FlightCondition) -> bool:
    return bool(condition.document.get("engine") == "propeller")
