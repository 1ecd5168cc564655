"""How large an integrator's step may be before a stable aircraft becomes an unstable simulation.

Reference: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2: a mode of eigenvalue
lambda decays if |R(h lambda)| <= 1, R being the method's stability function.
"""

from collections.abc import Sequence

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
    limits = [(h, mode) for mode in modes if mode.eigenvalue.real < 0.0 and (h := _limit(method, mode.eigenvalue))]
    return min(limits, key=lambda found: found[0], default=None)


def _limit(method: Tableau, eigenvalue: complex) -> float | None:
    """The first step at which |R| exceeds one, by walking outward in steps of the mode's own time and then halving."""
    unit = 1.0 / abs(eigenvalue)
    if unit > COARSEST:
        return None

    def grows(h: float) -> bool:
        return abs(stability_function(method, h * eigenvalue)) > 1.0

    outside = next((k * unit * 0.02 for k in range(1, GRID) if grows(k * unit * 0.02)), None)
    if outside is None:
        return None
    low, high = outside - 0.02 * unit, outside
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if grows(middle) else (middle, high)
    return low
