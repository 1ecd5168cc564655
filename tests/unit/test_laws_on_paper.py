"""Each law against what its loop comes to on paper, from the derivatives of a textbook's short equations.

No source of ours prints a closed loop of these aircraft; each test derives its own from the equations it names. Nelson:
R. C. Nelson, Flight Stability and Automatic Control, 2nd ed.
"""

from dataclasses import dataclass, replace
from math import sqrt

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from fdes.aircraft import load
from fdes.analysis import linear_model
from fdes.analysis.closed_loop import close, open_loop
from fdes.control import Law, LinearModel, Stick
from fdes.control.law import with_loop
from fdes.control.laws.direct import Direct
from fdes.control.laws.pitch_rate_damper import PitchRateDamper
from fdes.control.laws.pitch_rate_pi import PitchRatePi
from fdes.control.laws.roll_angle import RollAngle
from fdes.control.laws.roll_rate_damper import RollRateDamper
from fdes.control.laws.sensors import Sensors
from fdes.control.laws.spiral_stabilization import SpiralStabilization
from fdes.control.laws.yaw_damper import YawDamper
from fdes.physics.derivatives import dimensional
from fdes.physics.signals import Outputs, Surfaces

A4D = load("A-4D").at("M0.4_SL")
BARE = Direct(A4D.full_stick)
D = dimensional(A4D.coefficients, A4D.reference, "nelson")
MODEL = linear_model(A4D, "nelson", ("q", "p", "r", "phi", "p_dot"))
V = A4D.reference.V
S = Polynomial([0.0, 1.0])


def short(states: tuple[str, ...]) -> LinearModel:
    """The model of these states alone, all others held at zero; every surface and output still named."""
    kept = np.array([s in states for s in MODEL.states])
    rows = np.flatnonzero(kept)
    units = {name: MODEL.units[name] for name in (*states, *MODEL.inputs, *MODEL.outputs)}
    names = tuple(s for s in MODEL.states if s in states)
    return replace(MODEL, A=MODEL.A[np.ix_(rows, rows)], B=MODEL.B[rows], C=MODEL.C[:, rows], states=names, units=units)


def ordered(found: object) -> np.ndarray:
    return np.sort_complex(np.asarray(found, dtype=complex))


def roots(model: LinearModel, law: Law) -> np.ndarray:
    return ordered(np.linalg.eigvals(close(model, law).A))


def polynomials(model: LinearModel, signal: str, surface: str) -> tuple[Polynomial, Polynomial]:
    """N and Delta of signal / surface = N / Delta, of a model of two states, by Cramer's rule."""
    (a, b), (c, d) = model.A
    row = model.states.index(signal)
    e, f = model.B[:, model.inputs.index(surface)]
    delta = (S - a) * (S - d) - b * c
    return (e * (S - d) + b * f, f * (S - a) + c * e)[row], delta


@pytest.mark.parametrize("gain", [0.05, 0.2, 0.5])
def test_pitch_rate_damper(gain: float) -> None:
    """Nelson, 4.5: with elevator = K q the roots of the short period are those of Delta - K N_q."""
    model = short(("w", "q"))
    N, delta = polynomials(model, "q", "elevator")
    np.testing.assert_allclose(
        roots(model, PitchRateDamper(BARE, gain)), ordered((delta - gain * N).roots()), rtol=1e-9
    )
    # in derivatives: 2 zeta omega grows by -K M_de, M_de being negative (with M_wdot Z_de, which is small)
    more = -(gain * (D.M_de + D.M_wdot * D.Z_de))
    assert sum(delta.roots()).real - sum(roots(model, PitchRateDamper(BARE, gain))).real == pytest.approx(more)
    assert more > 0.0


def test_pitch_rate_pi() -> None:
    """elevator = (K + K_i / s) q: the roots are those of s Delta - (K s + K_i) N_q."""
    model = short(("w", "q"))
    N, delta = polynomials(model, "q", "elevator")
    K, K_i = 0.3, 0.7
    expected = (S * delta - (K * S + K_i) * N).roots()
    np.testing.assert_allclose(roots(model, PitchRatePi(BARE, K, K_i, 0.1)), ordered(expected), rtol=1e-9)


