"""What a root of a linear model is called: by which states take part in it.

Naming by size or by order fails as soon as a derivative is edited: with Cm_alpha > 0 the short period splits into two
real roots, and one of them joins a phugoid root in a new oscillation. So each root is given to the family of modes
whose states take most part in it, by participation factors, which do not depend on the units of the states. What a
control law, an actuator or a sensor remembers is a family of its own, named as the state is.

Reference: I. J. Perez-Arriaga, G. C. Verghese, F. C. Schweppe, IEEE Trans. Power Apparatus and Systems PAS-101 (1982)
3117-3125, for participation factors; Etkin and Reid, Dynamics of Flight, 3rd ed., sections 6.2 and 6.8, for the modes.
"""

import re
from collections import Counter
from collections.abc import Callable
from functools import cache
from typing import Literal, NamedTuple

import numpy as np

from fdes.control import LinearModel

Axis = Literal["longitudinal", "lateral"]

# The families of each axis, and the states they live in. A family has as many roots as states.
FAMILIES: dict[Axis, dict[str, tuple[str, ...]]] = {
    "longitudinal": {"short_period": ("w", "q"), "phugoid": ("u", "theta")},
    "lateral": {"roll": ("p",), "dutch_roll": ("beta", "r"), "spiral": ("phi",)},
}
MERGING = tuple(FAMILIES["longitudinal"])  # the faster first
OSCILLATIONS = {name for axis in FAMILIES.values() for name, states in axis.items() if len(states) == 2}
# The share of the airframe's part of an oscillation that a family must have to call it its own. The phugoid and the
# short period hardly mix before they merge; roll rate takes part in every Dutch roll.
OWN = {"short_period": 0.75, "phugoid": 0.75, "dutch_roll": 0.5}
OWN_OF_OTHERS = 0.5  # an oscillating actuator, of all
# What an oscillation is called when its two roots come from two families; those not listed have both names.
MERGED = {
    frozenset({"short_period", "phugoid"}): "third_oscillatory",
    frozenset({"roll", "spiral"}): "roll_spiral",
    frozenset({"roll", "dutch_roll"}): "roll_dutch_roll",
    frozenset({"spiral", "dutch_roll"}): "spiral_dutch_roll",
}
COUPLED = 1e-12  # below this an entry of A is rounding
ROUNDING = 1e-13  # of the fastest root, or of the frames in a second: a root below it is zero
GONE = 1e-4  # of a sampled root: what is less has settled within a frame, and is no mode


class Root(NamedTuple):
    """A root as an eigenvalue of continuous time [rad/s], its imaginary part not negative; each state's share in it.

    pair: it stands for two, a conjugate pair.
    """

    value: complex
    shares: dict[str, float]
    pair: bool


class NamedRoot(NamedTuple):
    """A root, what it is called, and to which axis it belongs."""

    name: str
    axis: Axis
    root: Root


def named_roots(model: LinearModel) -> list[NamedRoot]:
    """All roots with their names, longitudinal ones first, within an axis the fastest first.

    A law may couple the two axes: then a root belongs to the axis that has the greater part of it. The roots z of a
    sampled model are shown as ln(z) / dt; those that settle within a frame are left out.
    """
    parts = _axes_of(model)
    coupled = len(parts) == 1
    found = []
    for axis, states in parts.items():
        families = _families(states)
        for name, root in _named(_roots(model, states), families):
            found.append(NamedRoot(name, _axis(root) if coupled else axis, root))
    found.sort(key=lambda n: (n.axis == "lateral", -abs(n.root.value)))
    return _numbered(found)


def decoupled(model: LinearModel, mode: str) -> LinearModel:
    """The axis of `model` to which the mode belongs, with what a law remembers; all of it, where a law couples them."""
    states = states_beside(model, mode)
    return model.part(states, model.inputs)


def states_beside(model: LinearModel, mode: str) -> tuple[str, ...]:
    """The states of that axis."""
    axis: Axis = "longitudinal" if mode in FAMILIES["longitudinal"] else "lateral"
    return _axes_of(model).get(axis, model.states)


def _axes_of(model: LinearModel) -> dict[Axis, tuple[str, ...]]:
    """The states of each axis, what a law or an actuator remembers with them; all of them in one, if they couple."""
    longitudinal, lateral = (_reached(model, families) for families in FAMILIES.values())
    if longitudinal & lateral:
        return {"longitudinal": model.states}
    return {
        "longitudinal": tuple(s for s in model.states if s not in lateral),
        "lateral": tuple(s for s in model.states if s in lateral),
    }


def _reached(model: LinearModel, families: dict[str, tuple[str, ...]]) -> set[str]:
    """All states that have to do with those of the families, directly or by way of others."""
    coupled = np.abs(model.A) > COUPLED
    reached = {model.states.index(s) for states in families.values() for s in states}
    waiting = list(reached)
    while waiting:
        k = waiting.pop()
        more = {int(j) for j in np.flatnonzero(coupled[k] | coupled[:, k])} - reached
        reached |= more
        waiting += more
    return {model.states[k] for k in reached}


