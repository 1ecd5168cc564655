"""A flight that is known in advance, whole: the linear plant as a recursion, all frames at once.

With its commands scheduled, a fixed-step method on linear equations is x_next = R x + S u, R the method's stability
function of hA. `fly` defines the flight; one test holds the two together on all integrators and forms.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from fdes.control import Stick
from fdes.errors import Departed
from fdes.flight.excitation import Excitation, Gusts, blown
from fdes.flight.recorder import columns_of
from fdes.flight.recording import Recording
from fdes.flight.simulation import BOUND, Clock
from fdes.physics.signals import Air, Surfaces
from fdes.physics.small_perturbation import (
    ExactHold,
    PerturbationState,
    SmallPerturbation,
    advance,
    derivative,
    observe,
)

Array = NDArray[np.float64]

LINEAR = 9  # the first nine states are linear in themselves; north, east and height follow from them
NOWHERE = PerturbationState()
HUGE = 1e100


def trajectory(
    plant: SmallPerturbation,
    start: PerturbationState,
    clock: Clock,
    stick: Stick,
    excitation: Excitation,
    air: Air | None = None,
) -> Recording:
    """The recording of a flight of `clock.duration` from `start`: the stick still, the surfaces at trim but for
    `excitation`, the throttle where the stick has it; its gusts come on top of a steady `air`. Raises Departed when a
    state leaves what numbers can hold.
    """
    times = np.array(list(clock))
    gusts = Gusts(*np.array(excitation.gusts_over(times.tolist())))
    air = _each(blown(air or Air(), gusts, plant.reference.V), lambda part: np.broadcast_to(part, times.shape))
    added = np.array(excitation.over(times.tolist())).T
    commands = added + np.array(Surfaces(throttle=stick.throttle))
    held = np.vstack([[plant.trim()], commands[:-1]])
    limited = np.clip(commands, plant.limits.lower, plant.limits.upper)
    every = clock.substeps
    inner = np.repeat(limited, every, axis=0)
    x = _states(plant, start, inner, _each(air, lambda part: np.repeat(part, every)), clock.dt / every)[::every][
        : len(times)
    ]
    _must_be_finite(x, times)
    feel = Surfaces(*np.clip(held, plant.limits.lower, plant.limits.upper).T)
    shown = observe(plant, PerturbationState(*x.T), feel, air)
    count = len(times)
    parts = [times, *shown, *stick, *added.T, *held.T, *commands.T, *x.T, *air]
    data = np.column_stack([np.broadcast_to(part, count) for part in parts])
    return Recording({}, columns_of(PerturbationState), data, (), complete=True)


def _states(plant: SmallPerturbation, start: PerturbationState, commands: Array, air: Air, h: float) -> Array:
    """The state at the start of every step of length `h`, shape (steps, 12)."""
    R, S, G = _recursion(plant, h)
    pushed = (commands - plant.trim()) @ S.T + np.array(air).T @ G.T
    x = np.empty((len(commands), len(NOWHERE)))
    x[0] = start
    with np.errstate(over="ignore", invalid="ignore"):  # a flight that departs is found afterwards
        x[:, :LINEAR] = _recur(R, np.vstack([x[0, :LINEAR], pushed[:-1]]))
        moved = _displacements(plant, x[:-1], commands[:-1], _each(air, lambda part: part[:-1]), h)
        x[1:, LINEAR:] = x[0, LINEAR:] + np.cumsum(moved, axis=0)
    return x


def _recur(R: Array, given: Array) -> Array:
    """x_k = R x_(k-1) + given_k for all k, by doubling: after pass n each row holds its last 2^n terms.

    W. D. Hillis, G. L. Steele, Communications of the ACM 29 (1986) 1170-1183. Ten times as fast as row by row, which is
    done only where the powers of R are about to overflow.
    """
    x, power, reach = given.copy(), R.T, 1
    while reach < len(x):
        if np.abs(power).max() > HUGE:
            return _row_by_row(R, given)
        x[reach:] += x[:-reach] @ power
        power, reach = power @ power, 2 * reach
    return x


def _row_by_row(R: Array, given: Array) -> Array:
    x = given.copy()
    for k in range(1, len(x)):
        x[k] += R @ x[k - 1]
    return x


def _each(air: Air, change: Callable[[Array], Array]) -> Air:
    """The columns of `air`, changed in the same way."""
    return Air(*map(change, air))  # type: ignore[arg-type]  # whole columns


def _recursion(plant: SmallPerturbation, h: float) -> tuple[Array, Array, Array]:
    """R, S and G: what one step makes of states, surfaces and air, asked of the plant about one of them at a time."""

    def after(x: PerturbationState, held: Surfaces, blown: Air) -> Array:
        return np.array(advance(plant, x, held, blown, h, 1)[:LINEAR])

    trim, calm = plant.trim(), Air()
    R = [after(NOWHERE._replace(**{name: 1.0}), trim, calm) for name in NOWHERE._fields[:LINEAR]]
    S = [after(NOWHERE, trim._replace(**{n: v + 1.0}), calm) for n, v in trim._asdict().items()]
    G = [after(NOWHERE, trim, calm._replace(**{name: 1.0})) for name in Air._fields]
    return np.column_stack(R), np.column_stack(S), np.column_stack(G)


def _displacements(plant: SmallPerturbation, x: Array, commands: Array, air: Air, h: float) -> Array:
    """How far each step goes north, east and up: the integrator's own quadrature, all steps at once."""
    held = Surfaces(*commands.T)

    def slope(states: Array) -> Array:
        rates = derivative(plant, PerturbationState(*states.T), held, air)
        return np.column_stack([np.broadcast_to(r, len(states)) for r in rates])

    method = plant.integrator
    if isinstance(method, ExactHold):
        then = np.vstack([x[1:], x[-1:]])
        last = _each(air, lambda part: part[-1])
        then[-1, :LINEAR] = advance(plant, PerturbationState(*x[-1]), Surfaces(*commands[-1]), last, h, 1)[:LINEAR]
        return 0.5 * h * (slope(x) + slope(then))[:, LINEAR:]
    slopes: list[Array] = []
    for row in method.a:
        inner = x + h * sum((a * k for a, k in zip(row, slopes, strict=False)), np.zeros_like(x))
        slopes.append(slope(inner))
    return h * sum((b * k for b, k in zip(method.b, slopes, strict=True)), np.zeros_like(x))[:, LINEAR:]


def _must_be_finite(x: Array, times: Array) -> None:
    """As `fly` does it, at the first frame that is out of bounds."""
    out = ~(np.abs(x) < BOUND)
    if out.any():
        k = int(out.any(axis=1).argmax())
        name = PerturbationState._fields[int(out[k].argmax())]
        raise Departed.of(float(times[k]), name, float(x[k, out[k].argmax()]))
