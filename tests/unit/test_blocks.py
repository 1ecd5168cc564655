"""The blocks of control laws do what their transfer functions say."""

from collections.abc import Callable
from math import degrees, exp, pi

import numpy as np
import pytest

from fdes.control.blocks import PI, Block, Delay, Lag, LeadLag, Limiter, StateSpace, Washout
from fdes.errors import SpecError

DT = 0.01
BLOCKS: list[Block] = [
    Lag(0.2),
    Washout(1.5),
    LeadLag(0.3, 0.1),
    PI(0.4, 0.9),
    Limiter(-9.0, 9.0),
    Delay(0.0),
    Delay(0.03),
    Delay(0.0273),
]


def response(block: StateSpace, s: complex) -> complex:
    return complex(block.C @ np.linalg.solve(s * np.eye(len(block.A)) - block.A, block.B) + block.D)


def run(block: Block, inputs: list[float]) -> list[float]:
    memory, outputs = block.start(0.0), []
    for u in inputs:
        y, memory = block.step(u, memory, DT)
        outputs.append(y)
    return outputs


@pytest.mark.parametrize("block", BLOCKS, ids=repr)
def test_stepping_is_what_the_state_space_says(block: Block) -> None:
    inputs = [np.sin(0.37 * k) for k in range(200)]
    A, B, C, D = block.linear(DT)
    x, expected = np.zeros(len(A)), []
    for u in inputs:
        expected.append(C @ x + D * u)
        x = A @ x + B * u
    np.testing.assert_allclose(run(block, inputs), expected, atol=1e-12)


@pytest.mark.parametrize(
    ("block", "transfer"),
    [
        (Lag(0.2), lambda s: 1.0 / (0.2 * s + 1.0)),
        (Washout(1.5), lambda s: 1.5 * s / (1.5 * s + 1.0)),
        (LeadLag(0.3, 0.1), lambda s: (0.3 * s + 1.0) / (0.1 * s + 1.0)),
        (PI(0.4, 0.9), lambda s: 0.4 + 0.9 / s),
        (Delay(0.05), lambda s: np.exp(-0.05 * s)),
    ],
    ids=lambda value: "" if callable(value) and not hasattr(value, "linear") else repr(value),
)
def test_transfer_function(block: Block, transfer: Callable[[complex], complex]) -> None:
    """Continuous; and from frame to frame where the trapezoidal rule maps the frequency: s = 2/dt (z-1)/(z+1)."""
    w = 3.0
    assert response(block.linear(), 1j * w) == pytest.approx(transfer(1j * w), rel=1e-5)
    z = np.exp(1j * w * DT)
    s = 1j * w if isinstance(block, Delay) else 2.0 / DT * (z - 1.0) / (z + 1.0)
    assert response(block.linear(DT), z) == pytest.approx(transfer(s), rel=1e-12)


@pytest.mark.parametrize(("angle", "error"), [(1.7, 1.0), (1.9, 2.0)])
def test_the_continuous_delay_is_good_to_one_degree_as_far_as_it_says(angle: float, error: float) -> None:
    late = response(Delay(0.1).linear(), 1j * angle / 0.1)
    assert abs(late) == pytest.approx(1.0)
    assert error - 0.6 < abs(degrees(np.angle(late) + angle)) < error


def test_a_lag_reaches_63_percent_in_its_time_constant() -> None:
    assert run(Lag(0.5), [1.0] * 51)[-1] == pytest.approx(1.0 - exp(-1.0), rel=0.01)


def test_a_delay_is_late_by_itself_and_no_more() -> None:
    assert run(Delay(0.03), [1.0] * 5) == [0.0, 0.0, 0.0, 1.0, 1.0]
    assert run(Delay(0.025), [1.0] * 5) == pytest.approx([0.0, 0.0, 0.5, 1.0, 1.0])


def test_an_integral_does_not_wind_up() -> None:
    """Held at its limit for 10 s, it leaves the limit as soon as the input turns."""
    block = PI(0.1, 1.0, lower=-0.5, upper=0.5)
    outputs = run(block, [1.0] * 1000 + [-1.0] * 60)
    assert max(outputs) == 0.5
    assert outputs[1000] < 0.4
    assert outputs[-1] == pytest.approx(outputs[1000] - 59 * DT)


def test_an_integral_begins_where_the_output_is() -> None:
    block = PI(0.1, 1.0, lower=-0.5, upper=0.5)
    output, _ = block.step(0.2, block.start(0.2, 0.3), 1e-9)
    assert output == pytest.approx(0.3)
    assert block.step(0.2, block.start(0.2, 7.0), 1e-9)[0] == pytest.approx(0.5)


def test_a_limiter_limits() -> None:
    assert run(Limiter(-1.0, 2.0), [-pi, 0.5, pi]) == [-1.0, 0.5, 2.0]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Lag(0.0), "The time constant of a lag is 0 s; it must be positive, such as 0.1 s."),
        (lambda: Washout(-1.0), "The time constant of a washout is -1 s; it must be positive, such as 0.1 s."),
        (lambda: Delay(float("nan")), "The delay is nan s; it must be zero or more, such as 0.02 s."),
    ],
)
def test_says_which_time_cannot_be(make: Callable[[], Block], words: str) -> None:
    with pytest.raises(SpecError) as found:
        make()
    assert str(found.value) == words
