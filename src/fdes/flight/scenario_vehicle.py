"""The vehicle of a scenario: an aircraft of the hangar or of a file, in trim or as it is told, under a control law.

docs/reference/scenarios.md has the format.
"""

from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, field, fields, replace
from math import hypot
from typing import Any

from fdes.aircraft import load
from fdes.control import Law
from fdes.control.f16_autopilot import F16Autopilot
from fdes.control.laws.direct import Direct
from fdes.control.spoken import Loop, loops, units_of
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.excitation import Excitation
from fdes.flight.nonlinear import six_dof_of
from fdes.flight.scenario_text import REQUIRED, Known, only_known, quantities, table_of
from fdes.flight.simulation import Edit
from fdes.flight.trim_over_earth import Over, trim_over
from fdes.physics.earth import Earth
from fdes.physics.plant import SixDof
from fdes.physics.propulsion import Thrust
from fdes.physics.signals import Air, Outputs, Surfaces
from fdes.physics.turbofan import Turbofan, turbofan_thrust

VEHICLE = {"aircraft", "condition", "variant", "rotor", "power"}
POWERS = ("lag", "lever")
TRIM = "trim"
HELD: Known = {"elevator": ("rad", 0.0), "aileron": ("rad", 0.0), "rudder": ("rad", 0.0), "throttle": ("1", 0.0)}
AUTOPILOT = "f16_autopilot"
GOALS: Known = {"altitude": ("m", REQUIRED), "course": ("rad", REQUIRED), "airspeed": ("m/s", REQUIRED)}
DESIGN: Known = {"alpha": ("rad", REQUIRED), "theta": ("rad", REQUIRED)}
AT: Known = {"at": ("s", REQUIRED)}
SLACK = 1e-9  # s: frame times are sums of fractions


@dataclass(frozen=True)
class Flown:
    """How a scenario is flown: by which law, with the throttle lever where, with which test inputs, and which other law
    from which time [s] on. every: how many frames a row of the recording stands for.
    """

    law: Law = field(default_factory=lambda: Direct(Surfaces()))
    throttle: float = 0.0
    excitation: Excitation = field(default_factory=lambda: Excitation(()))
    later: tuple[tuple[float, Law], ...] = ()
    every: int = 1

    def edits(self) -> "Edits":
        """What changes in flight, once each."""
        return Edits(iter(self.later))


HANDS_OFF = Flown()


class Edits:
    """Laws that take over, each with the first frame that begins at its time."""

    def __init__(self, later: Iterator[tuple[float, Law]]) -> None:
        self._later = later
        self._next = next(later, None)

    def __call__(self, t: float) -> Edit | None:
        """What changes at `t` [s]."""
        law = None
        while self._next is not None and t >= self._next[0] - SLACK:
            law, self._next = self._next[1], next(self._later, None)
        return None if law is None else Edit(law=law, note={"law": str(law)})


def is_trimmed(initial: Mapping[str, Any]) -> bool:
    """Whether the vehicle is to be trimmed at the start: its pitch attitude is then found."""
    return initial.get("theta") == TRIM


def airframe(document: Mapping[str, Any], integrator: str) -> SixDof:
    """The aircraft itself, not yet anywhere. Raises SpecError, NoSuchPart."""
    said = table_of(document, "vehicle")
    only_known(said, VEHICLE, "vehicle.")
    if "aircraft" not in said:
        raise SpecError('vehicle.aircraft is missing: name one, such as "F-16", or a file.')
    ready = load(str(said["aircraft"])).at(_text(said, "condition"), str(said.get("variant", "corrected")))
    plant = six_dof_of(ready, integrator)
    if not _switch(said, "rotor"):
        plant = plant._replace(inertia=plant.inertia._replace(Hx=0.0))
    power = str(said.get("power", POWERS[0]))
    if power not in POWERS:
        raise NoSuchPart("kind of vehicle.power", power, POWERS)
    if power == "lever":
        if not isinstance(plant.engine, Turbofan):
            raise SpecError(
                f"The thrust of the {ready.aircraft_id} follows its lever already: leave vehicle.power out."
            )
        plant = plant._replace(propulsion=_lever_is_power, settled=_lever_as_power)
    return plant


def in_trim(plant: SixDof, earth: Earth, over: Over) -> SixDof:
    """The plant in straight flight, wings level. Raises SpecError, TrimError."""
    if earth.g:
        raise SpecError('initial.theta = "trim" is for a round Earth: let earth be "round" or "wgs84".')
    if not hypot(over.north, over.east):
        raise SpecError("initial.v_north and v_east are zero: a vehicle in trim must go somewhere.")
    return trim_over(plant, earth, over)


