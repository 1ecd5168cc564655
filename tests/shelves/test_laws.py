"""Every control law, ours and yours: pure, finite, starting anew like new, and as linear as it says."""

from collections.abc import Iterator
from dataclasses import MISSING, fields
from math import exp, isfinite
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.control import LinearModel, Stick
from fdes.control.law import STICKS, SURFACES, Law
from fdes.control.spoken import units_of
from fdes.flight import Clock, Excitation, HandsOff, Setup, SteadyAir, fly, plant_of
from fdes.physics.signals import Outputs, Surfaces
from fdes.shelf import shelf

A4D = load("A-4D").at("M0.4_SL")
DT = 1.0 / 120.0
SHAKEN = Excitation.parse(["doublet elevator 1deg for 1s", "doublet rudder 1deg for 1s", "doublet aileron 1deg for 1s"])
Y = Outputs(*[0.01 * (k + 1) for k in range(len(Outputs._fields))])
STICK = Stick(0.1, -0.2, 0.3, 0.4)


def example(name: str) -> Law:
    """The law of that name round the bare aircraft, every gain that has no default but zero at 0.3."""
    part = shelf("laws").get(name)
    given: dict[str, Any] = {"inner": shelf("laws").get("direct")(A4D.full_stick), "full_stick": A4D.full_stick}
    units = units_of(part)
    said = [f.name for f in fields(part) if f.default is MISSING or (f.default == 0.0 and units[f.name] != "s")]
    return part(**{name: given.get(name, 0.3) for name in said})


@pytest.fixture(params=shelf("laws").names())
def law(request: pytest.FixtureRequest) -> Law:
    return example(request.param)


def numbers(memory: Any) -> Iterator[float]:
    """The numbers of a memory, in order."""
    if isinstance(memory, tuple):
        for part in memory:
            yield from numbers(part)
    elif memory is not None:
        yield float(memory)


def with_numbers(memory: Any, values: Iterator[float]) -> Any:
    """The same memory with other numbers."""
    if isinstance(memory, tuple):
        parts = [with_numbers(part, values) for part in memory]
        return type(memory)(*parts) if hasattr(memory, "_fields") else tuple(parts)
    return None if memory is None else next(values)


def jacobian(law: Law, model: LinearModel) -> np.ndarray:
    """d(memory, surfaces)/d(memory, inputs) of one step, by differences that are exact for what is linear."""
    memory = law.start(Y, STICK)
    for _ in range(50):
        _, memory = law.step(Y, STICK, memory, DT)
    at = [*numbers(memory), *(getattr(Y, n, None) or getattr(STICK, n.removeprefix("stick_")) for n in model.inputs)]

    def answer(values: list[float]) -> np.ndarray:
        given = dict(zip(model.inputs, values[len(model.states) :], strict=True))
        y = Y._replace(**{n: v for n, v in given.items() if n not in STICKS})
        stick = STICK._replace(**{n.removeprefix("stick_"): v for n, v in given.items() if n in STICKS})
        command, after = law.step(y, stick, with_numbers(memory, iter(values)), DT)
        return np.array([*numbers(after), *command])

    columns = []
    for k in range(len(at)):
        up, down = list(at), list(at)
        up[k] += 2.0**-5
        down[k] -= 2.0**-5
        columns.append((answer(up) - answer(down)) / 2.0**-4)
    return np.column_stack(columns)


def blocks_of(model: LinearModel) -> np.ndarray:
    return np.block([[model.A, model.B], [model.C, model.D]])


def test_linear_is_the_jacobian_of_step(law: Law) -> None:
    model = law.linear(DT)
    assert model.dt == DT
    assert model.outputs == SURFACES
    np.testing.assert_allclose(jacobian(law, model), blocks_of(model), rtol=0.0, atol=1e-9)


