"""The nonlinear plant: six degrees of freedom over any of the Earths, the whole step on one screen.

It answers the same questions as `small_perturbation`. Its rates and load factors are along **body axes**; p, q, r are
relative to inertial space, which is what gyroscopes measure. Its surfaces are measured from those it is trimmed with.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 1.7 and 1.8.
"""

from collections.abc import Callable
from typing import Annotated, Any, NamedTuple

from fdes.elementary import atan2, cos, largest, sin, sqrt, where
from fdes.errors import SpecError
from fdes.physics.aero import SLOWEST, AirLoads, Flow
from fdes.physics.airdata import calibrated_airspeed, equivalent_airspeed, impact_pressure
from fdes.physics.atmosphere import Atmosphere, standard_atmosphere
from fdes.physics.attitude import (
    Rotation,
    Three,
    euler_angles,
    product,
    quaternion,
    quaternion_rate,
    rotation,
    seen_from,
    turned,
    turned_back,
)
from fdes.physics.earth import Earth, Place, gravitation, local_quaternion, place, position
from fdes.physics.envelope import lost_within, must_be_inside
from fdes.physics.propulsion import Engine, Thrust, at_once, no_power
from fdes.physics.rigid_body import Inertia, Loads, acceleration, angular_acceleration, cross
from fdes.physics.runge_kutta import Tableau, Vector, step
from fdes.physics.signals import Air, Outputs, Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.physics.wind import Wind, wind_at
from fdes.units import G0, Kelvin, Kilogram, Meter, MeterPerSecond, Number, RadianPerSecond


class State(NamedTuple):
    """Position in the Earth frame; velocity over the Earth and rates in inertial space, in body axes; attitude as the
    quaternion from body axes to the Earth frame; power of an engine with a lag.
    """

    x: Meter
    y: Meter
    z: Meter
    u: MeterPerSecond
    v: MeterPerSecond
    w: MeterPerSecond
    e0: Number
    e1: Number
    e2: Number
    e3: Number
    p: RadianPerSecond
    q: RadianPerSecond
    r: RadianPerSecond
    power: Annotated[float, "%"] = 0.0


class SixDof(NamedTuple):
    """The nonlinear plant: an airframe in its surroundings, and the three questions every plant answers.

    aerodynamics(aero, flow, surfaces) gives the loads, propulsion(engine, flow, h, throttle, power) the thrust, and
    settled(engine, throttle) the power that an engine with a lag comes to; engine: what these two are given.
    initial: where flights begin. rest: the surfaces that the face calls zero, and its throttle.
    """

    inertia: Inertia
    aero: Any
    aerodynamics: Callable[[Any, Flow, Surfaces], AirLoads]
    earth: Earth
    initial: State
    limits: Limits
    integrator: Tableau
    engine: Any = Engine()
    rest: Surfaces = Surfaces()
    wind: Wind = Wind()
    warmer: Kelvin = 0.0
    propulsion: Callable[[Any, Flow, Meter, Number, Number], Thrust] = at_once
    settled: Callable[[Any, Number], Number] = no_power
    atmosphere: Callable[[Meter, Kelvin], Atmosphere] = standard_atmosphere

    def start(self, height: Meter | None = None) -> State:
        """The initial state, moved up or down to `height` above mean sea level where one is given."""
        return self.initial if height is None else raised(self.earth, self.initial, height)

    def trim(self) -> Surfaces:
        """The surfaces that hold the initial flight."""
        return Surfaces(throttle=self.rest.throttle)

    def derivative(self, x: State, held: Surfaces, air: Air) -> State:
        """dx/dt with the surfaces held."""
        return derivative(self, x, held, air)

    def observe(self, x: State, held: Surfaces, air: Air) -> Outputs:
        """All outputs of this instant, the surfaces being `held`."""
        return observe(self, x, held, air)

    def advance(self, x: State, command: Surfaces, air: Air, dt: float, substeps: int = 1) -> State:
        """The state one frame later: `substeps` steps of the integrator, surfaces and air held. Raises Departed."""
        return advance(self, x, command, air, dt, substeps)


class Instant(NamedTuple):
    """What one evaluation of the equations finds on its way."""

    R: Rotation
    place: Place
    day: Atmosphere
    flow: Flow
    loads: Loads
    rate: State


def derivative(plant: SixDof, x: State, held: Surfaces, air: Air) -> State:
    """dx/dt."""
    return instant(plant, x, held, air).rate


