"""The model that benchmarks/kernel.py flies: a rigid aircraft with 26 aerodynamic numbers over a flat Earth.

It is written as physics is, plain scalar functions on named tuples, and stands alone so that the figures stay
comparable while physics grows. kernel_peer.cpp has the same equations.
Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., table 1.5-1.
"""

from typing import NamedTuple

from fdes.elementary import atan2, exp, pow, sqrt, where

G0 = 9.80665


class State(NamedTuple):
    """SI, body axes, and a quaternion from north-east-down."""

    north: float
    east: float
    h: float
    u: float
    v: float
    w: float
    e0: float
    e1: float
    e2: float
    e3: float
    p: float
    q: float
    r: float
    power: float


class Held(NamedTuple):
    elevator: float
    aileron: float
    rudder: float
    throttle: float


class Aero(NamedTuple):
    CL_0: float
    CL_alpha: float
    CL_q: float
    CL_de: float
    CD_0: float
    K: float
    CD_de2: float
    Cy_beta: float
    Cy_p: float
    Cy_r: float
    Cy_da: float
    Cy_dr: float
    Cl_beta: float
    Cl_p: float
    Cl_r: float
    Cl_da: float
    Cl_dr: float
    Cm_0: float
    Cm_alpha: float
    Cm_q: float
    Cm_de: float
    Cn_beta: float
    Cn_p: float
    Cn_r: float
    Cn_da: float
    Cn_dr: float


class Body(NamedTuple):
    m: float
    S: float
    b: float
    c: float
    Ix: float
    Iy: float
    Iz: float
    Ixz: float
    T_max: float
    lag: float


class Airframe(NamedTuple):
    body: Body
    aero: Aero


class Coefficients(NamedTuple):
    CL: float
    CD: float
    Cy: float
    Cl: float
    Cm: float
    Cn: float


# Near the NAVION's: Nelson, table B.1, the small ones made up so that every term is at work.
NAVION = Airframe(
    Body(m=1247.4, S=17.094, b=10.18, c=1.737, Ix=1420.9, Iy=4067.5, Iz=4786.0, Ixz=60.0, T_max=2277.0, lag=0.5),
    Aero(
        CL_0=0.36,
        CL_alpha=4.44,
        CL_q=3.8,
        CL_de=0.355,
        CD_0=0.041,
        K=0.054,
        CD_de2=0.02,
        Cy_beta=-0.564,
        Cy_p=0.01,
        Cy_r=0.02,
        Cy_da=0.003,
        Cy_dr=0.157,
        Cl_beta=-0.074,
        Cl_p=-0.41,
        Cl_r=0.107,
        Cl_da=0.134,
        Cl_dr=0.0118,
        Cm_0=0.007,
        Cm_alpha=-0.683,
        Cm_q=-9.96,
        Cm_de=-0.923,
        Cn_beta=0.071,
        Cn_p=-0.0575,
        Cn_r=-0.125,
        Cn_da=-0.0035,
        Cn_dr=-0.072,
    ),
)
START = State(
    north=0.0,
    east=0.0,
    h=500.0,
    u=53.6,
    v=0.4,
    w=0.6,
    e0=1.0,
    e1=0.0,
    e2=0.0,
    e3=0.0,
    p=0.02,
    q=0.0,
    r=0.01,
    power=0.5,
)
HELD = Held(elevator=-0.005, aileron=0.002, rudder=0.001, throttle=0.55)


def density(h: float) -> float:
    """Of the standard atmosphere to 20 km [kg/m^3]. U.S. Standard Atmosphere 1976, eq. 33a and 33b."""
    troposphere = 1.225 * pow(1.0 - 2.25576956e-5 * smaller_height(h), 4.25587981)
    stratosphere = 0.36391803 * exp(-1.57688485e-4 * (h - 11000.0))
    return where(h < 11000.0, troposphere, stratosphere)


def smaller_height(h: float) -> float:
    """At most 11 km, where the troposphere ends: its formula has no value far above."""
    return where(h < 11000.0, h, 11000.0)


