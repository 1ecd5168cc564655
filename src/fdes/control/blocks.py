"""The blocks that control laws are made of: each steps from frame to frame, and each is linear.

A block is a frozen dataclass: `start(u)` is the memory in which a steady input `u` leaves it at rest, `step(u, memory,
dt)` its output and its next memory, `linear()` its state space. What is continuous by nature is discretized by the
trapezoidal rule (Tustin), which adds no delay of its own; memories are chosen so that they become the states of the
continuous block as dt goes to zero. The pure delay is exact wherever it is a whole number of frames.

Reference: G. F. Franklin, J. D. Powell, M. Workman, Digital Control of Dynamic Systems, 3rd ed., section 6.1.
"""

from dataclasses import dataclass
from math import inf, isfinite
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from fdes.errors import SpecError
from fdes.units import Second

Array = NDArray[np.float64]


class StateSpace(NamedTuple):
    """One input and one output: dx/dt, or x_next, = A x + B u; y = C x + D u. A is (n, n), B and C are (n,)."""

    A: Array
    B: Array
    C: Array
    D: float


def series(first: StateSpace, second: StateSpace) -> StateSpace:
    """The second block of what the first makes of the input; the states of the first, then of the second."""
    n, k = len(first.A), len(second.A)
    A = np.block([[first.A, np.zeros((n, k))], [np.outer(second.B, first.C), second.A]])
    B = np.concatenate([first.B, second.B * first.D])
    return StateSpace(A, B, np.concatenate([second.D * first.C, second.C]), second.D * first.D)


class Past(tuple[float, ...]):
    """Inputs of the past, the newest first: a memory that fills up, and is as long as its delay needs."""

    __slots__ = ()


class Block(Protocol):
    """What a block offers. `dt` [s] is the length of a frame."""

    def start(self, u: float) -> Any:
        """The memory of a block that has long had the input `u`."""
        ...

    def step(self, u: float, memory: Any, dt: float) -> tuple[float, Any]:
        """The output of the frame that begins now, and the memory for the next."""
        ...

    def linear(self, dt: float | None = None) -> StateSpace:
        """The block as a state space: from frame to frame with `dt` [s], continuous without."""
        ...


def _first_order(T: float, keep: float, direct: float, dt: float | None) -> StateSpace:
    """x lags u by the time constant `T`; y = keep x + direct u."""
    if dt is None:
        return StateSpace(np.array([[-1.0 / T]]), np.array([1.0 / T]), np.array([keep]), direct)
    a = dt / (2.0 * T)
    A, B = (1.0 - a) / (1.0 + a), 2.0 * a / (1.0 + a)
    x_m, x_u = 1.0 / (1.0 + a), a / (1.0 + a)
    return StateSpace(np.array([[A]]), np.array([B]), np.array([keep * x_m]), keep * x_u + direct)


def _follow(u: float, memory: float, T: float, dt: float) -> tuple[float, float]:
    """The lagged input by the trapezoidal rule, and the memory: what this frame already adds to the next."""
    a = dt / (2.0 * T)
    x = (memory + a * u) / (1.0 + a)
    return x, (1.0 - a) * x + a * u


def _must_be_positive(what: str, value: float) -> None:
    if not (isfinite(value) and value > 0.0):
        raise SpecError(f"The time constant of a {what} is {value:g} s; it must be positive, such as 0.1 s.")


@dataclass(frozen=True)
class Lag:
    """1 / (T s + 1): a sensor, or a first-order filter. Trapezoidal rule."""

    time_constant: Second

    def __post_init__(self) -> None:
        _must_be_positive("lag", self.time_constant)

    def start(self, u: float) -> float:
        """At rest at `u`."""
        return u

    def step(self, u: float, memory: float, dt: float) -> tuple[float, float]:
        """The lagged input."""
        return _follow(u, memory, self.time_constant, dt)

    def linear(self, dt: float | None = None) -> StateSpace:
        """One state: the lagged input."""
        return _first_order(self.time_constant, 1.0, 0.0, dt)


@dataclass(frozen=True)
class Washout:
    """T s / (T s + 1): passes changes, and forgets what lasts longer than its time constant. Trapezoidal rule."""

    time_constant: Second

    def __post_init__(self) -> None:
        _must_be_positive("washout", self.time_constant)

    def start(self, u: float) -> float:
        """At rest at `u`: nothing comes out."""
        return u

    def step(self, u: float, memory: float, dt: float) -> tuple[float, float]:
        """The input without what lasts."""
        x, memory = _follow(u, memory, self.time_constant, dt)
        return u - x, memory

    def linear(self, dt: float | None = None) -> StateSpace:
        """One state: what is being forgotten."""
        return _first_order(self.time_constant, -1.0, 1.0, dt)


@dataclass(frozen=True)
class LeadLag:
    """(T1 s + 1) / (T2 s + 1), T1 the lead and T2 the lag. Trapezoidal rule."""

    lead: Second
    lag: Second

    def __post_init__(self) -> None:
        _must_be_positive("lead-lag", self.lag)

    def start(self, u: float) -> float:
        """At rest at `u`."""
        return u

    def step(self, u: float, memory: float, dt: float) -> tuple[float, float]:
        """The input, its changes first magnified by T1 / T2."""
        x, memory = _follow(u, memory, self.lag, dt)
        return x + self.lead / self.lag * (u - x), memory

    def linear(self, dt: float | None = None) -> StateSpace:
        """One state: the lagged input."""
        return _first_order(self.lag, 1.0 - self.lead / self.lag, self.lead / self.lag, dt)


