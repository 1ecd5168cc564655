"""Sensors: what the laws inside measure comes late, the stick does not; and the linear model says so too."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis import modes
from fdes.analysis.closed_loop import close
from fdes.analysis.design import law_for
from fdes.control import Law, LinearModel, Stick
from fdes.control.law import STICKS
from fdes.control.laws.direct import Direct
from fdes.control.laws.pitch_rate_pi import PitchRatePi
from fdes.control.laws.roll_angle import RollAngle
from fdes.control.laws.sensors import Sensors
from fdes.control.laws.yaw_damper import YawDamper
from fdes.errors import FdesError
from fdes.flight.actuated import actuators_of
from fdes.physics.signals import Outputs

A4D = load("A-4D").at("M0.4_SL")
BARE = Direct(A4D.full_stick)
INSIDE = YawDamper(RollAngle(PitchRatePi(BARE, 0.3, 0.5, 0.1), 0.5, 0.1), 0.4)
DT = 1.0 / 120.0
Y = Outputs(*[0.01 * (k + 1) for k in range(len(Outputs._fields))])
TIMES = [(0.0, 0.0), (0.02, 0.0), (0.0, 0.05), (0.02, 0.05), (0.03, 0.031), (0.01, 0.004)]


def numbers(memory: Any) -> Iterator[float]:
    if isinstance(memory, tuple):
        for part in memory:
            yield from numbers(part)
    elif memory is not None:
        yield memory


def with_numbers(memory: Any, values: Iterator[float]) -> Any:
    if isinstance(memory, tuple):
        parts = [with_numbers(part, values) for part in memory]
        return type(memory)(*parts) if hasattr(memory, "_fields") else type(memory)(parts)
    return None if memory is None else next(values)


def jacobian(law: Law, model: LinearModel) -> np.ndarray:
    """d(memory, surfaces)/d(memory, inputs) of one step, by differences that are exact for what is linear."""
    memory = law.start(Y, Stick())
    for _ in range(20):
        _, memory = law.step(Y, Stick(), memory, DT)
    n = len(list(numbers(memory)))

    def answer(values: np.ndarray) -> np.ndarray:
        given = dict(zip(model.inputs, values[n:], strict=True))
        y = Y._replace(**{k: v for k, v in given.items() if k not in STICKS})
        stick = Stick(**{k.removeprefix("stick_"): v for k, v in given.items() if k in STICKS})
        command, after = law.step(y, stick, with_numbers(memory, iter(values[:n])), DT)
        return np.array([*numbers(after), *command])

    steps = np.eye(n + len(model.inputs)) / 32.0
    return np.column_stack([(answer(step) - answer(-step)) * 16.0 for step in steps])


@pytest.mark.parametrize(("lag", "delay"), TIMES)
def test_linear_is_the_jacobian_of_step(lag: float, delay: float) -> None:
    law = Sensors(INSIDE, lag, delay)
    model = law.linear(DT)
    np.testing.assert_allclose(jacobian(law, model), np.block([[model.A, model.B], [model.C, model.D]]), atol=1e-9)


@pytest.mark.parametrize(("lag", "delay"), TIMES)
@pytest.mark.parametrize("omega", [0.5, 5.0, 20.0])
def test_each_signal_comes_through_a_lag_and_a_delay(lag: float, delay: float, omega: float) -> None:
    """Continuous: the law inside at that frequency, its measurements times exp(-s delay) / (lag s + 1)."""
    s = 1j * omega
    with_sensors, without = transfer(Sensors(INSIDE, lag, delay).linear(), s), transfer(INSIDE.linear(), s)
    late = np.exp(-s * delay) / (lag * s + 1.0)
    expected = without * np.array([1.0 if name in STICKS else late for name in INSIDE.linear().inputs])
    np.testing.assert_allclose(with_sensors, expected, atol=2e-3 * np.abs(without).max())


def transfer(model: LinearModel, s: complex) -> np.ndarray:
    return np.asarray(model.C @ np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B) + model.D)


def test_a_step_of_yaw_rate_is_felt_after_the_delay_and_the_stick_at_once() -> None:
    """Six frames of delay: nothing in six frames; in the seventh the trapezoidal lag has a / (1 + a), a = dt / 2 T."""
    law = Sensors(YawDamper(BARE, 0.5, 1e9), 0.1, 6 * DT)
    memory = law.start(Y._replace(r=0.0), Stick())
    rudder = []
    for _ in range(8):
        command, memory = law.step(Y._replace(r=1.0), Stick(roll=0.5), memory, DT)
        rudder.append(command.rudder)
        assert command.aileron == 0.5 * A4D.full_stick.aileron
    a = DT / 0.2
    assert rudder[:6] == [0.0] * 6
    assert rudder[6] == pytest.approx(0.5 * a / (1.0 + a), rel=1e-6)
    assert rudder[7] > rudder[6]


def test_it_takes_over_at_rest_and_without_a_bump() -> None:
    """The integral takes the elevator that is, not a late one."""
    law = Sensors(PitchRatePi(BARE, 0.3, 0.5, 0.1), 0.02, 0.05)
    y = Y._replace(q=0.0, elevator=-0.03)
    command, _ = law.step(y, Stick(), law.start(y, Stick()), DT)
    assert command.elevator == pytest.approx(-0.03, abs=1e-15)


@pytest.mark.parametrize(("lag", "delay"), TIMES)
def test_started_in_steady_motion_the_law_inside_sees_no_change(lag: float, delay: float) -> None:
    law = Sensors(INSIDE, lag, delay)
    memory, inner = law.start(Y, Stick()), INSIDE.start(Y, Stick())
    for _ in range(20):
        command, memory = law.step(Y, Stick(), memory, DT)
        expected, inner = INSIDE.step(Y, Stick(), inner, DT)
        assert command == pytest.approx(expected, rel=1e-12)


def test_lag_and_delay_can_be_turned_while_flying() -> None:
    """A slider from and to zero: the memory of one goes on in the other."""
    memory = Sensors(INSIDE).start(Y, Stick())
    for lag, delay in [*TIMES, *TIMES[::-1], *TIMES[::2]]:
        command, memory = Sensors(INSIDE, lag, delay).step(Y, Stick(), memory, DT)
        steady, _ = INSIDE.step(Y, Stick(), memory.inner, DT)
        assert command.rudder == pytest.approx(steady.rudder, abs=1e-3)


def test_said_last_it_makes_late_what_is_designed_with_it() -> None:
    bare = law_for("yaw_damper zeta=0.4", A4D)
    late = law_for("yaw_damper zeta=0.4; sensors lag=20ms delay=50ms", A4D)
    gain = late.gains["yaw_damper"]["gain"]
    assert gain != pytest.approx(bare.gains["yaw_damper"]["gain"], rel=0.02)
    assert late.gains["sensors"] == {"lag": 0.02, "delay": 0.05}
    assert late.law == Sensors(law_for(f"yaw_damper gain={gain!r}", A4D).law, 0.02, 0.05)
    (achieved,) = late.achieved
    assert achieved.designed == pytest.approx(0.4)
    named = {m.name: m for m in modes(close(A4D, late.law))}
    assert achieved.continuous == pytest.approx(0.4)
    assert named["dutch_roll"].zeta == pytest.approx(0.4)
    assert achieved.flown == pytest.approx(0.4, rel=0.02)
    assert achieved.alone != pytest.approx(0.4, abs=0.01)
    assert bare.achieved[0].alone == bare.achieved[0].continuous
    assert law_for(late.text, A4D).law == late.law
    assert {"short_period", "phugoid", "roll", "spiral", "r_lag", "r_delay"} <= set(named)


@pytest.mark.parametrize("dt", [None, DT, 0.02])
@pytest.mark.parametrize(
    "text", ["yaw_damper zeta=0.35", "roll_rate_damper time_constant=0.4", "pitch_rate_pi omega=4 zeta=0.6"]
)
def test_what_is_wanted_is_reached_with_sensors_and_actuators(text: str, dt: float | None) -> None:
    late = f"{text}; sensors lag=10ms delay=20ms"
    (achieved,) = law_for(late, A4D, dt=dt, actuators=actuators_of(A4D)).achieved
    assert achieved.reached
    assert achieved.designed == pytest.approx(achieved.wanted, rel=0.01)
    (without,) = law_for(text, A4D, dt=dt).achieved
    assert without.designed == pytest.approx(without.wanted, rel=0.01)


def test_sampled_modes_have_their_names_too() -> None:
    law = law_for("yaw_damper; pitch_rate_pi; sensors lag=20ms delay=50ms", A4D).law
    named = {m.name: m for m in modes(close(A4D, law, DT))}
    continuous = {m.name: m for m in modes(close(A4D, law))}
    assert {"short_period", "q_lag", "q_delay", "r_lag", "r_delay"} <= set(named)
    for name in ("dutch_roll", "roll", "spiral"):
        assert named[name].omega_n == pytest.approx(continuous[name].omega_n, rel=0.03)


def test_around_nothing_it_says_so() -> None:
    notes = law_for("sensors delay=50ms; yaw_damper gain=0.1", A4D).notes
    assert notes == ("sensors: the laws said before it measure nothing. Say it last, and it delays what they measure.",)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            "yaw_damper; sensors lag=-1ms",
            "The lag of the sensors is -0.001 s; it must be zero or more, such as 0.02 s.",
        ),
        ("yaw_damper; sensors delay=-2s", "The delay is -2 s; it must be zero or more, such as 0.02 s."),
        (
            "yaw_damper; sensors delay=1e6s",
            "The delay of 1e+06 s is 120,000,000 frames of 0.00833 s; at most 120 are computed. Ask for a shorter",
        ),
        ("yaw_damper; sensors delay=1.01s", "at most 120 are computed."),
        ("yaw_damper; sensors zeta=0.4", "sensors cannot be designed for zeta: FDES knows no design for it."),
        ("yaw_damper; sensors gain=0.4", "There is no setting of sensors named 'gain'."),
    ],
)
def test_says_what_cannot_be(text: str, words: str) -> None:
    with pytest.raises(FdesError) as found:
        law_for(text, A4D)
    assert words in str(found.value)