def instant(plant: SixDof, x: State, held: Surfaces, air: Air) -> Instant:
    """The equations of motion, read from top to bottom: where, in which air, under which loads, and so moving how."""
    earth, body = plant.earth, plant.inertia
    R = rotation(x.e0, x.e1, x.e2, x.e3)
    here = place(earth, x.x, x.y, x.z)
    day = day_at(plant, here.h)
    Omega = turned_back(R, 0.0, 0.0, earth.Omega)
    over_earth = x.p - Omega[0], x.q - Omega[1], x.r - Omega[2]
    flow = _flow(plant, x, R, here, day, over_earth, air)
    feel = surfaces(plant, held)
    aero = air_loads(plant, flow, feel)
    push = thrust_of(plant, flow, here.h, feel.throttle, x.power)
    gx, gy, gz = gravitation(earth, x.x, x.y, x.z)
    spin = earth.Omega * earth.Omega
    pull = turned_back(R, gx + spin * x.x, gy + spin * x.y, gz)  # with the centrifugal part
    turning = x.p + Omega[0], x.q + Omega[1], x.r + Omega[2]
    steady = Loads(aero.X + push.X, aero.Y, aero.Z + push.Z, aero.L, aero.M, aero.N)
    moved = acceleration(steady, body.m, pull, x.u, x.v, x.w, turning)
    loads = _with_alpha_dot(steady, aero, body.m, flow, moved, over_earth, x, air)
    moved = acceleration(loads, body.m, pull, x.u, x.v, x.w, turning)
    rate = State(
        *turned(R, x.u, x.v, x.w),
        *moved,
        *quaternion_rate(x.e0, x.e1, x.e2, x.e3, *over_earth),
        *angular_acceleration(body, x.p, x.q, x.r, loads.L, loads.M, loads.N),
        push.power_dot,
    )
    return Instant(R, here, day, flow, loads, rate)


def air_loads(plant: SixDof, flow: Flow, feel: Surfaces) -> AirLoads:
    """What the plant's own aerodynamics say. A compiled plant has those of one kind in its place."""
    return plant.aerodynamics(plant.aero, flow, feel)


def thrust_of(plant: SixDof, flow: Flow, h: Meter, throttle: Number, power: Number) -> Thrust:
    """What the plant's own engine gives. A compiled plant has one of one kind in its place."""
    return plant.propulsion(plant.engine, flow, h, throttle, power)


def day_at(plant: SixDof, h: Meter) -> Atmosphere:
    """The plant's own air at rest. A compiled plant has the standard one in its place."""
    return plant.atmosphere(h, plant.warmer)


def _flow(plant: SixDof, x: State, R: Rotation, here: Place, day: Atmosphere, rates: Three, air: Air) -> Flow:
    """How the air meets the body: its velocity over the Earth less that of the wind and the gust."""
    north, east, down = wind_at(plant.wind, here.h)
    blown = turned(here.local, north + air.wind_north, east + air.wind_east, down + air.wind_down)
    wu, wv, ww = turned_back(R, *blown)
    u, v, w = x.u - wu - air.gust_u, x.v - wv - air.gust_v, x.w - ww - air.gust_w
    V = sqrt(u * u + v * v + w * w)
    alpha, beta = atan2(w, u), atan2(v, sqrt(u * u + w * w))
    return Flow(V, u, v, w, alpha, beta, *rates, day.rho, V / day.a, 0.5 * day.rho * V * V)


def _with_alpha_dot(
    steady: Loads, aero: AirLoads, m: Kilogram, flow: Flow, moved: Three, rates: Three, x: State, air: Air
) -> Loads:
    """The loads with those of alpha_dot, solved for: no value of the last frame is used.

    alpha_dot = e (d/dt of the velocity in the air) / V_xz, e being downward across the flow in the plane of symmetry;
    the lift of alpha_dot acts against e. `moved` is the acceleration without it.
    """
    level = sqrt(flow.u * flow.u + flow.w * flow.w)
    level = where(level.real > SLOWEST, level, SLOWEST)
    sa, ca = flow.w / level, flow.u / level
    # In body axes, steady wind turns against the body.
    wu, wv, ww = x.u - flow.u - air.gust_u, x.v - flow.v - air.gust_v, x.w - flow.w - air.gust_w
    turn_u, _, turn_w = cross(*rates, wu, wv, ww)
    across = ca * (moved[2] + turn_w) - sa * (moved[0] + turn_u)
    alpha_dot = across / (level + aero.lift_alphadot / m)
    lift = aero.lift_alphadot * alpha_dot
    X, Y, Z, L, M, N = steady
    # By position: this is the innermost loop, and _replace takes a third of its time.
    return Loads(X + lift * sa, Y, Z - lift * ca, L, M + aero.M_alphadot * alpha_dot, N)


def surfaces(plant: SixDof, held: Surfaces) -> Surfaces:
    """The surfaces themselves: from their rest, as far as their stops."""
    rest, (low, high) = plant.rest, plant.limits
    return Surfaces(
        within(rest.elevator + held.elevator, low.elevator, high.elevator),
        within(rest.aileron + held.aileron, low.aileron, high.aileron),
        within(rest.rudder + held.rudder, low.rudder, high.rudder),
        within(held.throttle, low.throttle, high.throttle),
    )


def within(value: float, low: float, high: float) -> float:
    """`value`, or the limit that it is beyond; a complex one by its real part."""
    found: float = where(value.real < low, low, where(value.real > high, high, value))
    return found


