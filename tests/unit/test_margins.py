"""Margins of loops: against formulas, against python-control, and against loops closed with as much more gain."""

from dataclasses import replace
from math import atan, degrees, exp, inf, pi, sqrt
from typing import Any

import control
import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis import linear_model, modes
from fdes.analysis.closed_loop import close, open_loop
from fdes.analysis.design import law_for
from fdes.analysis.margins import Margins, costs, margins, without_sensors
from fdes.analysis.placement import continuous_roots
from fdes.control import LinearModel
from fdes.control.laws.direct import Direct
from fdes.control.laws.roll_angle import RollAngle
from fdes.control.laws.roll_rate_damper import RollRateDamper
from fdes.control.laws.sensors import Sensors
from fdes.control.laws.spiral_stabilization import SpiralStabilization
from fdes.control.laws.yaw_damper import YawDamper
from fdes.flight.actuated import actuators_of
from fdes.physics.actuators import Actuator, Actuators
from fdes.physics.derivatives import dimensional

A4D = load("A-4D").at("M0.4_SL")
BARE = Direct(A4D.full_stick)
D = dimensional(A4D.coefficients, A4D.reference, "nelson")
a, b = -D.L_p, D.L_da  # of pure roll: p' = -a p + b aileron, phi' = p
DT = 1.0 / 50.0
TEXT = "yaw_damper; roll_angle; pitch_rate_pi; sensors lag=20ms delay=50ms"


def rolling_alone() -> LinearModel:
    model = linear_model(A4D, "nelson", ("p", "phi"))
    rows = [model.states.index("p"), model.states.index("phi")]
    A, B = np.zeros_like(model.A), np.zeros_like(model.B)
    A[rows[0], rows[0]], A[rows[1], rows[0]] = -a, 1.0
    B[rows[0], model.inputs.index("aileron")] = b
    return replace(model, A=A, B=B)


def only(found: tuple[Margins, ...]) -> Margins:
    (one,) = found
    return one


def test_a_first_order_loop_has_the_phase_of_one_lag() -> None:
    """L = K b / (s + a): |L| = 1 at sqrt((K b)^2 - a^2), where its phase is -atan(omega / a)."""
    K = 2.0 * a / b
    found = only(margins(rolling_alone(), RollRateDamper(BARE, K)))
    omega = sqrt((K * b) ** 2 - a * a)
    assert (found.surface, found.gain_margin, found.gain_reduction, found.stable) == ("aileron", inf, 0.0, True)
    assert found.gain_crossover == pytest.approx(omega, rel=1e-9)
    assert found.phase_margin == pytest.approx(pi - atan(omega / a), rel=1e-9)
    assert found.delay_margin == pytest.approx((pi - atan(omega / a)) / omega, rel=1e-9)


def test_sampled_it_can_be_turned_up_until_it_alternates_from_frame_to_frame() -> None:
    """L = (K b / a) (1 - E) / (z - E), E = exp(-a dt): at z = -1 it is -(K b / a) (1 - E) / (1 + E)."""
    K, E = 2.0 * a / b, exp(-a * DT)
    found = only(margins(rolling_alone(), RollRateDamper(BARE, K), DT))
    assert found.gain_margin == pytest.approx((1.0 + E) / (2.0 * (1.0 - E)), rel=1e-9)
    assert found.phase_crossover == pytest.approx(pi / DT)


def test_bank_angle_through_an_actuator_is_the_textbooks_third_order_loop() -> None:
    """L = K b w / (s (s + a) (s + w)): by Routh K b can be a (a + w), where it swings at sqrt(a w)."""
    w = 20.0
    one = Actuator(w)
    K = 0.25 * a * (a + w) / b
    found = only(margins(rolling_alone(), RollAngle(BARE, K), None, Actuators(one, one, one)))
    assert found.gain_margin == pytest.approx(4.0, rel=1e-9)
    assert found.phase_crossover == pytest.approx(sqrt(a * w), rel=1e-9)
    beyond = only(margins(rolling_alone(), RollAngle(BARE, 5.0 * K), None, Actuators(one, one, one)))
    assert (beyond.stable, beyond.gain_reduction) == (False, pytest.approx(0.8, rel=1e-9))
    assert beyond.phase_margin < 0.0


def test_a_delay_of_the_margin_is_just_too_much() -> None:
    """K b / (s (s + a)): with one frame of delay less it decays, with one more it grows."""
    dt = 0.002
    law = RollAngle(BARE, 3.0 * a * a / b)
    margin = only(margins(rolling_alone(), law, dt)).delay_margin
    frames = int(margin / dt)

    def fastest(n: int) -> float:
        A = close(rolling_alone(), Sensors(law, 0.0, n * dt), dt).A
        felt = [k for k, row in enumerate(np.abs(A) + np.abs(A.T)) if row.sum() != 2.0 * abs(A[k, k])]
        return float(np.abs(np.linalg.eigvals(A[np.ix_(felt, felt)])).max())

    assert fastest(frames) < 1.0 < fastest(frames + 1)


