"""What must hold of every control law, tried on one: pure, finite, the same after a reset, as linear as it says.

The law is put round the bare A-4D, gains that have no default but zero at 0.3. Its linear model is compared with the
Jacobian of a step by differences: exact for what is linear, so that a law is to be tried away from its limits.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, dataclass, fields
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import FlightCondition, load
from fdes.control import Law, LinearModel, Stick
from fdes.control.law import STICKS, SURFACES
from fdes.control.laws.direct import Direct
from fdes.control.spoken import units_of
from fdes.errors import Departed
from fdes.flight import Clock, Excitation, HandsOff, Setup, SteadyAir, fly, plant_of
from fdes.physics.signals import Outputs, Surfaces

Array = NDArray[np.float64]

DT = 1.0 / 120.0  # s
SHORT = 1e-6  # s: a frame that is all but continuous
JACOBIAN = 1e-9
LIMIT = 1e-4
UNKNOWN = 0.3  # of a gain that has no default but zero
WARM = 50  # frames until a memory that fills up is full
Y = Outputs(*[0.01 * (k + 1) for k in range(len(Outputs._fields))])
STICK = Stick(0.1, -0.2, 0.3, 0.4)
SHAKEN = ("doublet elevator 1deg for 1s", "doublet rudder 1deg for 1s", "doublet aileron 1deg for 1s")


@dataclass(frozen=True)
class LawFinding:
    """What of a law does not hold: the rule, what was found, and what to do."""

    rule: str
    what: str
    advice: str


def law_findings(part: Any) -> tuple[LawFinding, ...]:
    """Everything that does not hold of a law, given as its dataclass; nothing if all does.

    A law whose code fails is found under the rule that met it, with the message.
    """
    condition = load("A-4D").at("M0.4_SL")
    try:
        law = _example(part, condition)
    except Exception as trouble:  # noqa: BLE001  it is somebody's own code
        return (LawFinding("made", _failed("making it", trouble), "Let every field be a number, but for inner."),)
    found = []
    for rule, look in RULES.items():
        try:
            said = look(law, condition)
        except Exception as trouble:  # noqa: BLE001  it is somebody's own code
            said = _failed("it", trouble), "Mend what fails."
        if said:
            found.append(LawFinding(rule, *said))
    return tuple(found)


Said = tuple[str, str] | None


def _example(part: Any, condition: FlightCondition) -> Law:
    given = {"inner": Direct(condition.full_stick), "full_stick": condition.full_stick}
    units = units_of(part)
    law: Law = part(**{f.name: given.get(f.name, UNKNOWN) for f in fields(part) if _is_to_be_said(f, units)})
    return law


def _is_to_be_said(f: Any, units: Mapping[str, str]) -> bool:
    """What has no default; and a gain that is zero by default, whose sign could not be seen."""
    if not f.init or f.default_factory is not MISSING:
        return False
    return f.default is MISSING or (units.get(f.name, "s") != "s" and f.default == 0.0)


def _frozen(law: Any, condition: FlightCondition) -> Said:
    if type(law).__dataclass_params__.frozen:
        return None
    return "It can be changed while it flies.", "Write @dataclass(frozen=True), and hand back what is remembered."


def _pure(law: Law, condition: FlightCondition) -> Said:
    memory = law.start(Y, STICK)
    first = law.step(Y, STICK, memory, DT)
    law.step(Y._replace(q=9.0, r=9.0, p=9.0, phi=9.0), Stick(1.0, 1.0, 1.0, 1.0), memory, DT)
    if law.start(Y, STICK) == memory and law.step(Y, STICK, memory, DT) == first:
        return None
    return "The same question has another answer the second time.", "Keep nothing in the law: pass it through memory."


def _surfaces(law: Law, condition: FlightCondition) -> Said:
    command: Any = law.step(Y, STICK, law.start(Y, STICK), DT)[0]
    if isinstance(command, Surfaces) and all(isfinite(v) for v in command):
        return None
    return f"step commands {command!r}.", "Return Surfaces of finite numbers, such as command._replace(aileron=...)."


def _flight(law: Law, condition: FlightCondition) -> Said:
    plant = plant_of(condition)

    def flown() -> list[Surfaces]:
        frames = fly(
            plant.start(500.0),
            Setup(plant, law),
            HandsOff(condition.trim_throttle),
            SteadyAir(),
            Clock(DT, 1, 4.0),
            Excitation.parse(list(SHAKEN)),
        )
        return [frame.command for frame in frames]

    try:
        once = flown()
    except Departed as ending:
        return f"Four seconds of flight at gains of {UNKNOWN:g} end early: {ending}", "Turn the sign, or say a default."
    if not all(isfinite(v) for command in once for v in command):
        return "It commands what is no number in flight.", "Look for a division by zero."
    if flown() != once:
        return "Flown again from the start, it flies differently.", "Keep nothing in the law: pass it through memory."
    return None


def _measures(law: Law, condition: FlightCondition) -> Said:
    memory = law.start(Y, STICK)
    command, _ = law.step(Y, STICK, memory, DT)
    hidden = [
        name
        for name in sorted(set(Outputs._fields) - set(law.linear().inputs))
        if law.step(Y._replace(**{name: 7.0}), STICK, memory, DT)[0] != command
    ]
    if not hidden:
        return None
    said = f"{', '.join(hidden)} moves surfaces, and is no input of linear()."
    return said, "Name it there, as with_loop does with its signals."


def _units(law: Law, condition: FlightCondition) -> Said:
    model = law.linear()
    lacking = sorted({*model.states, *model.inputs, *model.outputs} - set(model.units))
    if model.outputs == SURFACES and not lacking:
        return None
    if lacking:
        return f"linear() does not say the unit of {', '.join(lacking)}.", "Give with_loop the states with their units."
    return f"The outputs of linear() are {', '.join(model.outputs)}.", f"Let them be {', '.join(SURFACES)}."


def _jacobian(law: Law, condition: FlightCondition) -> Said:
    model = law.linear(DT)
    if model.dt != DT:
        return f"linear({DT:.5f}) is a model of dt = {model.dt}.", "Hand dt on to what is inside, and to every block."
    memory = law.start(Y, STICK)
    for _ in range(WARM):
        _, memory = law.step(Y, STICK, memory, DT)
    held = len(list(_numbers(memory)))
    if held != len(model.states):
        said = f"It remembers {held} numbers, and linear() has {len(model.states)} states."
        return said, "Name every number of the memory, in its order."
    is_, says = _differences(law, model, memory), np.block([[model.A, model.B], [model.C, model.D]])
    k, j = np.unravel_index(int(np.argmax(np.abs(is_ - says))), is_.shape)
    if abs(is_[k, j] - says[k, j]) <= JACOBIAN:
        return None
    rows, columns = (*model.states, *SURFACES), (*model.states, *model.inputs)
    said = (
        f"{columns[j]} moves {rows[k]} by {is_[k, j]:.6g} in a step, and linear({DT:.5f}) says {says[k, j]:.6g} "
        f"[{model.units[rows[k]]} per {model.units[columns[j]]}]."
    )
    return said, "Let both say the same; look at signs first."


def _continuous(law: Law, condition: FlightCondition) -> Said:
    whole, short = law.linear(), law.linear(SHORT)
    if (whole.dt, whole.states, whole.inputs) != (None, short.states, short.inputs):
        return "linear() and linear(dt) have other states, inputs or dt.", "Let both be made of the same blocks."
    moves = (short.A - np.eye(len(short.states))) / SHORT, short.B / SHORT, short.C, short.D
    apart = max(
        float(np.abs(a - b).max(initial=0.0)) for a, b in zip((whole.A, whole.B, whole.C, whole.D), moves, strict=True)
    )
    if apart <= LIMIT * max(1.0, float(np.abs(whole.A).max(initial=0.0))):
        return None
    return f"linear() is {apart:.3g} away from what linear(dt) tends to as dt goes to zero.", "Compare the two."


RULES: dict[str, Callable[[Law, FlightCondition], Said]] = {
    "frozen": _frozen,
    "surfaces": _surfaces,
    "pure": _pure,
    "flight": _flight,
    "measures": _measures,
    "units": _units,
    "jacobian": _jacobian,
    "continuous": _continuous,
}


def _failed(what: str, trouble: Exception) -> str:
    return f"Trying {what} fails: {type(trouble).__name__}: {trouble}."


def _differences(law: Law, model: LinearModel, memory: Any) -> Array:
    """d(memory, surfaces)/d(memory, inputs) of one step."""
    stick = {name: getattr(STICK, name.removeprefix("stick_")) for name in STICKS}
    at = np.array([*_numbers(memory), *(stick[n] if n in stick else getattr(Y, n) for n in model.inputs)])
    n = len(model.states)

    def answer(values: Array) -> Array:
        given = dict(zip(model.inputs, values[n:].tolist(), strict=True))
        y = Y._replace(**{name: v for name, v in given.items() if name not in STICKS})
        pushed = STICK._replace(**{name.removeprefix("stick_"): v for name, v in given.items() if name in STICKS})
        command, after = law.step(y, pushed, _with_numbers(memory, iter(values[:n].tolist())), DT)
        return np.array([*_numbers(after), *command])

    steps = np.eye(len(at)) * 2.0**-5
    return np.column_stack([(answer(at + step) - answer(at - step)) * 2.0**4 for step in steps])


def _numbers(memory: Any) -> Iterator[float]:
    """The numbers of a memory, in order."""
    if isinstance(memory, tuple):
        for part in memory:
            yield from _numbers(part)
    elif memory is not None:
        yield float(memory)


def _with_numbers(memory: Any, values: Iterator[float]) -> Any:
    """The same memory with other numbers."""
    if isinstance(memory, tuple):
        parts = [_with_numbers(part, values) for part in memory]
        return type(memory)(*parts) if hasattr(memory, "_fields") else type(memory)(parts)
    return None if memory is None else next(values)
