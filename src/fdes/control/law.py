"""The contract of a control law: from stick and outputs to surfaces, once per frame, memory passed through.

A law is a frozen dataclass without state of its own. What it remembers it hands back and is handed again, so that a
flight can be reset, branched and replayed by keeping a value.

Laws compose by containment: a law with a field `inner` adds to what the law inside it commands, down to `direct`.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Annotated, Any, NamedTuple, Protocol

import numpy as np

from fdes.control.blocks import StateSpace
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces, channels
from fdes.units import Number

STATIC = StateSpace(np.zeros((0, 0)), np.zeros(0), np.zeros(0), 1.0)


class Stick(NamedTuple):
    """The pilot's controls, in no aircraft's units: -1 to 1, throttle 0 to 1."""

    pitch: Annotated[Number, "stick, aft positive"] = 0.0
    roll: Annotated[Number, "stick, right positive"] = 0.0
    yaw: Annotated[Number, "pedals, right positive"] = 0.0
    throttle: Annotated[Number, "throttle lever"] = 0.0


class Law(Protocol):
    """What a control law offers."""

    def start(self, y: Outputs, stick: Stick) -> Any:
        """The memory with which the law takes over at outputs `y` without a bump: numbers, or tuples of them."""
        ...

    def step(self, y: Outputs, stick: Stick, memory: Any, dt: float) -> tuple[Surfaces, Any]:
        """The surfaces to command for the frame of length `dt` [s] that begins now, and the memory for the next."""
        ...

    def linear(self, dt: float | None = None) -> LinearModel:
        """The law as a linear model from outputs and stick to surfaces, away from its limits.

        Its inputs are those fields of `Outputs` that it measures, and ``stick_pitch`` and so on; its states are what it
        remembers, in the order of its memory. With `dt` [s] it is the Jacobian of `step`, without it what that tends to
        as dt goes to zero.
        """
        ...


def alike(one: Law, other: Law) -> bool:
    """Whether two laws are made of the same parts, whatever their gains: each can go on with the other's memory."""
    inner, outer = getattr(one, "inner", None), getattr(other, "inner", None)
    if type(one) is not type(other) or (inner is None) != (outer is None):
        return False
    return inner is None or outer is None or alike(inner, outer)


SURFACES = Surfaces._fields
STICKS = tuple(c.name for c in channels(Stick, "stick_"))
UNITS = {c.name: c.unit for c in (*channels(Outputs), *channels(Stick, "stick_"), *channels(Surfaces))}


def proportional(gains: Mapping[str, tuple[str, float]], dt: float | None = None) -> LinearModel:
    """The linear model of a law without memory: for each surface, the one stick it follows, and by how much."""
    D = np.zeros((len(SURFACES), len(STICKS)))
    for surface, (stick, gain) in gains.items():
        D[SURFACES.index(surface), STICKS.index(stick)] = gain
    nothing = np.zeros((0, 0))
    units = {name: UNITS[name] for name in (*SURFACES, *STICKS)}
    return LinearModel(
        nothing, np.zeros((0, len(STICKS))), (), STICKS, units, {}, SURFACES, np.zeros((len(SURFACES), 0)), D, dt
    )


def with_loop(
    law: LinearModel,
    signals: Mapping[str, float],
    surface: str,
    block: StateSpace = STATIC,
    states: Mapping[str, str] | None = None,
) -> LinearModel:
    """`law` with one loop more: to `surface` is added what `block` makes of the sum of weight times signal.

    `states` names the block's states and gives their units.
    """
    states = states or {}
    inputs = (*law.inputs, *(s for s in signals if s not in law.inputs))
    n, k, m = len(law.states), len(states), len(inputs)
    weights = np.array([signals.get(name, 0.0) for name in inputs])
    A, B = np.zeros((n + k, n + k)), np.zeros((n + k, m))
    A[:n, :n], A[n:, n:] = law.A, block.A
    B[:n, : len(law.inputs)], B[n:] = law.B, np.outer(block.B, weights)
    C, D = np.zeros((len(SURFACES), n + k)), np.zeros((len(SURFACES), m))
    C[:, :n], D[:, : len(law.inputs)] = law.C, law.D
    row = SURFACES.index(surface)
    C[row, n:] = block.C
    D[row] += block.D * weights
    units = law.units | {name: UNITS[name] for name in inputs} | dict(states)
    return replace(law, A=A, B=B, C=C, D=D, states=(*law.states, *states), inputs=inputs, units=units)


def with_stick_held(law: LinearModel, *sticks: str) -> LinearModel:
    """`law` with these of its sticks centered: what a law does that gives the stick another meaning."""
    free = np.array([name not in sticks for name in law.inputs])
    return replace(law, B=law.B * free, D=law.D * free)
