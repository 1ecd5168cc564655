"""Law and actuators of a craft: what a pilot asked for, what came of it, and what the page is told of it.

A law comes as a text that names parts of the shelf `laws` and their numbers (`fdes.control.spoken`), never as a path or
code. It is designed once, when it is asked for; later edits of the aircraft keep its gains.
"""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.closed_loop import close, with_actuators
from fdes.analysis.design import law_for
from fdes.analysis.design_rules import RULES
from fdes.analysis.designed import Designed
from fdes.analysis.linearize import linear_model
from fdes.control import LinearModel
from fdes.control.laws.direct import Direct
from fdes.control.spoken import WISHES, units_of
from fdes.errors import SpecError
from fdes.flight.actuated import actuators_of
from fdes.physics.derivatives import Form
from fdes.shelf import shelf

NONE = "direct"


@dataclass(frozen=True)
class Control:
    """What flies between stick and surfaces. `law` is a text; once fitted, with all its gains.

    sampled: design at the step of the flight, in z; else continuous, in s. wanted: by law, what it was designed for.
    """

    law: str = NONE
    actuators: bool = False
    sampled: bool = False
    wanted: Mapping[str, float] = field(default_factory=dict)

    def asked(self, text: str, *, sampled: bool) -> "Control":
        """The same with another law. What is wanted of loops that keep all their numbers is remembered."""
        kept = {part.strip() for part in text.split(";")} & {part.strip() for part in self.law.split(";")}
        names = {part.split()[0] for part in kept if part}
        return replace(
            self,
            law=text,
            sampled=sampled,
            wanted={name: value for name, value in self.wanted.items() if name in names},
        )


@dataclass(frozen=True)
class Fitted:
    """A control as it is on an aircraft: `control` with its gains, and the continuous `model` of the whole."""

    control: Control
    designed: Designed
    model: LinearModel

    @property
    def bare(self) -> bool:
        """Whether nothing is between stick and surfaces."""
        return self.control.law == NONE and not self.control.actuators


def fitted(control: Control, condition: FlightCondition, form: Form, dt: float) -> Fitted:
    """The control on that aircraft, flown in frames of `dt` [s]. Raises SpecError, NoSuchPart."""
    actuators = actuators_of(condition) if control.actuators else None
    if control.law.strip() == NONE:  # before anything else: a server must start at once, and designing loads SciPy
        model = linear_model(condition, form)
        law = Designed(Direct(condition.full_stick), NONE, {}, (), (), dt)
        whole = with_actuators(model, actuators) if actuators else model
        return Fitted(replace(control, law=NONE, wanted={}), law, whole)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)  # an overflow shows in what comes out
            found = law_for(control.law, condition, form, dt if control.sampled else None, dt, actuators=actuators)
            model = close(condition, found.law, None, actuators, form)
            if not np.isfinite(model.A).all():
                raise SpecError(_too_great(control.law))
    except (ArithmeticError, np.linalg.LinAlgError):
        raise SpecError(_too_great(control.law)) from None
    achieved = tuple(replace(a, wanted=control.wanted.get(a.law)) if a.wanted is None else a for a in found.achieved)
    wanted = {a.law: a.wanted for a in achieved if a.wanted is not None}
    found = replace(found, achieved=achieved)
    return Fitted(replace(control, law=found.text, wanted=wanted), found, model)


def _too_great(text: str) -> str:
    return f"The law {text[:80]!r} cannot be flown: its numbers are too great or too small. Gains are about 0.01 to 10."


def control_message(now: Fitted, condition: FlightCondition) -> dict[str, Any]:
    """The wire's CONTROL: the law in use, what came of its design, and the actuators."""
    said = now.designed.as_dict()
    rate = actuators_of(condition).elevator
    return {
        "type": "control",
        **said,
        "sampled": now.control.sampled,
        "actuators": {
            "on": now.control.actuators,
            "bandwidth": rate.bandwidth,
            "rate_limit": rate.rate_limit,
            "reason": condition.assumed["actuator_bandwidth"]["reason"],
        },
    }


@cache
def laws_message() -> dict[str, Any]:
    """The wire's LAWS: what can be asked for, with units and with what one may wish of it."""
    laws = []
    for name, rule in RULES.items():
        part = shelf("laws").get(name)
        units = units_of(part)
        laws.append(
            {
                "name": name,
                "mode": rule.mode,
                "gains": {gain: units[gain] for gain in rule.gains},
                "settings": {key: unit for key, unit in units.items() if key not in rule.gains},
                "wishes": {wish: WISHES[wish] for wish in rule.wishes},
                "summary": part.__doc__.partition("\n\n")[0].strip(),
            }
        )
    return {"type": "laws", "laws": laws}
