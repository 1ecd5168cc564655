"""The closed loop as a linear model is the loop that is flown, and its modes are what a textbook expects."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis import linear_model, linearize, modes
from fdes.analysis.closed_loop import close, with_actuators
from fdes.control import Law, LinearModel
from fdes.control.blocks import Delay, Past
from fdes.control.laws.direct import Direct
from fdes.control.laws.pitch_rate_damper import PitchRateDamper
from fdes.control.laws.pitch_rate_pi import PitchRatePi
from fdes.control.laws.roll_angle import RollAngle
from fdes.control.laws.roll_rate_damper import RollRateDamper
from fdes.control.laws.sensors import Sensors
from fdes.control.laws.spiral_stabilization import SpiralStabilization
from fdes.control.laws.yaw_damper import YawDamper
from fdes.errors import SpecError
from fdes.flight import Clock, HandsOff, Setup, SteadyAir, fly, plant_of
from fdes.flight.actuated import WithActuators
from fdes.physics.actuators import Actuator, Actuators
from fdes.physics.derivatives import dimensional
from fdes.physics.small_perturbation import PerturbationState

A4D = load("A-4D").at("M0.4_SL")
BARE = Direct(A4D.full_stick)
DT = 1.0 / 120.0
LAWS: list[Law] = [
    BARE,
    PitchRateDamper(BARE, 0.3),
    PitchRatePi(BARE, 0.3, 0.5, 0.1),
    RollAngle(BARE, 0.5, 0.1),
    RollRateDamper(BARE, 0.1),
    SpiralStabilization(BARE, 0.3),
    YawDamper(BARE, 0.5),
    RollRateDamper(YawDamper(PitchRatePi(BARE, 0.2, 0.4, 0.1), 0.5), 0.1),
]
BEHIND_SENSORS = [
    Sensors(LAWS[-1], 0.03, 0.05),
    Sensors(LAWS[-1], 0.0, 0.031),
    Sensors(LAWS[-1], 0.05, 0.0),
    Sensors(RollAngle(BARE, 0.5, 0.1), 0.02, 0.004),
]
FREE = replace(A4D, limits=A4D.limits._replace(lower=A4D.limits.lower._replace(throttle=-1.0)))
SHAKEN = PerturbationState(u=0.2, w=0.3, q=0.002, theta=0.001, beta=0.002, p=0.003, r=0.002, phi=0.004, h=500.0)


def flown(law: Law, integrator: str, actuators: Actuators | None, substeps: int = 1) -> np.ndarray:
    """States and memory, frame by frame, of a flight of two seconds from a small disturbance."""
    plant = plant_of(FREE, "full", integrator, DT / substeps)
    setup, start = Setup(plant, law), SHAKEN
    if actuators is not None:
        moved = WithActuators(plant, actuators)
        setup, start = Setup(moved, law), moved.beginning(SHAKEN, plant.trim())
    frames = fly(start, setup, HandsOff(FREE.trim_throttle), SteadyAir(), Clock(DT, substeps, 2.0))
    return np.array([[getattr(f.state, s) for s in linear_model(A4D).states] for f in frames])


def predicted(law: Law, model: LinearModel, frames: int) -> np.ndarray:
    plant = plant_of(FREE)
    y = plant.observe(SHAKEN, plant.trim(), SteadyAir().air)
    memory = law.start(y, HandsOff(0.0)(0.0))
    x = np.zeros(len(model.states))
    x[:8] = [getattr(SHAKEN, s) for s in model.states[:8]]
    if isinstance(law, Sensors):  # which have long measured what they do at the start
        n = Delay(law.delay).length(DT)
        memory = memory._replace(sensed=tuple(s._replace(past=Past(s.past * n)) for s in memory.sensed))
    remembered = list(_numbers(memory))
    if remembered:
        x[-len(remembered) :] = remembered
    rows = [x]
    for _ in range(frames - 1):
        rows.append(model.A @ rows[-1])
    return np.array(rows)[:, :8]


def _numbers(memory: Any) -> Iterator[float]:
    if isinstance(memory, tuple):
        for part in memory:
            yield from _numbers(part)
    elif memory is not None:
        yield memory


@pytest.mark.parametrize("law", [*LAWS, *BEHIND_SENSORS], ids=lambda law: type(law).__name__)
def test_the_flown_loop_is_its_sampled_data_model(law: Law) -> None:
    seen = flown(law, "exact", None)
    model = close(A4D, law, DT)
    np.testing.assert_allclose(seen, predicted(law, model, len(seen)), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("law", [LAWS[-1], BEHIND_SENSORS[0]], ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("damping", [0.0, 0.7])
def test_so_it_is_with_actuators(law: Law, damping: float) -> None:
    """Runge-Kutta of order 5 with four steps a frame, against the exact hold of aircraft and actuators together."""
    one = Actuator(20.0, damping)
    actuators = Actuators(one, one, one)
    seen = flown(law, "dopri5", actuators, substeps=4)
    np.testing.assert_allclose(seen, predicted(law, close(A4D, law, DT, actuators), len(seen)), rtol=1e-8, atol=1e-9)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_continuous_is_the_limit_of_ever_shorter_frames(law: Law) -> None:
    continuous, dt = close(A4D, law), 1e-5
    sampled = close(A4D, law, dt)
    np.testing.assert_allclose((sampled.A - np.eye(len(sampled.A))) / dt, continuous.A, rtol=2e-3, atol=2e-2)


def test_without_a_loop_the_aircraft_is_as_it_was() -> None:
    np.testing.assert_allclose(close(A4D, BARE).A, linear_model(A4D).A, rtol=1e-12)
    for one, other in zip(modes(close(A4D, BARE, DT)), modes(A4D), strict=True):
        assert one.name == other.name
        assert one.eigenvalue == pytest.approx(other.eigenvalue, rel=1e-9)


def test_a_roll_damper_quickens_pure_roll_as_on_paper() -> None:
    """Rolling alone: tau = 1 / (-L_p + K L_da)."""
    d = dimensional(A4D.coefficients, A4D.reference, "nelson")
    model = linear_model(A4D, "nelson", ("p",))
    alone = replace(model, A=model.A * _only("p"), B=model.B * (np.array(model.states) == "p")[:, None])
    closed = close(alone, RollRateDamper(BARE, 0.25))
    k = closed.states.index("p")
    assert -1.0 / closed.A[k, k] == pytest.approx(1.0 / (-d.L_p + 0.25 * d.L_da), rel=1e-12)


def _only(state: str) -> np.ndarray:
    states = np.array(linear_model(A4D).states)
    return np.outer(states == state, states == state)


def test_spiral_stabilization_is_less_roll_due_to_yaw() -> None:
    """The loop is an aircraft with L_r - K L_da, N_r - K N_da and the like: the same roots."""
    k = 0.3
    model = linear_model(A4D)
    column, aileron = model.states.index("r"), model.inputs.index("aileron")
    less = model.A.copy()
    less[:, column] -= k * model.B[:, aileron]
    np.testing.assert_allclose(close(A4D, SpiralStabilization(BARE, k)).A, less, atol=1e-12)


def test_pitch_damper_is_more_pitch_damping() -> None:
    """Constant speed, Nelson's section 4.5: 2 zeta omega = -(M_q + M_wdot V + Z_w), and the loop adds -K M_de."""
    d, V = dimensional(A4D.coefficients, A4D.reference, "nelson"), A4D.reference.V
    model = linear_model(A4D, "nelson", ("q",)).part(("w", "q"), ("elevator", "throttle"))
    full = np.zeros((2, 4))
    full[:, :2] = model.B
    short = replace(model, B=full, D=np.zeros((1, 4)), inputs=("elevator", "throttle", "aileron", "rudder"))
    short = replace(short, units=linear_model(A4D).units)
    trace = np.trace(close(short, PitchRateDamper(BARE, 0.2)).A)
    expected = d.M_q + d.M_wdot * V + d.Z_w + 0.2 * (d.M_de + d.M_wdot * d.Z_de)
    assert trace == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(
    ("law", "name"),
    [
        (lambda gain: PitchRateDamper(BARE, gain), "short_period"),
        (lambda gain: YawDamper(BARE, gain), "dutch_roll"),
    ],
)
def test_positive_gains_damp(law: Callable[[float], Law], name: str) -> None:
    zetas = [next(m.zeta for m in modes(close(A4D, law(g))) if m.name == name) for g in (-0.05, 0.0, 0.05, 0.1)]
    assert all(one < other for one, other in pairwise(zetas))


