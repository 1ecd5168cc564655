"""Delay of the response to the cockpit controls, as an equivalent time delay.

Reference: MIL-F-8785C, 1980, paragraph 3.5.3, table XIV, pages 41 and 42.
"""

from fdes.aircraft.role import Role
from fdes.analysis.measured import Measured
from fdes.analysis.verdict import Band, Criterion, Requirement, Verdict, asked

__all__ = ["RESPONSE_DELAY"]

NAME = "mil_f_8785c_response_delay"
LIMITS: tuple[Band, ...] = ((None, 0.10), (None, 0.20), (None, 0.25))
DELAY = Requirement(
    NAME, "response", "s", asked("delay", LIMITS, "s"), "MIL-F-8785C, paragraph 3.5.3, table XIV, pages 41 and 42"
)


def evaluate(m: Measured, role: Role) -> Verdict:
    """By the delay between stick and surface; a model without anything between them has none to judge."""
    if m.delay is None:
        return DELAY.not_applicable(m.missing.get("delay", "delay, the equivalent time delay, is not given."))
    parts = m.notes.get("delay")
    says = f"The response comes {m.delay:.3g} s after the stick" + (f", {parts}" if parts else "")
    return DELAY.graded(m.delay, LIMITS, says)


RESPONSE_DELAY = Criterion(
    name=NAME,
    mode="response",
    title="Delay of the response",
    reads=("delay",),
    evaluate=evaluate,
)
