"""From nondimensional derivatives to dimensional ones, and from those to A and B, in three forms.

Small perturbations about straight, steady flight, in stability axes (x along the undisturbed velocity):

    longitudinal  x = (u, w, q, theta)       inputs (elevator, throttle)
    lateral       x = (beta, p, r, phi)      inputs (aileron, rudder)

The forms differ in what they keep:

    paper    Mansor and Perumal eq. 2.1 and 2.2 as printed: no M_wdot, no M_u, no Z_q, no Z_wdot, no Ixz
    nelson   Nelson eq. 4.53 and 5.35: M_wdot and M_u kept, Z_q, Z_wdot and Ixz neglected
    full     Z_wdot, Z_q and Ixz kept, the inertias rotated from body to stability axes by the trim angle of attack

Reference: R. C. Nelson, Flight Stability and Automatic Control, 2nd ed., McGraw-Hill 1998, tables 3.5 and 5.1 for the
dimensional derivatives; D. McRuer, I. Ashkenas, D. Graham, Aircraft Dynamics and Automatic Control, 1973, ch. 4-6, for
the primed derivatives. The published examples are tests: tests/published.
"""

from typing import Annotated, Literal, NamedTuple

from fdes.elementary import cos, sin, tan
from fdes.units import (
    Kilogram,
    KilogramMeter2,
    KilogramPerMeter3,
    Meter,
    Meter2,
    MeterPerSecond,
    MeterPerSecond2,
    Newton,
    Number,
    PerRadian,
    Radian,
)

Form = Literal["paper", "nelson", "full"]
FORMS: tuple[Form, ...] = ("paper", "nelson", "full")

Matrix = tuple[tuple[float, ...], ...]


class Coefficients(NamedTuple):
    """Nondimensional stability and control derivatives in stability axes, with the signs of docs/symbols.md.

    Rates are made nondimensional with c/(2 V) in pitch and b/(2 V) in roll and yaw; Mach derivatives are per unit Mach.
    """

    CL: Number
    CD: Number
    CL_alpha: PerRadian
    CD_alpha: PerRadian
    Cm_alpha: PerRadian
    CL_alphadot: PerRadian
    Cm_alphadot: PerRadian
    CL_q: PerRadian
    Cm_q: PerRadian
    CL_M: Number
    CD_M: Number
    Cm_M: Number
    CL_de: PerRadian
    CD_de: PerRadian
    Cm_de: PerRadian
    Cy_beta: PerRadian
    Cl_beta: PerRadian
    Cn_beta: PerRadian
    Cy_p: PerRadian
    Cl_p: PerRadian
    Cn_p: PerRadian
    Cy_r: PerRadian
    Cl_r: PerRadian
    Cn_r: PerRadian
    Cy_da: PerRadian
    Cl_da: PerRadian
    Cn_da: PerRadian
    Cy_dr: PerRadian
    Cl_dr: PerRadian
    Cn_dr: PerRadian


class Reference(NamedTuple):
    """The condition about which the derivatives hold. Inertias in body axes; alpha is the trim angle of attack."""

    V: MeterPerSecond
    rho: KilogramPerMeter3
    mach: Number
    g: MeterPerSecond2
    h: Meter
    alpha: Radian
    gamma: Radian
    S: Meter2
    b: Meter
    c: Meter
    m: Kilogram
    Ix: KilogramMeter2
    Iy: KilogramMeter2
    Iz: KilogramMeter2
    Ixz: KilogramMeter2
    T_max: Newton


class Dimensional(NamedTuple):
    """Dimensional derivatives: forces by the mass, moments by the moment of inertia. Nelson, tables 3.5 and 5.1."""

    X_u: Annotated[float, "1/s"]
    X_w: Annotated[float, "1/s"]
    X_de: Annotated[float, "m/(s^2 rad)"]
    X_dT: Annotated[float, "m/s^2"]
    Z_u: Annotated[float, "1/s"]
    Z_w: Annotated[float, "1/s"]
    Z_wdot: Annotated[float, "1"]
    Z_q: Annotated[float, "m/(s rad)"]
    Z_de: Annotated[float, "m/(s^2 rad)"]
    M_u: Annotated[float, "rad/(m s)"]
    M_w: Annotated[float, "rad/(m s)"]
    M_wdot: Annotated[float, "rad/m"]
    M_q: Annotated[float, "1/s"]
    M_de: Annotated[float, "1/s^2"]
    Y_beta: Annotated[float, "m/(s^2 rad)"]
    Y_p: Annotated[float, "m/(s rad)"]
    Y_r: Annotated[float, "m/(s rad)"]
    Y_da: Annotated[float, "m/(s^2 rad)"]
    Y_dr: Annotated[float, "m/(s^2 rad)"]
    L_beta: Annotated[float, "1/s^2"]
    L_p: Annotated[float, "1/s"]
    L_r: Annotated[float, "1/s"]
    L_da: Annotated[float, "1/s^2"]
    L_dr: Annotated[float, "1/s^2"]
    N_beta: Annotated[float, "1/s^2"]
    N_p: Annotated[float, "1/s"]
    N_r: Annotated[float, "1/s"]
    N_da: Annotated[float, "1/s^2"]
    N_dr: Annotated[float, "1/s^2"]


