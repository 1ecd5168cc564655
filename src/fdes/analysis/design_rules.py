"""What each law of the shelf is designed for: which gains, which mode, what may be wished of it, and what is fair."""

from collections.abc import Mapping
from typing import NamedTuple

from fdes.analysis.placement import Quantity
from fdes.control.spoken import Loop
from fdes.errors import SpecError

PAIR_ZETA = 0.8  # of a pair that is asked for by its speed alone


class Rule(NamedTuple):
    """How a law of the shelf is designed: which of its gains, for which mode, and what one may wish of that."""

    gains: tuple[str, ...]
    mode: str
    wishes: tuple[Quantity, ...]


RULES = {
    "pitch_rate_damper": Rule(("gain",), "short_period", ("zeta",)),
    "pitch_rate_pi": Rule(("gain", "integral_gain"), "short_period", ("zeta", "omega", "time_constant")),
    "roll_angle": Rule(("gain", "rate_gain"), "roll", ("zeta", "omega", "time_constant")),
    "roll_rate_damper": Rule(("gain",), "roll", ("time_constant",)),
    "yaw_damper": Rule(("gain",), "dutch_roll", ("zeta",)),
    "spiral_stabilization": Rule(("gain",), "spiral", ("time_constant",)),
}


def wishes_of(loop: Loop, rule: Rule) -> Mapping[str, float]:
    """What is wished of the loop. Raises SpecError for what cannot be wished of such a law."""
    for name, value in loop.wishes.items():
        if name not in rule.wishes:
            raise SpecError(f"{loop.name} cannot be designed for {name}: it can for {', '.join(rule.wishes)}.")
        if value <= 0.0:
            raise SpecError(f"{loop.name} cannot be designed for {name} {value:g}: it must be positive.")
    if len(rule.gains) == 1 and loop.wishes.get("zeta", 0.0) >= 1.0:
        raise SpecError(
            f"{loop.name} cannot be designed for zeta {loop.wishes['zeta']:g}: an oscillation has less than 1."
        )
    return loop.wishes


def fair_wish(mode: str, quantity: Quantity, has: float) -> float:
    """What a law named bare is designed for: well damped or quick, and a good deal better than the bare aircraft."""
    if quantity == "zeta":
        least = 0.7 if mode == "short_period" else 0.4
        return min(max(least, 1.5 * has), 0.95)
    return min(20.0 if mode == "spiral" else 1.0, 0.5 * has)
