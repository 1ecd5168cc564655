"""Newton's and Euler's equations of a rigid body, in body axes, with the whole tensor of inertia.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., sec. 1.7.
"""

from typing import Annotated, NamedTuple

from fdes.physics.attitude import Three
from fdes.units import Kilogram, KilogramMeter2, MeterPerSecond, MeterPerSecond2, Newton, RadianPerSecond

NewtonMeter = Annotated[float, "N m"]


class Inertia(NamedTuple):
    """Mass and moments of inertia; a product is the integral of x y dm, with its sign. Hx: of the engine's rotor."""

    m: Kilogram
    Ix: KilogramMeter2
    Iy: KilogramMeter2
    Iz: KilogramMeter2
    Ixz: KilogramMeter2 = 0.0
    Ixy: KilogramMeter2 = 0.0
    Iyz: KilogramMeter2 = 0.0
    Hx: Annotated[float, "N m s"] = 0.0


class Loads(NamedTuple):
    """Forces and, about the center of gravity, moments, in body axes."""

    X: Newton = 0.0
    Y: Newton = 0.0
    Z: Newton = 0.0
    L: NewtonMeter = 0.0
    M: NewtonMeter = 0.0
    N: NewtonMeter = 0.0


def cross(ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> Three:
    """The vector product a x b."""
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


def angular_momentum(
    body: Inertia, p: RadianPerSecond, q: RadianPerSecond, r: RadianPerSecond
) -> tuple[float, float, float]:
    """In body axes [N m s]."""
    return (
        body.Ix * p - body.Ixy * q - body.Ixz * r + body.Hx,
        -body.Ixy * p + body.Iy * q - body.Iyz * r,
        -body.Ixz * p - body.Iyz * q + body.Iz * r,
    )


def rotational_energy(body: Inertia, p: RadianPerSecond, q: RadianPerSecond, r: RadianPerSecond) -> float:
    """Kinetic energy of rotation, without the engine's own [J]."""
    hx, hy, hz = angular_momentum(body._replace(Hx=0.0), p, q, r)
    return 0.5 * (p * hx + q * hy + r * hz)


def angular_acceleration(
    body: Inertia, p: RadianPerSecond, q: RadianPerSecond, r: RadianPerSecond, L: float, M: float, N: float
) -> Three:
    """p_dot, q_dot, r_dot [rad/s^2] of a body that turns with p, q, r in inertial space. Euler's equations."""
    gx, gy, gz = cross(p, q, r, *angular_momentum(body, p, q, r))
    L, M, N = L - gx, M - gy, N - gz
    Ix, Iy, Iz, Ixy, Ixz, Iyz = body.Ix, body.Iy, body.Iz, body.Ixy, body.Ixz, body.Iyz
    # The inverse of the tensor by cofactors, which are symmetric.
    kx, ky, kz = Iy * Iz - Iyz * Iyz, Ix * Iz - Ixz * Ixz, Ix * Iy - Ixy * Ixy
    kxy, kxz, kyz = Ixy * Iz + Iyz * Ixz, Ixy * Iyz + Iy * Ixz, Ix * Iyz + Ixy * Ixz
    D = 1.0 / (Ix * kx - Ixy * kxy - Ixz * kxz)
    return (
        (kx * L + kxy * M + kxz * N) * D,
        (kxy * L + ky * M + kyz * N) * D,
        (kxz * L + kyz * M + kz * N) * D,
    )


def acceleration(
    loads: Loads, m: Kilogram, pull: Three, u: MeterPerSecond, v: MeterPerSecond, w: MeterPerSecond, turning: Three
) -> tuple[MeterPerSecond2, MeterPerSecond2, MeterPerSecond2]:
    """u_dot, v_dot, w_dot over the Earth: forces by the mass and gravity, less what the turning of the axes takes.

    `pull` is gravity with the centrifugal part, `turning` the rates in inertial space plus those of the Earth, all in
    body axes.
    """
    cx, cy, cz = cross(*turning, u, v, w)
    return loads.X / m + pull[0] - cx, loads.Y / m + pull[1] - cy, loads.Z / m + pull[2] - cz
