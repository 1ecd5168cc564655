"""Spiral stability: the time in which bank doubles.

Reference: MIL-F-8785C, 1980, paragraph 3.3.1.3, table VIII, page 23: after a disturbance of up to 20 degrees, with the
cockpit controls free. Controls held fixed stand for it here.
"""

import math
from dataclasses import replace

from fdes.aircraft.role import Category, Role
from fdes.analysis.measured import LN2, Measured
from fdes.analysis.verdict import Band, Criterion, Requirement, Verdict, asked

__all__ = ["SPIRAL"]

NAME = "mil_f_8785c_spiral"
LIMITS: dict[Category, tuple[Band, ...]] = {
    "A": ((12.0, None), (8.0, None), (4.0, None)),
    "B": ((20.0, None), (8.0, None), (4.0, None)),
    "C": ((12.0, None), (8.0, None), (4.0, None)),
}


def evaluate(m: Measured, role: Role) -> Verdict:
    """By the time to double. A stable or neutral spiral meets every Level; its margin is that of its root."""
    limits = LIMITS[role.category]
    asks = Requirement(
        criterion=NAME,
        mode="spiral",
        unit="s",
        requirement=asked("time to double", limits, "s") + f" (Category {role.category}); a stable spiral meets all",
        reference="MIL-F-8785C, paragraph 3.3.1.3, table VIII, page 23",
    )
    t2 = m.t2_spiral
    if t2 is None:
        default = "t2_spiral, the time in which bank doubles, is not given."
        return asks.not_applicable(m.missing.get("t2_spiral", default))
    if t2 < 0.0 or math.isinf(t2):
        root = LN2 / t2
        allowed = LN2 / (limits[0][0] or 1.0)
        kind = "neutral" if math.isinf(t2) else f"stable, with the time to half {-t2:.3g} s"
        reason = f"The spiral is {kind}. Value and margin are those of its root, which may be up to {allowed:.3g} 1/s."
        return replace(asks, unit="1/s").found(1, (allowed - root) / allowed, root, reason)
    return asks.graded(t2, limits, f"Bank doubles in {t2:.3g} s")


SPIRAL = Criterion(
    name=NAME,
    mode="spiral",
    title="Spiral stability",
    reads=("t2_spiral",),
    evaluate=evaluate,
)
