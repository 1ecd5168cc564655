"""Where the linear plant and the nonlinear one part company."""

import math

import pytest

from fdes.aircraft import load
from fdes.analysis.parting import amplitude, apart, parting
from fdes.errors import SpecError
from fdes.flight import Clock
from fdes.units import DEG

A4D = load("A-4D").at()
CLOCK = Clock(0.02, duration=6.0)
DOUBLET = ["doublet elevator 2deg for 2s"]


def test_the_difference_falls_with_the_amplitude() -> None:
    """It is of second order, so its share of the response falls with the input."""
    small, large = (apart(A4D, DOUBLET, CLOCK, scale) for scale in (1.0, 2.0))
    assert large.shares["theta"] > 1.6 * small.shares["theta"]
    assert small.linear["elevator"][10] == pytest.approx(2.0 * DEG)
    assert large.nonlinear["elevator"][10] == pytest.approx(4.0 * DEG)


@pytest.mark.parametrize("inputs", [DOUBLET, ["doublet rudder 5deg for 2s"]])
def test_parting_is_where_the_share_is_reached(inputs: list[str]) -> None:
    found = parting(A4D, inputs, CLOCK, 0.05)
    assert found.flights.worst <= 0.05 < found.beyond.worst
    assert found.flights.worst == pytest.approx(0.05, rel=0.05)
    assert found.beyond.scale <= 1.01 * found.scale
    again = apart(A4D, inputs, CLOCK, found.scale)
    assert dict(again.shares) == dict(found.flights.shares)
    (_, size), *_ = amplitude(inputs, found.scale)
    assert size == pytest.approx(found.scale * (2.0 if inputs is DOUBLET else 5.0) * DEG)


def test_a_full_roll_is_no_difference() -> None:
    """Bank begins anew after half a turn in the nonlinear plant, and goes on in the linear one."""
    found = apart(A4D, ["pulse aileron 15deg for 3s"], Clock(0.02, duration=3.0))
    assert found.linear["phi"].max() > math.pi > found.nonlinear["phi"].max()
    assert found.shares["phi"] < 0.2


def test_no_further_than_the_stops_is_looked() -> None:
    """The assumed stop of the A-4D's ailerons is 20 deg."""
    found = parting(A4D, ["doublet aileron 5deg for 2s"], CLOCK)
    assert found.scale == math.inf
    assert found.flights.scale == pytest.approx(4.0)
    beyond = parting(A4D, ["doublet aileron 50deg for 0.1s"], Clock(0.02, duration=0.2), 0.9)
    assert (beyond.scale, beyond.flights.scale) == (math.inf, 1.0)


def test_a_flight_that_ends_early_is_far_apart() -> None:
    found = apart(A4D, ["step throttle 500"], Clock(0.1, duration=60.0))
    assert len(found.nonlinear.data) <= len(found.linear.data)
    assert found.worst == math.inf if found.departed else found.worst > 0.1


@pytest.mark.parametrize(
    ("inputs", "allowed", "words"),
    [
        ([], 0.1, "There is no input: say one, such as 'doublet elevator 2deg for 2s'"),
        (["step elevator 1deg at 60s"], 0.1, "Nothing moved: let the input begin before the end of the flight"),
        (DOUBLET, 2.0, "The difference allowed is 2; it must be a share between 0 and 1"),
    ],
)
def test_what_cannot_be_compared(inputs: list[str], allowed: float, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        parting(A4D, inputs, CLOCK, allowed)
