"""The nonlinear plant on the inputs of the linear one: small ones give the same flight, large ones do not."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

import fdes
from fdes.aircraft import load
from fdes.analysis.jacobian import OUTPUTS, linearized, perturbed
from fdes.analysis.nonlinear_response import simulate_nonlinear
from fdes.analysis.trim import CALM, TrimSpec, trim
from fdes.errors import Departed, SpecError
from fdes.flight import Clock, Recording
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.plant import state_at
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import PerturbationState
from fdes.units import DEG

CLOCK = Clock(0.02, duration=4.0)
plants = {name: six_dof_of(load(name).at()) for name in ("A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar")}


def linear_flight(inputs: list[str]) -> tuple[np.ndarray, Recording]:
    """The trim's own linear model on the same inputs, exactly held, and the nonlinear flight."""
    condition = load("A-4D").at("M0.4_SL")
    point = trim(six_dof_of(condition), TrimSpec(condition.reference.V, condition.reference.h))
    model = linearized(point).held(CLOCK.dt)
    flight = simulate_nonlinear(condition, inputs, clock=CLOCK)
    commands = np.column_stack([flight[f"command_{name}"] for name in model.inputs])
    commands[:, model.inputs.index("throttle")] -= point.surfaces.throttle
    x = np.zeros((len(commands), 8))
    for k in range(1, len(commands)):
        x[k] = model.A @ x[k - 1] + model.B @ commands[k - 1]
    return x, flight


@pytest.mark.parametrize(
    ("surface", "signals", "falls"),
    [
        ("elevator", ("alpha", "q", "theta"), 3.5),
        ("aileron", ("p", "beta"), 7.0),
        ("rudder", ("r", "beta"), 7.0),
    ],
)
def test_linear_meets_nonlinear_as_the_pulse_halves(surface: str, signals: tuple[str, ...], falls: float) -> None:
    """The difference is of second order; in lateral states, which are odd in lateral inputs, of third."""

    def difference(degrees: float) -> dict[str, float]:
        x, flight = linear_flight([f"pulse {surface} {degrees}deg at 0.2s for 1s"])
        _, w, q, theta, beta, p, r, _ = x.T
        V, alpha = flight["V"][0], flight["alpha"][0]
        linear = {
            "alpha": alpha + w / V,
            "q": q,
            "theta": alpha + theta,
            "beta": beta,
            "p": p * np.cos(alpha) - r * np.sin(alpha),
            "r": r * np.cos(alpha) + p * np.sin(alpha),
        }
        return {s: float(np.abs(flight[s] - linear[s]).max()) for s in signals}

    large, small = difference(1.0), difference(0.5)
    for signal, value in small.items():
        assert large[signal] / value > falls, signal


def test_rows_can_be_computed_again_and_what_is_assumed_is_recorded() -> None:
    condition = load("NAVION").at()
    flight = simulate_nonlinear(condition, ["step aileron 2deg"], clock=CLOCK, initial=["beta=3deg"])
    assert flight.header["form"] == "nonlinear"
    assert len(flight.header["assumptions"]) == 4
    assert flight["beta"][0] == pytest.approx(3.0 * DEG, rel=1e-3)
    assert flight["p"][-1] > 0.0
    assert flight.columns[-1].name == "air_gust_w"


def test_a_loop_can_be_flown_that_the_linear_plant_cannot() -> None:
    """Elevator held: the nose goes through the vertical, and all numbers stay numbers."""
    condition = load("A-4D").at("M0.4_SL")
    pull = ["step elevator -4deg at 1s", "step throttle 0.6 at 0s"]
    flight = simulate_nonlinear(condition, pull, clock=Clock(0.02, duration=25.0), spec=TrimSpec(250.0, 1000.0))
    assert flight["theta"].max() > 89.0 * DEG
    assert np.isfinite(flight.data).all()
    assert np.abs(flight["phi"]).max() > 2.0  # on its back


ENVELOPE = {
    "V": (0.0, 700.0),
    "alpha": (-3.2, 3.2),
    "beta": (-1.5, 1.5),
    "rate": (-6.0, 6.0),
    "h": (-4000.0, 80000.0),
}


def spans(*names: str) -> list[some.SearchStrategy[float]]:
    return [some.floats(*ENVELOPE[name]) for name in names]