class Matrices(NamedTuple):
    """A and B of the two decoupled sets, rows and columns in the order of the states and inputs above."""

    A_lon: Matrix
    B_lon: Matrix
    A_lat: Matrix
    B_lat: Matrix


def stability_axis_inertia(ref: Reference) -> tuple[KilogramMeter2, KilogramMeter2, KilogramMeter2]:
    """Ix, Iz, Ixz after rotating from body to stability axes by the trim angle of attack. McRuer et al., eq. 4-87."""
    s, c = sin(ref.alpha), cos(ref.alpha)
    Ix = ref.Ix * c * c + ref.Iz * s * s - 2.0 * ref.Ixz * s * c
    Iz = ref.Ix * s * s + ref.Iz * c * c + 2.0 * ref.Ixz * s * c
    Ixz = (ref.Ix - ref.Iz) * s * c + ref.Ixz * (c * c - s * s)
    return Ix, Iz, Ixz


def primed(L: float, N: float, Ix: KilogramMeter2, Iz: KilogramMeter2, Ixz: KilogramMeter2) -> tuple[float, float]:
    """A rolling and a yawing derivative with the product of inertia in them. McRuer et al., eq. 6-5."""
    by_x, by_z = Ixz / Ix, Ixz / Iz
    prime = 1.0 / (1.0 - by_x * by_z)
    return (L + by_x * N) * prime, (N + by_z * L) * prime


def dimensional(k: Coefficients, ref: Reference, form: Form) -> Dimensional:
    """Dimensional derivatives. Only `full` rotates the inertias. The sign of Z_wdot is that of a lift force:
    the book's table prints it without the minus.
    """
    V, m = ref.V, ref.m
    qS = 0.5 * ref.rho * V * V * ref.S
    c2, b2 = ref.c / (2.0 * V), ref.b / (2.0 * V)
    Ix, Iz, _ = stability_axis_inertia(ref) if form == "full" else (ref.Ix, ref.Iz, 0.0)
    drag, lift = qS / (m * V), qS / (m * V)
    side, pitch, roll, yaw = qS / m, qS * ref.c / ref.Iy, qS * ref.b / Ix, qS * ref.b / Iz
    return Dimensional(
        X_u=-(ref.mach * k.CD_M + 2.0 * k.CD) * drag,  # table 3.5, CD_u = M dCD/dM
        X_w=-(k.CD_alpha - k.CL) * drag,
        X_de=-k.CD_de * qS / m,
        X_dT=ref.T_max / m,
        Z_u=-(ref.mach * k.CL_M + 2.0 * k.CL) * lift,
        Z_w=-(k.CL_alpha + k.CD) * lift,
        Z_wdot=-k.CL_alphadot * c2 * lift,
        Z_q=-k.CL_q * c2 * qS / m,
        Z_de=-k.CL_de * qS / m,
        M_u=ref.mach * k.Cm_M * pitch / V,
        M_w=k.Cm_alpha * pitch / V,
        M_wdot=k.Cm_alphadot * c2 * pitch / V,
        M_q=k.Cm_q * c2 * pitch,
        M_de=k.Cm_de * pitch,
        Y_beta=k.Cy_beta * side,  # table 5.1
        Y_p=k.Cy_p * b2 * side,
        Y_r=k.Cy_r * b2 * side,
        Y_da=k.Cy_da * side,
        Y_dr=k.Cy_dr * side,
        L_beta=k.Cl_beta * roll,
        L_p=k.Cl_p * b2 * roll,
        L_r=k.Cl_r * b2 * roll,
        L_da=k.Cl_da * roll,
        L_dr=k.Cl_dr * roll,
        N_beta=k.Cn_beta * yaw,
        N_p=k.Cn_p * b2 * yaw,
        N_r=k.Cn_r * b2 * yaw,
        N_da=k.Cn_da * yaw,
        N_dr=k.Cn_dr * yaw,
    )


