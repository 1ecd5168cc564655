"""The textbook's approximations to the natural modes, and the static figures that go with them.

Each is what a student derives on paper from a few derivatives; beside the exact eigenvalue it shows what was neglected.
Where the exact modes have merged or split, an approximation has no partner, and is not compared with a mode that only
happens to be near.

Reference: R. C. Nelson, Flight Stability and Automatic Control, 2nd ed., McGraw-Hill 1998, chapters 4 and 5.
"""

import cmath
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from fdes.aircraft import FlightCondition
from fdes.analysis.linearize import linear_model
from fdes.analysis.measured import n_alpha
from fdes.analysis.mode_names import MERGED
from fdes.analysis.modes import Mode, modes
from fdes.physics.derivatives import Dimensional, Form, Reference, dimensional


@dataclass(frozen=True)
class Approximation:
    """One approximate mode: its eigenvalue [rad/s], the upper one of a pair, and the equation it is from."""

    name: str
    eigenvalue: complex
    reference: str

    @property
    def omega_n(self) -> float:
        """Undamped natural frequency [rad/s]; of a real root its size."""
        return abs(self.eigenvalue)

    @property
    def zeta(self) -> float:
        """Damping ratio; of a real root 1 (stable) or -1 (unstable)."""
        return -self.eigenvalue.real / abs(self.eigenvalue) if self.eigenvalue else -1.0


def approximate_modes(condition: FlightCondition, form: Form = "nelson") -> list[Approximation]:
    """Nelson's approximations to the five classical modes, of the derivatives that the form keeps.

    One whose formula has no meaning here is left out. Raises SpecError where there are no nondimensional derivatives.
    """
    d, ref = dimensional(condition.coefficients, condition.reference, form), condition.reference
    if form == "paper":  # its equations have no M_wdot, so an error with it would not be that of the approximation
        d = d._replace(M_wdot=0.0)
    found = [_short_period(d, ref), _phugoid(d, ref), _roll(d), _dutch_roll(d, ref)]
    if d.L_beta != 0.0:
        found.append(_spiral(d))
    return found


def _short_period(d: Dimensional, ref: Reference) -> Approximation:
    """Constant speed: the phugoid is taken out."""
    stiffness = d.Z_w * d.M_q - d.M_w * ref.V
    damping = -(d.M_q + d.M_wdot * ref.V + d.Z_w)
    return Approximation("short_period", _upper_root(stiffness, damping), "Nelson, chapter 4")


def _phugoid(d: Dimensional, ref: Reference) -> Approximation:
    """Constant angle of attack: energy goes to and fro between height and speed."""
    return Approximation("phugoid", _upper_root(-d.Z_u * ref.g / ref.V, -d.X_u), "Nelson, chapter 4")


def _roll(d: Dimensional) -> Approximation:
    """Rolling alone."""
    return Approximation("roll", complex(d.L_p), "Nelson, chapter 5")


def _spiral(d: Dimensional) -> Approximation:
    """Sideslip and yaw in balance."""
    return Approximation("spiral", complex((d.L_beta * d.N_r - d.N_beta * d.L_r) / d.L_beta), "Nelson, chapter 5")


def _dutch_roll(d: Dimensional, ref: Reference) -> Approximation:
    """Sideslip and yaw alone, wings level."""
    V = ref.V
    stiffness = (d.Y_beta * d.N_r - d.N_beta * d.Y_r + V * d.N_beta) / V
    damping = -(d.Y_beta + V * d.N_r) / V
    return Approximation("dutch_roll", _upper_root(stiffness, damping), "Nelson, chapter 5")


def _upper_root(stiffness: float, damping: float) -> complex:
    """The root of s^2 + damping s + stiffness with the larger imaginary part; of two real roots the slower."""
    root = cmath.sqrt(damping * damping / 4.0 - stiffness)
    return -damping / 2.0 + (root if root.imag > 0.0 or damping > 0.0 else -root)


@dataclass(frozen=True)
class Compared:
    """An approximation beside the exact mode of its name.

    exact: None where there is no such mode, and then `alone` says why. Errors are fractions of the exact value,
    positive where the approximation is larger; that of a real root, the eigenvalue's, stands under `omega_n_error`.
    """

    approximation: Approximation
    exact: Mode | None
    alone: str

    @property
    def omega_n_error(self) -> float | None:
        """Error of the undamped natural frequency; of a real root that of the eigenvalue with its sign."""
        if self.exact is None or not self.exact.eigenvalue:
            return None
        if self.exact.oscillatory:
            return self.approximation.omega_n / self.exact.omega_n - 1.0
        return self.approximation.eigenvalue.real / self.exact.eigenvalue.real - 1.0

    @property
    def zeta_error(self) -> float | None:
        """Error of the damping ratio; a real root has none."""
        if self.exact is None or not self.exact.oscillatory or not self.exact.zeta:
            return None
        return self.approximation.zeta / self.exact.zeta - 1.0

    def as_dict(self) -> dict[str, Any]:
        """The comparison as JSON has it; `mode` is the exact mode's name."""
        a = self.approximation
        return {
            "name": a.name,
            "eigenvalue": [a.eigenvalue.real, a.eigenvalue.imag],
            "omega_n": a.omega_n,
            "zeta": a.zeta,
            "mode": self.exact and self.exact.name,
            "omega_n_error": self.omega_n_error,
            "zeta_error": self.zeta_error,
            "alone": self.alone or None,
            "reference": a.reference,
        }


