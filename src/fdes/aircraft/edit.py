"""Variable stability: an aircraft with some of its numbers changed is a new value, with the list of its changes.

A change is written ``Cm_alpha=-0.3``, ``Cn_r*=2`` or ``m+=500 kg``: everywhere, on the command line, in the cockpit
and in files. Changes are made one after the other, each to what the ones before have left, so that a list of them
always makes the same aircraft. Some numbers carry others with them, as the textbooks have it:

    cg                   the moments are taken about the new place (`_about_new_cg`)
    m, S, V, mach, h     lift must carry the weight again: CL, CD, CD_alpha and the trim alpha follow (`_carrying`)

Of an aircraft that is interpolated across Mach, a change of a derivative, of m, cg, S, b or c is made to each of its
conditions; inertias, thrust and flight condition are those of the chosen one.
"""

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal, cast

from fdes.aircraft.dimensional import DimensionalTable
from fdes.aircraft.flight_condition import FlightCondition, in_a_condition
from fdes.errors import NoSuchPart, SpecError
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Coefficients, Reference
from fdes.physics.signals import channels
from fdes.units import DEG, parse

Operator = Literal["=", "*=", "+="]

FIGURES = ("m", "cg", "Ix", "Iy", "Iz", "Ixz", "S", "b", "c", "V", "mach", "h", "alpha", "T_max")  # besides derivatives
POSITIVE = ("m", "Ix", "Iy", "Iz", "S", "b", "c", "V", "mach", "T_max")
UNBALANCING = ("m", "S", "V", "mach", "h")
OF_ALL_CONDITIONS = (*Coefficients._fields, "m", "cg", "S", "b", "c")  # across which an aircraft is interpolated
SUITS_DIMENSIONAL = ("T_max",)  # what does not enter into dimensional derivatives
MEANT = {"mass": "m", "weight": "m", "altitude": "h", "speed": "V", "trim_alpha": "alpha", "max_thrust": "T_max"}
LOWEST, HIGHEST = -500.0, 30000.0  # m
STEEPEST = 30.0 * DEG  # of the trim angle of attack
FORWARD, AFT = -1.0, 2.0  # of the center of gravity, in mean chords
UNITS = {c.name: c.unit for c in (*channels(Coefficients), *channels(Reference))} | {"cg": "1"}

_CHANGE = re.compile(r"\s*(\w+)\s*(\*=|\+=|=)\s*(\S.*?)\s*")


@dataclass(frozen=True)
class Change:
    """One number of an aircraft changed: set (`=`), multiplied (`*=`) or added to (`+=`); `amount` in `unit`, SI.

    As text it can be read again, to the same change.
    """

    name: str
    operator: Operator
    amount: float
    unit: str

    def __str__(self) -> str:
        unit = "" if self.operator == "*=" or self.unit in {"1", "1/rad"} else f" {self.unit}"
        return f"{self.name}{self.operator}{self.amount!r}{unit}"

    def of(self, value: float) -> float:
        """What becomes of `value`."""
        if self.operator == "=":
            return self.amount
        return value * self.amount + 0.0 if self.operator == "*=" else value + self.amount  # never -0.0


def edited(condition: FlightCondition, changes: Iterable[str | Change]) -> FlightCondition:
    """`condition` with `changes` made to it, in their order; a text is one change.

    Raises NoSuchPart for a number that the aircraft does not have, SpecError for a change that is not understood or
    that no aircraft can have, and for what is no flight condition.

    >>> from fdes.aircraft import load
    >>> slack = edited(load("A-4D").at(), ["Cm_q*=0.5", "cg+=0.02"])
    >>> round(slack.coefficients.Cm_alpha, 6)
    -0.311
    >>> [str(change) for change in slack.changes]
    ['Cm_q*=0.5', 'cg+=0.02']
    """
    condition = in_a_condition(condition)
    for change in [changes] if isinstance(changes, str) else changes:
        asked = read_change(condition, change) if isinstance(change, str) else change
        condition = _changed(condition, asked)
    return condition


