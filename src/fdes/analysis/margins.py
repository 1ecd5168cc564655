"""Gain, phase and delay margins of a control law, its loop broken at one surface at a time, all others closed.

The loop is broken at the command: L is what comes back, with its sign turned, when the surface is commanded. -1 is
where the closed loop is about to grow. Continuous, it is L(s) with the law's `linear()`; sampled, L(z) of the exact
sampled-data model, up to half the frame rate. What stands between stick and air - sensors, actuators, the half frame of
the hold - costs margin, and `costs` adds one after the other.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., section 3.8, for the
margins; G. F. Franklin, J. D. Powell, A. Emami-Naeini, Feedback Control of Dynamic Systems, 6.4, for several crossings.
"""

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from math import degrees, inf, isfinite, log10, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import FlightCondition
from fdes.analysis.closed_loop import open_loop
from fdes.analysis.placement import continuous_roots, stable
from fdes.control import Law, LinearModel
from fdes.control.laws.sensors import Sensors
from fdes.physics.actuators import Actuators
from fdes.physics.derivatives import Form
from fdes.physics.signals import Surfaces

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

SLOWEST = 1e-4  # rad/s: slower crossings are those of a steady value, which is looked at by itself
BEYOND = 100.0  # times the fastest root: there a continuous loop has no more to show
PER_DECADE = 200
NEAR_A_ROOT = np.concatenate([s * np.geomspace(1e-5, 0.3, 40) for s in (-1.0, 1.0)])
BISECTIONS = 50
NOTHING = 1e-9  # of a loop gain: rounding
COUPLED = 1e-12  # of an entry of A: less is rounding


@dataclass(frozen=True)
class Margins:
    """How far one loop is from growing. A loop that never gets there has infinite margins, and no crossover.

    gain_margin: the factor above 1 by which its gain can grow, gain_reduction that below 1 to which it can shrink
    (0 where it can be left open), each to the nearest phase crossover; phase_crossover [rad/s] that of gain_margin.
    phase_margin [rad]: that nearest to zero, at gain_crossover [rad/s]: of lag, or negative, of lead. delay_margin [s]:
    of further delay. stable: whether the loop decays as it is; where not, the margins lead to its next crossing.
    """

    surface: str
    gain_margin: float
    gain_reduction: float
    phase_crossover: float | None
    phase_margin: float
    gain_crossover: float | None
    delay_margin: float
    stable: bool

    def as_dict(self) -> dict[str, Any]:
        """What JSON says: margins in dB, degrees and seconds, null where there is no end; crossovers in rad/s."""
        said = asdict(self)
        up, down = said.pop("gain_margin"), said.pop("gain_reduction")
        return {
            "surface": said["surface"],
            "gain_margin_db": decibels(up),
            "gain_reduction_db": decibels(down),
            "phase_crossover": self.phase_crossover,
            "phase_margin_deg": degrees(self.phase_margin) if isfinite(self.phase_margin) else None,
            "gain_crossover": self.gain_crossover,
            "delay_margin_s": self.delay_margin if isfinite(self.delay_margin) else None,
            "stable": self.stable,
        }


def decibels(factor: float) -> float | None:
    """A factor in dB; None for zero and infinity."""
    return 20.0 * log10(factor) if 0.0 < factor < inf else None


def margins(
    of: FlightCondition | LinearModel,
    law: Law,
    dt: float | None = None,
    actuators: Actuators | None = None,
    form: Form = "full",
) -> tuple[Margins, ...]:
    """The margins at each surface that the law moves by what it measures, with what `close` takes.

    dt [s]: sampled at that step, else continuous. Raises SpecError as `close` does.
    """
    found = []
    for surface in Surfaces._fields:
        loop = _felt(open_loop(of, law, surface, dt, actuators, form))
        if np.any(loop.C) or np.any(loop.D):
            found.append(_of_loop(surface, loop))
    return tuple(found)


def costs(
    of: FlightCondition,
    law: Law,
    dt: float | None = None,
    actuators: Actuators | None = None,
    form: Form = "full",
) -> dict[str, tuple[Margins, ...]]:
    """The margins of the law by itself, then with its sensors, actuators and the sampling at `dt` [s], one by one.

    Only what there is has an entry, and each has in it those before it.
    """
    bare = without_sensors(law)
    found = {"law alone": margins(of, bare, form=form)}
    if bare != law:
        found["+ sensors"] = margins(of, law, form=form)
    if actuators is not None:
        found["+ actuators"] = margins(of, law, None, actuators, form)
    if dt is not None:
        found["+ frames"] = margins(of, law, dt, actuators, form)
    return found


def without_sensors(law: Any) -> Any:
    """The law as if it measured at once."""
    inner = getattr(law, "inner", None)
    if inner is None:
        return law
    return without_sensors(inner) if isinstance(law, Sensors) else replace(law, inner=without_sensors(inner))


