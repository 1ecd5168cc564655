"""The linear plant: nondimensional derivatives, dimensional derivatives, A and B in three forms, and the flight itself.

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

from fdes.elementary import atan2, cos, sin, sqrt, tan
from fdes.physics.airdata import calibrated_airspeed, equivalent_airspeed, impact_pressure
from fdes.physics.atmosphere import GAMMA_AIR
from fdes.physics.runge_kutta import Tableau, Vector, step
from fdes.physics.signals import Air, Outputs, Surfaces
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
    RadianPerSecond,
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


class Limits(NamedTuple):
    """How far the surfaces and the throttle can go."""

    lower: Surfaces
    upper: Surfaces


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


class PerturbationState(NamedTuple):
    """The state of the linear plant: perturbations in stability axes, then where the aircraft is."""

    u: MeterPerSecond = 0.0
    w: MeterPerSecond = 0.0
    q: RadianPerSecond = 0.0
    theta: Radian = 0.0
    beta: Radian = 0.0
    p: RadianPerSecond = 0.0
    r: RadianPerSecond = 0.0
    phi: Radian = 0.0
    psi: Radian = 0.0
    north: Meter = 0.0
    east: Meter = 0.0
    h: Meter = 0.0


class ExactHold(NamedTuple):
    """The exact zero-order hold of the linear equations for one step: x_next = Phi x + Gamma u.

    Longitudinal u is (elevator, throttle, gust_u, gust_w); lateral x ends with psi, u is (aileron, rudder, gust_v).
    Reference: G. F. Franklin, J. D. Powell, M. Workman, Digital Control of Dynamic Systems, 3rd ed., eq. 4.58.
    """

    h: Annotated[float, "s"]
    Phi_lon: Matrix
    Gamma_lon: Matrix
    Phi_lat: Matrix
    Gamma_lat: Matrix


def stability_axis_inertia(ref: Reference) -> tuple[KilogramMeter2, KilogramMeter2, KilogramMeter2]:
    """Ix, Iz, Ixz after rotating from body to stability axes by the trim angle of attack. McRuer et al., eq. 4-87."""
    s, c = sin(ref.alpha), cos(ref.alpha)
    Ix = ref.Ix * c * c + ref.Iz * s * s - 2.0 * ref.Ixz * s * c
    Iz = ref.Ix * s * s + ref.Iz * c * c + 2.0 * ref.Ixz * s * c
    Ixz = (ref.Ix - ref.Iz) * s * c + ref.Ixz * (c * c - s * s)
    return Ix, Iz, Ixz


def dimensional(k: Coefficients, ref: Reference, form: Form) -> Dimensional:
    """Dimensional derivatives. Only `full` rotates the inertias. The sign of Z_wdot is that of a lift force:
    the book's table prints it without the minus."""
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
    McRuer et al., eq. 5-2 and 6-2, with the primed derivatives of eq. 6-5."""
    g, V, gamma = ref.g, ref.V, ref.gamma
    z = 1.0 / (1.0 - d.Z_wdot)
    w = (d.Z_u * z, d.Z_w * z, (V + d.Z_q) * z, -g * sin(gamma) * z)
    w_de = d.Z_de * z
    q = (d.M_u + d.M_wdot * w[0], d.M_w + d.M_wdot * w[1], d.M_q + d.M_wdot * w[2], d.M_wdot * w[3])
    Ix, Iz, Ixz = stability_axis_inertia(ref)
    by_x, by_z = Ixz / Ix, Ixz / Iz
    prime = 1.0 / (1.0 - by_x * by_z)

    def roll(L: float, N: float) -> float:
        return (L + by_x * N) * prime

    def yaw(L: float, N: float) -> float:
        return (N + by_z * L) * prime

    return Matrices(
        A_lon=((d.X_u, d.X_w, 0.0, -g * cos(gamma)), w, q, (0.0, 0.0, 1.0, 0.0)),
        B_lon=((d.X_de, d.X_dT), (w_de, 0.0), (d.M_de + d.M_wdot * w_de, 0.0), (0.0, 0.0)),
        A_lat=(
            (d.Y_beta / V, d.Y_p / V, d.Y_r / V - 1.0, g * cos(gamma) / V),
            (roll(d.L_beta, d.N_beta), roll(d.L_p, d.N_p), roll(d.L_r, d.N_r), 0.0),
            (yaw(d.L_beta, d.N_beta), yaw(d.L_p, d.N_p), yaw(d.L_r, d.N_r), 0.0),
            (0.0, 1.0, tan(gamma), 0.0),
        ),
        B_lat=(
            (d.Y_da / V, d.Y_dr / V),
            (roll(d.L_da, d.N_da), roll(d.L_dr, d.N_dr)),
            (yaw(d.L_da, d.N_da), yaw(d.L_dr, d.N_dr)),
            (0.0, 0.0),
        ),
    )


class SmallPerturbation(NamedTuple):
    """The linear plant: constant numbers, and the three questions every plant answers.

    Its air data are those of the reference condition, whatever the height: that is where the derivatives hold.
    """

    reference: Reference
    matrices: Matrices
    trim_throttle: Number
    limits: Limits
    integrator: Tableau | ExactHold

    def start(self, height: Meter | None = None) -> PerturbationState:
        """Undisturbed flight, heading north, at `height` above mean sea level or at the condition's own."""
        return PerturbationState(h=self.reference.h if height is None else height)

    def trim(self) -> Surfaces:
        """The surfaces that hold undisturbed flight."""
        return Surfaces(throttle=self.trim_throttle)

    def derivative(self, x: PerturbationState, held: Surfaces, air: Air) -> PerturbationState:
        """dx/dt with the surfaces held."""
        return derivative(self, x, limited(held, self.limits), air)

    def observe(self, x: PerturbationState, held: Surfaces, air: Air) -> Outputs:
        """All outputs of this instant, the surfaces being `held`."""
        return observe(self, x, limited(held, self.limits), air)

    def advance(
        self, x: PerturbationState, command: Surfaces, air: Air, dt: float, substeps: int = 1
    ) -> PerturbationState:
        """The state one frame later: `substeps` steps of the integrator, surfaces and air held."""
        return advance(self, x, limited(command, self.limits), air, dt, substeps)


