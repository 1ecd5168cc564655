"""What the flying-qualities requirements look at, measured on a linear model: damping, frequencies, n/alpha, phi/beta.

A mode whose two roots have turned real is still a second-order motion: omega^2 is the product of its roots and zeta
follows from their sum, greater than 1. Where one of them is unstable omega^2 is negative. A mode that has merged with
another is none any more, and what was measured on it is missing, with the reason; but a Dutch roll goes on as what it
has become, and a short period as the motion at constant speed.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fdes.analysis.linearize import STATES
from fdes.analysis.modes import Mode, modes
from fdes.control import LinearModel

NEUTRAL = 1e-6  # rad/s: a slower real root, which takes more than a week to double, is rounding
LN2 = math.log(2.0)


def frequency_in_words(symbol: str, omega: float) -> str:
    """A natural frequency [rad/s], or where `omega` is negative omega^2, the product of its roots.

    >>> frequency_in_words("omega_sp", -1.06)
    'omega_sp^2 = -1.12 (rad/s)^2, the product of its roots'
    """
    if omega > 0.0:
        return f"{symbol} {omega:.3g} rad/s"
    return f"{symbol}^2 = {omega * abs(omega):.3g} (rad/s)^2, the product of its roots"


@dataclass(frozen=True)
class Measured:
    """The quantities, SI; None where one is not known. `missing` says why, by name.

    omega_sp, omega_dr [rad/s]: natural frequencies; negative stands for minus the root of a negative omega^2, where the
    mode has split into one stable and one unstable root. zeta_sp, zeta_dr: damping ratios; None where omega^2 < 0.
    n_alpha: steady load factor per angle of attack at constant speed [1/rad].
    zeta_ph, t2_ph: phugoid damping ratio, and its time to double where it grows [s].
    t2_speed: time to double of an aperiodic divergence of airspeed [s].
    phi_beta: |phi / beta| in the Dutch roll. tau_roll: roll-mode time constant [s], negative where it diverges.
    t2_spiral: time to double of the spiral [s]; infinite where neutral, negative (minus the time to half) where stable.
    damping_rs: zeta omega_n of a coupled roll-spiral mode [rad/s]. delay: equivalent time delay of the response [s].
    """

    omega_sp: float | None = None
    zeta_sp: float | None = None
    n_alpha: float | None = None
    zeta_ph: float | None = None
    t2_ph: float | None = None
    t2_speed: float | None = None
    omega_dr: float | None = None
    zeta_dr: float | None = None
    phi_beta: float | None = None
    tau_roll: float | None = None
    t2_spiral: float | None = None
    damping_rs: float | None = None
    delay: float | None = None
    missing: Mapping[str, str] = field(default_factory=dict)
    notes: Mapping[str, str] = field(default_factory=dict)


class Pair(NamedTuple):
    """A second-order motion: omega_n [rad/s], negative where omega^2 < 0, and its damping ratio, then None."""

    omega: float
    zeta: float | None


def measure(
    model: LinearModel,
    delay: float | None = None,
    found: Sequence[Mode] | None = None,
    airframe: LinearModel | None = None,
) -> Measured:
    """Measure `model`.

    delay [s]: of everything between stick and surface, else what the model shows of it. found: the modes of the model,
    where they are known. airframe: the model without law and actuators, of which n/alpha is taken; else the model's.
    """
    named = {mode.name: mode for mode in (modes(model) if found is None else found)}
    missing: dict[str, str] = {}
    notes: dict[str, str] = {}
    short_period, missing["omega_sp"] = _short_period(model, named, notes)
    after_yaw = _after_yaw(named)
    dutch_roll, missing["omega_dr"] = _dutch_roll(after_yaw, named, notes)
    phugoid, missing["zeta_ph"] = _phugoid(named, notes)
    missing["zeta_sp"], missing["zeta_dr"] = missing["omega_sp"], missing["omega_dr"]
    roll, spiral, coupled = (named.get(name) for name in ("roll", "spiral", "roll_spiral"))
    missing["tau_roll"], missing["t2_spiral"] = _gone("roll", named), _gone("spiral", named)
    if coupled is None:
        apart = roll is not None and spiral is not None
        missing["damping_rs"] = f"Roll and spiral {'are separate modes' if apart else 'do not form a mode together'}."
    missing["delay"] = "The model has no actuator and no computer between stick and surface: give their delay."
    parts = delays_of(model)
    if delay is None and parts:
        notes["delay"] = " and ".join(f"{value:.3g} s of {what}" for what, value in parts.items())
    return Measured(
        omega_sp=short_period and short_period.omega,
        zeta_sp=short_period and short_period.zeta,
        n_alpha=n_alpha(airframe or model),
        zeta_ph=phugoid and phugoid.zeta,
        t2_ph=_doubling(phugoid),
        t2_speed=_speed_divergence(named),
        omega_dr=dutch_roll and dutch_roll.omega,
        zeta_dr=dutch_roll and dutch_roll.zeta,
        phi_beta=None if after_yaw is None else phi_beta(model, after_yaw.eigenvalue),
        tau_roll=None if roll is None else -1.0 / _away_from_zero(roll.eigenvalue.real),
        t2_spiral=None if spiral is None else _t2(spiral.eigenvalue.real),
        damping_rs=None if coupled is None else -coupled.eigenvalue.real,
        delay=delay_of(model) if delay is None else delay,
        missing={name: reason for name, reason in missing.items() if reason},
        notes=notes,
    )


def n_alpha(model: LinearModel) -> float:
    """Steady load factor per radian of angle of attack in a pull-up by elevator at constant speed [1/rad].

    From w and q at rest with the elevator eliminated, so that feedback to the elevator, which moves the poles, leaves
    it as it is. Without lift on the elevator it is -Z_alpha/g. MIL-F-8785C, pages 76 and 77.
    """
    V, g = float(model.point["V"]), float(model.point["g"])
    w, q = model.states.index("w"), model.states.index("q")
    A = model.A if model.dt is None else (model.A - np.eye(len(model.states))) / model.dt
    by_surface = _elevator(model)
    Z_de, M_de = (1.0, 0.0) if by_surface is None else (float(by_surface[w]), float(by_surface[q]))
    if M_de == 0.0:
        return float(-A[w, w] * V / g)
    lift, turn = M_de * A[w, w] - Z_de * A[q, w], M_de * A[w, q] - Z_de * A[q, q]
    return float(-lift / turn * V * V / g) if turn else 0.0


def _elevator(model: LinearModel) -> NDArray[np.float64] | None:
    """What elevator does to the states, up to a factor: through its actuator, where there is one."""
    if "elevator_actuator" in model.states:
        return np.asarray(model.A[:, model.states.index("elevator_actuator")])
    return np.asarray(model.B[:, model.inputs.index("elevator")]) if "elevator" in model.inputs else None


def delay_of(model: LinearModel) -> float | None:
    """The delay that the model holds between stick and surface [s], the sum of `delays_of`. None without any."""
    return sum(delays_of(model).values()) or None


def delays_of(model: LinearModel) -> dict[str, float]:
    """What comes between stick and surface in a model, and its delay [s]: the slowest actuator, half a frame of hold.

    A lag counts by the slope of its phase at low frequency, the sum of -1/s over its roots. Sensors are no part of it:
    they stand in the feedback, and the stick does not pass through them.
    """
    lags = [_lag(model, surface) for surface in ("elevator", "aileron", "rudder")]
    slowest = max((lag for lag in lags if lag is not None), default=None)
    found = {} if slowest is None else {"the slowest actuator": slowest}
    return found if model.dt is None else found | {"half a frame": 0.5 * model.dt}


def _lag(model: LinearModel, surface: str) -> float | None:
    rows = [k for k, name in enumerate(model.states) if name in {f"{surface}_actuator", f"{surface}_actuator_rate"}]
    if not rows:
        return None
    roots = np.linalg.eigvals(model.A[np.ix_(rows, rows)]).astype(complex)
    if model.dt is not None:
        roots = np.log(roots) / model.dt
    return float(-(1.0 / roots).sum().real)


def phi_beta(model: LinearModel, eigenvalue: complex) -> float | None:
    """|phi / beta| in the mode of that eigenvalue [rad/s], from its eigenvector; None where it does not sideslip."""
    values, vectors = np.linalg.eig(model.A)
    root = eigenvalue if model.dt is None else np.exp(eigenvalue * model.dt)
    vector = vectors[:, int(np.argmin(np.abs(values - root)))]
    beta, phi = (abs(vector[model.states.index(name)]) for name in ("beta", "phi"))
    return float(phi / beta) if beta > 0.0 else None


def _pair(family: str, named: Mapping[str, Mode], notes: dict[str, str]) -> tuple[Pair | None, str]:
    """The second-order motion of a family, or why there is none."""
    if family in named:
        return _as_pair(named[family]), ""
    fast, slow = named.get(f"{family}_fast"), named.get(f"{family}_slow")
    if fast is None or slow is None:
        return None, _gone(family, named)
    a, b = fast.eigenvalue.real, slow.eigenvalue.real
    words = family.replace("_", " ")
    notes[family] = f"The {words} has split into two real roots, {a:.3g} and {b:.3g} 1/s."
    product = a * b
    growing = max(a, b)
    if growing > NEUTRAL:
        notes[family] += f" That of {growing:.3g} grows: it doubles in {LN2 / growing:.3g} s, with no oscillation."
    if product <= 0.0:
        return Pair(-math.sqrt(-product), None), f"One of the two real roots of the {words} is unstable."
    return Pair(math.sqrt(product), -(a + b) / (2.0 * math.sqrt(product))), ""


def _gone(name: str, named: Mapping[str, Mode]) -> str:
    """Why a mode is not there."""
    if name in named:
        return ""
    into = [
        _with_growth(other, mode)
        for other, mode in named.items()
        if other == "third_oscillatory" or _plain(name) in _plain(other)
    ]
    words = name.replace("_", " ")
    return f"There is no {words}: it has become part of another mode ({'; '.join(into) or 'none of the usual'})."


def _plain(name: str) -> str:
    """A name in which the Dutch roll is no roll."""
    return name.replace("dutch_roll", "dutch")


def _with_growth(name: str, mode: Mode) -> str:
    """The name of a mode in words, and how fast it grows if it does."""
    grows = "" if mode.time_to_double is None else f", unstable: it doubles in {mode.time_to_double:.3g} s"
    return name.replace("_", " ") + grows


def _short_period(model: LinearModel, named: Mapping[str, Mode], notes: dict[str, str]) -> tuple[Pair | None, str]:
    """The short period; where it has merged with the phugoid, the motion in w and q at constant speed.

    That is the approximation of which the requirements on the short-term response are made (R. C. Nelson, Flight
    Stability and Automatic Control, 2nd ed., 1998, chapter 4), and it goes on where the exact mode ends. A model with
    states of law or actuators has no such part: there the short period is missing.
    """
    if "third_oscillatory" not in named or not _is_bare(model):
        return _pair("short_period", named, notes)
    at = [model.states.index("w"), model.states.index("q")]
    a, b = sorted(np.linalg.eigvals(model.A[np.ix_(at, at)]), key=lambda root: root.real)
    product, total = float((a * b).real), float((a + b).real)
    roots = f"{a.real:.3g} and {b.real:.3g} 1/s" if a.imag == 0.0 else f"{a.real:.3g} +- {abs(a.imag):.3g}i 1/s"
    notes["short_period"] = f"The short period has merged with the phugoid; at constant speed its roots are {roots}."
    if product <= 0.0:
        return Pair(0.0 - math.sqrt(-product), None), "One of its two roots at constant speed does not decay."
    return Pair(math.sqrt(product), -total / (2.0 * math.sqrt(product))), ""


def _is_bare(model: LinearModel) -> bool:
    """Whether the pitching motion of a continuous model has no states but the airframe's."""
    return model.dt is None and {"w", "q"} <= set(model.states) <= set(STATES)


