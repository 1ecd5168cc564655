"""The recursion and the flight loop are one flight."""

from itertools import product

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.control import Stick
from fdes.control.laws.direct import Direct
from fdes.errors import Departed
from fdes.flight import Clock, Excitation, HandsOff, Setup, SteadyAir, fly, integrator_names, plant_of, trajectory
from fdes.flight.recorder import row_of
from fdes.physics.derivatives import FORMS
from fdes.physics.signals import Air
from fdes.physics.small_perturbation import PerturbationState

SHAKEN = Excitation.parse(["doublet elevator 3deg at 0.1s for 1s", "sine rudder 2deg", "step aileron 2deg"])
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
