"""Questions that anybody in a session may ask: they change nothing."""

from typing import Any, cast

from fdes.aircraft.save import as_toml, saved
from fdes.analysis import linear_model
from fdes.analysis.airspeeds import airspeeds
from fdes.analysis.improvement import adjustables, improvements, unreachable
from fdes.analysis.margins import costs
from fdes.analysis.qualities import assess
from fdes.cockpit import commands
from fdes.cockpit.craft import Craft
from fdes.cockpit.excite import preview
from fdes.cockpit.flight_control import fitted
from fdes.control import LinearModel
from fdes.flight.actuated import actuators_of
from fdes.physics.derivatives import Form, dimensional
from fdes.physics.signals import channels

Question = (
    commands.Ping
    | commands.Preview
    | commands.Improve
    | commands.Calculate
    | commands.Margins
    | commands.Airspeeds
    | commands.SaveAircraft
)


def answer(question: Question, shown: Craft) -> dict[str, Any]:
    """What is replied to a question about the craft that is `shown`. Raises FdesError where it cannot be answered."""
    match question:
        case commands.Preview(text):
            return preview(text)
        case commands.Improve(criterion):
            return improved(shown, criterion)
        case commands.Calculate():
            return calculated(shown)
        case commands.Margins():
            return {"margins": margins(shown)}
        case commands.Airspeeds(kind, value, h):
            return airspeeds(kind, value, h)._asdict()
        case commands.SaveAircraft():
            content = saved(shown.condition)
            return {"name": f"{content['id']}.toml", "text": as_toml(shown.condition)}
        case commands.Ping():
            return {}


def improved(craft: Craft, criterion: str) -> dict[str, Any]:
    """The changes that reach the next Level by a criterion, or why there are none. Raises NoSuchPart."""
    form = cast("Form", craft.form)
    airframe = linear_model(craft.condition, form)
    (verdict,) = assess(craft.fit.model, craft.role, airframe=airframe, criteria=[criterion])
    candidates = adjustables(
        craft.condition, verdict.mode, lambda changed: fitted(craft.fit.control, changed, form, craft.clock.dt).model
    )
    found = improvements(verdict, candidates, craft.role)
    best = verdict.reason if verdict.level is None else "Level 1 is the best: nothing needs to change."
    return {
        "improvements": [each.as_dict() for each in found],
        "reason": "" if found else unreachable(verdict, candidates) or best,
    }


def calculated(craft: Craft) -> dict[str, Any]:
    """Dimensional derivatives, None where the source gives no others, and A and B: as they fly, SI."""
    condition, form = craft.condition, cast("Form", craft.form)
    model = linear_model(condition, form)
    named = dimensional(condition.coefficients, condition.reference, form) if condition.nondimensional else None
    return {
        "dimensional": named
        and [
            {"name": c.name, "value": value, "unit": c.unit}
            for c, value in zip(channels(type(named)), named, strict=True)
        ],
        "longitudinal": _matrices(model.longitudinal()),
        "lateral": _matrices(model.lateral()),
    }


def margins(craft: Craft) -> list[dict[str, Any]]:
    """The margins at each surface: of the law alone, then with all that comes between it and the air, one by one."""
    control, condition = craft.fit.control, craft.condition
    actuators = actuators_of(condition) if control.actuators else None
    found = costs(condition, craft.fit.designed.law, craft.clock.dt, actuators, cast("Form", craft.form))
    return [{"step": step, **margin.as_dict()} for step, loops in found.items() for margin in loops]


def _matrices(part: LinearModel) -> dict[str, Any]:
    return {"states": list(part.states), "inputs": list(part.inputs), "A": part.A.tolist(), "B": part.B.tolist()}
