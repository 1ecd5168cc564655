"""How large an integrator's step may be before a stable aircraft becomes an unstable simulation.

Reference: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2: a mode of eigenvalue
lambda decays if |R(h lambda)| <= 1, R being the method's stability function.
"""

from collections.abc import Sequence
from functools import lru_cache
from itertools import takewhile

from fdes.analysis.modes import Mode
from fdes.physics.runge_kutta import Tableau, stability_function
from fdes.physics.small_perturbation import ExactHold

COARSEST = 1000.0  # s: a step that no mode forbids up to here is forbidden by none
GRID = 400


def step_limit(method: Tableau | ExactHold, modes: Sequence[Mode]) -> tuple[float, Mode] | None:
    """The largest step [s] at which every stable mode still decays, and the mode that sets it.

    None where no step makes a stable mode grow: for the exact hold, and where no mode is stable. The limit is the first
    step at which a mode stops decaying; beyond it some methods have islands of stability, which nobody should use.
    """
    if isinstance(method, ExactHold):
        return None
    found: tuple[float, Mode] | None = None
    for mode in sorted(modes, key=lambda each: -abs(each.eigenvalue)):  # the fastest first: it is likely to be the one
        if mode.eigenvalue.real < 0.0:
            h = _limit(method, mode.eigenvalue, found[0] if found else COARSEST)
            found = found if h is None or (found and found[0] <= h) else (h, mode)
    return found


@lru_cache(maxsize=256)  # with each edit of an aircraft most of its modes stay
def _limit(method: Tableau, eigenvalue: complex, highest: float) -> float | None:
    """The first step up to about `highest` at which |R| exceeds one, walking outward in steps of the mode's time and
    then halving.
    """
    unit = 1.0 / abs(eigenvalue)
    if unit > COARSEST:
        return None

    def grows(h: float) -> bool:
        return abs(stability_function(method, h * eigenvalue)) > 1.0

    walk = takewhile(lambda h: h <= highest + 0.02 * unit, (k * unit * 0.02 for k in range(1, GRID)))
    outside = next(filter(grows, walk), None)
    if outside is None:
        return None
    low, high = outside - 0.02 * unit, outside
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if grows(middle) else (middle, high)
    return low
