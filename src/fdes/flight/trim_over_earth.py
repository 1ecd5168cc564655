"""Trim in straight flight over a round, turning Earth: steady as seen from local axes that go along.

Over such an Earth no flight is exactly steady: gravity changes underway, and the turning of the Earth pushes sideways.
So speed, path and attitude are held against north, east and down at one place: there the accelerations along the body's
x and z axes and in pitch are zero, wings level, and the rates are those at which the local axes turn.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 1.6, for the radii;
NASA/TM-2015-218675, appendix B, case 11, for the flight.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from fdes.elementary import atan2, sin, sqrt, tan
from fdes.errors import SpecError, TrimError
from fdes.flight.steady import CALM, FREE, slopes
from fdes.physics.attitude import Three, quaternion, rotation, turned_back
from fdes.physics.earth import Earth
from fdes.physics.plant import SixDof, State, derivative, state_at
from fdes.physics.signals import Surfaces
from fdes.units import DEG, Meter, MeterPerSecond, Radian

ENOUGH = 1e-10  # of the accelerations [m/s^2 and rad/s^2]
ITERATIONS = 25
NORTHMOST = 89.9 * DEG


class Over(NamedTuple):
    """Where and how to fly: the velocity over the Earth along north, east and down."""

    latitude: Radian
    longitude: Radian
    h: Meter
    north: MeterPerSecond
    east: MeterPerSecond
    down: MeterPerSecond = 0.0


def trim_over(plant: SixDof, earth: Earth, over: Over) -> SixDof:
    """The plant over `earth`, its flights beginning in that one. Raises SpecError, TrimError.

    SpecError: over a flat Earth, or straight up or down. TrimError: nothing balances it, or not within the stops of
    elevator and throttle.
    """
    level = sqrt(over.north * over.north + over.east * over.east)
    if earth.g or not level:
        raise SpecError("This trim is along the surface of a round Earth: over a flat one, ask for an ordinary trim.")
    if abs(over.latitude) > NORTHMOST:
        raise SpecError(
            f"The latitude is {over.latitude / DEG:g} deg; a trim is within {NORTHMOST / DEG:g} deg of the equator: "
            "at a pole, no direction is north."
        )
    course = atan2(over.east, over.north)
    turning = local_rates(earth, over)
    free = plant._replace(earth=earth, limits=FREE, rest=Surfaces())

    def state(theta: float, throttle: float) -> State:
        rates = turned_back(rotation(*quaternion(0.0 * theta, theta, course + 0.0 * theta)), *turning)
        at, velocity = (over.latitude, over.longitude, over.h), (over.north, over.east, over.down)
        x = state_at(earth, at, velocity, (0.0 * theta, theta, course + 0.0 * theta), rates)
        return x._replace(power=plant.settled(plant.engine, throttle))

    def accelerations(z: Sequence[float]) -> list[float]:
        theta, elevator, throttle = z
        rate = derivative(free, state(theta, throttle), Surfaces(elevator, throttle=throttle), CALM)
        return [rate.u, rate.w, rate.q]

    z = np.array([atan2(plant.initial.w, plant.initial.u) + atan2(-over.down, level), 0.0, plant.rest.throttle])
    left = np.array(accelerations(z.tolist()))
    for _ in range(ITERATIONS):
        if np.abs(left).max() < ENOUGH or not np.isfinite(left).all():
            break
        z -= np.linalg.lstsq(slopes(accelerations, z.tolist()), left, rcond=None)[0]
        left = np.array(accelerations(z.tolist()))
    theta, elevator, throttle = z.tolist()
    low, high = plant.limits
    within = low.elevator <= elevator <= high.elevator and low.throttle <= throttle <= high.throttle
    found = plant._replace(earth=earth, initial=state(theta, throttle), rest=Surfaces(elevator, throttle=throttle))
    if not (within and np.abs(left).max() <= 100.0 * ENOUGH):
        raise TrimError(
            f"No trim over that Earth: the nearest has pitch {theta / DEG:.4g} deg, elevator {elevator / DEG:.4g} deg "
            f"of {low.elevator / DEG:.4g} to {high.elevator / DEG:.4g}, throttle {throttle:.4g} of {low.throttle:g} to "
            f"{high.throttle:g}, and still accelerates by {np.abs(left).max():.2g} m/s^2 or rad/s^2. "
            "Ask for another speed or height.",
            best=found,
            nearest=None,
        )
    return found


def local_rates(earth: Earth, over: Over) -> Three:
    """At which north, east and down turn against the Earth, about themselves [rad/s]. Sec. 1.6."""
    e2 = earth.flattening * (2.0 - earth.flattening)
    w = 1.0 - e2 * sin(over.latitude) * sin(over.latitude)
    across = earth.a / sqrt(w)
    along = earth.a * (1.0 - e2) / (w * sqrt(w))
    longitude_dot = over.east / (across + over.h)
    return longitude_dot, -over.north / (along + over.h), -longitude_dot * tan(over.latitude)
