"""Aerodynamics: what the flow does to an aircraft, as forces and moments in body axes about the center of gravity.

Each way to say aerodynamics is a named tuple of numbers, and a function that makes `Loads` of them and a `Flow`. The
simple body is one of which only drag and damping are known.
"""

from typing import NamedTuple

from fdes.elementary import where
from fdes.physics.rigid_body import Loads
from fdes.physics.signals import Surfaces
from fdes.units import FOOT, KilogramPerMeter3, Meter, Meter2, MeterPerSecond, Number, Pascal, Radian, RadianPerSecond

SLOWEST: MeterPerSecond = 0.5 * FOOT  # below it, rates are made dimensionless by it: NASA/TM-2015-218675, the brick


class Flow(NamedTuple):
    """How the air meets the body. Its rates p, q, r are relative to the air, which turns with the Earth."""

    V: MeterPerSecond
    u: MeterPerSecond
    v: MeterPerSecond
    w: MeterPerSecond
    alpha: Radian
    beta: Radian
    p: RadianPerSecond
    q: RadianPerSecond
    r: RadianPerSecond
    rho: KilogramPerMeter3
    mach: Number
    qbar: Pascal


class SimpleBody(NamedTuple):
    """A body that air slows down: drag along the wind, and damping of its rotation, all about constant coefficients."""

    S: Meter2
    b: Meter
    c: Meter
    CD: Number = 0.0
    Cl_p: Number = 0.0
    Cm_q: Number = 0.0
    Cn_r: Number = 0.0


def simple_body_loads(body: SimpleBody, flow: Flow, surfaces: Surfaces) -> Loads:
    """Its drag and its damping; it has no surfaces. NASA/TM-2015-218675, appendix B, brick and cannonball."""
    drag = 0.5 * flow.rho * flow.V * body.S * body.CD  # divided by V, so that a body at rest has a direction
    qS = flow.qbar * body.S
    hat = 0.5 / where(flow.V.real > SLOWEST, flow.V, SLOWEST)
    return Loads(
        -drag * flow.u,
        -drag * flow.v,
        -drag * flow.w,
        qS * body.b * body.Cl_p * hat * body.b * flow.p,
        qS * body.c * body.Cm_q * hat * body.c * flow.q,
        qS * body.b * body.Cn_r * hat * body.b * flow.r,
    )
