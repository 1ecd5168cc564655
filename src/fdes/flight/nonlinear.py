"""From an aircraft in a flight condition to the nonlinear plant.

Sources of derivatives do not say how an aircraft behaves far from their condition. What is assumed for that is listed
by `assumptions`, and whoever flies the plant should show it.
"""

from itertools import pairwise

from fdes.aircraft import FlightCondition, in_a_condition
from fdes.aircraft.terms import Terms
from fdes.errors import SpecError
from fdes.physics.across_mach import (
    AcrossMach,
    Between,
    across_mach,
    across_mach_loads,
    conditions_of,
    loads_between,
    mach_derivatives,
    secants,
)
from fdes.physics.aero import DerivativeAero, derivative_aero, derivative_loads
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Coefficients
from fdes.physics.earth import FLAT
from fdes.physics.plant import SixDof, state_at
from fdes.physics.propulsion import JET_LAPSE, Engine, Spooling, assumed_engine, settled_power, spooling
from fdes.physics.rigid_body import Inertia
from fdes.physics.signals import Surfaces
from fdes.physics.terms import term_loads
from fdes.physics.turbofan import commanded_power, turbofan
from fdes.shelf import shelf
from fdes.units import DEG, to_si


def six_dof_of(condition: FlightCondition, integrator: str = "rk4") -> SixDof:
    """The nonlinear plant of `condition` over a flat Earth, not trimmed: level, at the condition's angle of attack.

    Raises SpecError where the source gives dimensional derivatives, which hold at one condition alone.
    """
    condition = in_a_condition(condition)
    if not condition.nondimensional:
        raise SpecError(
            f"{condition.aircraft_id} {condition.condition} cannot fly nonlinear: its source gives dimensional "
            "derivatives, which hold at one speed and height alone. Fly the linear plant, or another aircraft."
        )
    ref = condition.reference
    if condition.tables:
        return _of_tables(condition, condition.tables, integrator)
    air = standard_atmosphere(ref.h)
    plant = SixDof(
        inertia=Inertia(ref.m, ref.Ix, ref.Iy, ref.Iz, ref.Ixz),
        aero=_aero(condition, ref.alpha),
        aerodynamics=derivative_loads,
        earth=FLAT,
        initial=state_at(FLAT, (0.0, 0.0, ref.h), (ref.V, 0.0, 0.0), (0.0, ref.alpha, 0.0)),
        limits=condition.limits,
        integrator=shelf("integrators").get(integrator),
        engine=assumed_engine(ref.T_max, ref.V, air.rho, -ref.alpha, propeller=_has_propeller(condition)),
        rest=Surfaces(throttle=condition.trim_throttle),
    )
    if condition.spool:
        plant = plant._replace(
            engine=Spooling(plant.engine, _lag(condition)), propulsion=spooling, settled=settled_power
        )
    return _across(condition, plant) if condition.across else plant


def _lag(condition: FlightCondition) -> float:
    """The assumed lag of the engine [s]."""
    said = condition.assumed["engine_lag"]
    return to_si(said["value"], said["unit"])


def _aero(condition: FlightCondition, alpha: float) -> DerivativeAero:
    """The aerodynamics of one condition, `alpha` [rad] being its angle of attack."""
    ref = condition.reference._replace(alpha=alpha)
    return derivative_aero(condition.coefficients, ref, ref.V / standard_atmosphere(ref.h).a)


def _across(condition: FlightCondition, plant: SixDof) -> SixDof:
    """The plant with aerodynamics between `condition` and those that it is interpolated with."""
    others = [_aero(other, _alpha_seen_from(condition, other)) for other in condition.across]
    sets = tuple(sorted([plant.aero, *others], key=lambda aero: aero.mach_0))
    if any(low.mach_0 == high.mach_0 for low, high in pairwise(sets)):
        raise SpecError(
            f"With its changes, {condition.aircraft_id} {condition.condition} is at the Mach number of another "
            "condition, with which it cannot be interpolated then. Leave that change or --across out."
        )
    aero = across_mach(sets)
    return plant._replace(aero=aero, aerodynamics=loads_between if isinstance(aero, Between) else across_mach_loads)


