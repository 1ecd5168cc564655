"""Physics as it stands, compiled: the parts of the nonlinear derivative against their plain text."""

from collections.abc import Callable
from typing import Any

import pytest

from fdes.aircraft import load
from fdes.flight.nonlinear import six_dof_of
from fdes.kernel import compiled
from fdes.physics.aero import Flow, SimpleBody, derivative_loads, limited_lift, simple_body_loads
from fdes.physics.attitude import euler_angles, product, quaternion, quaternion_rate, rotation, seen_from
from fdes.physics.earth import FLAT, ROUND, WGS84, gravitation, place, potential
from fdes.physics.propulsion import thrust
from fdes.physics.rigid_body import Inertia, Loads, acceleration, angular_acceleration
from fdes.physics.signals import Surfaces
from fdes.physics.wind import Wind, wind_at

NAVION = six_dof_of(load("NAVION").at())
FLOW = Flow(55.0, 54.8, 2.0, 4.0, 0.073, 0.036, 0.1, 0.2, -0.1, 1.1, 0.16, 1660.0)
HELD = Surfaces(-0.02, 0.03, 0.01, 0.6)
HERE = (4.2e6, 0.9e6, 4.7e6)
R = rotation(*quaternion(0.1, 0.2, 0.3))
CASES: list[tuple[Callable[..., Any], tuple[Any, ...]]] = [
    (quaternion, (0.1, -0.2, 3.0)),
    (rotation, (0.9, 0.1, 0.3, 0.3)),
    (product, (quaternion(0.1, 0.2, 0.3), quaternion(0.3, 0.2, 0.1))),
    (euler_angles, (R,)),
    (seen_from, (R, rotation(*quaternion(0.3, 0.1, 2.0)))),
    (quaternion_rate, (0.9, 0.1, 0.3, 0.3, 0.1, 0.2, 0.3)),
    (place, (WGS84, *HERE)),
    (place, (ROUND, *HERE)),
    (place, (FLAT, 3.0, 4.0, -500.0)),
    (gravitation, (WGS84, *HERE)),
    (potential, (WGS84, *HERE)),
    (wind_at, (Wind(3.0, 4.0, 0.0, 0.01, 0.0), 500.0)),
    (angular_acceleration, (Inertia(2.0, 2.0, 3.0, 4.0, 0.5, -0.3, 0.2, 7.0), 0.1, 0.2, 0.3, 1.0, 2.0, 3.0)),
    (acceleration, (Loads(1.0, 2.0, 3.0), 2.0, (0.0, 0.0, 9.8), 50.0, 2.0, 4.0, (0.1, 0.2, 0.3))),
    (thrust, (NAVION.engine, FLOW, 0.6)),
    (limited_lift, (1.15, 1.2)),
    (derivative_loads, (NAVION.aero, FLOW, HELD)),
    (simple_body_loads, (SimpleBody(0.02, 0.3, 0.3, 0.1, -0.4, -9.0, -0.2), FLOW, HELD)),
]


def flat(values: Any) -> list[float]:
    return [v for part in values for v in flat(part)] if isinstance(values, tuple) else [values]


@pytest.mark.parametrize(("function", "arguments"), CASES, ids=[f.__name__ for f, _ in CASES])
def test_compiled_is_plain(function: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
    plain, machine = flat(function(*arguments)), flat(compiled(function)(*arguments))
    assert machine == pytest.approx(plain, rel=1e-12, abs=1e-9 * max(map(abs, plain)))