def read_change(condition: FlightCondition, text: str) -> Change:
    """A change of `condition` from its text. Raises NoSuchPart and SpecError as `edited` does."""
    found = _CHANGE.fullmatch(text)
    if found is None:
        raise SpecError(f"The change {text!r} is not understood. Write it like Cm_alpha=-0.3, Cn_r*=2 or 'm+=500 kg'.")
    said, operator, amount = found.groups()
    name = MEANT.get(said.lower(), said)
    known = editable(condition)
    if name not in known:
        raise _unknown(condition, said, known)
    unit = unit_of(condition, name)
    if unit not in {"1", "1/rad"} and operator != "*=" and _is_number(amount):
        example = f"{name}{operator}{amount} {unit}"
        raise SpecError(f"The change {text!r} has no unit: {name} is in {unit}. Write it like {example!r}.")
    try:
        number = parse(amount, "1" if operator == "*=" else unit)
    except SpecError as trouble:
        raise SpecError(f"The change {text!r} cannot be read. {trouble}") from trouble
    return Change(name, cast("Operator", operator), number, unit)


def editable(condition: FlightCondition) -> tuple[str, ...]:
    """The names of all numbers of `condition` that can be changed: derivatives; mass, size and flight condition."""
    table = condition.aerodynamics
    if isinstance(table, DimensionalTable):
        return (*table.derivatives.numbers(), *SUITS_DIMENSIONAL)
    return (*Coefficients._fields, *FIGURES)


def value_of(condition: FlightCondition, name: str) -> float:
    """A number of `condition` in SI by its name; the center of gravity, where it is not known, from where it was."""
    table = condition.aerodynamics
    if name == "cg":
        shifted = sum(change.amount for change in condition.changes if change.name == name)
        return shifted if condition.cg is None else condition.cg
    if name in Reference._fields:
        return float(getattr(condition.reference, name))
    return table.value[name] if isinstance(table, DimensionalTable) else float(getattr(table, name))


def unit_of(condition: FlightCondition, name: str) -> str:
    """The SI unit of that number."""
    if name in UNITS and (condition.nondimensional or name in SUITS_DIMENSIONAL):
        return UNITS[name]
    return condition.provenance[name].si_unit


def _unknown(condition: FlightCondition, said: str, known: tuple[str, ...]) -> SpecError | NoSuchPart:
    if not condition.nondimensional and said in UNITS:
        return SpecError(
            f"{said} cannot be changed on {condition.aircraft_id}: its source gives dimensional derivatives, which "
            f"hold for its own mass and speed. Change one of them: {', '.join(known)}."
        )
    return NoSuchPart(f"number of the {condition.aircraft_id}", said, known, MEANT)


def _changed(before: FlightCondition, change: Change, *, flown: bool = True) -> FlightCondition:
    """One change made. flown: not only one of the conditions that what flies is interpolated with: it has an engine."""
    name = change.name
    if name not in editable(before):
        raise _unknown(before, name, editable(before))
    if name == "cg" and before.cg is None and change.operator != "+=":
        raise SpecError(
            f"The source of the {before.aircraft_id} does not say where its center of gravity is. Shift it instead, as "
            "in cg+=0.05 (mean chords, aft)."
        )
    value = change.of(value_of(before, name))
    _possible(name, value, change.unit)
    after = replace(_set(before, name, value), changes=(*before.changes, change))
    ref = after.reference
    if ref.Ix and ref.Ix * ref.Iz <= ref.Ixz**2:
        raise SpecError(
            f"{change} would make Ix, Iz and Ixz {ref.Ix:,.0f}, {ref.Iz:,.0f} and {ref.Ixz:,.0f} kg m^2; no body has "
            "such inertias. Ixz squared must be less than Ix times Iz."
        )
    if name in UNBALANCING:
        after = _carrying(before, after)
    if flown and name in (*UNBALANCING, "CD", "T_max") and after.nondimensional:
        after = _throttled(after, change)
    if before.across and name in OF_ALL_CONDITIONS:
        after = replace(after, across=tuple(_changed(other, change, flown=False) for other in before.across))
    return after


def _possible(name: str, value: float, unit: str) -> None:
    """Raises SpecError for a value that no aircraft can have."""
    said = f"{name} would be {value:.6g}" + ("" if unit == "1" else f" {unit}")
    if not math.isfinite(value):
        raise SpecError(f"{said}; it must be a finite number.")
    if name in POSITIVE and value <= 0.0:
        raise SpecError(f"{said}; it must be greater than zero.")
    low, high = {"h": (LOWEST, HIGHEST), "alpha": (-STEEPEST, STEEPEST), "cg": (FORWARD, AFT)}.get(
        name, (-math.inf, math.inf)
    )
    if not low <= value <= high:
        raise SpecError(f"{said}; it can be from {low:.6g} to {high:.6g}.")


