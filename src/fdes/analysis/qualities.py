"""Flying qualities of a linear model: the verdicts of all criteria, or of those that are asked for.

>>> from fdes.aircraft import load
>>> [verdict.level for verdict in assess(load("A-4D").at(), criteria=["mil_f_8785c_short_period"])]
[1]
"""

from collections.abc import Iterable, Sequence
from functools import cache

from fdes.aircraft import FlightCondition
from fdes.aircraft.role import STRICTEST, Role, role_of
from fdes.analysis.linearize import linear_model
from fdes.analysis.measured import Measured, measure
from fdes.analysis.modes import Mode
from fdes.analysis.quality_charts import Chart
from fdes.analysis.verdict import Criterion, Verdict
from fdes.control import LinearModel
from fdes.physics.derivatives import Form
from fdes.shelf import shelf

ORDER = ("short_period", "phugoid", "roll", "dutch_roll", "spiral", "roll_spiral", "response")  # of the modes


def assess(
    of: LinearModel | FlightCondition,
    role: Role | None = None,
    *,
    form: Form = "full",
    delay: float | None = None,
    found: Sequence[Mode] | None = None,
    airframe: LinearModel | None = None,
    criteria: Iterable[str] | None = None,
) -> list[Verdict]:
    """One verdict per criterion, on a linear model or on an aircraft in a flight condition.

    The model may be that of an edited aircraft or of a closed loop. role: Class, Category and Flight Phase, else those
    of the aircraft's file, else the strictest. delay [s]: of all that lies between stick and surface. found: the modes
    of the model, where they are known already. airframe: the model without law and actuators, for n/alpha; a sampled
    closed loop gives it to 2 %. criteria: their names, else the whole shelf.
    Raises NoSuchPart for an unknown criterion.
    """
    model = of if isinstance(of, LinearModel) else linear_model(of, form)
    return judge(measure(model, delay, found, airframe), role or _role(of), criteria)


def judge(measured: Measured, role: Role, criteria: Iterable[str] | None = None) -> list[Verdict]:
    """The verdicts on quantities that are known already, the longitudinal ones first."""
    return [criterion.evaluate(measured, role) for criterion in chosen(criteria)]


def charts(measured: Measured, role: Role, criteria: Iterable[str] | None = None) -> list[Chart]:
    """The figures of the criteria, with the aircraft's point in them."""
    return [chart for criterion in chosen(criteria) for chart in criterion.charts(measured, role)]


def chosen(names: Iterable[str] | None = None) -> list[Criterion]:
    """The criteria of these names, or all: those on the usual modes in their usual order, then others."""
    return list(_all()) if names is None else [shelf("criteria").get(name) for name in names]


@cache  # looking through the shelf takes several milliseconds, and the cockpit asks with each edit
def _all() -> tuple[Criterion, ...]:
    parts = [shelf("criteria").get(name) for name in shelf("criteria").names()]
    return tuple(sorted(parts, key=lambda c: ORDER.index(c.mode) if c.mode in ORDER else len(ORDER)))


def _role(of: LinearModel | FlightCondition) -> Role:
    return STRICTEST if isinstance(of, LinearModel) else role_of(of.document, of.condition)