def compare(condition: FlightCondition, form: Form, exact: Sequence[Mode]) -> list[Compared]:
    """Nelson's approximations beside the modes of the same equations. Raises SpecError as `approximate_modes` does."""
    return [_beside(approximation, exact) for approximation in approximate_modes(condition, form)]


def _beside(approximation: Approximation, exact: Sequence[Mode]) -> Compared:
    name = approximation.name
    partner = next((mode for mode in exact if mode.name == name), None)
    if partner is not None and partner.oscillatory == bool(approximation.eigenvalue.imag):
        return Compared(approximation, partner, "")
    if partner is not None:
        return Compared(approximation, None, "its two real roots are an oscillation in truth")
    merged = next((m for m in exact if name in _ORIGIN.get(m.name, ())), None)
    if merged is not None:
        return Compared(approximation, None, f"merged into the {merged.name.replace('_', ' ')}")
    return Compared(approximation, None, "split into two real roots")


_ORIGIN = {name: families for families, name in MERGED.items()}


def mode_report(condition: FlightCondition, form: Form = "full", exact: Sequence[Mode] | None = None) -> dict[str, Any]:
    """The modes and all that goes with them, as JSON and the cockpit have it: `modes`, each with its
    `approximation`; `approximations`, also those that have no mode; `static`, the static figures.

    exact: the modes, where they are known already. Without nondimensional derivatives `approximations` and `static` are
    None, and `without_coefficients` says why.
    """
    found = modes(condition, form) if exact is None else exact
    known = condition.nondimensional
    compared = [c.as_dict() for c in compare(condition, form, found)] if known else []
    beside = {c["mode"]: c for c in compared if c["mode"]}
    return {
        "modes": [mode.as_dict() | {"approximation": beside.get(mode.name)} for mode in found],
        "approximations": compared if known else None,
        "static": asdict(static_figures(condition, condition.cg)) if known else None,
        "without_coefficients": None if known else WITHOUT_COEFFICIENTS,
    }


WITHOUT_COEFFICIENTS = (
    "The source gives dimensional derivatives. The approximations, static margin, n/alpha and steady roll rate are "
    "made of nondimensional ones, so there are none."
)


@dataclass(frozen=True)
class StaticFigures:
    """What balance and a steady pull-up or roll say of an aircraft, lengths in fractions of the mean chord.

    static_margin: -Cm_alpha / CL_alpha. maneuver_margin: with the damping of a pull-up. n_alpha: load factor per
    radian of angle of attack in a steady pull-up by elevator at constant speed [1/rad], as MIL-F-8785C means it
    (pages 76 and 77); n_alpha_lift: q S CL_alpha / (m g), without the lift of the elevator [1/rad].
    roll_rate: steady roll rate per radian of aileron [1/s], the same in deg/s per degree; None without roll
    damping. The points need the center of gravity, and are None without it.
    """

    static_margin: float
    neutral_point: float | None
    maneuver_margin: float
    maneuver_point: float | None
    n_alpha: float
    n_alpha_lift: float
    roll_rate: float | None


def static_figures(condition: FlightCondition, cg: float | None = None) -> StaticFigures:
    """Static margin and its relatives. `cg` in fractions of the mean chord places the points; None leaves them out.

    Nelson, chapters 2 and 5; Etkin and Reid, Dynamics of Flight, 3rd ed., chapter 3, for the maneuver margin: with the
    pitch rate of a pull-up, (n - 1) g/V, in both lift and moment.
    """
    k, ref = condition.coefficients, condition.reference
    static = -k.Cm_alpha / k.CL_alpha
    relative_mass = 2.0 * ref.m / (ref.rho * ref.S * ref.c)
    maneuver = static - k.Cm_q / (2.0 * relative_mass - k.CL_q)
    qS = 0.5 * ref.rho * ref.V * ref.V * ref.S
    return StaticFigures(
        static_margin=static,
        neutral_point=None if cg is None else cg + static,
        maneuver_margin=maneuver,
        maneuver_point=None if cg is None else cg + maneuver,
        n_alpha=n_alpha(linear_model(condition)),
        n_alpha_lift=qS * k.CL_alpha / (ref.m * ref.g),
        roll_rate=-k.Cl_da / k.Cl_p * 2.0 * ref.V / ref.b if k.Cl_p else None,
    )