@settings(max_examples=300, deadline=None)
@given(
    some.sampled_from(["A-4D", "F-104A", "NAVION", "Convair880", "B747", "JetStar"]),
    some.tuples(*spans("V", "alpha", "beta", "h")),
    some.tuples(*spans("alpha", "beta", "alpha")),
    some.tuples(*spans("rate", "rate", "rate")),
    some.builds(Surfaces, *[some.floats(-1.0, 1.0)] * 3, some.floats(-0.5, 1.5)),
)
def test_no_state_of_the_envelope_gives_what_is_no_number(
    name: str,
    flow: tuple[float, float, float, float],
    attitude: tuple[float, float, float],
    rates: tuple[float, float, float],
    held: Surfaces,
) -> None:
    """At rest, backward, tumbling, at any height of the atmosphere, surfaces at their stops."""
    V, alpha, beta, h = flow
    plant = plants[name]
    still = state_at(plant.earth, (0.0, 0.0, h), (0.0, 0.0, 0.0), attitude, rates)
    x = still._replace(u=V * np.cos(alpha) * np.cos(beta), v=V * np.sin(beta), w=V * np.sin(alpha) * np.cos(beta))
    assert np.isfinite(plant.observe(x, held, CALM)).all()
    assert np.isfinite(plant.advance(x, held, CALM, 1.0 / 120.0)).all()


def test_a_flight_into_the_ground_and_far_below_departs() -> None:
    """The equations know no ground; the atmosphere ends."""
    condition = load("F-104A").at("M1.8_55kft")
    with pytest.raises(Departed, match="its height reached"):
        simulate_nonlinear(
            condition, ["step elevator 8deg at 0s"], clock=Clock(0.05, duration=400.0), spec=TrimSpec(500.0, 16000.0)
        )


def test_c_and_d_are_the_derivatives_of_the_outputs() -> None:
    """Against central differences of what the plant shows."""
    condition = load("JetStar").at("M0.20_SL")
    point = trim(six_dof_of(condition), TrimSpec(condition.reference.V, 2000.0, gamma=2.0 * DEG))
    model = linearized(point)
    plant, h = point.plant, 1e-5

    def shown(state: PerturbationState, **surfaces: float) -> np.ndarray:
        held = Surfaces(throttle=point.surfaces.throttle)._replace(**surfaces)
        y = plant.observe(perturbed(point, state), held, CALM)._asdict()
        return np.array([y[name] for name in OUTPUTS])

    rest = PerturbationState()
    for k, name in enumerate(model.states):
        slope = (shown(rest._replace(**{name: h})) - shown(rest._replace(**{name: -h}))) / (2.0 * h)
        np.testing.assert_allclose(model.C[:, k], slope, rtol=1e-6, atol=1e-6)
    for k, name in enumerate(model.inputs):
        base = point.surfaces.throttle if name == "throttle" else 0.0
        slope = (shown(rest, **{name: base + h}) - shown(rest, **{name: base - h})) / (2.0 * h)
        np.testing.assert_allclose(model.D[:, k], slope, rtol=1e-6, atol=1e-6)
    assert model.C[OUTPUTS.index("gamma"), model.states.index("theta")] == pytest.approx(1.0)


def test_only_straight_flight_is_linearized_or_disturbed() -> None:
    condition = load("NAVION").at()
    turning = TrimSpec(55.0, 500.0, turn=0.05)
    with pytest.raises(SpecError, match="Only straight flight without sideslip is linearized"):
        linearized(trim(six_dof_of(condition), turning))
    with pytest.raises(SpecError, match="takes no initial perturbation"):
        simulate_nonlinear(condition, clock=CLOCK, spec=turning, initial=["beta=3deg"])


def test_a_steady_turn_stays_one() -> None:
    flight = simulate_nonlinear(
        load("NAVION").at(), clock=Clock(0.05, duration=30.0), spec=TrimSpec(55.0, 500.0, turn=0.1)
    )
    assert np.ptp(flight["V"]) < 1e-6
    assert np.ptp(flight["h"]) < 1e-5
    assert np.unwrap(flight["psi"])[-1] == pytest.approx(3.0, abs=1e-6)


def test_it_starts_where_the_linear_plant_does() -> None:
    """And a small doublet is the same flight to a few parts in a thousand, data and all."""
    condition = load("B747").at("M0.25_SL")
    inputs = ["doublet aileron 1deg at 0s for 2s"]
    linear = fdes.simulate(condition, inputs, clock=CLOCK)
    other = simulate_nonlinear(condition, inputs, clock=CLOCK)
    assert np.abs(other["phi"] - linear["phi"]).max() < 0.03 * np.abs(linear["phi"]).max()
