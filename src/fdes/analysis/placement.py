"""Gains that put a root where it is wanted: one gain by following the root, two by solving for them.

A closed loop is affine in its gains, A(K) = A0 + K1 A1 + K2 A2, in s and, sampled, in z. What is wanted is always said
of s, a root z being ln(z) / dt.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from fdes.control import LinearModel

Array = NDArray[np.float64]
Roots = NDArray[np.complex128]
Quantity = Literal["zeta", "omega", "time_constant"]

REACH = np.concatenate([[0.0], np.geomspace(1e-3, 1e2, 600)])  # of the gain that moves the root by its own size
SLOWEST = 0.1  # rad/s: a root slower than this is taken to be this far from the origin
HALVINGS = 60
STEPS = 200  # of the way from no loop to one
MARGIN = 0.5  # of the gain at which some root begins to grow: 6 dB
GROWING = 1e-6  # rad/s: less is rounding


def measure(s: complex, quantity: Quantity) -> float:
    """Damping ratio, natural frequency [rad/s], time constant [s], infinite if it does not decay."""
    if quantity == "zeta":
        return -s.real / abs(s) if s else 0.0
    if quantity == "omega":
        return abs(s)
    return -1.0 / s.real if s.real < 0.0 else float("inf")


def continuous_roots(A: Array, dt: float | None) -> Roots:
    """The roots as those of continuous time [rad/s], of one matrix or of many."""
    return _continuous(np.linalg.eigvals(A), dt)


def nearest_root(model: LinearModel, s: complex) -> complex:
    """The root of `model` that is nearest to `s`."""
    roots = continuous_roots(model.A, model.dt)
    return complex(roots[np.argmin(np.abs(roots - s))])


def followed_root(without: LinearModel, closed: LinearModel, root: complex) -> complex:
    """What becomes of a root of the loop with gains of zero when they grow together to those of `closed`."""
    added, dt = closed.A - without.A, without.dt
    least = REACH[1] * min(1.0, _gain_of_its_size(without.A, added, dt, root))  # a great gain moves it far at first
    share = np.concatenate([[0.0], np.geomspace(least, 1.0, STEPS)])
    roots = continuous_roots(without.A + share[:, None, None] * added, dt)
    return nearest_root(closed, complex(_followed(roots, root)[-1]))


@dataclass(frozen=True)
class Found:
    """A gain and the root it gives [rad/s]. reached: whether that is what was wanted, or else the best there is.

    limit: twice this gain makes some root grow; infinite where none does.
    """

    gain: float
    root: complex
    reached: bool
    limit: float


def one_gain(closed: Callable[[float], LinearModel], root: complex, quantity: Quantity, wanted: float) -> Found:
    """The smallest positive gain at which the mode that begins at `root` has what is wanted.

    `closed` is the loop for a gain. The mode is followed from gain 0 upward. Where it never gets there, the answer is
    the gain at which it comes nearest; a mode that is better without the loop is left alone, at gain 0. No gain is
    taken that leaves less than 6 dB, a factor of two, to where some root grows that did not grow as fast without.
    """
    none, one = closed(0.0), closed(1.0)
    A0, A1, dt = none.A, one.A - none.A, none.dt
    gains = REACH * _gain_of_its_size(A0, A1, dt, root)
    roots = continuous_roots(A0 + gains[:, None, None] * A1, dt)
    fastest = roots.real.max(axis=1)
    grows = fastest > max(float(fastest[0]), 0.0) + GROWING
    limit = MARGIN * float(gains[grows.argmax()]) if grows.any() else float("inf")
    path = _followed(roots[gains <= limit], root)
    sign = -1.0 if quantity == "time_constant" else 1.0  # more is better, but of a time less
    shown = sign * np.array([measure(s, quantity) for s in path])
    there = shown >= sign * wanted
    if not there.any() or there[0]:
        k = 0 if there[0] else int(shown.argmax())
        return Found(float(gains[k]), complex(path[k]), False, limit)
    k = int(there.argmax())
    low, high, s = float(gains[k - 1]), float(gains[k]), complex(path[k - 1])

    def at(gain: float) -> complex:
        there = continuous_roots(A0 + gain * A1, dt)
        return complex(there[np.argmin(np.abs(there - s))])

    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if sign * measure(at(middle), quantity) >= sign * wanted:
            high = middle
        else:
            low, s = middle, at(middle)
    return Found(high, at(high), True, limit)


def two_gains(closed: Callable[[float, float], LinearModel]) -> Callable[[complex], tuple[float, float] | None]:
    """For a root s [rad/s], the two gains that make it and its conjugate roots of the loop; None where no gains do.

    Both feed one surface, so that det(s I - A(K)) is linear in them: one complex equation for two real gains.
    """
    none, only_first, only_second = closed(0.0, 0.0), closed(1.0, 0.0), closed(0.0, 1.0)
    dt, identity = none.dt, np.eye(len(none.A))

    def gains(s: complex) -> tuple[float, float] | None:
        root = s if dt is None else np.exp(s * dt)
        sign, log = np.linalg.slogdet([root * identity - m.A for m in (none, only_first, only_second)])
        first, second = (complex(1.0 - sign[k] / sign[0] * np.exp(log[k] - log[0])) for k in (1, 2))
        equations = np.array([[first.real, second.real], [first.imag, second.imag]])
        if abs(np.linalg.det(equations)) < 1e-12 * np.abs(equations).max() ** 2:
            return None
        one, two = np.linalg.solve(equations, [1.0, 0.0])
        return float(one), float(two)

    return gains


def stable(model: LinearModel, beyond: Sequence[complex] = ()) -> bool:
    """Whether no root grows, but for those as fast as the fastest growing `beyond`."""
    allowed = max([0.0, *[s.real for s in beyond]])
    return bool(continuous_roots(model.A, model.dt).real.max() <= allowed + GROWING)


def _gain_of_its_size(A0: Array, A1: Array, dt: float | None, root: complex) -> float:
    """The gain that would move the root by its own size, at the speed at which it begins to move."""
    values, right = np.linalg.eig(A0)
    k = int(np.argmin(np.abs(_continuous(values, dt) - root)))
    turned, left = np.linalg.eig(A0.T)  # not the inverse of `right`: a delay of several frames has none
    y, x = left[:, int(np.argmin(np.abs(turned - values[k])))], right[:, k]
    speed = abs(y @ A1 @ x) / max(abs(y @ x), 1e-300)
    speed = speed if dt is None else speed / dt / abs(values[k])
    return float(max(abs(root), SLOWEST) / speed) if speed > 1e-12 else 1.0


def _continuous(values: Any, dt: float | None) -> Roots:
    if dt is None:
        return np.asarray(values, dtype=complex)
    with np.errstate(divide="ignore"):  # the logarithm of what is over within a frame
        return np.asarray(np.log(np.abs(values)) / dt + 1j * np.angle(values) / dt)


def _followed(roots: Roots, root: complex) -> Roots:
    """The path of one root: at each gain the root nearest to where it was."""
    path = np.empty(len(roots), dtype=complex)
    for k, here in enumerate(roots):
        root = here[np.argmin(np.abs(here - root))]
        path[k] = root
    return path
