"""Aerodynamics between flight conditions at different Mach numbers.

Each condition has its own derivatives, about its own angle of attack. At one angle of attack, and with one deflection
of the surfaces, forces and moments go in a straight line over Mach from what one condition says to what the next one
says, so every derivative does. The printed Mach derivatives are slopes at the conditions, which a straight line cannot
have: a cubic is added to lift, drag and pitching moment that is zero at both conditions and has there what the slopes
lack (C. Hermite's interpolation; E. Kreyszig, Advanced Engineering Mathematics, 10th ed., sec. 19.4). Beyond the first
and the last condition the aircraft is that of this condition.
"""

from typing import NamedTuple

from fdes.elementary import cos, sin, where
from fdes.physics.aero import AirLoads, DerivativeAero, Flow, derivative_loads
from fdes.physics.signals import Surfaces
from fdes.units import Number, Radian


class Static(NamedTuple):
    """Lift, drag and pitching moment, or how they change."""

    CL: Number
    CD: Number
    Cm: Number


class Bend(NamedTuple):
    """What the Mach derivatives of two neighbors have over the straight line between them, times the step in Mach."""

    below: Static
    above: Static


class Between(NamedTuple):
    """The aerodynamics of two conditions, `low` being at the lower Mach number, and the bend between them."""

    low: DerivativeAero
    high: DerivativeAero
    bend: Bend


class AcrossMach(NamedTuple):
    """The aerodynamics of three or more conditions: of each two neighbors, by rising Mach number."""

    pieces: tuple[Between, ...]


def across_mach(sets: tuple[DerivativeAero, ...]) -> Between | AcrossMach:
    """The aerodynamics of `sets`, which are about one center of gravity, in one body, by rising Mach number."""
    pieces = tuple(Between(sets[k], sets[k + 1], _bend(sets[k], sets[k + 1])) for k in range(len(sets) - 1))
    return pieces[0] if len(pieces) == 1 else AcrossMach(pieces)


def conditions_of(a: Between | AcrossMach) -> tuple[DerivativeAero, ...]:
    """The aerodynamics of the conditions themselves, by rising Mach number."""
    pieces = (a,) if isinstance(a, Between) else a.pieces
    return (*(piece.low for piece in pieces), pieces[-1].high)


def secants(low: DerivativeAero, high: DerivativeAero) -> tuple[Static, Static]:
    """The slopes over Mach of the straight lines between two conditions: at the angle of attack of either."""
    step = high.mach_0 - low.mach_0
    found = []
    for alpha in (low.alpha_0, high.alpha_0):
        pairs = zip(static(high, alpha), static(low, alpha), strict=True)
        found.append(Static(*((there - here) / step for there, here in pairs)))
    return found[0], found[1]


def static(a: DerivativeAero, alpha: Radian) -> Static:
    """Lift, drag and pitching moment of a condition at its Mach number, without rates, surfaces at trim."""
    still = Flow(1.0, 1.0, 0.0, 0.0, alpha, 0.0, 0.0, 0.0, 0.0, 1.0, a.mach_0, 1.0)
    loads = derivative_loads(a, still, Surfaces())
    ca, sa = cos(alpha), sin(alpha)
    return Static((loads.X * sa - loads.Z * ca) / a.S, -(loads.X * ca + loads.Z * sa) / a.S, loads.M / (a.S * a.c))


def mach_derivatives(a: DerivativeAero) -> Static:
    """Those that the source prints."""
    return Static(a.k.CL_M, a.k.CD_M, a.k.Cm_M)


def _bend(low: DerivativeAero, high: DerivativeAero) -> Bend:
    step = high.mach_0 - low.mach_0
    found = []
    for a, secant in zip((low, high), secants(low, high), strict=True):
        found.append(Static(*(step * (slope - line) for slope, line in zip(mach_derivatives(a), secant, strict=True))))
    return Bend(*found)


def across_mach_loads(a: AcrossMach, flow: Flow, surfaces: Surfaces) -> AirLoads:
    """The loads between the two conditions of which one is slower and one faster, or beyond all of them."""
    k, mach = 0, flow.mach.real
    while k < len(a.pieces) - 1 and mach >= a.pieces[k].high.mach_0:
        k += 1
    return loads_between(a.pieces[k], flow, surfaces)


def loads_between(a: Between, flow: Flow, surfaces: Surfaces) -> AirLoads:
    """The loads between two conditions; beyond them those of the nearest, whose Mach derivatives act there."""
    slower, faster = flow.mach - a.low.mach_0, flow.mach - a.high.mach_0
    t = slower / (a.high.mach_0 - a.low.mach_0)
    t = where(t.real < 0.0, 0.0, where(t.real > 1.0, 1.0, t))
    s = 1.0 - t
    below = derivative_loads(a.low, _at_mach(flow, a.low.mach_0 + where(slower.real < 0.0, slower, 0.0)), surfaces)
    above = derivative_loads(a.high, _at_mach(flow, a.high.mach_0 + where(faster.real > 0.0, faster, 0.0)), surfaces)
    of_low, of_high = a.bend.below, a.bend.above
    qS, ca, sa = flow.qbar * a.low.S * s * t, cos(flow.alpha), sin(flow.alpha)
    lift, drag = qS * (s * of_low.CL - t * of_high.CL), qS * (s * of_low.CD - t * of_high.CD)
    return AirLoads(
        s * below.X + t * above.X + lift * sa - drag * ca,
        s * below.Y + t * above.Y,
        s * below.Z + t * above.Z - lift * ca - drag * sa,
        s * below.L + t * above.L,
        s * below.M + t * above.M + qS * a.low.c * (s * of_low.Cm - t * of_high.Cm),
        s * below.N + t * above.N,
        s * below.lift_alphadot + t * above.lift_alphadot,
        s * below.M_alphadot + t * above.M_alphadot,
    )


def _at_mach(f: Flow, mach: Number) -> Flow:
    """The same flow with another Mach number: at that of its condition, Mach derivatives do nothing."""
    return Flow(f.V, f.u, f.v, f.w, f.alpha, f.beta, f.p, f.q, f.r, f.rho, mach, f.qbar)
