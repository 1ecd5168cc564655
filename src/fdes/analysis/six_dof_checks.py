"""What must hold of six degrees of freedom without anyone's data: conservation, symmetry, order, consistency.

The tests and ``fdes verify sixdof`` read the same list.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from fdes.aircraft import FlightCondition, load
from fdes.analysis.jacobian import linearized
from fdes.analysis.nonlinear_response import simulate_nonlinear
from fdes.analysis.trim import CALM, TINY, TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.flight.simulation import Clock
from fdes.physics.aero import SimpleBody, simple_body_loads
from fdes.physics.attitude import Three, rotation, turned
from fdes.physics.earth import FLAT, ROUND, WGS84, Earth, geodetic, gravitation, position, potential
from fdes.physics.integrators.rk4 import rk4
from fdes.physics.plant import SixDof, State, state_at
from fdes.physics.rigid_body import Inertia, angular_momentum, rotational_energy
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.physics.wind import wind_from
from fdes.units import DEG

PAPER = ("A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar")
LOPSIDED = Inertia(m=2.0, Ix=2.0, Iy=3.0, Iz=4.0, Ixz=0.5, Ixy=-0.3, Iyz=0.2)
SYMMETRIC = Inertia(m=2.0, Ix=2.0, Iy=3.0, Iz=4.0, Ixz=0.5)
BALL, VACUUM = SimpleBody(S=0.02, b=0.3, c=0.3, CD=0.1), SimpleBody(S=0.0, b=1.0, c=1.0)
TUMBLING = state_at(FLAT, (0.0, 0.0, 5000.0), (30.0, 0.0, 0.0), (0.1, 0.2, 0.3), (1.0, 2.0, 3.0))


@dataclass(frozen=True)
class Property:
    """One property: how far from it we are, and how far is allowed. Where `least`, it is a figure to reach."""

    says: str
    found: float
    allowed: float
    least: bool = False

    @property
    def passed(self) -> bool:
        """Whether it holds."""
        return self.found >= self.allowed if self.least else self.found <= self.allowed


def six_dof_properties() -> Iterator[Property]:
    """All of them, each computed now."""
    yield from _free_spin()
    yield Property("rk4: order measured on a tumbling body, from 4", abs(_order() - 4.0), 0.3)
    yield Property("gravity against the gradient of its potential, relative", _gravity(), 1e-12)
    yield Property(
        "position to latitude, longitude, height and back, poles and date line too [m]", _there_and_back(), 1e-6
    )
    yield Property("energy of a free fall over the rotating Earth, 20 s [J/kg of 6e7]", _free_fall(), 1e-6)
    yield Property("a flight against its mirror image, 5 s [m, m/s, rad/s]", _mirror(), 1e-9)
    yield Property("a flight across the date line against one elsewhere, 20 s [SI]", _longitude(), 1e-7)
    for name in PAPER:
        yield Property(f"{name}, trimmed: accelerations that are left [m/s^2, rad/s^2]", _trimmed(name), 1e-9)
    for surface, signal, falls in (("elevator", "q", 3.5), ("aileron", "p", 7.0), ("rudder", "r", 7.0)):
        says = f"A-4D, {surface} pulse halved: linear and nonlinear {signal} nearer by a factor of"
        yield Property(says, _meeting(surface, signal), falls, least=True)


def _body(earth: Earth, start: State, aero: SimpleBody = VACUUM, inertia: Inertia = LOPSIDED) -> SixDof:
    return SixDof(inertia, aero, simple_body_loads, earth, start, Limits(Surfaces(), Surfaces()), rk4)


def _flown(plant: SixDof, seconds: float, dt: float = 0.01) -> State:
    x = plant.start()
    for _ in range(round(seconds / dt)):
        x = plant.advance(x, Surfaces(), CALM, dt)
    return x


def _free_spin() -> Iterator[Property]:
    """Of a lopsided body in vacuum; the momentum in inertial axes, direction and all."""
    start, end = TUMBLING, _flown(_body(FLAT, TUMBLING), 10.0)

    def momentum(x: State) -> Three:
        return turned(rotation(x.e0, x.e1, x.e2, x.e3), *angular_momentum(LOPSIDED, x.p, x.q, x.r))

    energy = [rotational_energy(LOPSIDED, x.p, x.q, x.r) for x in (start, end)]
    yield Property("energy of a free spin, 10 s, relative", abs(energy[1] / energy[0] - 1.0), 1e-7)
    moved = math.dist(momentum(start), momentum(end)) / math.hypot(*momentum(start))
    yield Property("angular momentum of a free spin, 10 s, relative", moved, 1e-6)


def _order() -> float:
    """How the error of the rates falls when the step is halved."""
    plant = _body(FLAT, TUMBLING, BALL)
    exact = _flown(plant, 2.0, 0.0025)
    coarse, fine = (math.dist(_flown(plant, 2.0, dt)[10:], exact[10:]) for dt in (0.1, 0.05))
    return math.log2(coarse / fine)


def _gravity() -> float:
    worst = 0.0
    for latitude, longitude, h in product((-1.2, 0.0, 0.6, 1.5), (0.0, 2.0), (0.0, 80000.0)):
        r = position(WGS84, latitude, longitude, h)
        pull = gravitation(WGS84, *r)
        for k in range(3):
            tilted: list[complex] = [complex(c, TINY if i == k else 0.0) for i, c in enumerate(r)]
            slope = potential(WGS84, *tilted).imag / TINY  # type: ignore[arg-type]  # a complex step
            worst = max(worst, abs(pull[k] + slope) / math.hypot(*pull))
    return worst


def _there_and_back() -> float:
    worst = 0.0
    for latitude, longitude, h in product(
        (-90.0, -45.0, 0.0, 89.9999999, 90.0), (-180.0, 0.0, 179.9999999), (-4e3, 8e4)
    ):
        there = position(WGS84, latitude * DEG, longitude * DEG, h)
        worst = max(worst, math.dist(position(WGS84, *geodetic(WGS84, *there)), there))
    return worst


def _free_fall() -> float:
    """Kinetic, potential, and that of the centrifugal force: conserved in axes that turn."""
    start = state_at(WGS84, (0.7, 2.0, 20000.0), (100.0, 200.0, -50.0), (0.0, 0.0, 0.0))
    end = _flown(_body(WGS84, start), 20.0)

    def energy(x: State) -> float:
        motion = 0.5 * (x.u**2 + x.v**2 + x.w**2) - 0.5 * WGS84.Omega**2 * (x.x**2 + x.y**2)
        return motion + potential(WGS84, x.x, x.y, x.z)

    return abs(energy(end) - energy(start))


def _mirror() -> float:
    """Left and right exchanged about the plane of a meridian, over an Earth that does not turn, in wind."""

    def mirrored(x: State) -> State:
        return x._replace(y=-x.y, v=-x.v, e1=-x.e1, e3=-x.e3, p=-x.p, r=-x.r)

    start = state_at(ROUND, (0.5, 0.0, 3000.0), (50.0, 5.0, 3.0), (0.3, 0.1, 0.2), (0.5, 0.2, -0.4))
    here = _body(ROUND, start, BALL, SYMMETRIC)._replace(wind=wind_from(90.0 * DEG, 10.0, 0.001))
    there = here._replace(initial=mirrored(start), wind=wind_from(270.0 * DEG, 10.0, 0.001))
    return math.dist(_flown(there, 5.0), mirrored(_flown(here, 5.0)))


def _longitude() -> float:
    """Height, speed, attitude and the rest do not know the longitude."""

    def shown(longitude: float) -> list[float]:
        start = state_at(WGS84, (0.6, longitude * DEG, 3000.0), (50.0, 120.0, 3.0), (0.3, 0.1, 1.5), (0.5, 0.2, -0.4))
        plant = _body(WGS84, start, BALL)
        return list(plant.observe(_flown(plant, 20.0), Surfaces(), CALM))

    return float(np.abs(np.subtract(shown(179.99), shown(0.0))).max())


def _point(condition: FlightCondition) -> TrimSpec:
    return TrimSpec(condition.reference.V, condition.reference.h)


def _trimmed(name: str) -> float:
    condition = load(name).at()
    return trim(six_dof_of(condition), _point(condition)).residual


def _meeting(surface: str, signal: str) -> float:
    """How much smaller the difference to the linear model becomes, over 4 s after a pulse of 1 s, when it is halved."""
    condition, clock = load("A-4D").at(), Clock(0.02, duration=4.0)
    point = trim(six_dof_of(condition), _point(condition))
    model = linearized(point).held(clock.dt)
    row = model.C[model.outputs.index(signal)]

    def apart(degrees: float) -> float:
        flight = simulate_nonlinear(condition, [f"pulse {surface} {degrees}deg at 0.2s for 1s"], clock=clock)
        x, worst = np.zeros(len(model.states)), 0.0
        for k, command in enumerate(flight[f"command_{surface}"].tolist()):
            worst = max(worst, abs(float(row @ x) - float(flight[signal][k])))
            x = model.A @ x + model.B[:, model.inputs.index(surface)] * command
        return worst

    return apart(1.0) / apart(0.5)
