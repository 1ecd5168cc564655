"""Every aircraft, every condition, both variants, answers its controls the right way round, as docs/symbols.md says."""

import numpy as np
import pytest

from fdes.aircraft import FlightCondition, catalogue
from fdes.flight import Clock, Recording, simulate

EVERY = [
    pytest.param(a.at(c.id, variant=v), id=f"{a.id} {c.id} {v}")
    for a in catalogue()
    for c in a.conditions
    for v in ("corrected", "printed")
]


def flown(fc: FlightCondition, text: str, duration: float) -> Recording:
    return simulate(fc, [text], clock=Clock(0.01, duration=duration), integrator="exact")


@pytest.mark.parametrize("fc", EVERY)
def test_positive_aileron_rolls_right(fc: FlightCondition) -> None:
    flight = flown(fc, "step aileron +15deg", 1.0)
    assert flight["p"][-1] > 0.0
    assert flight["phi"][-1] > 0.0
    assert (flight["p"][1:] > 0.0).all()


@pytest.mark.parametrize("fc", EVERY)
def test_positive_elevator_brings_the_nose_down(fc: FlightCondition) -> None:
    flight = flown(fc, "step elevator +1deg", 0.5)
    assert (flight["q"][1:] < 0.0).all()
    assert flight["theta"][-1] < flight["theta"][0]


@pytest.mark.parametrize("fc", EVERY)
def test_positive_rudder_yaws_left_at_first(fc: FlightCondition) -> None:
    flight = flown(fc, "step rudder +1deg", 0.5)
    misprinted = fc.aircraft_id == "A-4D" and fc.variant == "printed"  # Cn_dr > 0 in the book, which its file mends
    left = -1.0 if misprinted else 1.0
    assert (left * flight["r"][1:20] < 0.0).all()
    assert left * flight["psi"][20] < 0.0


@pytest.mark.parametrize("fc", EVERY)
def test_more_throttle_is_more_speed(fc: FlightCondition) -> None:
    flight = flown(fc, "step throttle +0.1", 2.0)
    assert (np.diff(flight["V"][:100]) > 0.0).all()
