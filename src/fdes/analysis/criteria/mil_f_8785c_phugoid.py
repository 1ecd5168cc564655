"""Phugoid damping, and airspeed that diverges without oscillating.

Reference: MIL-F-8785C, 1980, paragraph 3.2.1.2, page 12, and paragraph 3.2.1.1, page 11.
"""

from dataclasses import replace

from fdes.aircraft.role import Role
from fdes.analysis.measured import Measured
from fdes.analysis.verdict import WORSE, Band, Criterion, Requirement, Verdict, level_name, worst

__all__ = ["PHUGOID"]

NAME = "mil_f_8785c_phugoid"
DAMPING: tuple[Band, ...] = ((0.04, None), (0.0, None))
SLOWEST = 55.0  # s, time to double of an unstable phugoid at Level 3
SLOWEST_APERIODIC = 6.0  # s, time to double of airspeed at Level 3
OSCILLATION = Requirement(
    criterion=NAME,
    mode="phugoid",
    unit="1",
    requirement="zeta_ph: Level 1 at least 0.04, Level 2 at least 0; Level 3: time to double at least 55 s",
    reference="MIL-F-8785C, paragraph 3.2.1.2, page 12",
)
DIVERGENCE = Requirement(
    criterion=NAME,
    mode="phugoid",
    unit="s",
    requirement="airspeed must not diverge without oscillating; Level 3: time to double at least 6 s",
    reference="MIL-F-8785C, paragraph 3.2.1.1, page 11",
)


def evaluate(m: Measured, role: Role) -> Verdict:
    """Damping while it is stable, time to double where it is not; airspeed that diverges is judged with it."""
    parts = [*_divergence(m), _oscillation(m)]
    said = worst(parts)
    note = m.notes.get("phugoid")
    return replace(said, reason=f"{note} {said.reason}") if note and said.level is not None else said


def _oscillation(m: Measured) -> Verdict:
    if m.t2_ph is not None and (m.zeta_ph is None or m.zeta_ph < 0.0):
        return _slow_enough(replace(OSCILLATION, unit="s"), m.t2_ph, SLOWEST, "The phugoid grows")
    if m.zeta_ph is None:
        default = "Neither zeta_ph nor t2_ph, the time to double of an unstable phugoid, is known."
        return OSCILLATION.not_applicable(m.missing.get("zeta_ph", default))
    if m.zeta_ph < 0.0:
        return OSCILLATION.not_applicable(
            f"zeta_ph is {m.zeta_ph:.3g}, which misses Level 2: whether it is Level 3 takes t2_ph, the time to double."
        )
    return OSCILLATION.graded(m.zeta_ph, DAMPING, f"zeta_ph is {m.zeta_ph:.3g}")


def _divergence(m: Measured) -> list[Verdict]:
    if m.t2_speed is None:
        return []
    return [_slow_enough(DIVERGENCE, m.t2_speed, SLOWEST_APERIODIC, "Airspeed diverges without oscillating")]


def _slow_enough(asks: Requirement, t2: float, least: float, what: str) -> Verdict:
    """Level 3 or worse: what grows may do so slowly."""
    level = 3 if t2 >= least else WORSE
    return asks.found(level, (t2 - least) / least, t2, f"{what}, doubling every {t2:.3g} s: {level_name(level)}.")


PHUGOID = Criterion(
    name=NAME,
    mode="phugoid",
    title="Phugoid damping",
    reads=("zeta_ph", "t2_ph", "t2_speed"),
    evaluate=evaluate,
)
