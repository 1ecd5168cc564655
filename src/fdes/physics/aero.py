"""Aerodynamics: what the flow does to an aircraft, as forces and moments in body axes about the center of gravity.

Each way to say aerodynamics is a named tuple of numbers, and a function that makes `AirLoads` of them and a `Flow`: the
simple body, of which only drag and damping are known; and the aircraft of which the derivatives at one condition are.

Reference: R. C. Nelson, Flight Stability and Automatic Control, 2nd ed., McGraw-Hill 1998, ch. 3.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import cos, largest, sin, where
from fdes.physics.derivatives import Coefficients, Reference
from fdes.physics.rigid_body import NewtonMeter
from fdes.physics.signals import Surfaces
from fdes.units import (
    FOOT,
    KilogramPerMeter3,
    Meter,
    Meter2,
    MeterPerSecond,
    Newton,
    Number,
    Pascal,
    Radian,
    RadianPerSecond,
)

SLOWEST: MeterPerSecond = 0.5 * FOOT  # below it, rates are made dimensionless by it: NASA/TM-2015-218675, the brick


class Flow(NamedTuple):
    """How the air meets the body. Its rates p, q, r are relative to the air, which turns with the Earth."""

    V: MeterPerSecond
    u: MeterPerSecond
    v: MeterPerSecond
    w: MeterPerSecond
    alpha: Radian
    beta: Radian
    p: RadianPerSecond
    q: RadianPerSecond
    r: RadianPerSecond
    rho: KilogramPerMeter3
    mach: Number
    qbar: Pascal


class AirLoads(NamedTuple):
    """Forces and moments in body axes, without what is in proportion to alpha_dot: of that the lift and the pitching
    moment for each rad/s, which the equations of motion solve for.
    """

    X: Newton = 0.0
    Y: Newton = 0.0
    Z: Newton = 0.0
    L: NewtonMeter = 0.0
    M: NewtonMeter = 0.0
    N: NewtonMeter = 0.0
    lift_alphadot: Annotated[float, "N s"] = 0.0
    M_alphadot: Annotated[float, "N m s"] = 0.0


class SimpleBody(NamedTuple):
    """A body that air slows down: drag along the wind, and damping of its rotation, all about constant coefficients."""

    S: Meter2
    b: Meter
    c: Meter
    CD: Number = 0.0
    Cl_p: Number = 0.0
    Cm_q: Number = 0.0
    Cn_r: Number = 0.0


def simple_body_loads(body: SimpleBody, flow: Flow, surfaces: Surfaces) -> AirLoads:
    """Its drag and its damping; it has no surfaces. NASA/TM-2015-218675, appendix B, brick and cannonball."""
    drag = 0.5 * flow.rho * flow.V * body.S * body.CD  # divided by V, so that a body at rest has a direction
    qS = flow.qbar * body.S
    hat = 0.5 / where(flow.V.real > SLOWEST, flow.V, SLOWEST)
    return AirLoads(
        -drag * flow.u,
        -drag * flow.v,
        -drag * flow.w,
        qS * body.b * body.Cl_p * hat * body.b * flow.p,
        qS * body.c * body.Cm_q * hat * body.c * flow.q,
        qS * body.b * body.Cn_r * hat * body.b * flow.r,
        0.0,
        0.0,
    )


ROUNDING = 0.9  # of the largest lift coefficient: the lift curve is straight up to here; assumed
LEAST_CL_MAX = 1.2  # assumed where no source says how large lift can be
ABOVE_TRIM = 1.3  # the largest lift coefficient over that of the condition, at least; assumed
PLATE: Number = 2.0  # drag coefficient of a flat plate across the flow, S. F. Hoerner, Fluid-Dynamic Drag, 1965, ch. 3


class DerivativeAero(NamedTuple):
    """An aircraft whose nondimensional derivatives at one condition are known, in stability axes of that condition.

    The polar CD_0 + K CL^2 passes through the condition with the slope CD_alpha. Mach derivatives act on M - mach_0.
    """

    k: Coefficients
    S: Meter2
    b: Meter
    c: Meter
    alpha_0: Radian
    mach_0: Number
    K: Number
    CD_0: Number
    CL_max: Number


def derivative_aero(k: Coefficients, ref: Reference, mach: Number) -> DerivativeAero:
    """The aerodynamics of `k` about the condition `ref`, whose Mach number is `mach` in the air that is flown in.

    K = CD_alpha / (2 CL CL_alpha), for CD_alpha = 2 K CL CL_alpha.
    """
    K = k.CD_alpha / (2.0 * k.CL * k.CL_alpha)
    CL_max = largest(LEAST_CL_MAX, ABOVE_TRIM * k.CL)
    return DerivativeAero(k, ref.S, ref.b, ref.c, ref.alpha, mach, K, k.CD - K * k.CL * k.CL, CL_max)


def derivative_loads(a: DerivativeAero, flow: Flow, surfaces: Surfaces) -> AirLoads:
    """Nelson's build-up, lift and drag along the flow in the plane of symmetry, moments in the axes of the condition.

    Beyond the assumed largest lift the lift curve is flat, and drag grows as that of a flat plate.
    """
    k = a.k
    V = where(flow.V.real > SLOWEST, flow.V, SLOWEST)
    b2, c2 = 0.5 * a.b / V, 0.5 * a.c / V
    ca0, sa0 = cos(a.alpha_0), sin(a.alpha_0)
    p_hat, r_hat = b2 * (flow.p * ca0 + flow.r * sa0), b2 * (flow.r * ca0 - flow.p * sa0)
    q_hat, alpha, mach = c2 * flow.q, flow.alpha - a.alpha_0, flow.mach - a.mach_0
    de, da, dr = surfaces.elevator, surfaces.aileron, surfaces.rudder
    straight = k.CL + k.CL_alpha * alpha
    lifting = limited_lift(straight, a.CL_max)
    stalled = sin((straight - lifting) / k.CL_alpha)  # how far beyond, as an angle
    CL = lifting + k.CL_M * mach + k.CL_q * q_hat + k.CL_de * de
    CD = a.CD_0 + a.K * lifting * lifting + k.CD_M * mach + k.CD_de * de + PLATE * stalled * stalled
    Cy = k.Cy_beta * flow.beta + k.Cy_p * p_hat + k.Cy_r * r_hat + k.Cy_da * da + k.Cy_dr * dr
    Cl = k.Cl_beta * flow.beta + k.Cl_p * p_hat + k.Cl_r * r_hat + k.Cl_da * da + k.Cl_dr * dr
    Cm = k.Cm_alpha * alpha + k.Cm_M * mach + k.Cm_q * q_hat + k.Cm_de * de
    Cn = k.Cn_beta * flow.beta + k.Cn_p * p_hat + k.Cn_r * r_hat + k.Cn_da * da + k.Cn_dr * dr
    qS = flow.qbar * a.S
    ca, sa = cos(flow.alpha), sin(flow.alpha)
    return AirLoads(
        qS * (CL * sa - CD * ca),
        qS * Cy,
        -qS * (CL * ca + CD * sa),
        qS * a.b * (Cl * ca0 - Cn * sa0),
        qS * a.c * Cm,
        qS * a.b * (Cn * ca0 + Cl * sa0),
        qS * c2 * k.CL_alphadot,
        qS * a.c * c2 * k.Cm_alphadot,
    )


def limited_lift(CL: Number, CL_max: Number) -> Number:
    """`CL` up to 0.9 CL_max, from there a parabola that ends level at CL_max; the same below zero."""
    size = where(CL.real < 0.0, -CL, CL)
    begins = ROUNDING * CL_max
    span = 2.0 * (CL_max - begins)
    short = where(size.real < begins + span, begins + span - size, 0.0)
    bent = where(size.real < begins, size, CL_max - short * short / (2.0 * span))
    found: float = where(CL.real < 0.0, -bent, bent)
    return found
