"""Attitude: quaternions, Euler angles, and the rotations they stand for.

A `Rotation` takes a vector from the axes of a body to those of a frame; its columns are the body axes, seen there.
Euler angles are the 3-2-1 angles of flight: heading, then pitch, then bank.

Reference: B. L. Stevens, F. L. Lewis, E. N. Johnson, Aircraft Control and Simulation, 3rd ed., Wiley 2016, ch. 1.
"""

from typing import NamedTuple

from fdes.elementary import atan2, cos, sin, sqrt
from fdes.units import Number, Radian, RadianPerSecond

Three = tuple[float, float, float]


class Quaternion(NamedTuple):
    """A unit quaternion, its scalar part first: the rotation from body axes to a frame."""

    e0: Number
    e1: Number
    e2: Number
    e3: Number


class Rotation(NamedTuple):
    """The rotation from body axes to a frame, row by row: xy is the part of the body's y axis along the frame's x."""

    xx: Number
    xy: Number
    xz: Number
    yx: Number
    yy: Number
    yz: Number
    zx: Number
    zy: Number
    zz: Number


def rotation(e0: Number, e1: Number, e2: Number, e3: Number) -> Rotation:
    """The rotation of a unit quaternion. Stevens et al., sec. 1.8."""
    return Rotation(
        e0 * e0 + e1 * e1 - e2 * e2 - e3 * e3,
        2.0 * (e1 * e2 - e0 * e3),
        2.0 * (e1 * e3 + e0 * e2),
        2.0 * (e1 * e2 + e0 * e3),
        e0 * e0 - e1 * e1 + e2 * e2 - e3 * e3,
        2.0 * (e2 * e3 - e0 * e1),
        2.0 * (e1 * e3 - e0 * e2),
        2.0 * (e2 * e3 + e0 * e1),
        e0 * e0 - e1 * e1 - e2 * e2 + e3 * e3,
    )


def turned(R: Rotation, x: float, y: float, z: float) -> Three:
    """A vector of the body in the axes of the frame."""
    return R.xx * x + R.xy * y + R.xz * z, R.yx * x + R.yy * y + R.yz * z, R.zx * x + R.zy * y + R.zz * z


def turned_back(R: Rotation, x: float, y: float, z: float) -> Three:
    """A vector of the frame in the axes of the body."""
    return R.xx * x + R.yx * y + R.zx * z, R.xy * x + R.yy * y + R.zy * z, R.xz * x + R.yz * y + R.zz * z


def seen_from(local: Rotation, body: Rotation) -> Rotation:
    """The body's rotation to the axes `local`, both being rotations to the same frame."""
    xx, yx, zx = turned_back(local, body.xx, body.yx, body.zx)
    xy, yy, zy = turned_back(local, body.xy, body.yy, body.zy)
    xz, yz, zz = turned_back(local, body.xz, body.yz, body.zz)
    return Rotation(xx, xy, xz, yx, yy, yz, zx, zy, zz)


def euler_angles(R: Rotation) -> tuple[Radian, Radian, Radian]:
    """(phi, theta, psi). Stevens et al., sec. 1.3; the pitch by atan2, which is exact near 90 degrees too."""
    level = sqrt(R.xx * R.xx + R.yx * R.yx)
    return atan2(R.zy, R.zz), atan2(-R.zx, level), atan2(R.yx, R.xx)


def quaternion(phi: Radian, theta: Radian, psi: Radian) -> Quaternion:
    """From Euler angles. Stevens et al., sec. 1.8."""
    cf, sf = cos(0.5 * phi), sin(0.5 * phi)
    ct, st = cos(0.5 * theta), sin(0.5 * theta)
    cp, sp = cos(0.5 * psi), sin(0.5 * psi)
    return Quaternion(
        cf * ct * cp + sf * st * sp,
        sf * ct * cp - cf * st * sp,
        cf * st * cp + sf * ct * sp,
        cf * ct * sp - sf * st * cp,
    )


def product(a: Quaternion, b: Quaternion) -> Quaternion:
    """First the rotation `b`, then `a`. Stevens et al., sec. 1.8."""
    return Quaternion(
        a.e0 * b.e0 - a.e1 * b.e1 - a.e2 * b.e2 - a.e3 * b.e3,
        a.e0 * b.e1 + a.e1 * b.e0 + a.e2 * b.e3 - a.e3 * b.e2,
        a.e0 * b.e2 - a.e1 * b.e3 + a.e2 * b.e0 + a.e3 * b.e1,
        a.e0 * b.e3 + a.e1 * b.e2 - a.e2 * b.e1 + a.e3 * b.e0,
    )


def quaternion_rate(
    e0: Number, e1: Number, e2: Number, e3: Number, p: RadianPerSecond, q: RadianPerSecond, r: RadianPerSecond
) -> tuple[float, float, float, float]:
    """d/dt of the quaternion of a body that turns with p, q, r, its rates relative to the frame. Sec. 1.8."""
    return (
        0.5 * (-p * e1 - q * e2 - r * e3),
        0.5 * (p * e0 + r * e2 - q * e3),
        0.5 * (q * e0 - r * e1 + p * e3),
        0.5 * (r * e0 + q * e1 - p * e2),
    )
