"""The F-16's control system of the check cases, by itself."""

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.control import Stick
from fdes.control.f16_autopilot import F16Autopilot
from fdes.control.law import SURFACES
from fdes.flight import plant_of
from fdes.physics.signals import Air, Outputs
from fdes.units import DEG, FOOT, KNOT

PLANT = plant_of(load("F-16").at("M0.53_10kft"))
Y: Outputs = PLANT.observe(PLANT.start(), PLANT.trim(), Air())
STEADY = F16Autopilot(
    altitude=Y.h, course=Y.psi, airspeed=Y.eas, alpha=Y.alpha, theta=Y.theta, elevator=-3.23 * DEG, throttle=0.1387
)
DT = 0.01


def command(y: Outputs, law: F16Autopilot = STEADY) -> np.ndarray:
    return np.array(law.step(y, Stick(), None, DT)[0])


def test_in_its_steady_flight_it_leaves_all_as_it_is() -> None:
    np.testing.assert_allclose(command(Y), [0.0, 0.0, 0.0, 0.1387], atol=1e-12)


def test_linear_is_the_jacobian_of_step() -> None:
    model = STEADY.linear(DT)
    assert model.outputs == SURFACES
    for name, column in zip(model.inputs, model.D.T, strict=True):
        h = 1e-6 * {"eas": 10.0, "h": 10.0}.get(name, 1e-2)
        up, down = (command(Y._replace(**{name: getattr(Y, name) + s * h})) for s in (1.0, -1.0))
        np.testing.assert_allclose((up - down) / (2.0 * h), column, atol=1e-7 * max(1.0, np.abs(column).max()))


@pytest.mark.parametrize(
    ("signal", "by", "surface", "sign"),
    [
        ("q", 0.01, "elevator", 1.0),  # pitching up: trailing edge down, nose down
        ("theta", 0.01, "elevator", 1.0),
        ("h", 30.0, "elevator", 1.0),  # too high: push
        ("p", 0.01, "aileron", -1.0),  # rolling right: roll left
        ("phi", 0.01, "aileron", -1.0),
        ("psi", 0.01, "aileron", -1.0),  # right of the course: bank left
        ("r", 0.01, "rudder", 1.0),  # yawing right: trailing edge left
        ("eas", 0.1, "throttle", -1.0),
    ],
)
def test_it_works_against_what_is_off(signal: str, by: float, surface: str, sign: float) -> None:
    moved = command(Y._replace(**{signal: getattr(Y, signal) + by})) - command(Y)
    assert sign * moved[SURFACES.index(surface)] > 0.0


def test_it_asks_for_no_more_than_there_is() -> None:
    """Full stick, full lever, 5 deg of pitch and 30 deg of bank."""
    far = command(Y._replace(h=Y.h - 1e5 * FOOT, eas=Y.eas - 200.0 * KNOT, theta=-1.0))
    assert far[0] + STEADY.elevator == pytest.approx(-25.0 * DEG)
    assert far[3] == 1.0
    much, more = (command(Y._replace(h=Y.h - h * FOOT)) for h in (100.0, 1000.0))
    np.testing.assert_allclose(much, more)
    much, more = (command(Y._replace(psi=Y.psi - turn * DEG)) for turn in (4.0, 170.0))
    np.testing.assert_allclose(much, more)
    np.testing.assert_allclose(command(Y._replace(psi=Y.psi + 2.0 * np.pi - 4.0 * DEG)), much)


def test_it_says_what_the_published_file_says() -> None:
    """F16_control.dml itself, its equations evaluated as they stand there: a little off in everything."""
    law = F16Autopilot(
        altitude=10013.0 * FOOT,
        course=45.0 * DEG,
        airspeed=287.8 * KNOT,
        alpha=2.653813535191715 * DEG,
        theta=2.653813535191715 * DEG,
        elevator=-25.0 * DEG * 0.1296382327486013,
        throttle=0.1390191130965607,
    )
    angles = {"alpha": 2.655, "beta": 0.02, "phi": 0.02, "theta": 2.66, "psi": 45.001}
    rates = {"p": -0.001, "q": 0.0002, "r": 0.002}
    off = Y._replace(h=10013.2 * FOOT, eas=287.81 * KNOT, **rates, **{k: v * DEG for k, v in angles.items()})
    elevator, aileron, rudder, throttle = command(off, law)
    assert (elevator + law.elevator) / DEG == pytest.approx(-1.926081658180272, abs=1e-9)
    assert aileron / DEG == pytest.approx(-15.16219670110104, abs=1e-9)  # theirs is positive to the left
    assert rudder / DEG == pytest.approx(-4.821123704129841, abs=1e-9)
    assert 100.0 * throttle == pytest.approx(12.545522852095308, abs=1e-9)
