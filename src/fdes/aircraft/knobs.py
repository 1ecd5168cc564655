"""What can be changed of an aircraft, for whoever draws sliders: each number with its meaning and a sensible range."""

from dataclasses import dataclass

from fdes.aircraft.edit import FIGURES, editable, unit_of, value_of
from fdes.aircraft.expectations import RANGES
from fdes.aircraft.flight_condition import FlightCondition
from fdes.aircraft.number import Confidence
from fdes.units import DEG

FORCES = {
    "CL": "lift",
    "CD": "drag",
    "Cm": "pitching moment",
    "Cy": "side force",
    "Cl": "rolling moment",
    "Cn": "yawing moment",
}
CAUSES = {
    "alpha": "angle of attack",
    "alphadot": "rate of change of angle of attack",
    "q": "pitch rate",
    "M": "Mach number",
    "de": "elevator",
    "beta": "sideslip",
    "p": "roll rate",
    "r": "yaw rate",
    "da": "aileron",
    "dr": "rudder",
}
CALLED = {
    "Cm_alpha": "pitch stiffness",
    "Cm_q": "pitch damping",
    "Cm_de": "elevator power",
    "Cl_beta": "dihedral effect",
    "Cl_p": "roll damping",
    "Cl_da": "aileron power",
    "Cn_beta": "weathercock stability",
    "Cn_r": "yaw damping",
    "Cn_da": "adverse yaw of the aileron",
    "Cn_dr": "rudder power",
}
FIGURE_WORDS = {
    "m": "mass",
    "cg": "center of gravity, in mean chords from the leading edge",
    "Ix": "moment of inertia in roll, body axes",
    "Iy": "moment of inertia in pitch",
    "Iz": "moment of inertia in yaw, body axes",
    "Ixz": "product of inertia, body axes",
    "S": "wing area",
    "b": "wing span",
    "c": "mean chord",
    "V": "true airspeed",
    "mach": "Mach number",
    "h": "altitude of the flight condition",
    "alpha": "trim angle of attack",
    "T_max": "greatest thrust, assumed",
}
LATERAL = ("Cy", "Cl", "Cn", "Y", "L_", "N_")
SPAN = 2.0  # of a slider, to either side, as multiples of the value itself
AROUND = {"cg": 0.3, "alpha": 10.0 * DEG}  # to either side, for what is not measured from a natural zero
IN_FILES = {"m": "W", "V": "speed", "h": "altitude", "alpha": "trim_alpha"}
FACTORS = (0.5, 2.0)  # for what must be positive
HIGHEST = 15000.0  # m: where sliders end


@dataclass(frozen=True)
class Knob:
    """One number that can be changed. `value` is the unchanged aircraft's, in `unit`; so are `low` and `high`.

    group: ``longitudinal``, ``lateral`` or ``mass, size and condition``. printed: as in the source, in its unit and
    with its sign; None where the source has no such number. confidence: that it prints just this.
    assumed: whether no source gives it. tabulated: whether `printed` is the slope of the aircraft's own tables instead.
    """

    name: str
    group: str
    meaning: str
    unit: str
    value: float
    low: float
    high: float
    printed: str | None
    confidence: Confidence | None
    assumed: bool
    tabulated: bool


def knobs(condition: FlightCondition) -> list[Knob]:
    """All that can be changed of `condition`, which is as its file has it, in the order in which it is shown."""
    return [_knob(condition, name) for name in editable(condition)]


def _knob(condition: FlightCondition, name: str) -> Knob:
    value = value_of(condition, name)
    low, high = _range(name, value)
    given = condition.provenance.get(IN_FILES.get(name, name))
    printed = None if given is None else f"{given.printed:g} {given.unit}".removesuffix(" 1").removesuffix(" 1/rad")
    return Knob(
        name=name,
        group=_group(name),
        meaning=meaning(name),
        unit=unit_of(condition, name),
        value=value,
        low=low,
        high=high,
        printed=printed,
        confidence=None if given is None else given.confidence,
        assumed=name == "T_max",
        tabulated=condition.tables is not None and name not in FIGURES,
    )


def meaning(name: str) -> str:
    """What a number is, in words: ``meaning("Cm_q") == "pitch damping: pitching moment by pitch rate"``."""
    if name in FIGURE_WORDS:
        return FIGURE_WORDS[name]
    force, _, cause = name.partition("_")
    if force not in FORCES:
        return "dimensional derivative"
    words = f"{FORCES[force]} by {CAUSES[cause]}" if cause else f"{FORCES[force]} coefficient in level flight"
    return f"{CALLED[name]}: {words}" if name in CALLED else words


def _group(name: str) -> str:
    if name in FIGURES:
        return "mass, size and condition"
    return "lateral" if name.startswith(LATERAL) else "longitudinal"


def _range(name: str, value: float) -> tuple[float, float]:
    if name == "h":
        return 0.0, max(HIGHEST, value)
    if name in AROUND:
        return value - AROUND[name], value + AROUND[name]
    if name in FIGURES and name != "Ixz":
        return FACTORS[0] * value, FACTORS[1] * value
    if value == 0.0:
        typical = max((max(abs(r.low), abs(r.high)) for r in RANGES if r.derivative == name), default=1.0)
        return -0.25 * typical, 0.25 * typical
    return value - SPAN * abs(value), value + SPAN * abs(value)