def test_linear_measures_all_that_step_does(law: Law) -> None:
    memory = law.start(Y, STICK)
    command, _ = law.step(Y, STICK, memory, DT)
    for name in set(Outputs._fields) - set(law.linear().inputs):
        other, _ = law.step(Y._replace(**{name: 7.0}), STICK, memory, DT)
        assert other == command, f"{name} moves the surfaces, and is no input of linear()"


def test_continuous_is_the_limit_of_ever_shorter_frames(law: Law) -> None:
    continuous, dt = law.linear(), 1e-6
    sampled = law.linear(dt)
    assert continuous.dt is None
    assert (continuous.states, continuous.inputs) == (sampled.states, sampled.inputs)
    identity = np.eye(len(sampled.states))
    np.testing.assert_allclose((sampled.A - identity) / dt, continuous.A, atol=1e-4)
    np.testing.assert_allclose(sampled.B / dt, continuous.B, atol=1e-4)
    np.testing.assert_allclose(sampled.C, continuous.C, atol=1e-4)
    np.testing.assert_allclose(sampled.D, continuous.D, atol=1e-4)


def test_names_have_units(law: Law) -> None:
    model = law.linear()
    assert {*model.states, *model.inputs, *model.outputs} <= set(model.units)


def test_pure(law: Law) -> None:
    """The same question has the same answer, whatever was asked in between; a law cannot be changed."""
    memory = law.start(Y, STICK)
    first = law.step(Y, STICK, memory, DT)
    law.step(Y._replace(q=9.0, r=9.0, p=9.0, phi=9.0), Stick(1.0, 1.0, 1.0, 1.0), memory, DT)
    assert law.start(Y, STICK) == memory
    assert law.step(Y, STICK, memory, DT) == first
    with pytest.raises(AttributeError):
        law.gain = 2.0  # type: ignore[attr-defined]


def test_finite_in_flight_and_the_same_after_a_reset(law: Law) -> None:
    plant = plant_of(A4D)
    clock = Clock(DT, 1, 4.0)

    def flown() -> list[Surfaces]:
        setup = Setup(plant, law)
        frames = fly(plant.start(500.0), setup, HandsOff(A4D.trim_throttle), SteadyAir(), clock, SHAKEN)
        return [frame.command for frame in frames]

    once = flown()
    assert all(isfinite(v) for command in once for v in command)
    assert flown() == once


def test_started_in_trim_nothing_moves(law: Law) -> None:
    plant = plant_of(A4D)
    y = plant.observe(plant.start(), plant.trim(), SteadyAir().air)
    stick = Stick(throttle=A4D.trim_throttle)
    command, _ = law.step(y, stick, law.start(y, stick), DT)
    assert command == pytest.approx(plant.trim(), abs=1e-15)


def test_the_yaw_damper_forgets_a_steady_turn() -> None:
    law = example("yaw_damper")
    memory = law.start(Y._replace(r=0.0), Stick())
    turning = Y._replace(r=0.1)
    first, memory = law.step(turning, Stick(), memory, DT)
    for _ in range(round(3.0 / DT)):
        last, memory = law.step(turning, Stick(), memory, DT)
    assert first.rudder == pytest.approx(0.3 * 0.1, rel=0.01)
    assert last.rudder == pytest.approx(0.3 * 0.1 * exp(-1.0), rel=0.01)


def test_started_in_a_turn_the_yaw_damper_leaves_the_rudder_alone() -> None:
    law = example("yaw_damper")
    command, _ = law.step(Y._replace(r=0.2), Stick(), law.start(Y._replace(r=0.2), Stick()), DT)
    assert command.rudder == pytest.approx(0.0, abs=1e-15)


def test_the_integral_takes_over_the_elevator_that_is() -> None:
    law = example("pitch_rate_pi")
    y = Y._replace(q=0.1, elevator=-0.03)
    command, _ = law.step(y, Stick(), law.start(y, Stick()), DT)
    assert command.elevator == pytest.approx(-0.03, abs=0.3 * 0.1 * DT)