def test_pitch_rate_pi_gives_the_rate_that_is_commanded() -> None:
    """The integral leaves no error: at full aft stick the steady pitch rate is full_rate, whatever the aircraft."""
    closed = close(short(("w", "q")), PitchRatePi(BARE, 0.3, 0.7, 0.1))
    steady = -np.linalg.solve(closed.A, closed.B[:, closed.inputs.index("stick_pitch")])
    assert steady[closed.states.index("q")] == pytest.approx(0.1, rel=1e-12)


def test_roll_angle() -> None:
    """Nelson, 5.3, rolling alone, phi'' = L_p p + L_da aileron: omega^2 = K L_da, 2 zeta omega = -L_p + K_p L_da."""
    model = short(("p", "phi"))
    omega, zeta = 3.0, 0.7
    K, K_p = omega * omega / D.L_da, (2.0 * zeta * omega + D.L_p) / D.L_da
    pair = omega * complex(-zeta, sqrt(1.0 - zeta * zeta))
    np.testing.assert_allclose(roots(model, RollAngle(BARE, K, K_p)), [pair.conjugate(), pair], rtol=1e-9)
    closed = close(model, RollAngle(BARE, K, K_p, 0.5))
    steady = -np.linalg.solve(closed.A, closed.B[:, closed.inputs.index("stick_roll")])
    assert steady == pytest.approx([0.0, 0.5], abs=1e-12)  # p and phi: the bank that is commanded


def test_roll_rate_damper() -> None:
    """Nelson, 5.3: tau = -1 / L_p, and with the loop 1 / (-L_p + K L_da); the steady rate falls by the same factor."""
    model = short(("p",))
    closed = close(model, RollRateDamper(BARE, 0.25))
    assert closed.A[0, 0] == pytest.approx(D.L_p - 0.25 * D.L_da, rel=1e-12)
    rate = -closed.B[0, closed.inputs.index("stick_roll")] / closed.A[0, 0]
    assert rate == pytest.approx(A4D.full_stick.aileron * D.L_da / (-D.L_p + 0.25 * D.L_da), rel=1e-12)


@pytest.mark.parametrize("washout", [1.0, 3.0, 1e6])
def test_yaw_damper(washout: float) -> None:
    """rudder = K T s / (T s + 1) r: the roots are those of (T s + 1) Delta - K T s N_r."""
    model = short(("beta", "r"))
    N, delta = polynomials(model, "r", "rudder")
    K, T = 0.4, washout
    expected = ((T * S + 1.0) * delta - K * T * S * N).roots()
    np.testing.assert_allclose(roots(model, YawDamper(BARE, K, T)), ordered(expected), rtol=1e-6, atol=1e-9)


def test_yaw_damper_without_washout_is_more_yaw_damping() -> None:
    """Nelson, 5.4: 2 zeta omega = -(Y_beta / V + N_r), and the loop makes N_r + K N_dr of N_r, N_dr being negative."""
    model = short(("beta", "r"))
    found = roots(model, YawDamper(BARE, 0.4, 1e9))
    pair = found[np.abs(found.imag) > 0.0]
    assert -pair.sum().real == pytest.approx(-(D.Y_beta / V + D.N_r + 0.4 * D.N_dr), rel=1e-6)


def test_yaw_damper_leaves_a_steady_turn_alone() -> None:
    law = YawDamper(BARE, 0.4, 3.0).linear()
    steady = law.D - law.C @ np.linalg.solve(law.A, law.B)
    assert steady[law.outputs.index("rudder"), law.inputs.index("r")] == pytest.approx(0.0, abs=1e-15)


