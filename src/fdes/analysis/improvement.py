"""Which number to change, and to what, so that a verdict reaches the next Level.

Each candidate is a number of the aircraft that the mode is known to hang on, or a gain. It is moved through a sensible
range until the criterion, asked again of the changed aircraft, gives the better Level; the nearest such value is found
by halving. What the change costs elsewhere is found the same way, by asking all criteria again.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from fdes.aircraft import FlightCondition
from fdes.aircraft.edit import Change, edited
from fdes.aircraft.knobs import knobs
from fdes.aircraft.role import Role
from fdes.analysis.designed import Designed
from fdes.analysis.linearize import linear_model
from fdes.analysis.measured import measure
from fdes.analysis.qualities import assess, chosen
from fdes.analysis.verdict import WORSE, Verdict, level_name
from fdes.control import Law, LinearModel
from fdes.errors import FdesError

# What each mode hangs on most: Nelson, sections 4.5 and 5.3, and Etkin and Reid, sections 6.3 and 6.8. The names on the
# right are dimensional.
MOVED_BY = {
    "short_period": ("Cm_q", "Cm_alpha", "Cm_alphadot", "CL_alpha", "M_q", "M_w", "M_wdot", "Z_w"),
    "phugoid": ("CD", "Cm_M", "CL_M", "CD_M", "X_u", "Z_u", "M_u"),
    "roll": ("Cl_p", "L_p"),
    "dutch_roll": (
        "Cn_r",
        "Cn_beta",
        "Cl_beta",
        "Cn_p",
        "Cy_beta",
        "N_r",
        "N_beta",
        "N_v",
        "L_beta",
        "L_v",
        "N_p",
        "Y_v",
    ),
    "spiral": ("Cl_beta", "Cn_r", "Cl_r", "Cn_beta", "L_beta", "L_v", "N_r", "L_r"),
    "roll_spiral": ("Cl_beta", "Cl_p", "Cn_beta", "Cn_r", "L_beta", "L_v", "L_p", "N_r"),
}
HIGHER = 4.0  # times a gain: how far it is turned up
STEPS = 10  # from the present value to either end of the range
HALVINGS = 14  # then: to a hundred-thousandth of the range
DIGITS = 3  # of what is proposed
NUDGE = 0.01  # of a value, for its sensitivity


@dataclass(frozen=True)
class Adjustable:
    """A number that can be turned, in `unit`, from `low` to `high`. model: the aircraft with another value of it."""

    name: str
    unit: str
    value: float
    low: float
    high: float
    model: Callable[[float], LinearModel]


@dataclass(frozen=True)
class Improvement:
    """One change that reaches a better Level.

    name, value, wanted, unit: what to change, from what, to what. level: what is reached, verified on the changed
    aircraft. sensitivity: by how many percent the governing quantity changes when the number changes by one percent;
    None where the number is zero. costs: what else gets a worse Level by it.
    """

    criterion: str
    mode: str
    name: str
    value: float
    wanted: float
    unit: str
    level: int
    sensitivity: float | None
    costs: tuple[str, ...]

    def __str__(self) -> str:
        unit = "" if self.unit in {"1", "1/rad"} else f" {self.unit}"
        times = f" (x{self.wanted / self.value:.3g})" if self.value else ""
        but = f", but {'; '.join(self.costs)}" if self.costs else ""
        return (
            f"{self.name} from {self.value:.3g} to {self.wanted:.3g}{unit}{times} reaches {level_name(self.level)}{but}"
        )

    def as_dict(self) -> dict[str, Any]:
        """The change as JSON has it."""
        return {**vars(self), "costs": list(self.costs), "says": str(self)}


def adjustables(
    condition: FlightCondition, mode: str, model_of: Callable[[FlightCondition], LinearModel] = linear_model
) -> list[Adjustable]:
    """The derivatives of `condition` that `mode` hangs on, each within its own sign.

    model_of: what is judged of a changed aircraft: its linear model, or a loop closed round it.
    """
    found = []
    for knob in knobs(condition):
        if knob.name not in MOVED_BY.get(mode, ()):
            continue

        def model(value: float, name: str = knob.name, unit: str = knob.unit) -> LinearModel:
            return model_of(edited(condition, [Change(name, "=", value, unit)]))

        low = max(knob.low, 0.0) if knob.value > 0.0 else knob.low
        high = min(knob.high, 0.0) if knob.value < 0.0 else knob.high
        found.append(Adjustable(knob.name, knob.unit, knob.value, low, high, model))
    return found


def gains(designed: Designed, model_of: Callable[[Law], LinearModel]) -> list[Adjustable]:
    """The gains of a law, each from zero to `HIGHER` times itself. model_of: the loop closed by a law."""
    found = []
    for part, fields in designed.gains.items():
        for field, value in fields.items():
            if "gain" not in field or not 0.0 < value < math.inf:
                continue

            def model(wanted: float, part: str = part, field: str = field) -> LinearModel:
                return model_of(_with_gain(designed.law, part, field, wanted))

            found.append(Adjustable(f"{part} {field}", "1", value, 0.0, HIGHER * value, model))
    return found


def _with_gain(law: Any, name: str, gain: str, value: float) -> Any:
    """The law with another gain in the part of it that is called `name`."""
    if type(law).__name__.casefold() == name.replace("_", "") and hasattr(law, gain):
        return replace(law, **{gain: value})
    return replace(law, inner=_with_gain(law.inner, name, gain, value)) if hasattr(law, "inner") else law


def improvements(
    verdict: Verdict, candidates: Iterable[Adjustable], role: Role, delay: float | None = None, most: int = 3
) -> list[Improvement]:
    """The changes by which `verdict` reaches the next Level, those of least effort first, at most `most`.

    Empty where it is Level 1 or not applicable, and where no candidate alone reaches a better Level within its range.
    """
    if verdict.level is None or verdict.level == 1:
        return []
    search = _Search(verdict, role, delay, verdict.level - 1)
    found = [(search.effort(knob, wanted), knob, wanted) for knob in candidates for wanted in search.reached(knob)]
    nearest = sorted(found, key=lambda f: f[0])[:most]
    return [search.improvement(knob, wanted) for _, knob, wanted in nearest]


@dataclass(frozen=True)
class _Search:
    verdict: Verdict
    role: Role
    delay: float | None
    target: int

    def _asked(self, knob: Adjustable, value: float) -> Verdict | None:
        """The verdict with another value, or None where no aircraft can have it."""
        try:
            measured = measure(knob.model(value), self.delay)
        except (FdesError, ArithmeticError):
            return None
        return chosen([self.verdict.criterion])[0].evaluate(measured, self.role)

    def _good(self, knob: Adjustable, value: float) -> bool:
        found = self._asked(knob, value)
        return found is not None and found.level is not None and found.level <= self.target

    def reached(self, knob: Adjustable) -> list[float]:
        """The nearest value that is good enough, of either direction the easier; none where there is none."""
        found = [value for end in (knob.low, knob.high) for value in self._towards(knob, end)]
        return [min(found, key=lambda value: self.effort(knob, value))] if found else []

    def _towards(self, knob: Adjustable, end: float) -> list[float]:
        span = end - knob.value
        last = knob.value
        for step in range(1, STEPS + 1):
            value = knob.value + span * step / STEPS
            if span and self._good(knob, value):
                return self._rounded(knob, self._halved(knob, last, value), value)
            last = value
        return []

    def _halved(self, knob: Adjustable, bad: float, good: float) -> float:
        for _ in range(HALVINGS):
            middle = 0.5 * (bad + good)
            bad, good = (bad, middle) if self._good(knob, middle) else (middle, good)
        return good

    def _rounded(self, knob: Adjustable, exact: float, beyond: float) -> list[float]:
        """A round number a little further on, if that is good as well."""
        for digits in (DIGITS, DIGITS + 1, DIGITS + 2):
            value = _rounded_away(exact, knob.value, digits)
            if abs(value - knob.value) <= abs(beyond - knob.value) and self._good(knob, value):
                return [value]
        return [exact]

    @staticmethod
    def effort(knob: Adjustable, wanted: float) -> float:
        """The share of its range that a change takes."""
        return abs(wanted - knob.value) / (knob.high - knob.low)

    def improvement(self, knob: Adjustable, wanted: float) -> Improvement:
        changed = assess(knob.model(wanted), self.role, delay=self.delay)
        before = {v.criterion: v for v in assess(knob.model(knob.value), self.role, delay=self.delay)}
        own = next(v for v in changed if v.criterion == self.verdict.criterion)
        return Improvement(
            criterion=self.verdict.criterion,
            mode=self.verdict.mode,
            name=knob.name,
            value=knob.value,
            wanted=wanted,
            unit=knob.unit,
            level=own.level or WORSE,
            sensitivity=self._sensitivity(knob),
            costs=tuple(_costs(before, changed)),
        )

    def _sensitivity(self, knob: Adjustable) -> float | None:
        """Of the governing quantity, whatever governs after a nudge: relative, by central difference."""
        sides = [self._same(self._asked(knob, knob.value * (1.0 + side))) for side in (NUDGE, -NUDGE)]
        value = self.verdict.value
        if not knob.value or not value or None in sides:
            return None
        more, less = sides
        return ((more or 0.0) - (less or 0.0)) / (2.0 * NUDGE * value)

    def _same(self, found: Verdict | None) -> float | None:
        """The value of the quantity that governs now."""
        parts: Sequence[Verdict] = () if found is None else found.parts or (found,)
        return next((p.value for p in parts if _quantity(p) == _quantity(self.verdict)), None)


def _quantity(verdict: Verdict) -> tuple[str, str]:
    return verdict.unit, verdict.requirement.partition(":")[0]


def _costs(before: dict[str, Verdict], after: Iterable[Verdict]) -> Iterable[str]:
    for verdict in after:
        was, now = before[verdict.criterion].level, verdict.level
        if was is not None and now is not None and now > was:
            yield f"the {verdict.mode.replace('_', ' ')} falls to {level_name(now)}"


def _rounded_away(value: float, start: float, digits: int) -> float:
    """`value` with so many digits, rounded away from `start`."""
    if value == 0.0:
        return value
    unit = 10.0 ** (math.floor(math.log10(abs(value))) - digits + 1)
    count = math.ceil(value / unit) if value > start else math.floor(value / unit)
    return float(f"{count * unit:.{digits + 1}g}")


def unreachable(verdict: Verdict, candidates: Iterable[Adjustable]) -> str:
    """What is said where there is no improvement; nothing where none is needed."""
    tried = ", ".join(knob.name for knob in candidates)
    if verdict.level is None or verdict.level == 1:
        return ""
    if not tried:
        return "No derivative changes it."
    return f"None of {tried} alone reaches {level_name(verdict.level - 1)} within its range."
