"""An engine with an assumed lag: thrust follows the throttle in time, and a settled engine is as one without."""

import tomllib

import numpy as np
import pytest

from fdes.aircraft import load, parse
from fdes.aircraft.load import HANGAR
from fdes.analysis.jacobian import linearized
from fdes.analysis.nonlinear_response import simulate_nonlinear
from fdes.analysis.trim import TrimSpec, trim
from fdes.analysis.what_if import what_if
from fdes.cockpit.craft import make_craft
from fdes.flight import Clock
from fdes.flight.crossing import carried
from fdes.flight.nonlinear import assumptions, six_dof_of
from fdes.physics.signals import Air

LAG = {"A-4D": 1.8, "NAVION": 1.2}
each = pytest.mark.parametrize(("name", "lag"), LAG.items())


@each
def test_power_comes_nearer_to_the_throttle_by_63_percent_in_one_lag(name: str, lag: float) -> None:
    condition = load(name).at(spool=True)
    flight = simulate_nonlinear(condition, ["step throttle 0.2 at 1s"], clock=Clock(0.01, duration=6.0))
    power, t = flight["state_power"], flight["t"] - 1.0
    settled = power[0] + 20.0 * np.where(t > 0.0, 1.0 - np.exp(-np.maximum(t, 0.0) / lag), 0.0)
    np.testing.assert_allclose(power, settled, atol=0.12)  # the throttle is held through the first frame, 10 ms
    late = simulate_nonlinear(condition, ["step throttle 0.2 at 1s"], clock=Clock(0.001, duration=6.0))
    at_lag = late["state_power"][np.searchsorted(late["t"], 1.0 + lag)]
    assert (at_lag - power[0]) / 20.0 == pytest.approx(1.0 - np.exp(-1.0), abs=1e-3)
    at_once = simulate_nonlinear(load(name).at(), ["step throttle 0.2 at 1s"], clock=Clock(0.01, duration=6.0))
    assert 0.0 < flight["V"][-1] - flight["V"][0] < 0.9 * (at_once["V"][-1] - at_once["V"][0])


def test_from_15_percent_it_is_at_95_percent_in_five_seconds() -> None:
    """14 CFR 33.73 (b), which the lag of jets is from; it is rounded."""
    plant = six_dof_of(load("A-4D").at(spool=True))
    x, held = plant.start()._replace(power=15.0), plant.trim()._replace(throttle=1.0)
    for _ in range(500):
        x = plant.advance(x, held, Air(), 0.01)
    assert x.power == pytest.approx(95.0, abs=0.5)


@each
def test_trims_and_linear_models_are_those_of_a_settled_engine(name: str, lag: float) -> None:
    condition = load(name).at()
    spec = TrimSpec(condition.reference.V, condition.reference.h + 500.0)
    with_lag, without = (trim(six_dof_of(c), spec) for c in (load(name).at(spool=True), condition))
    assert with_lag.surfaces == pytest.approx(without.surfaces, abs=1e-12)
    assert with_lag.state.power == pytest.approx(100.0 * without.surfaces.throttle)
    for held in (True, False):
        ours, other = linearized(with_lag, thrust_held=held), linearized(without, thrust_held=held)
        np.testing.assert_allclose(ours.A, other.A, rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(ours.B, other.B, rtol=1e-12, atol=1e-12)
    x = with_lag.plant.start()
    for _ in range(200):
        x = with_lag.plant.advance(x, with_lag.plant.trim(), Air(), 0.05)
    assert x.power == pytest.approx(with_lag.state.power, abs=1e-9)


def test_recordings_say_it_and_those_that_do_not_are_flown_without() -> None:
    inputs, clock = ["doublet throttle 0.1 at 0.5s for 2s"], Clock(0.02, duration=4.0)
    flight = simulate_nonlinear(load("A-4D").at(spool=True), inputs, clock=clock)
    assert flight.header["spool"] is True
    np.testing.assert_array_equal(what_if(flight).recording.data, flight.data)
    before = simulate_nonlinear(load("A-4D").at(), inputs, clock=clock)
    assert "spool" not in before.header
    np.testing.assert_array_equal(what_if(before).recording.data, before.data)
    elsewhere = what_if(flight, "aircraft=F-16").recording
    assert not elsewhere.header["spool"]


def test_the_cockpit_switches_to_a_settled_engine() -> None:
    linear = make_craft(load("A-4D").at(spool=True))
    nonlinear = linear.but(plant="nonlinear")
    x = carried(linear.start, linear.setup.plant, nonlinear.setup.plant, nonlinear.setup.plant.trim())
    assert x.power == pytest.approx(100.0 * nonlinear.trim_throttle)
    assert nonlinear.header()["spool"] is True


def test_a_file_may_say_its_own_lag() -> None:
    document = tomllib.loads((HANGAR / "a4d.toml").read_text(encoding="utf-8"))
    document["assumed"]["engine_lag"] = {"value": 700.0, "unit": "ms", "reason": "for this test"}
    condition = parse(document, "the file").at(spool=True)
    plant = six_dof_of(condition)
    assert plant.engine.lag == pytest.approx(0.7)
    assert any("It follows the throttle with a lag of 0.7 s." in said for said in assumptions(condition, plant))
