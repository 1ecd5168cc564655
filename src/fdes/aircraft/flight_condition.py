"""An aircraft in one flight condition: the numbers a plant is made of, in SI, and where each is from."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, get_args

from fdes.aircraft.check import waived_notes
from fdes.aircraft.dimensional import DimensionalDerivatives, DimensionalTable
from fdes.aircraft.number import Confidence, Number, Part, Variant
from fdes.aircraft.schema import AircraftFile, Assumed, Condition
from fdes.aircraft.terms import Terms
from fdes.aircraft.turbofan import TurbofanTables
from fdes.errors import AircraftFileError, NoSuchPart, SpecError
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Coefficients, Form, Matrices, Reference, dimensional, matrices
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.units import DEG, G0, si_unit

if TYPE_CHECKING:
    from fdes.aircraft.edit import Change

FORMS: tuple[Form, ...] = get_args(Form)
AILERON = ("Cy_da", "Cl_da", "Cn_da", "Ystar_da", "L_da", "N_da")
LOPSIDED = ("Ixy", "Iyz")  # products of inertia that a symmetric aircraft does not have
MAYBE_UNKNOWN = ("S", "b", "c", "Ix", "Iy", "Iz", "Ixz")  # where the derivatives are dimensional


@dataclass(frozen=True)
class Provenance:
    """Where one number is from.

    value: what is used, in `si_unit`, with the signs of docs/symbols.md.
    printed, corrected: as the file has them, in `unit`; `corrected` is None where the print stands.
    confidence: that the source prints just this; None where the file does not say.
    sources: keys of `Aircraft.sources`: works in which the same number was found.
    reason, unverified: why it is corrected, and whether that is only presumed.
    """

    value: float
    si_unit: str
    printed: float
    corrected: float | None
    unit: str
    confidence: Confidence | None
    sources: tuple[str, ...]
    reason: str | None
    unverified: bool
    note: str | None


@dataclass(frozen=True)
class FlightCondition:
    """An aircraft in a flight condition, ready to become a plant. SI and radians.

    aerodynamics: nondimensional derivatives; or the table of dimensional ones, where the source gives those.
    reference: geometry and inertias that the source does not give, and the equations do not need, are 0.
    full_stick: surfaces, from trim, at full aft stick, full right stick, full right pedal and full throttle.
    trim_throttle: the share of `reference.T_max` that equals the drag.
    cg: fraction of the mean chord; None where the file does not say.
    notes: sentences that whoever uses the numbers should know.
    assumed: what no source gives: ``{"value", "unit", "reason"}`` by name, in the unit it was chosen in.
    provenance: where each number of the file is from, by its name there.
    document: the whole content of the file.
    tables: the aerodynamics that the nonlinear plant has instead of derivatives, and `turbofan` its engine; None where
        the file has none.
    configuration: of flaps and gear, by the file's word for it; None where that does not say.
    across: other conditions, which the nonlinear plant is interpolated with in Mach (`fdes.aircraft.across`).
    spool: the nonlinear plant's engine follows the throttle with the lag that is assumed.
    changes: what was changed since (`fdes.aircraft.edit`); provenance and document are those of the unchanged aircraft.
    """

    aircraft_id: str
    aircraft_name: str
    condition: str
    variant: Variant
    aerodynamics: Coefficients | DimensionalTable
    reference: Reference
    limits: Limits
    full_stick: Surfaces
    trim_throttle: float
    cg: float | None
    notes: tuple[str, ...] = field(repr=False)
    assumed: Mapping[str, Mapping[str, Any]] = field(repr=False)
    provenance: Mapping[str, Provenance] = field(repr=False)
    document: Mapping[str, Any] = field(repr=False)
    tables: Terms | None = field(default=None, repr=False)
    turbofan: TurbofanTables | None = field(default=None, repr=False)
    configuration: str | None = None
    across: "tuple[FlightCondition, ...]" = field(default=(), repr=False)
    spool: bool = False
    changes: "tuple[Change, ...]" = ()

    @property
    def nondimensional(self) -> bool:
        """Whether there are nondimensional derivatives."""
        return isinstance(self.aerodynamics, Coefficients)

    @property
    def coefficients(self) -> Coefficients:
        """The nondimensional derivatives. Raises SpecError where the source gives dimensional ones instead."""
        if isinstance(self.aerodynamics, Coefficients):
            return self.aerodynamics
        raise SpecError(
            f"{self.aircraft_id} {self.condition} has no nondimensional derivatives: its source gives dimensional "
            "ones. What is made of coefficients does not apply to it; its modes and its A and B are those of form "
            "'full'."
        )

    def equations(self, form: Form) -> Matrices:
        """A and B in that form. Raises NoSuchPart for a form that there is not, and SpecError for another than `full`
        where dimensional derivatives are given.
        """
        if form not in FORMS:
            raise NoSuchPart("form of the linear equations", form, FORMS)
        if isinstance(self.aerodynamics, Coefficients):
            return matrices(dimensional(self.aerodynamics, self.reference, form), self.reference, form)
        if form != "full":
            raise SpecError(
                f"Form {form!r} does not apply to {self.aircraft_id} {self.condition}: it is made of nondimensional "
                "derivatives, and this source gives dimensional ones. Use form 'full'."
            )
        return self.aerodynamics.matrices(self.reference)

    @property
    def trim_alpha_uncertain(self) -> bool:
        """Whether the trim angle of attack, by which the inertias are turned, is unknown or of low confidence."""
        given = self.provenance.get("trim_alpha")
        return self.nondimensional and (given is None or given.confidence == "low")


def in_a_condition(of: object) -> FlightCondition:
    """`of`, if it is an aircraft in a flight condition. Raises SpecError, which says how to get one."""
    if isinstance(of, FlightCondition):
        return of
    known = [condition.id for condition in getattr(of, "conditions", ())]  # those of an Aircraft
    if known:
        raise SpecError(
            f"This aircraft is in no flight condition yet. It has {', '.join(known)}: take one with .at({known[0]!r}), "
            "or the first with .at()."
        )
    said = f"the text {of!r}" if isinstance(of, str) else f"of type {type(of).__name__}"
    raise SpecError(
        f"An aircraft in a flight condition is needed, and this is {said}. Load one: fdes.load('A-4D').at('M0.4_SL')."
    )


def flight_condition(
    file: AircraftFile, condition: Condition, variant: Variant, document: Mapping[str, Any]
) -> FlightCondition:
    """Make one condition of a file ready.

    Raises AircraftFileError where its numbers do not go together, SpecError for a height without a standard atmosphere.
    """
    numbers = _numbers(file, condition, variant)
    reverse = file.aileron_sense == "positive rolls left"
    sign = dict.fromkeys(AILERON, -1.0) if reverse else {}
    provenance = {name: _provenance(number, variant, sign.get(name, 1.0)) for name, number in numbers.items()}
    value = {name: p.value for name, p in provenance.items()}
    assumed = {name: a for name in Assumed.model_fields if (a := file.assumption(name, condition))}
    si = {name: a.si() for name, a in assumed.items()}

    reference = _reference(value, condition.mach, si["max_thrust"])
    limits = Limits(
        lower=Surfaces(-si["elevator_up_limit"], -si["aileron_limit"], -si["rudder_limit"], 0.0),
        upper=Surfaces(si["elevator_down_limit"], si["aileron_limit"], si["rudder_limit"], 1.0),
    )
    full_stick = Surfaces(-si["full_stick_elevator"], si["full_stick_aileron"], -si["full_pedal_rudder"], throttle=1.0)
    if condition.dimensional:
        drag = si["drag"]
        table = DimensionalTable(condition.dimensional, value)
        table.matrices(reference)  # complains now, if it must
        aerodynamics: Coefficients | DimensionalTable = table
    else:
        drag = value["CD"] * 0.5 * reference.rho * reference.V**2 * reference.S
        aerodynamics = Coefficients(**{name: value.get(name, 0.0) for name in Coefficients._fields})
    ready = FlightCondition(
        aircraft_id=file.id,
        aircraft_name=file.name,
        condition=condition.id,
        variant=variant,
        aerodynamics=aerodynamics,
        reference=reference,
        limits=limits,
        full_stick=full_stick,
        trim_throttle=drag / reference.T_max,
        cg=value.get("cg"),
        notes=(*file.notes, *condition.notes, *_notes(condition, variant, provenance, reverse=reverse)),
        assumed={name: a.model_dump() for name, a in assumed.items()},
        provenance=provenance,
        document=document,
        tables=file.terms,
        turbofan=file.turbofan,
        configuration=condition.configuration.name if condition.configuration else None,
    )
    _check(ready, drag)
    return replace(ready, notes=(*ready.notes, *waived_notes(ready)))


def _numbers(file: AircraftFile, condition: Condition, variant: Variant) -> dict[str, Number]:
    """All numbers that are given for the condition, by name; the mass is that which belongs to it."""
    table = condition.table
    derivatives = table.numbers() if isinstance(table, DimensionalDerivatives) else _given(table)
    found = _given(file.geometry) | _given(condition.mass or file.mass) | _given(condition) | derivatives
    consistent = condition.consistent_mass
    if consistent and variant == "corrected":
        more = consistent.model_dump(include={"reason", "confidence", "unverified", "sources"})
        for name, number in _given(consistent).items():
            printed = found.get(name, number)
            found[name] = printed.model_copy(update={"corrected": number.printed, "note": number.note, **more})
    return found


def _given(part: Part | None) -> dict[str, Number]:
    return {name: number for name, number in part or () if isinstance(number, Number)}


def _provenance(number: Number, variant: Variant, sign: float) -> Provenance:
    unit = number.unit or "1"
    said = number.model_dump(exclude={"unit"})
    return Provenance(value=number.si(variant) * sign, si_unit=si_unit(unit), unit=unit, **said)


def _reference(value: Mapping[str, float], mach: float, T_max: float) -> Reference:
    h = value["altitude"]
    air = standard_atmosphere(h)
    return Reference(
        V=value.get("speed", mach * air.a),
        rho=value.get("density", air.rho),
        mach=mach,
        g=value.get("gravity", G0),
        h=h,
        alpha=value.get("trim_alpha", 0.0),
        gamma=0.0,
        m=value["W"],
        **{name: value.get(name, 0.0) for name in MAYBE_UNKNOWN},
        T_max=T_max,
    )


def _notes(condition: Condition, variant: Variant, provenance: Mapping[str, Provenance], *, reverse: bool) -> list[str]:
    """What follows from how the file is filled in."""
    notes = []
    absent = [name for name in Coefficients._fields if condition.derivatives and name not in provenance]
    presumed = [name for name, p in provenance.items() if p.corrected is not None and p.unverified]
    lopsided = [name for name in LOPSIDED if name in provenance]
    if lopsided:
        notes.append(f"{' and '.join(lopsided)}: given, and left out of the linear equations, which are symmetric.")
    if condition.consistent_mass:
        used = "the one that belongs to them" if variant == "corrected" else "the printed one all the same"
        notes.append(f"{condition.consistent_mass.reason} The mass used is {used}.")
    if presumed and variant == "corrected":
        notes.append(f"Presumed corrections, found in no source: {', '.join(presumed)}.")
    if condition.dimensional:
        axes = f"{condition.dimensional.axes} axes"
        notes.append(f"The source gives dimensional derivatives in {axes}: the linear plant is made of them.")
        unknown = [name for name in MAYBE_UNKNOWN if name not in provenance]
        if unknown:
            notes.append(f"Not given, and not needed: {', '.join(unknown)}.")
        if condition.trim_alpha is None:
            notes.append("The trim angle of attack is not given: alpha and theta are shown as if it were zero.")
    elif condition.trim_alpha is None:
        notes.append("The trim angle of attack is not known: it is taken as zero, the inertias as in stability axes.")
    if reverse:
        notes.append("In the source, positive aileron rolls left: aileron derivatives are used with the opposite sign.")
    if absent:
        notes.append(f"Not tabulated, taken as zero: {', '.join(absent)}.")
    return notes


def _check(ready: FlightCondition, drag: float) -> None:
    """What no single number shows."""
    ref = ready.reference
    if "Ix" in ready.provenance and ref.Ix * ref.Iz <= ref.Ixz**2:
        raise AircraftFileError(
            f"Ix, Iz and Ixz are {ref.Ix:,.0f}, {ref.Iz:,.0f} and {ref.Ixz:,.0f} kg m^2; no body has such "
            "inertias. Ixz squared must be less than Ix times Iz."
        )
    _possible_inertia(ready)
    name = "L_da" if "L_da" in ready.provenance else "Cl_da"
    rolling = ready.provenance[name]
    if rolling.value <= 0.0:
        raise AircraftFileError(
            f"{name} is {rolling.value:g} {rolling.si_unit} by the file's aileron_sense, but positive aileron "
            f'must roll right. Where the source prints {name} < 0, say aileron_sense = "positive rolls left".'
        )
    if not 0.0 <= ready.trim_throttle <= 1.0:
        raise AircraftFileError(
            f"level flight needs {drag:,.0f} N of thrust, but max_thrust is {ref.T_max:,.0f} N. "
            "Check the drag, the altitude and the units, or assume more thrust."
        )
    for name, held, low, high in zip(
        Surfaces._fields, ready.full_stick, ready.limits.lower, ready.limits.upper, strict=True
    ):
        if not low <= held <= high:
            raise AircraftFileError(
                f"full stick moves the {name} to {held / DEG:g} deg, beyond its limits of {low / DEG:g} and "
                f"{high / DEG:g} deg. Assume less stick or more travel."
            )


def _possible_inertia(ready: FlightCondition) -> None:
    """A full inertia tensor is positive definite, as that of any body: H. Goldstein, Classical Mechanics, chapter 5."""
    given = [name for name in LOPSIDED if name in ready.provenance]
    if not given:
        return
    ref = ready.reference
    Ixy, Iyz = (ready.provenance[name].value if name in given else 0.0 for name in LOPSIDED)
    minor = ref.Ix * ref.Iy - Ixy**2
    whole = ref.Iz * minor - ref.Ix * Iyz**2 - 2.0 * Ixy * Iyz * ref.Ixz - ref.Iy * ref.Ixz**2
    if minor <= 0.0 or whole <= 0.0:
        raise AircraftFileError(
            f"with Ixy = {Ixy:,.0f} and Iyz = {Iyz:,.0f} kg m^2, the inertias are those of no body. "
            "Compare them with the source: their unit, and whether it prints the product or its double."
        )