def _families(states: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    """The families that live in these states: the airframe's, then one for whatever else remembers something."""
    own = {name: members for axis in FAMILIES.values() for name, members in axis.items() if set(members) <= set(states)}
    others: dict[str, tuple[str, ...]] = {}
    for state in states:
        if not any(state in members for members in own.values()):
            family = re.sub(r"(_rate|_\d+)$", "", state)
            others[family] = (*others.get(family, ()), state)
    return own | others


def _named(roots: list[Root], families: dict[str, tuple[str, ...]]) -> list[tuple[str, Root]]:
    """Give each root a place in a family, oscillations first, the purest of them before the others."""
    places = [family for family, states in families.items() for _ in states]
    pairs = [root for root in roots if root.pair]
    airframe = {s for axis in FAMILIES.values() for family in axis if family in families for s in families[family]}

    def share(family: str, root: Root) -> float:
        return sum(root.shares[s] for s in families[family])

    def is_own(family: str, root: Root) -> bool:
        """Whether the family has enough of the airframe's part, or of all where it is no family of the airframe.

        And no other oscillation would be the better half of it: with Cn_beta about zero yaw rate oscillates with roll
        rate, and sideslip with bank; neither is a Dutch roll.
        """
        if family not in OWN:
            return share(family, root) >= OWN_OF_OTHERS
        return share(family, root) >= OWN[family] * airframes(root) and not any(
            root.shares[state] + other.shares[theirs] < root.shares[theirs] + other.shares[state]
            for other in pairs
            for state in families[family]
            for theirs in airframe - set(families[family])
        )

    def airframes(root: Root) -> float:
        return sum(root.shares[state] for state in airframe)

    def most_of_its_own(root: Root) -> float:
        return max(share(f, root) for f, states in families.items() if len(states) == 2)

    named: list[tuple[str, Root]] = []
    for pair in sorted(pairs, key=most_of_its_own, reverse=True):
        first, *others = sorted(dict.fromkeys(places), key=lambda f: share(f, pair), reverse=True)
        own = places.count(first) >= 2 and (not others or is_own(first, pair))
        taken = (first, first) if own else (first, others[0])
        both = "_".join(sorted(taken, key=list(families).index))
        named.append((first if own else MERGED.get(frozenset(taken), both), pair))
        for family in taken:
            places.remove(family)
    reals = [r for r in roots if not r.pair]
    return [*named, *_real_roots(_placed(reals, places, share), families)]


def _placed(reals: list[Root], places: list[str], share: Callable[[str, Root], float]) -> list[tuple[str, Root]]:
    """Each real root in one place, so that the shares add up to as much as they can."""

    @cache
    def best(k: int, left: frozenset[int]) -> tuple[float, tuple[tuple[int, int], ...]]:
        """The best that places `k` and later can do with the roots that are left."""
        if not left:
            return 0.0, ()
        options = []
        for r in sorted(left):
            score, chosen = best(k + 1, left - {r})
            options.append((score + share(places[k], reals[r]), ((k, r), *chosen)))
        if len(places) - k > len(left):
            options.append(best(k + 1, left))
        return max(options, key=lambda o: o[0])

    return [(places[k], reals[r]) for k, r in best(0, frozenset(range(len(reals))))[1]]


def _real_roots(placed: list[tuple[str, Root]], families: dict[str, tuple[str, ...]]) -> list[tuple[str, Root]]:
    """The real roots by name. Those of an oscillation that has split are its faster and its slower half; where only one
    half is real, the other has merged elsewhere: the short period leaves its faster half, the phugoid its slower.
    """
    reals = sorted(placed, key=lambda n: -abs(n[1].value))
    left = [family for family, _ in reals if family in MERGING]
    if len(left) == len(set(left)) == 2:  # one half of each
        in_order = iter(MERGING)
        reals = [(next(in_order) if family in MERGING else family, root) for family, root in reals]
    all_of_them = [family for family, _ in reals]
    named = []
    for i, (family, root) in enumerate(reals):
        if len(families[family]) != 2:
            named.append((family, root))
        elif all_of_them.count(family) == 2:
            named.append((f"{family}_{'fast' if family in all_of_them[i + 1 :] else 'slow'}", root))
        else:
            named.append((f"{family}_{'slow' if family == 'phugoid' else 'fast'}", root))
    return named


def _numbered(found: list[NamedRoot]) -> list[NamedRoot]:
    """The second root of one name, as a long delay has them, becomes name_2."""
    seen: Counter[str] = Counter()
    unique = []
    for named in found:
        seen[named.name] += 1
        count = seen[named.name]
        unique.append(named if count == 1 else named._replace(name=f"{named.name}_{count}"))
    return unique


def _axis(root: Root) -> Axis:
    part = {
        axis: sum(root.shares[s] for states in families.values() for s in states) for axis, families in FAMILIES.items()
    }
    return "longitudinal" if part["longitudinal"] >= part["lateral"] else "lateral"


def _roots(model: LinearModel, states: tuple[str, ...]) -> list[Root]:
    rows = [model.states.index(s) for s in states]
    values, right = np.linalg.eig(model.A[np.ix_(rows, rows)])
    try:
        left = np.linalg.inv(right)
    except np.linalg.LinAlgError:
        # A repeated root has too few eigenvectors: who takes part is then read from the right ones alone.
        left = right.conj().T
    weights = np.abs(right * left.T)
    weights /= weights.sum(axis=0)
    least = ROUNDING * (float(np.abs(values).max()) if model.dt is None else 1.0 / model.dt)
    return [
        Root(
            s if abs(s) > least else 0j,
            {state: float(w) for state, w in zip(states, column, strict=True)},
            v.imag > 0.0,
        )
        for v, column in zip(values, weights.T, strict=True)
        if v.imag >= 0.0 and (s := _continuous(complex(v), model.dt)) is not None
    ]


def _continuous(value: complex, dt: float | None) -> complex | None:
    """The eigenvalue of continuous time: ln(z) / dt of a sampled one, None where that has settled within a frame."""
    if dt is None:
        return value
    return complex(np.log(value) / dt) if abs(value) > GONE else None