def held_at_start(plant: SixDof, initial: Mapping[str, Any]) -> SixDof:
    """The plant with the surfaces and the throttle that the file says, which its face then calls zero."""
    return plant._replace(rest=Surfaces(*quantities(initial, HELD, "initial.").values()))


def flown_with(document: Mapping[str, Any], plant: SixDof, every: int) -> Flown:
    """Law, inputs and commands. Raises SpecError, NoSuchPart."""
    y = plant.observe(plant.start(), plant.trim(), Air())
    law = _law(document.get("law"), plant, y)
    inputs = document.get("inputs", [])
    if not isinstance(inputs, list) or not all(isinstance(text, str) for text in inputs):
        raise SpecError('inputs is no list of texts. Write it like inputs = ["doublet elevator 2deg at 1s for 2s"].')
    commands = document.get("commands", [])
    if not isinstance(commands, list) or not all(isinstance(each, dict) for each in commands):
        raise SpecError("commands are tables, each under [[commands]] with its time: at.")
    later, goals = [], law
    for each in sorted(commands, key=lambda c: quantities(c, AT, "commands.")["at"]):
        if not isinstance(goals, F16Autopilot):
            raise SpecError(f"commands are for a law that takes some: let [law] have name = {AUTOPILOT!r}.")
        only_known(each, {**AT, **GOALS}, "commands.")
        known = {name: how for name, how in GOALS.items() if name in each}
        goals = replace(goals, **quantities(each, known, "commands."))
        later.append((quantities(each, AT, "commands.")["at"], goals))
    return Flown(law, plant.rest.throttle, Excitation.parse(inputs), tuple(later), every)


def _law(said: Any, plant: SixDof, y: Outputs) -> Law:
    """A law as one says it, with its gains; or the F-16's autopilot, about the flight at the start."""
    if said is None:
        return Direct(Surfaces())
    if isinstance(said, str):
        law: Law = Direct(Surfaces())
        for loop in loops(said):
            law = _around(law, loop, said)
        return law
    if not isinstance(said, dict) or said.get("name") != AUTOPILOT:
        raise SpecError(
            f"law is {said!r}; it must be a text such as 'yaw_damper gain=0.5', or have name = {AUTOPILOT!r}."
        )
    only_known(said, {"name"} | GOALS.keys() | DESIGN.keys(), "law.")
    if not isinstance(plant.engine, Turbofan):
        raise SpecError("The gains of f16_autopilot are those of the F-16: fly that, or another law.")
    here = {"altitude": y.h, "course": y.chi, "airspeed": y.eas, "alpha": y.alpha, "theta": y.theta}
    known = {name: (unit, here[name]) for name, (unit, _) in {**GOALS, **DESIGN}.items()}
    return F16Autopilot(**quantities(said, known, "law."), elevator=plant.rest.elevator, throttle=plant.rest.throttle)


def _around(inner: Law, loop: Loop, said: str) -> Law:
    """The law of one loop around another, all of its settings said. Raises SpecError."""
    needed = [f.name for f in fields(loop.part) if f.default is MISSING and f.name in units_of(loop.part)]
    unsaid = [name for name in needed if name not in loop.settings]
    if loop.wishes or unsaid:
        missing = unsaid[0] if unsaid else next(iter(loop.wishes))
        why = "is not said" if unsaid else "is a wish"
        raise SpecError(
            f"law {said!r}: {missing} of {loop.name} {why}, and in a scenario nothing is designed. Say its gains."
        )
    taken = {"inner": inner} if "inner" in (f.name for f in fields(loop.part)) else {"full_stick": Surfaces()}
    law: Law = loop.part(**taken, **loop.settings)
    return law


def _text(said: Mapping[str, Any], name: str) -> str | None:
    value = said.get(name)
    if value is not None and not isinstance(value, str):
        raise SpecError(f"vehicle.{name} is {value!r}; it must be a text, in quotes.")
    return value


def _switch(said: Mapping[str, Any], name: str) -> bool:
    value = said.get(name, True)
    if not isinstance(value, bool):
        raise SpecError(f"vehicle.{name} is {value!r}; it must be true or false.")
    return value


def _lever_as_power(engine: Turbofan, throttle: float) -> float:
    """The power that the lever itself is, 0 to 1 being 0 to 100 %."""
    return 100.0 * throttle


def _lever_is_power(engine: Turbofan, flow: Any, h: float, throttle: float, power: float) -> Thrust:
    """Thrust at the power that the lever shows, at once."""
    return turbofan_thrust(engine, flow.mach, h, _lever_as_power(engine, throttle))