def response(loop: LinearModel, omega: Array) -> Complex:
    """A model of one input and one output at those frequencies [rad/s]; infinite on a pole."""
    s = 1j * omega if loop.dt is None else np.exp(1j * omega * loop.dt)
    systems = s[:, None, None] * np.eye(len(loop.A)) - loop.A
    try:
        x = np.linalg.solve(systems, np.broadcast_to(loop.B.astype(complex), (len(omega), *loop.B.shape)))
    except np.linalg.LinAlgError:
        return np.full(len(omega), np.inf, dtype=complex) if len(omega) == 1 else _one_by_one(loop, omega)
    return np.asarray((loop.C @ x + loop.D)[:, 0, 0])


def _one_by_one(loop: LinearModel, omega: Array) -> Complex:
    return np.array([response(loop, np.array([w]))[0] for w in omega])


def _of_loop(surface: str, loop: LinearModel) -> Margins:
    omega, L = _swept(loop)

    def at(w: float) -> complex:
        return complex(response(loop, np.array([w]))[0])

    size = [_crossing(omega, k, lambda w: abs(at(w)) - 1.0) for k in _changes(np.abs(L) - 1.0)]
    back = [_crossing(omega, k, lambda w: at(w).imag) for k in _changes(L.imag)]
    ends = [0.0] if loop.dt is None else [0.0, pi / loop.dt]  # there L is real
    phase = [(1.0 / abs(v), w) for w, v in ((w, at(w)) for w in (*ends, *back)) if _is_negative(v)]
    more = min((one for one in phase if one[0] >= 1.0), default=(inf, None))
    less = max((factor for factor, _ in phase if factor < 1.0), default=0.0)
    left = [(float(np.angle(-at(w))), w) for w in size]
    nearest = min(left, key=lambda one: abs(one[0]), default=(inf, None))
    closed = loop.A - loop.B @ loop.C / (1.0 + loop.D[0, 0])
    return Margins(
        surface=surface,
        gain_margin=more[0],
        gain_reduction=less,
        phase_crossover=more[1],
        phase_margin=nearest[0],
        gain_crossover=nearest[1],
        delay_margin=min(((angle % (2.0 * pi)) / w for angle, w in left), default=inf),
        stable=stable(replace(loop, A=closed)),
    )


def _swept(loop: LinearModel) -> tuple[Array, Complex]:
    """The loop over all frequencies that matter, closer together about its roots."""
    roots = np.abs(continuous_roots(loop.A, loop.dt))
    roots = roots[np.isfinite(roots) & (roots > SLOWEST)]
    last = pi / loop.dt if loop.dt is not None else BEYOND * float(roots.max(initial=1.0))
    wide = np.geomspace(SLOWEST, last, round(PER_DECADE * log10(last / SLOWEST)))
    omega = np.unique(np.concatenate([wide, np.outer(roots, 1.0 + NEAR_A_ROOT).ravel()]))
    omega = omega[omega <= last]
    return omega, response(loop, omega)


def _changes(values: Array) -> list[int]:
    """After which of the values the sign changes."""
    return [int(k) for k in np.flatnonzero(np.signbit(values[:-1]) != np.signbit(values[1:]))]


def _crossing(omega: Array, k: int, f: Callable[[float], float]) -> float:
    low, high = float(omega[k]), float(omega[k + 1])
    sign = f(low) > 0.0
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if (f(middle) > 0.0) == sign else (low, middle)
    return 0.5 * (low + high)


def _is_negative(value: complex) -> bool:
    """Whether it lies on the negative real axis; where a pole makes the sign change, it does not."""
    return isfinite(abs(value)) and value.real < -NOTHING and abs(value.imag) < 1e-6 * abs(value)


def _felt(loop: LinearModel) -> LinearModel:
    """The loop with those states alone that the surface moves and that come back: the others are no part of it."""
    moves = np.abs(loop.A) > COUPLED
    kept = sorted(_reached(moves.T, loop.B[:, 0]) & _reached(moves, loop.C[0]))
    return replace(
        loop,
        A=loop.A[np.ix_(kept, kept)],
        B=loop.B[kept],
        C=loop.C[:, kept],
        states=tuple(loop.states[k] for k in kept),
    )


def _reached(onward: NDArray[np.bool_], begin: Array) -> set[int]:
    """All states that can be got to from where `begin` is not zero; onward[i, j]: from i to j."""
    reached = {int(k) for k in np.flatnonzero(begin)}
    waiting = list(reached)
    while waiting:
        more = {int(j) for j in np.flatnonzero(onward[waiting.pop()])} - reached
        reached |= more
        waiting += more
    return reached