def _set(before: FlightCondition, name: str, value: float) -> FlightCondition:
    """One number replaced, and what goes with it by definition."""
    table, ref = before.aerodynamics, before.reference
    match name:
        case "cg":
            return _about_new_cg(before, value)
        case "V":
            return replace(before, reference=ref._replace(V=value, mach=ref.mach * value / ref.V))
        case "mach":
            return replace(before, reference=ref._replace(mach=value, V=ref.V * value / ref.mach))
        case "h":
            air = standard_atmosphere(value)
            return replace(before, reference=ref._replace(h=value, rho=air.rho, mach=ref.V / air.a))
        case _ if name in Reference._fields:
            return replace(before, reference=ref._replace(**{name: value}))
    if isinstance(table, DimensionalTable):
        return replace(before, aerodynamics=replace(table, value={**table.value, name: value}))
    return replace(before, aerodynamics=table._replace(**{name: value}))


def _about_new_cg(before: FlightCondition, cg: float) -> FlightCondition:
    """All moments about a center of gravity that has moved aft by x mean chords, the forces staying where they are.

    The lift then acts x c ahead of it, and the air meets the old place at alpha - 2 x (q c / 2V) and at
    beta + 2 y (r b / 2V), with y = x c / b. The inertias stay. So force and velocity of a rigid body move from one
    point to another; the static part, Cm_alpha = CL_alpha (x_cg - x_np), is Nelson's section 2.3.
    """
    k, ref = before.coefficients, before.reference
    x = cg - value_of(before, "cg")
    y = x * ref.c / ref.b
    moved = k._replace(
        Cm_alpha=k.Cm_alpha + x * k.CL_alpha,
        Cm_alphadot=k.Cm_alphadot + x * k.CL_alphadot,
        Cm_M=k.Cm_M + x * k.CL_M,
        Cm_de=k.Cm_de + x * k.CL_de,
        CL_q=k.CL_q - 2.0 * x * k.CL_alpha,
        Cm_q=k.Cm_q + x * k.CL_q - 2.0 * x * (k.Cm_alpha + x * k.CL_alpha),
        Cn_beta=k.Cn_beta + y * k.Cy_beta,
        Cn_p=k.Cn_p + y * k.Cy_p,
        Cn_da=k.Cn_da + y * k.Cy_da,
        Cn_dr=k.Cn_dr + y * k.Cy_dr,
        Cy_r=k.Cy_r + 2.0 * y * k.Cy_beta,
        Cl_r=k.Cl_r + 2.0 * y * k.Cl_beta,
        Cn_r=k.Cn_r + y * k.Cy_r + 2.0 * y * (k.Cn_beta + y * k.Cy_beta),
    )
    return replace(before, aerodynamics=moved, cg=None if before.cg is None else cg)


def _carrying(before: FlightCondition, after: FlightCondition) -> FlightCondition:
    """Level flight again: CL carries the weight, and drag follows on a parabolic polar, CD = CD0 + K CL^2.

    A parabola's slope gives K = CD_alpha / (2 CL CL_alpha): Nelson, section 2.2. What the printed CL misses of the
    weight, it goes on missing in proportion.
    """
    k, old, new = after.coefficients, before.reference, after.reference
    more = (new.m / (new.rho * new.V**2 * new.S)) / (old.m / (old.rho * old.V**2 * old.S))
    if k.CL_alpha == 0.0:
        raise SpecError("With CL_alpha = 0 no angle of attack carries the weight: change CL_alpha first.")
    lift = k.CL * more
    drag = k.CD + k.CD_alpha * k.CL * (more * more - 1.0) / (2.0 * k.CL_alpha)
    return replace(
        after,
        aerodynamics=k._replace(CL=lift, CD=drag, CD_alpha=k.CD_alpha * more),
        reference=new._replace(alpha=new.alpha + (lift - k.CL) / k.CL_alpha),
    )


def _throttled(after: FlightCondition, change: Change) -> FlightCondition:
    """The throttle that holds level flight. Raises SpecError when there is none."""
    ref, CD = after.reference, after.coefficients.CD
    drag = CD * 0.5 * ref.rho * ref.V**2 * ref.S
    if not 0.0 <= drag <= ref.T_max:
        raise SpecError(
            f"After {change}, level flight needs {drag:,.0f} N of thrust (CD = {CD:.4g}); there is none below 0 N and "
            f"none above the assumed T_max of {ref.T_max:,.0f} N. Change T_max first, or change less."
        )
    return replace(after, trim_throttle=drag / ref.T_max)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
