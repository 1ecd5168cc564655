"""Natural modes: eigenvalues, named by which states take part in them.

Naming by size or by order fails as soon as a derivative is edited: with Cm_alpha > 0 the short period splits into two
real roots, and one of them joins a phugoid root in a new oscillation. So each root is given to the family of modes
whose states take most part in it, by participation factors, which do not depend on the units of the states.

Reference: I. J. Perez-Arriaga, G. C. Verghese, F. C. Schweppe, IEEE Trans. Power Apparatus and Systems PAS-101 (1982)
3117-3125, for participation factors; Etkin and Reid, Dynamics of Flight, 3rd ed., sections 6.2 and 6.8, for the modes.
"""

import math
from dataclasses import asdict, dataclass
from itertools import permutations
from typing import Any, Literal

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.linearize import linear_model
from fdes.control import LinearModel
from fdes.physics.derivatives import Form

Axis = Literal["longitudinal", "lateral"]

# The families of each axis, and the states they live in. A family has as many roots as states.
FAMILIES: dict[Axis, dict[str, tuple[str, ...]]] = {
    "longitudinal": {"short_period": ("w", "q"), "phugoid": ("u", "theta")},
    "lateral": {"roll": ("p",), "dutch_roll": ("beta", "r"), "spiral": ("phi",)},
}
# The share of its states that a family must have in an oscillation to call it its own. The phugoid and the short period
# hardly mix before they merge; roll rate takes part in every Dutch roll.
OWN: dict[Axis, float] = {"longitudinal": 0.75, "lateral": 0.5}
# What an oscillation is called when its two roots come from two families.
MERGED = {
    frozenset({"short_period", "phugoid"}): "third_oscillatory",
    frozenset({"roll", "spiral"}): "roll_spiral",
    frozenset({"roll", "dutch_roll"}): "roll_dutch_roll",
    frozenset({"spiral", "dutch_roll"}): "spiral_dutch_roll",
}


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

    def _repr_html_(self) -> str:
        """The mode as a table, for notebooks."""
        value = f"{self.eigenvalue.real:.4g}" + (f" \u00b1 {self.eigenvalue.imag:.4g}i" if self.oscillatory else "")
        rows = [
            ("eigenvalue", value, "rad/s"),
            ("omega_n", f"{self.omega_n:.4g}", "rad/s"),
            ("zeta", f"{self.zeta:.4g}", ""),
        ]
        for name in ("time_constant", "time_to_half", "time_to_double", "period"):
            seconds = getattr(self, name)
            rows += [] if seconds is None else [(name, f"{seconds:.4g}", "s")]
        share = ", ".join(f"{state} {part:.0%}" for state, part in self.participation.items())
        body = "".join(f"<tr><th>{name}</th><td>{value} {unit}</td></tr>" for name, value, unit in rows)
        caption = f"{self.name.replace('_', ' ')}, {self.axis}: {share}"
        return f"<table><caption>{caption}</caption>{body}</table>"


def modes(of: LinearModel | FlightCondition, form: Form = "full") -> list[Mode]:
    """The modes of a linear model, or of an aircraft in a flight condition in the given form of its equations.

    Longitudinal modes come first; within an axis the fastest first. Heading, position and height are integrals of the
    states and no modes.
    """
    model = of if isinstance(of, LinearModel) else linear_model(of, form)
    return [*_axis_modes("longitudinal", model.longitudinal()), *_axis_modes("lateral", model.lateral())]


@dataclass(frozen=True)
class _Root:
    """An eigenvalue with nonnegative imaginary part, and the share of each state in it."""

    value: complex
    shares: dict[str, float]


def _axis_modes(axis: Axis, model: LinearModel) -> list[Mode]:
    roots = _roots(model)
    families = FAMILIES[axis]
    places = [family for family, states in families.items() for _ in states]

    def share(family: str, root: _Root) -> float:
        return sum(root.shares[s] for s in families[family])

    def most_of_its_own(root: _Root) -> float:
        return max(share(f, root) for f, states in families.items() if len(states) == 2)

    named: list[tuple[str, _Root]] = []
    for pair in sorted((r for r in roots if r.value.imag > 0.0), key=most_of_its_own, reverse=True):
        first, *others = sorted(dict.fromkeys(places), key=lambda f: share(f, pair), reverse=True)
        own = places.count(first) == 2 and (not others or share(first, pair) >= OWN[axis])
        taken = (first, first) if own else (first, others[0])
        named.append((first if own else MERGED[frozenset(taken)], pair))
        for family in taken:
            places.remove(family)
    reals = [r for r in roots if r.value.imag == 0.0]
    best = max(permutations(reals), key=lambda order: sum(map(share, places, order)))
    named += _real_modes(list(zip(places, best, strict=True)))
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


def _real_modes(by_family: list[tuple[str, _Root]]) -> list[tuple[str, _Root]]:
    """The real roots by name. Those of an oscillation that has split are its faster and its slower half; where only one
    half is real, the other has merged elsewhere: the short period leaves its faster half, the phugoid its slower.
    """
    reals = sorted(by_family, key=lambda n: -abs(n[1].value))
    families = [family for family, _ in reals]
    named = []
    for i, (family, root) in enumerate(reals):
        if family in {"roll", "spiral"}:
            named.append((family, root))
        elif families.count(family) == 2:
            named.append((f"{family}_{'fast' if family in families[i + 1 :] else 'slow'}", root))
        else:
            named.append((f"{family}_{'slow' if family == 'phugoid' else 'fast'}", root))
    return named


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
