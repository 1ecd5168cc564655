"""Sensors that lag and a computer that is late: what the laws inside measure comes late."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite
from typing import Any, NamedTuple

import numpy as np

from fdes.control.blocks import Delay, Lag, Past, StateSpace, series
from fdes.control.law import STICKS, UNITS, Law, Stick
from fdes.control.linear import LinearModel
from fdes.errors import SpecError
from fdes.physics.signals import Outputs, Surfaces
from fdes.units import Second

__all__ = ["Sensors"]


class Sensed(NamedTuple):
    """What is remembered of one signal: its lagged value, None without a lag, and its past, the newest first."""

    lagged: float | None
    past: Past


class Memory(NamedTuple):
    """What the law inside remembers, and each signal that it measures, in the order of its inputs."""

    inner: Any
    sensed: tuple[Sensed, ...]


@dataclass(frozen=True)
class Sensors:
    """Whatever the law inside measures is lagged by 1 / (`lag` s + 1), then comes `delay` late; the stick does not.

    Say it last: laws said after it measure without either. Flown, the delay is exact in whole frames, and between two
    frames lies on the straight line between them; continuous, it is its second-order Pade approximation, good to a
    phase of 1 deg up to omega delay = 1.7. It starts with what is measured having been so for long.
    """

    inner: Law
    lag: Second = 0.0
    delay: Second = 0.0

    def __post_init__(self) -> None:
        """Refuse what is no time. Raises SpecError."""
        if not (isfinite(self.lag) and self.lag >= 0.0):
            raise SpecError(f"The lag of the sensors is {self.lag:g} s; it must be zero or more, such as 0.02 s.")
        Delay(self.delay)

    @cached_property
    def measured(self) -> tuple[str, ...]:
        """The outputs that the law inside measures."""
        return tuple(name for name in self.inner.linear().inputs if name not in STICKS)

    def start(self, y: Outputs, stick: Stick) -> Memory:
        """Every sensor at rest."""
        return Memory(self.inner.start(y, stick), tuple(self._rest(getattr(y, name)) for name in self.measured))

    def step(self, y: Outputs, stick: Stick, memory: Memory, dt: float) -> tuple[Surfaces, Memory]:
        """The law inside, of what its sensors say."""
        late, sensed = {}, []
        for name, one in zip(self.measured, memory.sensed, strict=True):
            late[name], now = self._sense(getattr(y, name), one, dt)
            sensed.append(now)
        command, inner = self.inner.step(y._replace(**late), stick, memory.inner, dt)
        return command, Memory(inner, tuple(sensed))

    def linear(self, dt: float | None = None) -> LinearModel:
        """The law inside behind a lag and a delay for each signal that it measures."""
        late = Delay(self.delay).linear(dt)
        sensor, lagged = (series(Lag(self.lag).linear(dt), late), ["lag"]) if self.lag else (late, [])
        return _behind(self.inner.linear(dt), self.measured, sensor, lagged)

    def _rest(self, u: float) -> Sensed:
        return Sensed(u if self.lag else None, Delay(self.delay).start(u))

    def _sense(self, u: float, memory: Sensed, dt: float) -> tuple[float, Sensed]:
        lagged = None
        if self.lag:  # one that is put in while flying begins at rest
            u, lagged = Lag(self.lag).step(u, u if memory.lagged is None else memory.lagged, dt)
        late, past = Delay(self.delay).step(u, memory.past, dt)
        return late, Sensed(lagged, past)


def _behind(law: LinearModel, measured: tuple[str, ...], sensor: StateSpace, first: list[str]) -> LinearModel:
    """`law` with a sensor before each measured input. `first` names the sensor's states before those of its delay."""
    n, k, signals = len(law.states), len(sensor.A), len(measured)
    seen = [law.inputs.index(name) for name in measured]
    size = n + k * signals
    A, B = np.zeros((size, size)), np.zeros((size, len(law.inputs)))
    C, D = np.zeros((len(law.outputs), size)), law.D.copy()
    A[:n, :n], B[:n], C[:, :n] = law.A, law.B, law.C
    names: list[str] = []
    units: dict[str, str] = {}
    for i, (column, signal) in enumerate(zip(seen, measured, strict=True)):
        own = slice(n + k * i, n + k * (i + 1))
        A[own, own], B[own, column] = sensor.A, sensor.B
        A[:n, own], B[:n, column] = np.outer(law.B[:, column], sensor.C), law.B[:, column] * sensor.D
        C[:, own], D[:, column] = np.outer(law.D[:, column], sensor.C), law.D[:, column] * sensor.D
        kinds = [*first, *(f"delay_{j + 1}" for j in range(k - len(first)))]
        names += [f"{signal}_{kind}" for kind in kinds]
        units |= {f"{signal}_{kind}": UNITS[signal] for kind in kinds}
    return replace(law, A=A, B=B, C=C, D=D, states=(*law.states, *names), units=law.units | units)
