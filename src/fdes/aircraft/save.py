"""An aircraft written as a file: what flies, changed or not, with its printed values and where each number is from.

The file holds the one condition that flies. A number that was changed keeps what its source prints, and has the flown
value as `corrected`; the notes list the changes. Loaded again, it flies the same to the last bit: where no number in
the unit of the source is exactly the value that flies, it is written in SI, and a note says what was printed.
"""

import math
from collections.abc import Mapping
from copy import deepcopy
from typing import Any

from fdes.aircraft.dimensional import ControlCoefficients, DimensionalTable
from fdes.aircraft.flight_condition import AILERON, FlightCondition
from fdes.aircraft.load import parse
from fdes.aircraft.schema import Derivatives, Geometry, MassProperties
from fdes.errors import SpecError
from fdes.physics.atmosphere import standard_atmosphere
from fdes.units import G0, si_unit, to_si

NEIGHBORS = 4  # floats tried to either side
MARK = ", changed"  # after the name
FIGURE_OF = {"W": "m", "altitude": "h", "speed": "V", "density": "rho", "trim_alpha": "alpha", "gravity": "g"}
Content = dict[str, Any]


def saved(condition: FlightCondition) -> Content:
    """The content of a file that flies as `condition` does by its corrected values, plain enough for TOML.

    Raises SpecError where no file can say a value to the last bit, which happens with dimensional derivatives in feet,
    and for an aircraft between several conditions.
    """
    if condition.across:
        flown = ", ".join((condition.condition, *(c.condition for c in condition.across)))
        raise SpecError(
            f"What flies is interpolated across Mach between {flown}; a saved file holds one condition alone. Share "
            "the experiment instead, which keeps all of them."
        )
    content = deepcopy(dict(condition.document))
    own = next(c for c in content["conditions"] if c["id"] == condition.condition)
    content["conditions"] = [own]
    if waivers := [w for w in content.pop("waivers", ()) if w.get("condition") in {None, own["id"]}]:
        content["waivers"] = waivers
    _describe(content, own, condition)
    _write_mass(content, own, condition)
    _write_flight(own, condition)
    _write_derivatives(content, own, condition)
    _write_thrust(content, own, condition)
    return content


def as_toml(condition: FlightCondition) -> str:
    """The text of that file. Raises SpecError as `saved` does, AircraftFileError for what no file may say.

    In flight an aircraft may be tried that a file is refused with, such as one whose ailerons roll it the wrong way.

    >>> from fdes.aircraft import edited, load
    >>> from fdes.aircraft.load import aircraft_of
    >>> slack = edited(load("A-4D").at(), ["Cm_q*=0.5"])
    >>> aircraft_of(as_toml(slack), "the file").at().coefficients == slack.coefficients
    True
    """
    import tomli_w

    content = saved(condition)
    parse(content, "What was to be saved")
    return str(tomli_w.dumps(content))


def decimal(value: float, unit: str) -> float | None:
    """The number of `unit` that is `value` in SI to the last bit; None where there is none."""
    up = down = value / to_si(1.0, unit)
    for _ in range(NEIGHBORS):
        for tried in (up, down):
            if to_si(tried, unit) == value:
                return tried
        up, down = math.nextafter(up, math.inf), math.nextafter(down, -math.inf)
    return None


def _describe(content: Content, own: Content, condition: FlightCondition) -> None:
    if condition.spool:
        own["notes"] = [*own.get("notes", ()), "Flown with --spool, which no file can say: give it again."]
    if not condition.changes:
        return
    said = "; ".join(str(change) for change in condition.changes)
    content["name"] = f"{condition.aircraft_name.removesuffix(MARK)}{MARK}"
    content["id"] = f"{condition.aircraft_id.removesuffix('-changed')}-changed"
    content.pop("aliases", None)
    own["notes"] = [*own.get("notes", ()), f"Changed from {condition.aircraft_id}, in this order: {said}."]


def _why(condition: FlightCondition) -> str:
    return "changed in flight" if condition.changes else f"the {condition.variant} value is flown"