def test_what_a_law_and_actuators_remember_has_modes_of_its_own() -> None:
    one = Actuator(20.0)
    names = [m.name for m in modes(close(A4D, YawDamper(BARE, 0.2), None, Actuators(one, one, one)))]
    assert names == [
        "elevator_actuator",
        "short_period",
        "phugoid",
        "aileron_actuator",
        "rudder_actuator",
        "dutch_roll",
        "roll",
        "yaw_washout",
        "spiral",
    ]


def test_second_order_actuators_oscillate() -> None:
    second = Actuator(30.0, 0.7)
    found = modes(with_actuators(linear_model(A4D), Actuators(second, second, second)))
    rudder = next(m for m in found if m.name == "rudder_actuator")
    assert (rudder.omega_n, rudder.zeta) == pytest.approx((30.0, 0.7))


def test_a_law_that_couples_the_axes_has_modes_of_both() -> None:
    model = close(A4D, BARE)
    coupled = model.A.copy()
    coupled[model.states.index("q"), model.states.index("beta")] = 0.5
    coupled[model.states.index("r"), model.states.index("w")] = 0.001
    found = modes(replace(model, A=coupled))
    assert [m.name for m in found] == [m.name for m in modes(A4D)]
    assert {s for m in found for s in m.participation} == set(model.states)


