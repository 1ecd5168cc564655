"""Natural modes: eigenvalues, named by which states take part in them.

Naming by size or by order fails as soon as a derivative is edited: with Cm_alpha > 0 the short period splits into two
real roots, and one of them may join a phugoid root in a new oscillation. So each eigenvalue is named by its
participation factors, which do not depend on the units or scaling of the states.

Reference: I. J. Perez-Arriaga, G. C. Verghese, F. C. Schweppe, IEEE Trans. Power Apparatus and Systems PAS-101 (1982)
3117-3125, for participation factors; Etkin and Reid, Dynamics of Flight, 3rd ed., sections 6.2 and 6.8, for the modes.
"""

import math
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.linearize import linear_model
from fdes.control import LinearModel
from fdes.physics.derivatives import Form

Axis = Literal["longitudinal", "lateral"]

# A pair is a third oscillation when neither family of states owns more than this share of it.
MIXED = 0.65


@dataclass(frozen=True)
class Mode:
    """One natural mode. A complex pair is one mode, given by its eigenvalue with positive imaginary part [rad/s].

    omega_n [rad/s]; zeta, for a real root 1 (stable) or -1 (unstable); times [s], None where they do not apply.
    participation: share of each state in the mode, adding up to 1.
    """

    name: str
    axis: Axis
    eigenvalue: complex
    omega_n: float
    zeta: float
    time_constant: float | None
    time_to_half: float | None
    time_to_double: float | None
    period: float | None
    participation: dict[str, float]

    @property
    def oscillatory(self) -> bool:
        """Whether the mode is a complex pair."""
        return self.eigenvalue.imag > 0.0

    def as_dict(self) -> dict[str, Any]:
        """The mode as JSON has it: the eigenvalue is ``[real, imaginary]``."""
        return asdict(self) | {"eigenvalue": [self.eigenvalue.real, self.eigenvalue.imag]}


def modes(of: LinearModel | FlightCondition, form: Form = "full") -> list[Mode]:
    """The modes of a linear model, or of an aircraft in a flight condition in the given form of its equations.

    Longitudinal modes come first; within an axis the fastest first. Heading, position and height are integrals of the
    states and no modes.
    """
    model = of if isinstance(of, LinearModel) else linear_model(of, form)
    return [*_axis_modes("longitudinal", model.longitudinal()), *_axis_modes("lateral", model.lateral())]


@dataclass(frozen=True)
class _Root:
    """An eigenvalue with nonnegative imaginary part, and who takes part in it."""

    value: complex
    shares: dict[str, float]

    def share(self, *states: str) -> float:
        return sum(self.shares[s] for s in states)


def _axis_modes(axis: Axis, model: LinearModel) -> list[Mode]:
    roots = _roots(model)
    pairs = [r for r in roots if r.value.imag > 0.0]
    reals = [r for r in roots if r.value.imag == 0.0]
    named = _longitudinal_names(pairs, reals) if axis == "longitudinal" else _lateral_names(pairs, reals)
    return [_mode(name, axis, root) for name, root in sorted(named, key=lambda n: -abs(n[1].value))]


def _roots(model: LinearModel) -> list[_Root]:
    values, right = np.linalg.eig(model.A)
    try:
        left = np.linalg.inv(right)
    except np.linalg.LinAlgError:
        # A repeated root has too few eigenvectors: who takes part is then read from the right ones alone.
        left = right.conj().T
    weights = np.abs(right * left.T)
    weights /= weights.sum(axis=0)
    return [
        _Root(complex(v), {state: float(w) for state, w in zip(model.states, column, strict=True)})
        for v, column in zip(values, weights.T, strict=True)
        if v.imag >= 0.0
    ]


def _longitudinal_names(pairs: list[_Root], reals: list[_Root]) -> list[tuple[str, _Root]]:
    """Two families: the fast one lives in w and q, the slow one in u and theta."""

    def fast(root: _Root) -> float:
        return root.share("w", "q")

    if len(pairs) == 2:
        slow, quick = sorted(pairs, key=fast)
        return [("short_period", quick), ("phugoid", slow)]
    ranked = sorted(reals, key=fast, reverse=True)
    if len(pairs) == 1:
        (pair,) = pairs
        if fast(pair) > MIXED:
            return [("short_period", pair), *_split("phugoid", ranked)]
        if fast(pair) < 1.0 - MIXED:
            return [("phugoid", pair), *_split("short_period", ranked)]
        quick, slow = ranked
        return [("third_oscillatory", pair), ("short_period_fast", quick), ("phugoid_slow", slow)]
    return [*_split("short_period", ranked[:2]), *_split("phugoid", ranked[2:])]


def _lateral_names(pairs: list[_Root], reals: list[_Root]) -> list[tuple[str, _Root]]:
    """The Dutch roll lives in beta and r; roll and spiral, or what they make together, in p and phi."""

    def yawing(root: _Root) -> float:
        return root.share("beta", "r")

    def rolling(root: _Root) -> float:
        return root.share("p")

    if len(pairs) == 2:
        roll_spiral, dutch = sorted(pairs, key=yawing)
        return [("dutch_roll", dutch), ("roll_spiral", roll_spiral)]
    if len(pairs) == 1:
        (pair,) = pairs
        if yawing(pair) >= 0.5 or max(yawing(r) for r in reals) < 0.5:
            spiral, roll = sorted(reals, key=rolling)
            return [("dutch_roll", pair), ("roll", roll), ("spiral", spiral)]
        return [("roll_spiral", pair), *_split("dutch_roll", reals)]
    ranked = sorted(reals, key=rolling)
    roll = ranked.pop()
    ranked.sort(key=yawing)
    spiral, *dutch_roots = ranked
    return [("roll", roll), ("spiral", spiral), *_split("dutch_roll", dutch_roots)]


def _split(family: str, roots: list[_Root]) -> list[tuple[str, _Root]]:
    """Two real roots of a family whose oscillation has split."""
    slow, quick = sorted(roots, key=lambda r: abs(r.value))
    return [(f"{family}_fast", quick), (f"{family}_slow", slow)]


def _mode(name: str, axis: Axis, root: _Root) -> Mode:
    value = root.value
    sigma, omega = value.real, value.imag
    omega_n = abs(value)
    of_a_real_root = 1.0 if sigma < 0.0 else -1.0
    return Mode(
        name=name,
        axis=axis,
        eigenvalue=value,
        omega_n=omega_n,
        zeta=-sigma / omega_n if omega > 0.0 else of_a_real_root,
        time_constant=-1.0 / sigma if sigma < 0.0 else None,
        time_to_half=-math.log(2.0) / sigma if sigma < 0.0 else None,
        time_to_double=math.log(2.0) / sigma if sigma > 0.0 else None,
        period=2.0 * math.pi / omega if omega > 0.0 else None,
        participation=root.shares,
    )
