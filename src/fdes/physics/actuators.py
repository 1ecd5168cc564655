"""Actuators: the surface follows its command, not at once and not faster than it can.

First order, position' = bandwidth (command - position); or second order with a damping ratio. The rate limit acts on
the position's rate. Where the surface stops is the plant's affair: it limits the command.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., section 3.6, for the
first-order actuator with its rate limit.
"""

from typing import NamedTuple

from fdes.physics.signals import Surfaces
from fdes.units import Number, Radian, RadianPerSecond, RadianPerSecond2


class Actuator(NamedTuple):
    """One actuator. damping: of a second-order one; 0 makes it of first order."""

    bandwidth: RadianPerSecond
    damping: Number = 0.0
    rate_limit: RadianPerSecond = float("inf")


class Actuators(NamedTuple):
    """One on each surface. The throttle has none: the engine is the plant's."""

    elevator: Actuator
    aileron: Actuator
    rudder: Actuator


class Deflections(NamedTuple):
    """Where the surfaces are, and how fast they move; the rate is a state of second-order actuators only."""

    elevator_position: Radian = 0.0
    elevator_rate: RadianPerSecond = 0.0
    aileron_position: Radian = 0.0
    aileron_rate: RadianPerSecond = 0.0
    rudder_position: Radian = 0.0
    rudder_rate: RadianPerSecond = 0.0


def positions(d: Deflections, throttle: Number) -> Surfaces:
    """The surfaces as the aircraft feels them."""
    return Surfaces(d.elevator_position, d.aileron_position, d.rudder_position, throttle)


def derivative(actuators: Actuators, d: Deflections, command: Surfaces) -> Deflections:
    """How the deflections change while the command is held. The rate of a first-order actuator is no state: zero."""
    elevator, aileron, rudder = actuators
    return Deflections(
        *_one(elevator, d.elevator_position, d.elevator_rate, command.elevator),
        *_one(aileron, d.aileron_position, d.aileron_rate, command.aileron),
        *_one(rudder, d.rudder_position, d.rudder_rate, command.rudder),
    )


def settled(actuators: Actuators, d: Deflections, command: Surfaces) -> Deflections:
    """After a step: no rate beyond its limit, and the rate of a first-order actuator as it now is."""
    elevator, aileron, rudder = actuators
    return d._replace(
        elevator_rate=_rate(elevator, d.elevator_position, d.elevator_rate, command.elevator),
        aileron_rate=_rate(aileron, d.aileron_position, d.aileron_rate, command.aileron),
        rudder_rate=_rate(rudder, d.rudder_position, d.rudder_rate, command.rudder),
    )


def _rate(a: Actuator, position: Radian, rate: RadianPerSecond, command: Radian) -> RadianPerSecond:
    wanted = rate if a.damping else a.bandwidth * (command - position)
    return min(max(wanted, -a.rate_limit), a.rate_limit)


def _one(
    a: Actuator, position: Radian, rate: RadianPerSecond, command: Radian
) -> tuple[RadianPerSecond, RadianPerSecond2]:
    moving = _rate(a, position, rate, command)
    if not a.damping:
        return moving, 0.0
    faster = a.bandwidth * a.bandwidth * (command - position) - 2.0 * a.damping * a.bandwidth * moving
    at_its_limit = abs(rate) >= a.rate_limit and faster * rate > 0.0
    return moving, 0.0 if at_its_limit else faster
