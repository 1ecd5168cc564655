"""A linter for aircraft: what in its numbers cannot be, or hardly, and what that means in flight.

A rule looks at one flight condition and finds something or nothing. A finding that is known and documented is waived in
the file, with the reason, and is then a note of the flight condition, so that it is shown in flight:

    [[waivers]]
    rule      = "inertia_triangle"
    condition = "M0.25_SL" # left out: all conditions
    reason    = "the book prints Ix ten times too small, and no source has the right one"
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from fdes.aircraft.expectations import DIMENSIONAL, GOVERNING, RANGES, RATIOS, SIGNS, Range, Ratio, Sign
from fdes.units import DEG

if TYPE_CHECKING:
    from fdes.aircraft.flight_condition import FlightCondition, Provenance
    from fdes.aircraft.load import Aircraft

Severity = Literal["error", "warning"]

WEIGHT_TOLERANCE = 0.1  # of CL
THROTTLE = (0.05, 0.95)
FAR = 2.0  # times beyond its range is too far for a slightly unusual derivative: another unit is likelier
SHOWN = 4  # of the derivatives that are out by 57


@dataclass(frozen=True)
class Finding:
    """Something found in an aircraft: `what` with value and unit, its `meaning` in flight, and what to do.

    condition: its id; None for the whole file. waived: the reason that the file gives for leaving it so, or None.
    """

    rule: str
    condition: str | None
    variant: str
    severity: Severity
    what: str
    meaning: str
    advice: str
    waived: str | None


class Found(NamedTuple):
    """What a rule says: a finding that does not know yet where it is from."""

    severity: Severity
    what: str
    meaning: str
    advice: str


Rule = Callable[["FlightCondition"], Found | None]


def check(aircraft: "Aircraft") -> list[Finding]:
    """All that the rules find in the corrected numbers of an aircraft, condition by condition, waived or not.

    A waiver that waives nothing is a finding too, so that none outlives its reason.
    """
    found = [f for c in aircraft.conditions for f in findings(aircraft.at(c.id))]
    idle = [w for w in aircraft.document.get("waivers", ()) if not any(f.waived and _covers(w, f) for f in found)]
    return [*found, *(_idle(waiver) for waiver in idle)]


def findings(ready: "FlightCondition") -> list[Finding]:
    """What the rules find in one flight condition, waived or not."""
    found = []
    for rule, look in RULES.items():
        if rule in OF_COEFFICIENTS and not ready.nondimensional:
            continue
        if said := look(ready):
            bare = Finding(rule, ready.condition, ready.variant, *said, waived=None)
            reasons = [w["reason"] for w in ready.document.get("waivers", ()) if _covers(w, bare)]
            found.append(replace(bare, waived=reasons[0] if reasons else None))
    return found


def waived_notes(ready: "FlightCondition") -> list[str]:
    """What is waived in a flight condition, and why, in sentences for whoever flies it."""
    if not ready.document.get("waivers"):
        return []
    return [f"Waived: {f.what} {_sentence(f.waived)}" for f in findings(ready) if f.waived]


def _covers(waiver: Mapping[str, Any], finding: Finding) -> bool:
    return waiver["rule"] == finding.rule and waiver.get("condition") in {None, finding.condition}


def _idle(waiver: Mapping[str, Any]) -> Finding:
    return Finding(
        rule="idle_waiver",
        condition=waiver.get("condition"),
        variant="corrected",
        severity="warning",
        what=f"A waiver of {waiver['rule']} waives nothing: that rule finds nothing here.",
        meaning="Nothing in flight; but if the mistake comes back, it comes back unseen.",
        advice="Delete the waiver.",
        waived=None,
    )


def _sentence(text: str | None) -> str:
    text = text or ""
    return text[:1].upper() + text[1:].rstrip(".") + "."


def sign(expected: Sign, ready: "FlightCondition") -> Found | None:
    """A derivative has the sign of docs/symbols.md. Sources: at each line of SIGNS."""
    if ready.nondimensional:
        name, unit, positive = expected.derivative, "1/rad", expected.positive
        value = getattr(ready.coefficients, name)
    else:
        names, opposite = DIMENSIONAL[expected.derivative]
        name = next(n for n in names if n in ready.provenance)
        value, unit = ready.provenance[name].value, ready.provenance[name].si_unit
        positive = expected.positive != opposite
    if value > 0.0 if positive else value < 0.0:
        return None
    return Found(
        "error",
        f"{name} is {value:.4g} {unit}; it must be {'greater' if positive else 'less'} than 0.",
        expected.meaning,
        "Compare the source's sign and sense with docs/symbols.md; mend a misprint with corrected = ... and a reason.",
    )


def plausible(expected: Range, ready: "FlightCondition") -> Found | None:
    """A coefficient is of the size that aircraft have. Sources: at each line of RANGES."""
    name, low, high, below, above = expected
    value = getattr(ready.coefficients, name)
    wrong_sign = (low > 0.0 >= value) or (high < 0.0 <= value)
    if low <= value <= high or _other_unit(expected, ready) or (wrong_sign and name in _SIGNED):
        return None
    return Found(
        "warning",
        f"{name} is {value:.4g}{_unit(name)}; plausible is {low:g} to {high:g}.",
        below if value < low else above,
        "Look for a slipped decimal, a swapped line, or another reference area, length or rate (c/2V, b/2V).",
    )


def per_degree(ready: "FlightCondition") -> Found | None:
    """No derivative is 57 times too small, as one per degree taken for one per radian is; nor 57 times too large.

    Sources print both kinds: McCormick, Aerodynamics, Aeronautics, and Flight Mechanics, 2nd ed., ch. 3, per degree.
    """
    found = [(expected, hint) for expected in RANGES if (hint := _other_unit(expected, ready))]
    if not found:
        return None
    said = [f"{e.derivative} {getattr(ready.coefficients, e.derivative):.3g} 1/rad, {hint}" for e, hint in found]
    more = f"; and {len(said) - SHOWN} more" if len(said) > SHOWN else ""
    return Found(
        "error",
        f"Out by 57: {'; '.join(said[:SHOWN])}{more}.",
        "The aircraft answers 57 times too weakly, or too strongly: it is not the one of the source.",
        'Look whether the source has them per degree or per radian, and say unit = "1/deg" or "1/rad".',
    )


def inertia_triangle(ready: "FlightCondition") -> Found | None:
    """No moment of inertia is greater than the sum of the other two: each is a sum of squares of two coordinates.

    Goldstein, Classical Mechanics, 2nd ed., chapter 5.
    """
    ref = ready.reference
    moments = {"Ix": ref.Ix, "Iy": ref.Iy, "Iz": ref.Iz}
    (a, small), (b, middle), (c, great) = sorted(moments.items(), key=lambda m: m[1])
    if great <= small + middle:
        return None
    a, b = sorted((a, b))
    return Found(
        "error",
        f"{a} + {b} is {small + middle:,.0f} kg m^2, less than {c}, {great:,.0f} kg m^2; no body is so.",
        "It turns too easily about one axis or too hard about another: roll mode and Dutch roll are not its own.",
        "Compare the three with the source: look for a slipped decimal, swapped lines, or another loading.",
    )


def inertia_product(ready: "FlightCondition") -> Found | None:
    """Nor do the moments about the principal axes break that rule; then Ixz^2 < Ix Iz too. Goldstein, chapter 5."""
    ref = ready.reference
    if "Ix" not in ready.provenance:
        return None
    apart = math.hypot(ref.Iz - ref.Ix, 2.0 * ref.Ixz)  # the two principal moments in the plane of symmetry, subtracted
    if ref.Ixz**2 < ref.Ix * ref.Iz and (apart <= ref.Iy or inertia_triangle(ready)):
        return None
    most = math.sqrt(max(min(ref.Ix * ref.Iz, (ref.Iy**2 - (ref.Iz - ref.Ix) ** 2) / 4.0), 0.0))
    return Found(
        "error",
        f"Ixz is {ref.Ixz:,.0f} kg m^2; with these Ix, Iy, Iz no body has more than {most:,.0f}.",
        "Rolling drags the nose along more than any body's can: the Dutch roll is not its own.",
        "Compare Ixz with the source: its unit, its decimal, and whether it is the product or its double.",
    )


def weight_and_lift(ready: "FlightCondition") -> Found | None:
    """Level flight: CL = W/(qS), within 10 %. Nelson, appendix B, pairs some coefficients with another loading."""
    ref, CL = ready.reference, ready.coefficients.CL
    needed = ref.m * ref.g * math.cos(ref.gamma) / (0.5 * ref.rho * ref.V**2 * ref.S)
    if abs(needed - CL) <= WEIGHT_TOLERANCE * abs(CL):
        return None
    return Found(
        "error",
        f"W/(qS) is {needed:.3f}, but CL is {CL:.3f}.",
        f"The lift of the derivatives does not carry the weight: it flies too {'heavy' if needed > CL else 'light'}, "
        "and the phugoid and the load factors are another loading's.",
        "Check W, S, mach, altitude and their units; give the mass of these derivatives under consistent_mass.",
    )


def trim_throttle(ready: "FlightCondition") -> Found | None:
    """Level flight needs neither all nor nothing of the thrust: cruise leaves some to climb with. McCormick, ch. 7."""
    low, high = THROTTLE
    if low <= ready.trim_throttle <= high:
        return None
    little = ready.trim_throttle < low
    return Found(
        "warning",
        f"The throttle for level flight is {ready.trim_throttle:.3f} of max_thrust, {ready.reference.T_max:,.0f} N.",
        "A touch of throttle is a kick, and closing it hardly slows the aircraft."
        if little
        else "It can neither climb nor accelerate: the throttle is all but open in level flight.",
        f"Check CD and the units, or assume {'less' if little else 'more'} thrust.",
    )


def reference_axes(ready: "FlightCondition") -> Found | None:
    """The trim angle of attack turns the inertias from body to stability axes. McRuer, Ashkenas, Graham, eq. 4-87.

    Unknown, it matters even where Ixz = 0 in body axes, as long as Ix and Iz differ.
    """
    ref, given = ready.reference, ready.provenance.get("trim_alpha")
    if not ready.trim_alpha_uncertain:
        return None
    said = "not given" if given is None else f"{ref.alpha / DEG:.3g} deg with low confidence"
    per_deg = (ref.Ix - ref.Iz) * DEG  # d(Ixz)/d(alpha), leading term
    return Found(
        "warning",
        f"trim_alpha is {said}; each degree would add {per_deg:,.0f} kg m^2 to Ixz in stability axes.",
        "The Dutch roll may be better or worse damped than it is shown.",
        "Find the trim angle of attack of the condition; where the inertias are in stability axes already, give 0.",
    )


def low_confidence(ready: "FlightCondition") -> Found | None:
    """The derivatives that set the modes and the controls are not of low confidence. Nelson, sections 4.5 and 5.3."""
    governing = GOVERNING if ready.nondimensional else [n for names, _ in DIMENSIONAL.values() for n in names]
    low = [name for name in governing if name in ready.provenance and ready.provenance[name].confidence == "low"]
    if not low:
        return None
    return Found(
        "warning",
        f"Of low confidence: {', '.join(low)}.",
        "What it shows may be another aircraft's handling: no second source confirms the print.",
        "Find a second source for them, and name it under sources.",
    )


def unverified_correction(ready: "FlightCondition") -> Found | None:
    """Every number in use was found somewhere: a presumed correction is said to be one. The rule of this hangar."""
    presumed = [n for n, p in ready.provenance.items() if p.corrected is not None and p.unverified]
    if not presumed or ready.variant == "printed":
        return None
    used = [_instead(name, ready.provenance[name]) for name in presumed]
    return Found(
        "warning",
        f"Corrected, but in no source: {', '.join(used)}.",
        "Handling that rests on these numbers is a guess, if a better one than the printed numbers.",
        "Find a source for them, then delete unverified.",
    )


def ratio(expected: Ratio, ready: "FlightCondition") -> Found | None:
    """Moment and force of a surface belong to one lever arm. Nelson, chapter 2; extremes at each line of RATIOS."""
    k = ready.coefficients
    moment, by = getattr(k, expected.moment), getattr(k, expected.by)
    if by == 0.0 or expected.low <= -moment / by <= expected.high:
        return None
    if any(e.derivative in {expected.moment, expected.by} and sign(e, ready) for e in SIGNS):
        return None
    return Found(
        "warning",
        f"-{expected.moment}/{expected.by} is {-moment / by:.3g} {expected.unit}; "
        f"plausible is {expected.low:g} to {expected.high:g}.",
        expected.meaning,
        f"Look for a slipped decimal or a swapped line in {expected.moment} and {expected.by}.",
    )


def _instead(name: str, number: "Provenance") -> str:
    unit = "" if number.si_unit in {"1", "1/rad"} else f" {number.unit}"
    return f"{name} {number.corrected:,.10g} for {number.printed:,.10g}{unit}"


def _other_unit(expected: Range, ready: "FlightCondition") -> str | None:
    """As what, per degree or per radian, a derivative that is not plausible would be."""
    name, low, high = expected[:3]
    value = getattr(ready.coefficients, name)
    if _unit(name) == "" or low <= 0.0 <= high:
        return None
    near, far = sorted((abs(low), abs(high)))
    if abs(value) <= near / FAR and low <= value / DEG <= high:
        return "as if per degree"
    if abs(value) >= far * FAR and low <= value * DEG <= high:
        return "as if per radian called per degree"
    return None


def _unit(name: str) -> str:
    return "" if name in {"CL", "CD"} or name.endswith("_M") else " 1/rad"


_SIGNED = {expected.derivative for expected in SIGNS}

RULES: dict[str, Rule] = {
    **{f"sign_{expected.derivative}": partial(sign, expected) for expected in SIGNS},
    "per_degree": per_degree,
    **{f"range_{expected.derivative}": partial(plausible, expected) for expected in RANGES},
    **{expected.rule: partial(ratio, expected) for expected in RATIOS},
    "inertia_triangle": inertia_triangle,
    "inertia_product": inertia_product,
    "weight_and_lift": weight_and_lift,
    "trim_throttle": trim_throttle,
    "reference_axes": reference_axes,
    "low_confidence": low_confidence,
    "unverified_correction": unverified_correction,
}

# What is not asked of a condition that is known by dimensional derivatives.
OF_COEFFICIENTS = {"per_degree", "weight_and_lift", *(r for r in RULES if r.startswith("range_"))}
OF_COEFFICIENTS |= {expected.rule for expected in RATIOS}