def test_spiral_stabilization_holds_the_spiral_just_where_nelson_says() -> None:
    """Nelson, 5.3: it is neutral where L_beta N_r = L_r N_beta; the loop makes L_r - K L_da and N_r - K N_da of them.

    So from K = (L_beta N_r - L_r N_beta) / (L_beta N_da - L_da N_beta), which may be negative, the spiral decays.
    """
    neutral = (D.L_beta * D.N_r - D.L_r * D.N_beta) / (D.L_beta * D.N_da - D.L_da * D.N_beta)
    lateral = short(("beta", "p", "r", "phi"))
    at, less, more = (roots(lateral, SpiralStabilization(BARE, K)) for K in (neutral, neutral - 0.05, neutral + 0.05))
    assert np.abs(at).min() < 1e-9
    assert less.real.max() > 1e-4
    assert more.real.max() < -1e-4


@dataclass(frozen=True)
class RollAcceleration:
    """aileron = stick - gain p_dot: what it measures, it moves at once."""

    inner: Law
    gain: float

    def start(self, y: Outputs, stick: Stick) -> None:
        """Nothing to remember."""

    def step(self, y: Outputs, stick: Stick, memory: None, dt: float) -> tuple[Surfaces, None]:
        """Left aileron while rolling faster and faster to the right."""
        command, _ = self.inner.step(y, stick, memory, dt)
        return command._replace(aileron=command.aileron - self.gain * y.p_dot), None

    def linear(self, dt: float | None = None) -> LinearModel:
        """One gain."""
        return with_loop(self.inner.linear(dt), {"p_dot": -self.gain}, "aileron")


def test_a_law_that_moves_what_it_measures_is_solved_for() -> None:
    """p' = L_p p + L_da (F stick - K p'): p' = (L_p p + L_da F stick) / (1 + L_da K), and so is the output p_dot."""
    K, F, b = 0.3, A4D.full_stick.aileron, D.L_da
    closed = close(short(("p",)), RollAcceleration(BARE, K))
    stick, aileron = closed.inputs.index("stick_roll"), closed.inputs.index("aileron")
    p_dot = closed.outputs.index("p_dot")
    for row, direct in ((closed.A[0], closed.B[0]), (closed.C[p_dot], closed.D[p_dot])):
        assert row[0] == pytest.approx(D.L_p / (1.0 + K * b), rel=1e-12)
        assert direct[stick] == pytest.approx(b * F / (1.0 + K * b), rel=1e-12)
        assert direct[aileron] == pytest.approx(b / (1.0 + K * b), rel=1e-12)


def test_so_it_is_through_a_lag() -> None:
    """m' = (p' - m) / T, aileron = F stick - K m: p' = L_p p - L_da K m + L_da F stick goes into m' at once."""
    K, F, b, T = 0.3, A4D.full_stick.aileron, D.L_da, 0.05
    closed = close(short(("p",)), Sensors(RollAcceleration(BARE, K), T))
    stick, aileron = closed.inputs.index("stick_roll"), closed.inputs.index("aileron")
    np.testing.assert_allclose(closed.A, [[D.L_p, -b * K], [D.L_p / T, (-b * K - 1.0) / T]], rtol=1e-12)
    np.testing.assert_allclose(closed.B[:, [aileron, stick]], [[b, b * F], [b / T, b * F / T]], rtol=1e-12)
    p_dot = closed.outputs.index("p_dot")
    np.testing.assert_allclose(closed.C[p_dot], closed.A[0], rtol=1e-12)
    np.testing.assert_allclose(closed.D[p_dot], closed.B[0], rtol=1e-12)
    broken = open_loop(short(("p",)), RollAcceleration(BARE, K), "aileron")
    assert (broken.C[0, 0], broken.D[0, 0]) == (pytest.approx(K * D.L_p), pytest.approx(K * b))


def test_and_with_both_at_once() -> None:
    """aileron = -K m - K_2 p': p' = (L_p p - L_da K m) / (1 + L_da K_2), and m' = (p' - m) / T."""
    K, K_2, b, T = 0.3, 0.2, D.L_da, 0.05
    closed = close(short(("p",)), RollAcceleration(Sensors(RollAcceleration(BARE, K), T), K_2))
    moves = np.array([D.L_p, -b * K]) / (1.0 + b * K_2)
    np.testing.assert_allclose(closed.A, [moves, (moves - [0.0, 1.0]) / T], rtol=1e-12)
