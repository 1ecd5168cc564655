"""Coupled roll-spiral oscillation: where it is allowed at all, and how well it must be damped.

Reference: MIL-F-8785C, 1980, paragraph 3.3.1.4, page 23.
"""

from fdes.aircraft.role import Role
from fdes.analysis.measured import Measured
from fdes.analysis.verdict import WORSE, Band, Criterion, Requirement, Verdict, asked

__all__ = ["COUPLED_ROLL_SPIRAL"]

NAME = "mil_f_8785c_coupled_roll_spiral"
LIMITS: tuple[Band, ...] = ((0.5, None), (0.3, None), (0.15, None))
DAMPING = Requirement(
    criterion=NAME,
    mode="roll_spiral",
    unit="rad/s",
    requirement=asked("zeta_rs omega_rs", LIMITS, "rad/s") + "; permitted in Categories B and C alone",
    reference="MIL-F-8785C, paragraph 3.3.1.4, page 23",
)


def evaluate(m: Measured, role: Role) -> Verdict:
    """By zeta omega_n. In Category A the mode is not permitted; without it nothing is asked."""
    product = m.damping_rs
    if product is None:
        default = "damping_rs, zeta times omega of a coupled roll-spiral mode, is not given."
        return DAMPING.not_applicable(m.missing.get("damping_rs", default))
    if role.category == "A":
        reason = "Roll and spiral are coupled, and Category A, with more than gentle maneuvers, does not permit it."
        return DAMPING.found(WORSE, -1.0, product, reason)
    return DAMPING.graded(product, LIMITS, f"Roll and spiral are coupled, with zeta omega_n {product:.3g} rad/s")


COUPLED_ROLL_SPIRAL = Criterion(
    name=NAME,
    mode="roll_spiral",
    title="Coupled roll-spiral oscillation",
    reads=("damping_rs",),
    evaluate=evaluate,
)