def _alpha_seen_from(condition: FlightCondition, other: FlightCondition) -> float:
    """The angle of attack of `other` [rad], in the body axes of `condition`.

    Where either is unknown, lift is taken to end at the same angle: while the flow stays subsonic, Mach stretches lift
    in proportion at every angle. Prandtl-Glauert: J. D. Anderson, Fundamentals of Aerodynamics, 6th ed., sec. 11.4.
    """
    if _alpha_known(condition) and _alpha_known(other):
        return other.reference.alpha
    k, of_other = condition.coefficients, other.coefficients
    return condition.reference.alpha - k.CL / k.CL_alpha + of_other.CL / of_other.CL_alpha


def _alpha_known(condition: FlightCondition) -> bool:
    return "trim_alpha" in condition.provenance


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
    engine = (
        "as the density, and as 1/V above half the condition's speed, as of a propeller at constant power"
        if _has_propeller(condition)
        else f"as the density to the power of {JET_LAPSE}, above 11 km in proportion, and not with speed, as of a jet"
    )
    thrust = f"Assumed: thrust changes {engine}. It acts along the flight path of the condition."
    if condition.spool:
        thrust += f" It follows the throttle with a lag of {_lag(condition):g} s."
    if condition.across:
        return [*_across_sentences(condition, plant.aero), thrust]
    aero: DerivativeAero = plant.aero
    return [
        f"{_lift(f'{aero.CL_max:.2f}')} The derivatives know no stall.",
        thrust,
        f"The drag polar is CD = {aero.CD_0:.4f} + {aero.K:.4f} CL^2, through the condition with its CD_alpha.",
        f"Derivatives hold at Mach {condition.reference.mach:g}: those with Mach act on the difference to it.",
    ]


def _lift(largest: str) -> str:
    return (
        f"Assumed: the lift coefficient of the wing ends at {largest}, rounded from 0.9 of that; beyond, drag grows as "
        "that of a flat plate."
    )


def _across_sentences(condition: FlightCondition, aero: Between | AcrossMach) -> list[str]:
    """What is said of a plant that is interpolated across Mach."""
    sets = conditions_of(aero)
    names = sorted((c.reference.mach, c.condition) for c in (condition, *condition.across))
    low, high = sets[0].mach_0, sets[-1].mach_0
    between = " and ".join(name for _, name in names)
    own = f"Mass ({condition.reference.m:,.0f} kg), inertias and engine are those of {condition.condition}."
    where = f"Derivatives are interpolated from Mach {low:.3g} to {high:.3g}, between {between}"
    said = [
        f"{where}; beyond, they are those of the nearest. {own}",
        f"{_lift(' and '.join(dict.fromkeys(f'{a.CL_max:.2f}' for a in sets)))} The derivatives know no stall.",
    ]
    for below, above in pairwise(sets):
        if below.mach_0 < 1.0 < above.mach_0:
            said.append(
                f"From Mach {below.mach_0:.3g} to {above.mach_0:.3g} the flow becomes supersonic, and straight lines "
                "know nothing of what happens on the way: drag there is far too low."
            )
        for a, line in zip((below, above), secants(below, above), strict=True):
            printed = mach_derivatives(a)
            pairs = [f"{n}_M {p:.3g} ({s:.3g})" for n, p, s in zip(line._fields, printed, line, strict=True)]
            said.append(
                f"At Mach {a.mach_0:.3g} the Mach derivatives are the printed ones, and in brackets what the straight "
                f"line from Mach {below.mach_0:.3g} to {above.mach_0:.3g} would have: {', '.join(pairs)}."
            )
    for other in condition.across:
        if not (_alpha_known(condition) and _alpha_known(other)):
            alpha = _alpha_seen_from(condition, other) / DEG
            said.append(
                f"Presumed: {other.condition} flies at {alpha:.2g} deg angle of attack in the axes of "
                f"{condition.condition}, for lift to end at the same angle at both; the source does not say it of both."
            )
    return said


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