def _write_mass(content: Content, own: Content, condition: FlightCondition) -> None:
    """Mass and geometry. What the source leaves out stays out; a mass that belongs to the derivatives is the mass."""
    ref, mass = condition.reference, own.get("mass") or content["mass"]
    consistent = own.pop("consistent_mass", {})
    if consistent:
        own["notes"] = [*own.get("notes", ()), consistent["reason"]]
    for name in MassProperties.model_fields:
        if name == "source" or not (name in mass or name in consistent):
            continue
        value = condition.cg if name == "cg" else getattr(ref, FIGURE_OF.get(name, name))
        if value is not None:
            mass[name] = _number(mass.get(name, consistent.get(name)), value, _why(condition))
    for name in Geometry.model_fields:
        if name in content.get("geometry", {}) and name != "source":
            content["geometry"][name] = _number(content["geometry"][name], getattr(ref, name), _why(condition))


def _write_flight(own: Content, condition: FlightCondition) -> None:
    """Speed, altitude and trim. Those that the standard atmosphere gives need not be said."""
    ref = condition.reference
    before = parse(condition.document, "the unchanged aircraft").at(condition.condition, condition.variant).reference
    own["mach"] = ref.mach
    own["altitude"] = _number(own["altitude"], ref.h, _why(condition))
    air = standard_atmosphere(ref.h)
    said = (("speed", ref.mach * air.a), ("density", air.rho), ("trim_alpha", 0.0), ("gravity", G0))
    for name, unsaid in said:
        figure = FIGURE_OF[name]
        value = getattr(ref, figure)
        if name in own:
            own[name] = _number(own[name], value, _why(condition))
        elif value != unsaid:
            unit = {"speed": "m/s", "density": "kg/m^3", "trim_alpha": "rad", "gravity": "m/s^2"}[name]
            own[name] = _number({"printed": getattr(before, figure), "unit": unit}, value, _why(condition))


def _write_derivatives(content: Content, own: Content, condition: FlightCondition) -> None:
    reversed_aileron = content.get("aileron_sense") == "positive rolls left"
    sign = dict.fromkeys(AILERON, -1.0) if reversed_aileron else {}
    table, why = condition.aerodynamics, _why(condition)
    if not isinstance(table, DimensionalTable):
        block = own["derivatives"]
        for name in Derivatives.model_fields:
            value = getattr(table, name) * sign.get(name, 1.0)
            if name in block or value != 0.0:
                block[name] = _number(block.get(name, 0.0), value, why)
        return
    block = own["dimensional"]
    for name, value in table.value.items():
        place = block.get("controls", {}) if name in ControlCoefficients.model_fields else block
        if name in place:
            unit = condition.provenance[name].unit
            place[name] = _number(place[name], value * sign.get(name, 1.0), why, unit if place is block else None)


def _write_thrust(content: Content, own: Content, condition: FlightCondition) -> None:
    """Thrust; and of dimensional derivatives the drag, so that the throttle of level flight is the same."""
    wanted, ref = condition.trim_throttle, condition.reference
    thrust = condition.assumed["max_thrust"]
    if to_si(thrust["value"], thrust["unit"]) == ref.T_max:
        return
    assumed = own.setdefault("assumed", {})
    assumed["max_thrust"] = {"value": ref.T_max, "unit": "N", "reason": _why(condition)}
    if condition.nondimensional:
        return
    drag = wanted * ref.T_max
    found = [d for d in (drag, math.nextafter(drag, math.inf), math.nextafter(drag, 0.0)) if d / ref.T_max == wanted]
    if not found:
        raise SpecError(f"No drag gives the trim throttle {wanted!r} to the last bit. Change T_max a little.")
    assumed["drag"] = {"value": found[0], "unit": "N", "reason": _why(condition)}


def _number(given: Any, value: float, why: str, table_unit: str | None = None) -> Any:
    """The number of a file, `given`, made to say `value` [SI]. table_unit: of a table that gives the unit once."""
    said = dict(given) if isinstance(given, Mapping) else {"printed": given}
    unit = table_unit or said.get("unit") or "1"
    if to_si(float(said.get("corrected", said["printed"])), unit) == value:
        return given
    said.pop("unverified", None)
    exact = decimal(value, unit)
    if exact is None:
        if table_unit:
            raise SpecError(f"No number in {unit} is {value!r} {si_unit(unit)} to the last bit. Change it a little.")
        said["note"] = f"{said['note']}; " if "note" in said else ""
        said["note"] += f"the source prints {said['printed']} {unit}"
        said |= {"printed": to_si(float(said["printed"]), unit), "unit": si_unit(unit)}
        exact = value
    return said | {"corrected": exact, "reason": why}