def coefficients(a: Aero, alpha: float, beta: float, p_hat: float, q_hat: float, r_hat: float, u: Held) -> Coefficients:
    """The build-up of 26 terms, forces along the wind."""
    de, da, dr = u.elevator, u.aileron, u.rudder
    CL = a.CL_0 + a.CL_alpha * alpha + a.CL_q * q_hat + a.CL_de * de
    return Coefficients(
        CL,
        a.CD_0 + a.K * CL * CL + a.CD_de2 * de * de,
        a.Cy_beta * beta + a.Cy_p * p_hat + a.Cy_r * r_hat + a.Cy_da * da + a.Cy_dr * dr,
        a.Cl_beta * beta + a.Cl_p * p_hat + a.Cl_r * r_hat + a.Cl_da * da + a.Cl_dr * dr,
        a.Cm_0 + a.Cm_alpha * alpha + a.Cm_q * q_hat + a.Cm_de * de,
        a.Cn_beta * beta + a.Cn_p * p_hat + a.Cn_r * r_hat + a.Cn_da * da + a.Cn_dr * dr,
    )


def derivative(x: State, held: Held, craft: Airframe) -> State:
    """dx/dt."""
    body = craft.body
    u, v, w, p, q, r = x.u, x.v, x.w, x.p, x.q, x.r
    e0, e1, e2, e3 = x.e0, x.e1, x.e2, x.e3
    level = sqrt(u * u + w * w)
    V = sqrt(u * u + v * v + w * w)
    rho = density(x.h)
    qS = 0.5 * rho * V * V * body.S
    b2, c2 = body.b / (2.0 * V), body.c / (2.0 * V)
    k = coefficients(craft.aero, atan2(w, u), atan2(v, level), b2 * p, c2 * q, b2 * r, held)
    ca, sa = u / level, w / level
    X = qS * (k.CL * sa - k.CD * ca) + body.T_max * x.power * (rho / 1.225)
    Y = qS * k.Cy
    Z = -qS * (k.CL * ca + k.CD * sa)
    L, M, N = qS * body.b * k.Cl, qS * body.c * k.Cm, qS * body.b * k.Cn
    Ix, Iy, Iz, Ixz = body.Ix, body.Iy, body.Iz, body.Ixz
    # Euler's equations, solved for the accelerations.
    D = 1.0 / (Ix * Iz - Ixz * Ixz)
    roll = L + (Iy - Iz) * q * r + Ixz * p * q
    yaw = N + (Ix - Iy) * p * q - Ixz * q * r
    drift = 1.0 - (e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3)
    # The columns of the rotation from body axes to north, east, down.
    nx, ny, nz = e0 * e0 + e1 * e1 - e2 * e2 - e3 * e3, 2.0 * (e1 * e2 - e0 * e3), 2.0 * (e1 * e3 + e0 * e2)
    ex, ey, ez = 2.0 * (e1 * e2 + e0 * e3), e0 * e0 - e1 * e1 + e2 * e2 - e3 * e3, 2.0 * (e2 * e3 - e0 * e1)
    dx, dy, dz = 2.0 * (e1 * e3 - e0 * e2), 2.0 * (e2 * e3 + e0 * e1), e0 * e0 - e1 * e1 - e2 * e2 + e3 * e3
    return State(
        nx * u + ny * v + nz * w,
        ex * u + ey * v + ez * w,
        -(dx * u + dy * v + dz * w),
        r * v - q * w + G0 * dx + X / body.m,
        p * w - r * u + G0 * dy + Y / body.m,
        q * u - p * v + G0 * dz + Z / body.m,
        0.5 * (-p * e1 - q * e2 - r * e3) + drift * e0,
        0.5 * (p * e0 + r * e2 - q * e3) + drift * e1,
        0.5 * (q * e0 - r * e1 + p * e3) + drift * e2,
        0.5 * (r * e0 + q * e1 - p * e2) + drift * e3,
        (Iz * roll + Ixz * yaw) * D,
        (M + (Iz - Ix) * p * r - Ixz * (p * p - r * r)) / Iy,
        (Ix * yaw + Ixz * roll) * D,
        (held.throttle - x.power) / body.lag,
    )
