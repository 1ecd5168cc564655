"""How the Dutch roll depends on a trim angle of attack that is not well known.

Inertias in body axes are turned to stability axes by the trim angle of attack: a few degrees make a product of inertia
that can turn a damped Dutch roll into an undamped one. Where a source does not give the angle, or only a doubtful one,
this says how much hangs on it.
"""

from dataclasses import replace
from typing import NamedTuple

from fdes.aircraft import FlightCondition
from fdes.analysis.modes import modes
from fdes.units import DEG, Number, Radian, RadianPerSecond

ANGLES = (0.0, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0)  # deg: from high speed to the approach


class DutchRollAt(NamedTuple):
    """The Dutch roll if the trim angle of attack were `alpha`. used: it is the one that the flight condition has."""

    alpha: Radian
    zeta: Number
    omega_n: RadianPerSecond
    used: bool


def dutch_roll_by_trim_alpha(condition: FlightCondition) -> list[DutchRollAt]:
    """The Dutch roll, form `full`, over the trim angle of attack; empty where that is well known or does not matter.

    An angle at which there is no Dutch roll, its roots having split or merged with others, is left out.
    """
    if not condition.trim_alpha_uncertain:
        return []
    given = condition.reference.alpha
    found = []
    for alpha in sorted({given, *[angle * DEG for angle in ANGLES]}):
        turned = replace(condition, reference=condition.reference._replace(alpha=alpha))
        found += [
            DutchRollAt(alpha, m.zeta, m.omega_n, alpha == given)
            for m in modes(turned, "full")
            if m.name == "dutch_roll"
        ]
    return found