def test_says_what_a_model_does_not_show() -> None:
    with pytest.raises(SpecError) as found:
        close(linear_model(A4D), YawDamper(BARE, 0.1))
    assert str(found.value) == "The law measures r, and the linear model does not show it: give it that output."
    with pytest.raises(SpecError) as found:
        linear_model(A4D, outputs=("psi",))
    assert str(found.value) == ("The linear model cannot show psi: it changes with psi, which is not among its states.")


@pytest.mark.parametrize("name", ["V", "alpha", "beta", "n_z", "n_y", "q", "p_dot", "gamma"])
def test_outputs_of_the_model_are_those_of_the_plant(name: str) -> None:
    model = linear_model(A4D, outputs=(name,))
    plant = plant_of(FREE)
    x = PerturbationState(u=1e-3, w=2e-3, q=1e-5, theta=3e-5, beta=1e-5, p=2e-5, r=-1e-5, phi=1e-5, h=A4D.reference.h)
    trim = plant.trim()
    held = trim._replace(elevator=1e-5, aileron=-2e-5, rudder=1e-5)
    air = SteadyAir().air
    moved = getattr(plant.observe(x, held, air), name) - getattr(plant.observe(plant.start(), trim, air), name)
    state = np.array([getattr(x, s) for s in model.states])
    surfaces = np.array([getattr(held, i) - getattr(trim, i) for i in model.inputs])
    assert moved == pytest.approx((model.C @ state + model.D @ surfaces)[0], rel=1e-4, abs=1e-12)


def test_states_that_are_shown_as_they_are_need_no_differences(monkeypatch: pytest.MonkeyPatch) -> None:
    names = linearize.AS_THEY_ARE
    known = linear_model(A4D, outputs=names)
    monkeypatch.setattr(linearize, "AS_THEY_ARE", ())
    found = linear_model(A4D, outputs=names)
    np.testing.assert_array_equal(known.C, found.C)
    np.testing.assert_array_equal(known.D, found.D)
    assert known.units == found.units
