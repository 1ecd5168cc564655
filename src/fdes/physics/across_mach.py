"""Aerodynamics between flight conditions at different Mach numbers.

Each condition has its own derivatives, about its own angle of attack. At one angle of attack, and with one deflection
of the surfaces, forces and moments go in a straight line over Mach from what one condition says to what the next one
says, so every derivative does. The printed Mach derivatives are slopes at the conditions, which a straight line cannot
have: a cubic is added to lift, drag and pitching moment that is zero at both conditions and has there what the slopes
lack (C. Hermite's interpolation; E. Kreyszig, Advanced Engineering Mathematics, 10th ed., sec. 19.4). Beyond the first
and the last condition the aircraft is that of this condition.
"""

from typing import NamedTuple

from fdes.elementary import cos, sin
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


class AcrossMach(NamedTuple):
    """The aerodynamics of two or more conditions by rising Mach number, and the bend between each two of them."""

    sets: tuple[DerivativeAero, ...]
    bends: tuple[Bend, ...]


def across_mach(sets: tuple[DerivativeAero, ...]) -> AcrossMach:
    """The aerodynamics of `sets`, which are about one center of gravity, in one body, by rising Mach number."""
    return AcrossMach(sets, tuple(_bend(sets[k], sets[k + 1]) for k in range(len(sets) - 1)))


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
    """The loads at the Mach number of `flow`: between two conditions, or those of the nearest one."""
    sets, mach = a.sets, flow.mach.real
    if mach <= sets[0].mach_0:
        return derivative_loads(sets[0], flow, surfaces)
    if mach >= sets[-1].mach_0:
        return derivative_loads(sets[-1], flow, surfaces)
    k = 0
    while mach >= sets[k + 1].mach_0:
        k += 1
    low, high = sets[k], sets[k + 1]
    t = (flow.mach - low.mach_0) / (high.mach_0 - low.mach_0)
    below = derivative_loads(low, flow._replace(mach=low.mach_0), surfaces)  # without its Mach derivatives
    above = derivative_loads(high, flow._replace(mach=high.mach_0), surfaces)
    CL, CD, Cm = (t * (1.0 - t) * ((1.0 - t) * b - t * e) for b, e in zip(*a.bends[k], strict=True))
    qS = flow.qbar * low.S
    ca, sa = cos(flow.alpha), sin(flow.alpha)
    X, Y, Z, L, M, N, *of_alpha_dot = (b + t * (e - b) for b, e in zip(below, above, strict=True))
    return AirLoads(
        X + qS * (CL * sa - CD * ca),
        Y,
        Z - qS * (CL * ca + CD * sa),
        L,
        M + qS * low.c * Cm,
        N,
        *of_alpha_dot,
    )