def advance(plant: SixDof, x: State, command: Surfaces, air: Air, dt: float, substeps: int) -> State:
    """The state `dt` later, by the plant's integrator, the quaternion made a unit again. Raises Departed."""

    def f(y: Vector) -> Vector:
        return derivative(plant, State(*y), command, air)

    for _ in range(substeps):
        try:
            x = State(*step(f, x, dt / substeps, plant.integrator))
        except (SpecError, ArithmeticError, ValueError):
            raise lost_within(x, dt / substeps) from None
        size = sqrt(x.e0 * x.e0 + x.e1 * x.e1 + x.e2 * x.e2 + x.e3 * x.e3)
        x = x._replace(e0=x.e0 / size, e1=x.e1 / size, e2=x.e2 / size, e3=x.e3 / size)
        must_be_inside(x, place(plant.earth, x.x, x.y, x.z).h)
    return x


def observe(plant: SixDof, x: State, held: Surfaces, air: Air) -> Outputs:
    """The outputs of one instant. Rates and load factors are along body axes; n is the force without gravity, by g0."""
    R, here, day, flow, loads, dx = instant(plant, x, held, air)
    attitude = seen_from(here.local, R)
    phi, theta, psi = euler_angles(attitude)
    v_north, v_east, v_down = turned_back(here.local, dx.x, dx.y, dx.z)
    ground_speed = sqrt(v_north * v_north + v_east * v_east)
    north, east = from_start(plant, x)
    alpha, *level = reference_angles(plant)
    weight = plant.inertia.m * G0
    feel = surfaces(plant, held)
    return Outputs(
        V=flow.V,
        mach=flow.mach,
        cas=calibrated_airspeed(impact_pressure(flow.mach, day.p)),
        eas=equivalent_airspeed(flow.V, day.rho),
        qbar=flow.qbar,
        alpha=flow.alpha,
        beta=flow.beta,
        gamma=atan2(-v_down, ground_speed),
        chi=atan2(v_east, v_north),
        phi=phi,
        theta=theta,
        psi=psi,
        p=x.p,
        q=x.q,
        r=x.r,
        p_dot=dx.p,
        q_dot=dx.q,
        r_dot=dx.r,
        psi_dot=(flow.q * sin(phi) + flow.r * cos(phi)) / cos(theta),
        n_x=loads.X / weight,
        n_y=loads.Y / weight,
        n_z=-loads.Z / weight,
        h=here.h,
        h_dot=-v_down,
        north=north,
        east=east,
        ground_speed=ground_speed,
        elevator=feel.elevator - plant.rest.elevator,
        aileron=feel.aileron - plant.rest.aileron,
        rudder=feel.rudder - plant.rest.rudder,
        throttle=feel.throttle,
        excursion=largest(abs(flow.alpha - alpha), abs(flow.beta), abs(phi - level[0]), abs(theta - level[1])),
    )


def reference_angles(plant: SixDof) -> Three:
    """Angle of attack in still air, bank and pitch of the initial flight."""
    x = plant.initial
    here = place(plant.earth, x.x, x.y, x.z)
    phi, theta, _ = euler_angles(seen_from(here.local, rotation(x.e0, x.e1, x.e2, x.e3)))
    return atan2(x.w, x.u), phi, theta


def from_start(plant: SixDof, x: State) -> tuple[Meter, Meter]:
    """How far north and east of its start the aircraft is, along the straight axes of the start."""
    first = plant.initial
    origin = place(plant.earth, first.x, first.y, first.z)
    north, east, _ = turned_back(origin.local, x.x - first.x, x.y - first.y, x.z - first.z)
    return north, east


def state_at(
    earth: Earth,
    at: Three,
    velocity: Three,
    attitude: Three,
    rates: Three = (0.0, 0.0, 0.0),
    *,
    inertial: bool = False,
) -> State:
    """The state of a body at latitude, longitude, height (over a flat Earth: north, east, height).

    velocity: over the Earth, along north, east, down. attitude: phi, theta, psi from local axes.
    rates: p, q, r relative to the Earth, or, where `inertial`, to inertial space.
    """
    e = quaternion(*attitude)
    if earth.g:
        x = (at[0], at[1], -at[2])
    else:
        x = position(earth, *at)
        e = product(local_quaternion(at[0], at[1]), e)
    R = rotation(*e)
    local = place(earth, *x).local
    Omega = (0.0, 0.0, 0.0) if inertial else turned_back(R, 0.0, 0.0, earth.Omega)
    return State(
        *x,
        *turned_back(R, *turned(local, *velocity)),
        *e,
        *(rate + turning for rate, turning in zip(rates, Omega, strict=True)),
    )


def raised(earth: Earth, x: State, h: Meter) -> State:
    """The same state, straight above or below, at height `h` above mean sea level."""
    here = place(earth, x.x, x.y, x.z)
    up = turned(here.local, 0.0, 0.0, here.h - h)
    return x._replace(x=x.x + up[0], y=x.y + up[1], z=x.z + up[2])