def _phugoid(named: Mapping[str, Mode], notes: dict[str, str]) -> tuple[Pair | None, str]:
    """The long-period oscillation, which may be one that the phugoid and the short period have formed together."""
    merged = named.get("third_oscillatory")
    if merged is None:
        return _pair("phugoid", named, notes)
    notes["phugoid"] = "Phugoid and short period have merged in a third oscillation, which is judged here."
    return _as_pair(merged), ""


def _after_yaw(named: Mapping[str, Mode]) -> Mode | None:
    """The oscillation that follows a yaw disturbance: the Dutch roll or, of what it has merged into, the worst damped.

    MIL-F-8785C, paragraph 3.3.1.1, asks it of the lateral-directional oscillations, whatever they are made of.
    """
    if "dutch_roll" in named:
        return named["dutch_roll"]
    merged = [named[name] for name in ("roll_dutch_roll", "spiral_dutch_roll") if name in named]
    return min(merged, key=lambda mode: mode.zeta, default=None)


def _dutch_roll(after_yaw: Mode | None, named: Mapping[str, Mode], notes: dict[str, str]) -> tuple[Pair | None, str]:
    """The Dutch roll, or what it has become part of, or why there is neither."""
    if after_yaw is None or after_yaw.name == "dutch_roll":
        return _pair("dutch_roll", named, notes)
    other = after_yaw.name.removesuffix("_dutch_roll")
    growing = named["dutch_roll_fast"].eigenvalue.real if "dutch_roll_fast" in named else 0.0
    if growing > NEUTRAL:
        notes["dutch_roll"] = (
            f"Half of the dutch roll has merged with the {other}, the other half, {growing:.3g} 1/s, grows: "
            f"it doubles in {LN2 / growing:.3g} s, with no oscillation."
        )
        # Of the other half only the size is left: that of the oscillation which it has become part of.
        return Pair(-math.sqrt(growing * after_yaw.omega_n), None), "Half of the dutch roll is unstable."
    notes["dutch_roll"] = f"Dutch roll and {other} have merged in one oscillation, which is judged here."
    return _as_pair(after_yaw), ""


def _as_pair(mode: Mode) -> Pair:
    return Pair(mode.omega_n, mode.zeta)


def _doubling(pair: Pair | None) -> float | None:
    if pair is None or pair.zeta is None or pair.zeta >= 0.0:
        return None
    return LN2 / (-pair.zeta * pair.omega)


def _speed_divergence(named: Mapping[str, Mode]) -> float | None:
    roots = [m.eigenvalue.real for m in named.values() if m.axis == "longitudinal" and not m.oscillatory]
    growing = max(roots, default=0.0)
    return LN2 / growing if growing > NEUTRAL else None


def _t2(root: float) -> float:
    return math.inf if abs(root) <= NEUTRAL else LN2 / root


def _away_from_zero(root: float) -> float:
    """A root that can be divided by: a neutral one counts as barely stable."""
    return root if abs(root) > NEUTRAL else -NEUTRAL
