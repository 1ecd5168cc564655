"""The recursion and the flight loop are one flight."""

from itertools import product

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.control import Stick
from fdes.control.laws.direct import Direct
from fdes.errors import Departed
from fdes.flight import (
    Clock,
    Excitation,
    GustyAir,
    HandsOff,
    Setup,
    SteadyAir,
    fly,
    integrator_names,
    plant_of,
    simulate,
    trajectory,
)
from fdes.flight.excitation import Gusts
from fdes.flight.recorder import row_of
from fdes.physics.derivatives import FORMS
from fdes.physics.signals import Air
from fdes.physics.small_perturbation import PerturbationState
from fdes.shelf import shelf

SHAKEN = Excitation.parse(["doublet elevator 3deg at 0.1s for 1s", "sine rudder 2deg", "step aileron 2deg"])
GUSTS = Excitation.parse(
    ["1-cosine gust_w -5m/s at 0.5s", "sine beta_g 2deg", "pulse gust_u 3m/s", "step alpha_g 1deg at 2s"]
)
BLOWN = Air(3.0, -2.0, 0.5, 1.0, -1.5, 0.7)
START = PerturbationState(u=2.0, beta=0.02, psi=0.3, h=500.0)


@pytest.mark.parametrize(("integrator", "form"), list(product(integrator_names(), FORMS)))
def test_recursion_equals_flight(integrator: str, form: str) -> None:
    condition = load("A-4D").at("M0.4_SL")
    clock = Clock(0.02, 2, 8.0)
    plant = plant_of(condition, form, integrator, clock.dt / clock.substeps)
    setup = Setup(plant, Direct(condition.full_stick))
    frames = fly(START, setup, HandsOff(0.5), SteadyAir(BLOWN), clock, SHAKEN)
    flown = np.array([row_of(frame) for frame in frames])
    whole = trajectory(plant, START, clock, Stick(throttle=0.5), SHAKEN, BLOWN)
    np.testing.assert_allclose(whole.data, flown, rtol=1e-9, atol=1e-9)


def test_a_departure_is_told_in_the_same_words() -> None:
    condition = load("A-4D").at("M0.4_SL")
    plant = plant_of(condition, "full", "euler")
    clock = Clock(0.5, 1, 600.0)
    with pytest.raises(Departed) as one:
        list(fly(START, Setup(plant, Direct(condition.full_stick)), HandsOff(0.5), SteadyAir(), clock))
    with pytest.raises(Departed) as other:
        trajectory(plant, START, clock, Stick(throttle=0.5), Excitation(()))
    assert str(one.value)[:40] == str(other.value)[:40]


@pytest.mark.parametrize("integrator", integrator_names())
@pytest.mark.parametrize("air", [Air(), BLOWN], ids=["calm", "steady"])
def test_recursion_equals_flight_through_gusts(integrator: str, air: Air) -> None:
    condition = load("A-4D").at("M0.4_SL")
    clock = Clock(0.02, 2, 8.0)
    plant = plant_of(condition, "full", integrator, clock.dt / clock.substeps)
    both = Excitation((*SHAKEN.parts, *GUSTS.parts))
    weather = GustyAir(both.gusts, condition.reference.V, air)
    frames = fly(START, Setup(plant, Direct(condition.full_stick)), HandsOff(0.5), weather, clock, both)
    flown = np.array([row_of(frame) for frame in frames])
    whole = trajectory(plant, START, clock, Stick(throttle=0.5), both, air)
    np.testing.assert_allclose(whole.data, flown, rtol=1e-9, atol=1e-9)
    assert np.ptp(whole["air_gust_w"]) > 5.0
    assert whole["air_gust_v"][12] - air.gust_v == pytest.approx(
        -condition.reference.V * np.radians(2.0) * np.sin(0.48 * np.pi)
    )


@pytest.mark.parametrize("channel", Gusts._fields)
@pytest.mark.parametrize("kind", [n for n in shelf("inputs").names() if n != "measured"])
def test_every_shape_can_be_a_gust(kind: str, channel: str) -> None:
    """What is recorded is the shape itself, in the air and nowhere else."""
    condition = load("A-4D").at("M0.4_SL")
    unit, si = ("deg", np.radians(1.0)) if channel.endswith("_g") else ("m/s", 1.0)
    flight = simulate(condition, [f"{kind} {channel} 1{unit}"], clock=Clock(0.05, duration=20.0))
    put = shelf("inputs").get(kind)(si)
    V = condition.reference.V
    blows = {"alpha_g": ("gust_w", -V), "beta_g": ("gust_v", -V)}.get(channel, (channel, 1.0))
    expected = [blows[1] * put(t) for t in flight["t"]]
    np.testing.assert_allclose(flight[f"air_{blows[0]}"], expected, rtol=1e-12, atol=1e-12)
    assert np.abs(flight[f"air_{blows[0]}"]).max() > 0.9 * abs(blows[1] * si)
    assert not flight["excitation_elevator"].any()