@dataclass(frozen=True)
class PI:
    """gain + integral_gain / s, between two limits. Trapezoidal rule.

    Its integral stands still while the output is at a limit and the input pushes it further: no wind-up.
    """

    gain: float
    integral_gain: float
    lower: float = -inf
    upper: float = inf

    def start(self, u: float, output: float | None = None) -> float:
        """The memory with which `u` gives `output` in the first frame, as nearly as the limits allow; else 0."""
        if output is None:
            return 0.0
        return min(max(output, self.lower), self.upper) - self.gain * u

    def step(self, u: float, memory: float, dt: float) -> tuple[float, float]:
        """The limited output."""
        added = 0.5 * dt * self.integral_gain * u
        wanted = self.gain * u + memory + added
        output = min(max(wanted, self.lower), self.upper)
        pushes = (wanted - output) * added > 0.0
        return output, memory if pushes else memory + 2.0 * added

    def linear(self, dt: float | None = None) -> StateSpace:
        """One state: the integral's part of the output. Away from the limits."""
        if dt is None:
            return StateSpace(np.zeros((1, 1)), np.array([self.integral_gain]), np.ones(1), self.gain)
        half = 0.5 * dt * self.integral_gain
        return StateSpace(np.ones((1, 1)), np.array([2.0 * half]), np.ones(1), self.gain + half)


@dataclass(frozen=True)
class Limiter:
    """No less than `lower` and no more than `upper`. Without memory."""

    lower: float
    upper: float

    def start(self, u: float) -> None:
        """Nothing to remember."""

    def step(self, u: float, memory: None, dt: float) -> tuple[float, None]:
        """The limited input."""
        return min(max(u, self.lower), self.upper), None

    def linear(self, dt: float | None = None) -> StateSpace:
        """Between its limits it does nothing."""
        return StateSpace(np.zeros((0, 0)), np.zeros(0), np.zeros(0), 1.0)


MOST_FRAMES = 120  # of a delay that is linearized: each is a state, and roots of many more take minutes


@dataclass(frozen=True)
class Delay:
    """The input of `time` [s] ago. Exact for whole frames; between two frames the straight line between them.

    Continuous, it is the second-order Pade approximation, good to a phase of 1 deg up to omega time = 1.7.
    Reference: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., section 9.3, for the approximation.
    """

    time: Second

    def __post_init__(self) -> None:
        if not (isfinite(self.time) and self.time >= 0.0):
            raise SpecError(f"The delay is {self.time:g} s; it must be zero or more, such as 0.02 s.")

    def start(self, u: float) -> Past:
        """It has always been `u`."""
        return Past((u,))

    def step(self, u: float, memory: Past, dt: float) -> tuple[float, Past]:
        """The late input. The memory holds past inputs, the newest first; before the oldest, nothing had changed."""
        whole, part = self._frames(dt)
        past = (u, *memory)
        last = len(past) - 1
        late, later = past[min(whole, last)], past[min(whole + 1, last)]
        return late + part * (later - late), Past(past[: self.length(dt)])

    def length(self, dt: float) -> int:
        """How many past inputs are remembered in frames of `dt` [s]."""
        whole, part = self._frames(dt)
        return whole + (part > 0.0)

    def linear(self, dt: float | None = None) -> StateSpace:
        """As many states as past inputs; continuous, two. Raises SpecError for more frames than `MOST_FRAMES`."""
        if dt is None:
            return self._pade()
        if not self.time / dt <= MOST_FRAMES:
            raise SpecError(
                f"The delay of {self.time:g} s is {self.time / dt:,.0f} frames of {dt:.3g} s; at most {MOST_FRAMES} "
                "are computed. Ask for a shorter delay, or a longer step."
            )
        n, (whole, part) = self.length(dt), self._frames(dt)
        A, B, taps = np.eye(n, k=-1), np.zeros(n), np.zeros(n + 2)
        B[:1] = 1.0
        taps[whole] += 1.0 - part
        taps[whole + 1] += part
        return StateSpace(A, B, taps[1 : n + 1], float(taps[0]))

    def _frames(self, dt: float) -> tuple[int, float]:
        """The delay as a whole number of frames and a part of one; a part below rounding is none."""
        frames = self.time / dt
        whole = int(frames + 1e-9)
        part = frames - whole
        return whole, part if part > 1e-9 else 0.0

    def _pade(self) -> StateSpace:
        if self.time == 0.0:
            return StateSpace(np.zeros((0, 0)), np.zeros(0), np.zeros(0), 1.0)
        # (s^2 - 6 s/T + 12/T^2) / (s^2 + 6 s/T + 12/T^2) = 1 - (12 s/T) / (...), the states scaled alike
        w = 1.0 / self.time
        A = np.array([[-6.0 * w, -12.0 * w], [w, 0.0]])
        return StateSpace(A, np.array([w, 0.0]), np.array([-12.0, 0.0]), 1.0)