def limited(command: Surfaces, limits: Limits) -> Surfaces:
    """The surfaces as far as their stops let them go."""
    return Surfaces(*[min(max(v, low), high) for v, low, high in zip(command, limits.lower, limits.upper, strict=True)])


def derivative(plant: SmallPerturbation, x: PerturbationState, held: Surfaces, air: Air) -> PerturbationState:
    """Equations 2.1 and 2.2 in whichever form, then the kinematics. A gust changes what the aerodynamics feels."""
    A, B, Alat, Blat = plant.matrices
    (xu, xw, xq, xt), (zu, zw, zq, zt), (mu, mw, mq, mt), _ = A
    (xe, xT), (ze, zT), (me, mT), _ = B
    (yb, yp, yr, yf), (lb, lp, lr, lf), (nb, np, nr, nf), (_, fp, fr, _) = Alat
    (ya, yd), (la, ld), (na, nd), _ = Blat
    ref = plant.reference
    de, da, dr, dT = held.elevator, held.aileron, held.rudder, held.throttle - plant.trim_throttle
    q, theta, p, r, phi = x.q, x.theta, x.p, x.r, x.phi
    u, w, beta = x.u - air.gust_u, x.w - air.gust_w, x.beta - air.gust_v / ref.V
    gamma = ref.gamma + theta - x.w / ref.V
    chi = x.psi + x.beta
    V = ref.V + x.u
    level = V * cos(gamma)
    return PerturbationState(
        u=xu * u + xw * w + xq * q + xt * theta + xe * de + xT * dT,
        w=zu * u + zw * w + zq * q + zt * theta + ze * de + zT * dT,
        q=mu * u + mw * w + mq * q + mt * theta + me * de + mT * dT,
        theta=q,
        beta=yb * beta + yp * p + yr * r + yf * phi + ya * da + yd * dr,
        p=lb * beta + lp * p + lr * r + lf * phi + la * da + ld * dr,
        r=nb * beta + np * p + nr * r + nf * phi + na * da + nd * dr,
        phi=fp * p + fr * r,
        psi=r / cos(ref.gamma),
        north=level * cos(chi) + air.wind_north,
        east=level * sin(chi) + air.wind_east,
        h=V * sin(gamma) - air.wind_down,
    )


