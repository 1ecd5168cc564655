"""Aerodynamics as a sum of terms: a gain, times the value of a table, times signals.

What an aircraft file says in its [terms] becomes a `TermAero`. Tables that share an axis share where it is read.
Coefficients are those of forces along body axes and of moments about the moment reference, from where `term_loads`
moves them to the center of gravity.
"""

from typing import NamedTuple

from fdes.elementary import where
from fdes.physics.aero import SLOWEST, AirLoads, Flow
from fdes.physics.signals import Surfaces
from fdes.physics.tables import Axis, Row, grid_at, row_at, spot
from fdes.units import Meter, Meter2, Number, Radian

SIGNALS = ("alpha", "beta", "mach", "p_hat", "q_hat", "r_hat", "elevator", "aileron", "rudder")
FORCES_AND_MOMENTS = ("CX", "CY", "CZ", "Cl", "Cm", "Cn")


class TermSignals(NamedTuple):
    """What terms are made of. p_hat and r_hat are made nondimensional with b/(2 V), q_hat with c/(2 V)."""

    alpha: Radian
    beta: Radian
    mach: Number
    p_hat: Number
    q_hat: Number
    r_hat: Number
    elevator: Radian
    aileron: Radian
    rudder: Radian


class SignalAxis(NamedTuple):
    """An axis in SI, and the signal that is read along it: `sign` times that of number `signal`.

    mirrored: read at the size of the signal; the tables over it are odd in it.
    """

    axis: Axis
    signal: int
    sign: float = 1.0
    mirrored: bool = False


class Table(NamedTuple):
    """Values over one axis, or over two, by their numbers: then a row for each breakpoint of the first."""

    axes: tuple[int, ...]
    values: Row | tuple[Row, ...]


class Term(NamedTuple):
    """gain times table times signals, the latter two by their numbers; without a table where that is None."""

    gain: float
    table: int | None
    signals: tuple[int, ...]


class TermAero(NamedTuple):
    """An aircraft whose aerodynamics are terms.

    arm: the center of gravity, forward of the moment reference. sums: of the terms of CX, CY, CZ, Cl, Cm, Cn.
    """

    S: Meter2
    b: Meter
    c: Meter
    arm: Meter
    axes: tuple[SignalAxis, ...]
    tables: tuple[Table, ...]
    sums: tuple[tuple[Term, ...], ...]


class BodyCoefficients(NamedTuple):
    """Forces along body axes, and moments about the moment reference."""

    CX: Number
    CY: Number
    CZ: Number
    Cl: Number
    Cm: Number
    Cn: Number


def term_signals(a: TermAero, flow: Flow, surfaces: Surfaces) -> TermSignals:
    """The signals of this instant."""
    V = where(flow.V.real > SLOWEST, flow.V, SLOWEST)
    b2, c2 = 0.5 * a.b / V, 0.5 * a.c / V
    rates = b2 * flow.p, c2 * flow.q, b2 * flow.r
    return TermSignals(flow.alpha, flow.beta, flow.mach, *rates, surfaces.elevator, surfaces.aileron, surfaces.rudder)


def body_coefficients(a: TermAero, signals: TermSignals) -> BodyCoefficients:
    """The sums of terms."""
    spots, signs = [], []
    for axis in a.axes:
        x = axis.sign * signals[axis.signal]
        negative = axis.mirrored and x.real < 0.0
        spots.append(spot(axis.axis, -x if negative else x))
        signs.append(-1.0 if negative else 1.0)
    read = []
    for axes, values in a.tables:
        if len(axes) == 1:
            read.append(signs[axes[0]] * row_at(values, spots[axes[0]]))  # type: ignore[arg-type]  # one axis, one row
        else:
            i, j = axes
            read.append(signs[i] * signs[j] * grid_at(values, spots[i], spots[j]))  # type: ignore[arg-type]
    found = []
    for terms in a.sums:
        total = 0.0
        for gain, table, factors in terms:
            value = gain if table is None else gain * read[table]
            for factor in factors:
                value = value * signals[factor]
            total = total + value
        found.append(total)
    return BodyCoefficients(*found)


def term_loads(a: TermAero, flow: Flow, surfaces: Surfaces) -> AirLoads:
    """Forces, and moments about the center of gravity: those about the reference, and those of the forces' arm."""
    k = body_coefficients(a, term_signals(a, flow, surfaces))
    qS = flow.qbar * a.S
    X, Y, Z = qS * k.CX, qS * k.CY, qS * k.CZ
    L, M, N = qS * a.b * k.Cl, qS * a.c * k.Cm + a.arm * Z, qS * a.b * k.Cn - a.arm * Y
    return AirLoads(X, Y, Z, L, M, N, 0.0, 0.0)


def ends(a: TermAero) -> dict[str, tuple[float, float]]:
    """Where the tables over each signal end, by its name: the narrowest of them, with the signs of FDES [SI]."""
    found: dict[str, tuple[float, float]] = {}
    for axis in a.axes:
        low, high = axis.axis.breakpoints[0], axis.axis.breakpoints[-1]
        low = -high if axis.mirrored else low
        low, high = (low, high) if axis.sign > 0.0 else (-high, -low)
        before = found.get(SIGNALS[axis.signal], (low, high))
        found[SIGNALS[axis.signal]] = max(low, before[0]), min(high, before[1])
    return found
