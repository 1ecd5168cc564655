"""From one plant to the other in flight: the same flight in the state of whichever flies on.

What is carried over is how far the aircraft is from the undisturbed flight of its plant, so that flight hands off stays
what it is, and where it is. The linear plant takes over only what small perturbations can be.
"""

from math import atan2, cos, radians, sin, sqrt
from typing import Any

from fdes.flight.actuated import WithActuators, fitted
from fdes.flight.simulation import Plant
from fdes.physics.attitude import euler_angles, quaternion, rotation
from fdes.physics.plant import SixDof, State, reference_angles
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import PerturbationState, SmallPerturbation

SMALL = radians(15.0)  # Mansor and Perumal, sec. 7: of angles, and of the change of speed over the speed


def carried(x: Any, before: Plant, after: Plant, surfaces: Surfaces) -> Any:
    """The state `x` of `before` as `after` has it, actuators and all; new actuators begin at the `surfaces`."""
    if not crosses(before, after):
        return fitted(x, after, surfaces)
    return as_far(x, before, after, surfaces)


def as_far(x: Any, before: Plant, after: Plant, surfaces: Surfaces) -> Any:
    """The state of `after` that is as far from its undisturbed flight as `x` is from that of `before`."""
    return fitted(_as(bare(after), _deviations(bare(before), fitted(x, bare(before), surfaces))), after, surfaces)


def crosses(before: Plant, after: Plant) -> bool:
    """Whether one is linear and the other is not."""
    return type(bare(before)) is not type(bare(after))


def can_carry(x: Any, before: Plant, after: Plant) -> bool:
    """Whether `after` can fly on from there: anything can but the linear plant beyond small perturbations."""
    if not crosses(before, after) or not isinstance(plant := bare(after), SmallPerturbation):
        return True
    d = _deviations(bare(before), fitted(x, bare(before), Surfaces()))
    V = plant.reference.V
    return max(abs(d.u) / V, abs(d.w) / V, abs(d.beta), abs(d.theta), abs(d.phi)) <= SMALL


def anew(x: Any, before: Plant, after: Plant) -> Any:
    """The undisturbed flight of `after` where the aircraft is: its place, height and heading."""
    d = _deviations(bare(before), fitted(x, bare(before), Surfaces()))
    here = _as(bare(after), PerturbationState(psi=d.psi, north=d.north, east=d.east, h=d.h))
    return fitted(here, after, after.trim())


def bare(plant: Plant) -> Any:
    """The plant without actuators."""
    return plant.plant if isinstance(plant, WithActuators) else plant


def displaced(x: Any, by: PerturbationState) -> Any:
    """A state of the nonlinear plant, with or without actuators, over a flat Earth, with perturbations `by` added.

    u, w, p and r are along and about the axes of the present flow; the attitude turns without the motion in body axes.
    """
    phi, theta, psi = euler_angles(rotation(x.e0, x.e1, x.e2, x.e3))
    if by.phi or by.theta or by.psi:
        e = quaternion(phi + by.phi, theta + by.theta, psi + by.psi)
        x = x._replace(e0=e[0], e1=e[1], e2=e[2], e3=e[3])
    alpha = atan2(x.w, x.u)
    ca, sa = cos(alpha), sin(alpha)
    V = sqrt(x.u * x.u + x.v * x.v + x.w * x.w)
    return x._replace(
        x=x.x + by.north,
        y=x.y + by.east,
        z=x.z - by.h,
        u=x.u + by.u * ca - by.w * sa,
        v=x.v + V * by.beta,
        w=x.w + by.u * sa + by.w * ca,
        p=x.p + by.p * ca - by.r * sa,
        q=x.q + by.q,
        r=x.r + by.p * sa + by.r * ca,
    )


def _deviations(plant: Any, x: Any) -> PerturbationState:
    """How far `x` is from undisturbed flight, in the state of the linear plant; heading and place are absolute."""
    if not isinstance(plant, SixDof):
        return PerturbationState(*x)
    V, alpha, _, theta_0 = _undisturbed(plant)
    ca, sa = cos(alpha), sin(alpha)
    phi, theta, psi = euler_angles(rotation(x.e0, x.e1, x.e2, x.e3))
    return PerturbationState(
        u=x.u * ca + x.w * sa - V,
        w=x.w * ca - x.u * sa,
        q=x.q,
        theta=theta - theta_0,
        beta=x.v / V,
        p=x.p * ca + x.r * sa,
        r=x.r * ca - x.p * sa,
        phi=phi,
        psi=psi,
        north=x.x - plant.initial.x,
        east=x.y - plant.initial.y,
        h=-x.z,
    )


def _as(plant: Any, d: PerturbationState) -> Any:
    """The state of `plant` that is so far from its undisturbed flight."""
    if not isinstance(plant, SixDof):
        return d
    V, alpha, _, theta_0 = _undisturbed(plant)
    ca, sa = cos(alpha), sin(alpha)
    along = V + d.u
    return State(
        plant.initial.x + d.north,
        plant.initial.y + d.east,
        -d.h,
        along * ca - d.w * sa,
        V * d.beta,
        along * sa + d.w * ca,
        *quaternion(d.phi, theta_0 + d.theta, d.psi),
        d.p * ca - d.r * sa,
        d.q,
        d.p * sa + d.r * ca,
        plant.initial.power,
    )


def _undisturbed(plant: SixDof) -> tuple[float, float, float, float]:
    """Speed, angle of attack, bank and pitch in which flights of `plant` begin."""
    x = plant.initial
    return (sqrt(x.u * x.u + x.v * x.v + x.w * x.w), *reference_angles(plant))
