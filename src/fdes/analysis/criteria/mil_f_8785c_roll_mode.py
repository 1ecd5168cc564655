"""Roll mode: its time constant.

Reference: MIL-F-8785C, 1980, paragraph 3.3.1.2, table VII, page 23.
"""

from fdes.aircraft.role import Role
from fdes.analysis.measured import Measured
from fdes.analysis.verdict import WORSE, Band, Criterion, Requirement, Verdict, asked

__all__ = ["ROLL_MODE"]

NAME = "mil_f_8785c_roll_mode"
QUICK: tuple[Band, ...] = ((None, 1.0), (None, 1.4), (None, 10.0))
SLOW: tuple[Band, ...] = ((None, 1.4), (None, 3.0), (None, 10.0))


def bands(role: Role) -> tuple[Band, ...]:
    """Table VII for `role` [s]."""
    if role.category == "A":
        return QUICK if role.airplane_class in {"I", "IV"} else SLOW
    if role.category == "C":
        return SLOW if role.airplane_class in {"II-L", "III"} else QUICK
    return SLOW


def evaluate(m: Measured, role: Role) -> Verdict:
    """By the time constant; a roll rate that diverges is worse than Level 3."""
    limits = bands(role)
    asks = Requirement(
        criterion=NAME,
        mode="roll",
        unit="s",
        requirement=asked("tau_roll", limits, "s") + f" (Category {role.category}, Class {role.airplane_class})",
        reference="MIL-F-8785C, paragraph 3.3.1.2, table VII, page 23",
    )
    tau = m.tau_roll
    if tau is None:
        default = "tau_roll, the roll-mode time constant, is not given."
        return asks.not_applicable(m.missing.get("tau_roll", default))
    if tau < 0.0:
        # The margin is that of the root, -1/tau: it is the root, not tau, that passes through zero.
        slowest = limits[-1][1] or 1.0
        reason = f"The roll rate diverges, with the time constant {-tau:.3g} s."
        return asks.found(WORSE, -1.0 + slowest / tau, tau, reason)
    return asks.graded(tau, limits, f"tau_roll is {tau:.3g} s")


ROLL_MODE = Criterion(
    name=NAME,
    mode="roll",
    title="Roll-mode time constant",
    reads=("tau_roll",),
    evaluate=evaluate,
)