def matrices(d: Dimensional, ref: Reference, form: Form) -> Matrices:
    """A and B in the form asked for. The throttle column X_dT is ours in all three: the sources have none."""
    if form == "paper":
        return _paper(d, ref)
    if form == "nelson":
        return _nelson(d, ref)
    return _full(d, ref)


def _paper(d: Dimensional, ref: Reference) -> Matrices:
    """Mansor and Perumal, eq. 2.1 and 2.2."""
    g, V = ref.g, ref.V
    return Matrices(
        A_lon=((d.X_u, d.X_w, 0.0, -g), (d.Z_u, d.Z_w, V, 0.0), (0.0, d.M_w, d.M_q, 0.0), (0.0, 0.0, 1.0, 0.0)),
        B_lon=((d.X_de, d.X_dT), (d.Z_de, 0.0), (d.M_de, 0.0), (0.0, 0.0)),
        A_lat=(
            (d.Y_beta / V, d.Y_p / V, -(1.0 - d.Y_r / V), g * cos(ref.gamma) / V),
            (d.L_beta, d.L_p, d.L_r, 0.0),
            (d.N_beta, d.N_p, d.N_r, 0.0),
            (0.0, 1.0, 0.0, 0.0),
        ),
        B_lat=((0.0, d.Y_dr / V), (d.L_da, d.L_dr), (d.N_da, d.N_dr), (0.0, 0.0)),
    )


def _nelson(d: Dimensional, ref: Reference) -> Matrices:
    """Nelson, eq. 4.53; the lateral set, eq. 5.35, is the paper's."""
    V = ref.V
    pitch = (d.M_u + d.M_wdot * d.Z_u, d.M_w + d.M_wdot * d.Z_w, d.M_q + d.M_wdot * V, 0.0)
    paper = _paper(d, ref)
    u, w, _, theta = paper.A_lon
    u_in, w_in, _, theta_in = paper.B_lon
    return paper._replace(A_lon=(u, w, pitch, theta), B_lon=(u_in, w_in, (d.M_de + d.M_wdot * d.Z_de, 0.0), theta_in))


def _full(d: Dimensional, ref: Reference) -> Matrices:
    """Nothing neglected that the derivatives can say: w_dot solved for first, then q_dot; p_dot and r_dot through Ixz.
    McRuer et al., eq. 5-2 and 6-2, with the primed derivatives of eq. 6-5.
    """
    g, V, gamma = ref.g, ref.V, ref.gamma
    z = 1.0 / (1.0 - d.Z_wdot)
    w = (d.Z_u * z, d.Z_w * z, (V + d.Z_q) * z, -g * sin(gamma) * z)
    w_de = d.Z_de * z
    q = (d.M_u + d.M_wdot * w[0], d.M_w + d.M_wdot * w[1], d.M_q + d.M_wdot * w[2], d.M_wdot * w[3])
    inertia = stability_axis_inertia(ref)
    L_beta, N_beta = primed(d.L_beta, d.N_beta, *inertia)
    L_p, N_p = primed(d.L_p, d.N_p, *inertia)
    L_r, N_r = primed(d.L_r, d.N_r, *inertia)
    L_da, N_da = primed(d.L_da, d.N_da, *inertia)
    L_dr, N_dr = primed(d.L_dr, d.N_dr, *inertia)
    return Matrices(
        A_lon=((d.X_u, d.X_w, 0.0, -g * cos(gamma)), w, q, (0.0, 0.0, 1.0, 0.0)),
        B_lon=((d.X_de, d.X_dT), (w_de, 0.0), (d.M_de + d.M_wdot * w_de, 0.0), (0.0, 0.0)),
        A_lat=(
            (d.Y_beta / V, d.Y_p / V, d.Y_r / V - 1.0, g * cos(gamma) / V),
            (L_beta, L_p, L_r, 0.0),
            (N_beta, N_p, N_r, 0.0),
            (0.0, 1.0, tan(gamma), 0.0),
        ),
        B_lat=(
            (d.Y_da / V, d.Y_dr / V),
            (L_da, L_dr),
            (N_da, N_dr),
            (0.0, 0.0),
        ),
    )