@pytest.mark.parametrize("surface", ["elevator", "aileron", "rudder"])
@pytest.mark.parametrize("dt", [None, DT])
def test_python_control_finds_the_same(surface: str, dt: float | None) -> None:
    law, actuators = law_for(TEXT, A4D).law, actuators_of(A4D)
    found = next(m for m in margins(A4D, law, dt, actuators) if m.surface == surface)
    L = open_loop(A4D, law, surface, dt, actuators)
    omega = np.geomspace(0.1, 3.0 * (found.phase_crossover or 1.0), 2_000)
    data = control.frd(control.ss(L.A, L.B, L.C, L.D, dt or 0), omega, smooth=True)
    gain, phase, _, at_phase, at_gain, _ = control.stability_margins(data)
    assert found.gain_margin == pytest.approx(gain, rel=1e-4)
    assert degrees(found.phase_margin) == pytest.approx(phase, rel=1e-4)
    assert found.phase_crossover == pytest.approx(at_phase, rel=1e-4)
    assert found.gain_crossover == pytest.approx(at_gain, rel=1e-4)


@pytest.mark.parametrize("dt", [None, DT])
@pytest.mark.parametrize("make", [RollRateDamper, SpiralStabilization, YawDamper])
def test_with_as_much_more_gain_a_root_stands_on_the_edge(make: Any, dt: float | None) -> None:
    gain, actuators = 0.3, actuators_of(A4D, 0.7)
    found = only(margins(A4D, make(BARE, gain), dt, actuators))
    assert found.gain_margin < inf
    edge = close(A4D, make(BARE, gain * found.gain_margin), dt, actuators)
    roots = continuous_roots(edge.A, dt)
    nearest = roots[np.argmin(np.abs(roots - 1j * (found.phase_crossover or 0.0)))]
    assert nearest == pytest.approx(1j * (found.phase_crossover or 0.0), abs=1e-5)


def test_a_spiral_that_only_the_loop_holds_needs_some_gain() -> None:
    """The bare spiral grows; the gain can shrink to where its root is zero, and no further."""
    condition = next(
        c for c in (load(n).at() for n in ("JetStar", "Convair880", "NAVION", "F-104A", "B747", "A-7A")) if grows(c)
    )
    law: Any = law_for("spiral_stabilization", condition).law
    found = only(margins(condition, law))
    assert found.stable
    assert 0.0 < found.gain_reduction < 1.0
    less = replace(law, gain=law.gain * found.gain_reduction)
    assert np.abs(np.linalg.eigvals(close(condition, less).A)).min() < 1e-9


def grows(condition: Any) -> bool:
    return any(m.name == "spiral" and m.zeta < 0.0 for m in modes(condition))


def test_the_loop_broken_is_the_loop_closed_again() -> None:
    law = law_for(TEXT, A4D).law
    for dt in (None, DT):
        whole = close(A4D, law, dt, actuators_of(A4D))
        for surface in ("elevator", "aileron", "rudder"):
            L = open_loop(A4D, law, surface, dt, actuators_of(A4D))
            assert (L.inputs, L.outputs) == ((surface,), (f"returned_{surface}",))
            np.testing.assert_allclose(L.A - L.B @ L.C / (1.0 + L.D[0, 0]), whole.A, atol=1e-9)


def test_what_lies_between_costs_margin() -> None:
    law = law_for(TEXT, A4D).law
    found = costs(A4D, law, DT, actuators_of(A4D))
    assert list(found) == ["law alone", "+ sensors", "+ actuators", "+ frames"]
    for one, other in zip(list(found.values())[1:], list(found.values())[2:], strict=False):
        for before, after in zip(one, other, strict=True):
            assert after.surface == before.surface
            assert after.gain_margin < before.gain_margin
            assert after.delay_margin < before.delay_margin
    assert list(costs(A4D, without_sensors(law))) == ["law alone"]
    assert without_sensors(law) == law_for(law_for(TEXT, A4D).text.rpartition(";")[0], A4D).law


def test_without_a_loop_there_is_nothing_to_say() -> None:
    assert margins(A4D, BARE) == ()
    assert margins(A4D, RollRateDamper(BARE, 0.0)) == ()


def test_json_has_no_infinities() -> None:
    said = only(margins(rolling_alone(), RollRateDamper(BARE, 0.5 * a / b))).as_dict()
    assert said == {
        "surface": "aileron",
        "gain_margin_db": None,
        "gain_reduction_db": None,
        "phase_crossover": None,
        "phase_margin_deg": None,
        "gain_crossover": None,
        "delay_margin_s": None,
        "stable": True,
    }
