"""Actuators: as fast as they are, no faster than they can, and part of the flight."""

from math import exp, inf, radians

import numpy as np
import pytest

import fdes
from fdes.analysis.design import law_for
from fdes.control.laws.direct import Direct
from fdes.errors import SpecError
from fdes.flight import Clock, plant_of
from fdes.flight.actuated import WithActuators, actuators_of
from fdes.physics.actuators import Actuator, Actuators
from fdes.physics.signals import Air, Surfaces

A4D = fdes.load("A-4D").at("M0.4_SL")
CLOCK = Clock(0.01, 1, 3.0)


def moved(one: Actuator, command: Surfaces, dt: float, frames: int) -> np.ndarray:
    """Elevator position and rate, frame by frame, after a step of the command."""
    plant = WithActuators(plant_of(A4D), Actuators(one, one, one))
    x, found = plant.start(), []
    for _ in range(frames):
        found.append((x.elevator_position, x.elevator_rate))
        x = plant.advance(x, command, Air(), dt, 1)
    return np.array(found)


def test_first_order_is_a_lag() -> None:
    (_, _), *_, (position, rate) = moved(Actuator(20.0), Surfaces(0.1, throttle=0.24), 0.005, 11)
    assert position == pytest.approx(0.1 * (1.0 - exp(-20.0 * 0.05)), rel=1e-6)
    assert rate == pytest.approx(20.0 * (0.1 - position), rel=1e-12)


def test_second_order_overshoots_as_its_damping_says() -> None:
    found = moved(Actuator(20.0, 0.5), Surfaces(0.1, throttle=0.24), 0.002, 300)[:, 0]
    overshoot = exp(-np.pi * 0.5 / np.sqrt(1.0 - 0.25))
    assert found.max() == pytest.approx(0.1 * (1.0 + overshoot), rel=1e-4)


@pytest.mark.parametrize("damping", [0.0, 0.7])
def test_no_faster_than_its_rate_limit(damping: float) -> None:
    limit = radians(60.0)
    found = moved(Actuator(20.0, damping, limit), Surfaces(0.17, throttle=0.24), 0.01, 60)
    assert np.abs(found[:, 1]).max() == pytest.approx(limit, rel=1e-12)
    assert np.abs(np.diff(found[:, 0])).max() <= limit * 0.01 * (1.0 + 1e-9)
    assert found[-1, 0] == pytest.approx(0.17, rel=0.01)


@pytest.mark.parametrize("damping", [0.0, 0.9])
def test_it_stops_where_the_surface_stops(damping: float) -> None:
    found = moved(Actuator(20.0, damping), Surfaces(9.0, throttle=0.24), 0.01, 200)
    assert found[-1, 0] == pytest.approx(A4D.limits.upper.elevator, rel=1e-6)


def test_undisturbed_flight_stays_undisturbed() -> None:
    plant = WithActuators(plant_of(A4D), actuators_of(A4D))
    x = plant.start()
    later = plant.advance(x, plant.trim(), Air(), 0.01, 1)
    assert later[:9] == pytest.approx(x[:9], abs=1e-15)
    assert later[12:] == x[12:]


def test_every_aircraft_has_actuators_that_are_said_to_be_assumed() -> None:
    assert actuators_of(A4D).rudder == Actuator(20.0, 0.0, radians(60.0))
    assert "F-16" in A4D.assumed["actuator_bandwidth"]["reason"]


def test_the_recording_says_where_the_surfaces_were() -> None:
    flight = fdes.simulate(A4D, ["step elevator 5deg at 0.5s"], clock=CLOCK, actuators=True)
    assert flight.header["actuators"] is True
    np.testing.assert_array_equal(flight["elevator"], flight["state_elevator_position"])
    k = round(0.55 / CLOCK.dt)
    assert 0.0 < flight["elevator"][k] < flight["held_elevator"][k] == pytest.approx(radians(5.0))
    assert flight["elevator"][-1] == pytest.approx(radians(5.0), rel=1e-6)


def test_very_fast_actuators_are_none() -> None:
    one = Actuator(2000.0, 0.0, inf)
    plant = plant_of(A4D, "full", "dopri5")
    moved = WithActuators(plant, Actuators(one, one, one))
    command = Surfaces(0.01, 0.01, 0.01, 0.24)
    x, bare = moved.start(), plant.start()
    for _ in range(100):
        x = moved.advance(x, command, Air(), 0.01, 20)
        bare = plant.advance(bare, command, Air(), 0.01, 1)
    assert x[:9] == pytest.approx(bare[:9], rel=2e-3, abs=1e-5)


def test_the_exact_hold_says_why_it_cannot() -> None:
    with pytest.raises(SpecError) as found:
        fdes.simulate(A4D, clock=CLOCK, integrator="exact", actuators=True)
    assert str(found.value) == (
        "The exact hold needs surfaces that stand still from frame to frame, and actuators move them. "
        "Take another integrator with actuators, such as rk4."
    )


def test_flown_frame_by_frame_it_is_the_flight_that_is_computed_whole() -> None:
    inputs = ["doublet elevator 3deg at 0.1s for 1s", "step gust_w -2m/s at 1s", "step aileron 2deg"]
    whole = fdes.simulate(A4D, inputs, clock=CLOCK, initial=["beta=2deg"])
    flown = fdes.simulate(A4D, inputs, clock=CLOCK, initial=["beta=2deg"], law=Direct(A4D.full_stick))
    np.testing.assert_allclose(flown.data, whole.data, rtol=1e-9, atol=1e-9)


def test_a_law_damps_what_is_simulated() -> None:
    designed = law_for("yaw_damper", A4D, frame=CLOCK.dt)
    bare = fdes.simulate(A4D, clock=CLOCK, initial=["beta=5deg"])
    damped = fdes.simulate(A4D, clock=CLOCK, initial=["beta=5deg"], law=designed.law, said=designed.text)
    assert np.abs(damped["beta"][-100:]).max() < 0.3 * np.abs(bare["beta"][-100:]).max()
    assert damped.header["law"] == designed.text
