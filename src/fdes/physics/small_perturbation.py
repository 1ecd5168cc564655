"""The linear plant: what flies when the equations are those of small perturbations.

Its state is what is disturbed, in stability axes, and where the aircraft is; `derivatives` makes its matrices. It is
honest to about 15 degrees from the reference condition (Mansor and Perumal, section 7), and `Outputs.excursion` says
how far it is.
"""

from collections.abc import Callable
from typing import Annotated, NamedTuple

from fdes.elementary import atan2, cos, dot, each, largest, sin, sqrt
from fdes.physics.airdata import calibrated_airspeed, equivalent_airspeed, impact_pressure
from fdes.physics.atmosphere import GAMMA_AIR
from fdes.physics.derivatives import Matrices, Matrix, Reference
from fdes.physics.runge_kutta import Tableau, Vector, step
from fdes.physics.signals import Air, Outputs, Surfaces
from fdes.units import Meter, MeterPerSecond, Number, Radian, RadianPerSecond


class Limits(NamedTuple):
    """How far the surfaces and the throttle can go."""

    lower: Surfaces
    upper: Surfaces


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
    elevator, aileron, rudder, throttle = command
    (e_low, a_low, r_low, t_low), (e_high, a_high, r_high, t_high) = limits
    free = e_low <= elevator <= e_high and a_low <= aileron <= a_high and r_low <= rudder <= r_high
    if free and t_low <= throttle <= t_high:
        return command
    return Surfaces(
        min(max(elevator, e_low), e_high),
        min(max(aileron, a_low), a_high),
        min(max(rudder, r_low), r_high),
        min(max(throttle, t_low), t_high),
    )


def derivative(plant: SmallPerturbation, x: PerturbationState, held: Surfaces, air: Air) -> PerturbationState:
    """Equations 2.1 and 2.2 in whichever form, then the kinematics."""
    return PerturbationState(*_rates(plant, held, air)(x))


def _rates(plant: SmallPerturbation, held: Surfaces, air: Air) -> Callable[[Vector], Vector]:
    """dx/dt as a function of the state alone: what surfaces and gusts add is the same for all stages of a step.

    A gust is felt by the aerodynamics as the opposite motion of the aircraft. Plain tuples, in the order of the state:
    this is the innermost loop, and records take twice as long.
    """
    ref = plant.reference
    A, B, Alat, Blat = plant.matrices
    (xu, xw, xq, xt), (zu, zw, zq, zt), (mu, mw, mq, mt), _ = A
    (xe, xT), (ze, zT), (me, mT), _ = B
    (yb, yp, yr, yf), (lb, lp, lr, lf), (nb, np, nr, nf), (_, hp, hr, _) = Alat
    (ya, yd), (la, ld), (na, nd), _ = Blat
    de, da, dr, throttle = held
    dT = throttle - plant.trim_throttle
    _, _, _, ug, vg, wg = air
    bg = vg / ref.V
    fu = xe * de + xT * dT - xu * ug - xw * wg
    fw = ze * de + zT * dT - zu * ug - zw * wg
    fq = me * de + mT * dT - mu * ug - mw * wg
    fb = ya * da + yd * dr - yb * bg
    fp = la * da + ld * dr - lb * bg
    fr = na * da + nd * dr - nb * bg
    level = cos(ref.gamma)

    def rates(x: Vector) -> Vector:
        u, w, q, theta, beta, p, r, phi, psi, _, _, _ = x
        return (
            xu * u + xw * w + xq * q + xt * theta + fu,
            zu * u + zw * w + zq * q + zt * theta + fw,
            mu * u + mw * w + mq * q + mt * theta + fq,
            q,
            yb * beta + yp * p + yr * r + yf * phi + fb,
            lb * beta + lp * p + lr * r + lf * phi + fp,
            nb * beta + np * p + nr * r + nf * phi + fr,
            hp * p + hr * r,
            r / level,
            *_velocity(ref, u, w, theta, psi + beta, air),
        )

    return rates


def _velocity(ref: Reference, u: float, w: float, theta: float, chi: float, air: Air) -> tuple[float, float, float]:
    """Over the Earth, north, east and up [m/s]: the airspeed along the flight path, heading `chi`, and the wind."""
    V = ref.V + u
    gamma = ref.gamma + theta - w / ref.V
    level = V * cos(gamma)
    return level * cos(chi) + air.wind_north, level * sin(chi) + air.wind_east, V * sin(gamma) - air.wind_down


def observe(plant: SmallPerturbation, x: PerturbationState, held: Surfaces, air: Air) -> Outputs:
    """The outputs of one instant. Rates and load factors are along the plant's stability axes."""
    ref = plant.reference
    du, dw, q_dot, _, dbeta, p_dot, r_dot, _, psi_dot, to_north, to_east, h_dot = _rates(plant, held, air)(x)
    u, v, w = ref.V + x.u - air.gust_u, ref.V * x.beta - air.gust_v, x.w - air.gust_w
    V = sqrt(u * u + v * v + w * w)
    a = ref.V / ref.mach
    mach = V / a
    static = ref.rho * a * a / GAMMA_AIR
    cas = each(lambda m: calibrated_airspeed(impact_pressure(m, static)), mach)
    d_alpha = atan2(w, u)
    beta = atan2(v, sqrt(u * u + w * w))
    level, steep = cos(ref.gamma), sin(ref.gamma)
    n_x = (du + ref.g * level * x.theta) / ref.g + steep
    n_y = ref.V * (dbeta + x.r) / ref.g - level * x.phi
    n_z = level - steep * x.theta - (dw - ref.V * x.q) / ref.g
    # By position: by name they take three times as long, and this is done in every frame.
    return Outputs(
        V, mach, cas, equivalent_airspeed(V, ref.rho), 0.5 * ref.rho * V * V,
        ref.alpha + d_alpha, beta, ref.gamma + x.theta - x.w / ref.V, atan2(to_east, to_north),
        x.phi, ref.alpha + ref.gamma + x.theta, x.psi,
        x.p, x.q, x.r, p_dot, q_dot, r_dot, psi_dot, n_x, n_y, n_z,
        x.h, h_dot, x.north, x.east, sqrt(to_north * to_north + to_east * to_east),
        held.elevator, held.aileron, held.rudder, held.throttle,
        largest(abs(d_alpha), abs(beta), abs(x.theta), abs(x.phi)),
    )  # fmt: skip


def advance(
    plant: SmallPerturbation, x: PerturbationState, command: Surfaces, air: Air, dt: float, substeps: int
) -> PerturbationState:
    """The state `dt` later, by the plant's integrator."""
    method = plant.integrator
    if isinstance(method, ExactHold):
        for _ in range(substeps):
            x = _held(plant, method, x, command, air)
        return x

    f = _rates(plant, command, air)
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
    north, east, up = _velocity(plant.reference, x.u, x.w, x.theta, x.psi + x.beta, air)
    north_then, east_then, up_then = _velocity(plant.reference, u, w, theta, psi + beta, air)
    half = 0.5 * hold.h
    place = (x.north + half * (north + north_then), x.east + half * (east + east_then), x.h + half * (up + up_then))
    return PerturbationState(u, w, q, theta, beta, p, r, phi, psi, *place)


def _affine(Phi: Matrix, x: Vector, Gamma: Matrix, u: Vector) -> list[float]:
    """Phi x + Gamma u."""
    return [dot(row, x) + dot(gain, u) for row, gain in zip(Phi, Gamma, strict=True)]