def observe(plant: SmallPerturbation, x: PerturbationState, held: Surfaces, air: Air) -> Outputs:
    """The outputs of one instant. Rates and load factors are along the plant's stability axes."""
    ref = plant.reference
    dx = derivative(plant, x, held, air)
    u, v, w = ref.V + x.u - air.gust_u, ref.V * x.beta - air.gust_v, x.w - air.gust_w
    V = sqrt(u * u + v * v + w * w)
    a = ref.V / ref.mach
    mach = V / a
    d_alpha = atan2(w, u)
    beta = atan2(v, sqrt(u * u + w * w))
    return Outputs(
        V=V,
        mach=mach,
        cas=calibrated_airspeed(impact_pressure(mach, ref.rho * a * a / GAMMA_AIR)),
        eas=equivalent_airspeed(V, ref.rho),
        qbar=0.5 * ref.rho * V * V,
        alpha=ref.alpha + d_alpha,
        beta=beta,
        gamma=ref.gamma + x.theta - x.w / ref.V,
        chi=atan2(dx.east, dx.north),
        phi=x.phi,
        theta=ref.alpha + ref.gamma + x.theta,
        psi=x.psi,
        p=x.p,
        q=x.q,
        r=x.r,
        p_dot=dx.p,
        q_dot=dx.q,
        r_dot=dx.r,
        psi_dot=dx.psi,
        n_x=(dx.u + ref.g * cos(ref.gamma) * x.theta) / ref.g + sin(ref.gamma),
        n_y=ref.V * (dx.beta + x.r) / ref.g - cos(ref.gamma) * x.phi,
        n_z=cos(ref.gamma) - sin(ref.gamma) * x.theta - (dx.w - ref.V * x.q) / ref.g,
        h=x.h,
        h_dot=dx.h,
        north=x.north,
        east=x.east,
        ground_speed=sqrt(dx.north * dx.north + dx.east * dx.east),
        elevator=held.elevator,
        aileron=held.aileron,
        rudder=held.rudder,
        throttle=held.throttle,
        excursion=max(abs(d_alpha), abs(beta), abs(x.theta), abs(x.phi)),
    )


def advance(
    plant: SmallPerturbation, x: PerturbationState, command: Surfaces, air: Air, dt: float, substeps: int
) -> PerturbationState:
    """The state `dt` later, by the plant's integrator."""
    method = plant.integrator
    if isinstance(method, ExactHold):
        for _ in range(substeps):
            x = _held(plant, method, x, command, air)
        return x

    def f(y: Vector) -> Vector:
        return derivative(plant, PerturbationState(*y), command, air)

    y: Vector = x
    for _ in range(substeps):
        y = step(f, y, dt / substeps, method)
    return PerturbationState(*y)


def _held(
    plant: SmallPerturbation, hold: ExactHold, x: PerturbationState, held: Surfaces, air: Air
) -> PerturbationState:
    """One exact step of the linear states; the place follows by the trapezoidal rule, for it is not linear in them."""
    lon = (x.u, x.w, x.q, x.theta)
    lon_in = (held.elevator, held.throttle - plant.trim_throttle, air.gust_u, air.gust_w)
    lat = (x.beta, x.p, x.r, x.phi, x.psi)
    lat_in = (held.aileron, held.rudder, air.gust_v)
    u, w, q, theta = _affine(hold.Phi_lon, lon, hold.Gamma_lon, lon_in)
    beta, p, r, phi, psi = _affine(hold.Phi_lat, lat, hold.Gamma_lat, lat_in)
    then = PerturbationState(u, w, q, theta, beta, p, r, phi, psi, x.north, x.east, x.h)
    before, after = derivative(plant, x, held, air), derivative(plant, then, held, air)
    half = 0.5 * hold.h
    return then._replace(
        north=x.north + half * (before.north + after.north),
        east=x.east + half * (before.east + after.east),
        h=x.h + half * (before.h + after.h),
    )


def _affine(Phi: Matrix, x: Vector, Gamma: Matrix, u: Vector) -> list[float]:
    return [
        sum([a * v for a, v in zip(row, x, strict=True)]) + sum([b * v for b, v in zip(gain, u, strict=True)])
        for row, gain in zip(Phi, Gamma, strict=True)
    ]
