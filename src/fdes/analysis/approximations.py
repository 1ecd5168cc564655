"""The textbook's approximations to the natural modes, and the static figures that go with them.

Each is what a student derives on paper from a few derivatives; beside the exact eigenvalue it shows what was neglected.

Reference: R. C. Nelson, Flight Stability and Automatic Control, 2nd ed., McGraw-Hill 1998, chapters 4 and 5.
"""

import cmath
from dataclasses import dataclass

from fdes.aircraft import FlightCondition
from fdes.physics.derivatives import Dimensional, Form, Reference, dimensional


@dataclass(frozen=True)
class Approximation:
    """One approximate mode: its eigenvalue [rad/s], the upper one of a pair, and the equation it is from."""

    name: str
    eigenvalue: complex
    reference: str


def approximate_modes(condition: FlightCondition, form: Form = "nelson") -> list[Approximation]:
    """Nelson's approximations to the five classical modes. Those whose formula has no meaning here are left out."""
    d, ref = dimensional(condition.coefficients, condition.reference, form), condition.reference
    found = [_short_period(d, ref), _phugoid(d, ref), _roll(d), _dutch_roll(d, ref)]
    if d.L_beta != 0.0:
        found.append(_spiral(d))
    return found


def _short_period(d: Dimensional, ref: Reference) -> Approximation:
    """Constant speed: the phugoid is taken out."""
    stiffness = d.Z_w * d.M_q - d.M_w * ref.V
    damping = -(d.M_q + d.M_wdot * ref.V + d.Z_w)
    return Approximation("short_period", _upper_root(stiffness, damping), "Nelson, section 4.5")


def _phugoid(d: Dimensional, ref: Reference) -> Approximation:
    """Constant angle of attack: energy goes to and fro between height and speed."""
    return Approximation("phugoid", _upper_root(-d.Z_u * ref.g / ref.V, -d.X_u), "Nelson, section 4.5")


def _roll(d: Dimensional) -> Approximation:
    """Rolling alone."""
    return Approximation("roll", complex(d.L_p), "Nelson, section 5.3")


def _spiral(d: Dimensional) -> Approximation:
    """Sideslip and yaw in balance."""
    return Approximation("spiral", complex((d.L_beta * d.N_r - d.N_beta * d.L_r) / d.L_beta), "Nelson, section 5.3")


def _dutch_roll(d: Dimensional, ref: Reference) -> Approximation:
    """Sideslip and yaw alone, wings level."""
    V = ref.V
    stiffness = (d.Y_beta * d.N_r - d.N_beta * d.Y_r + V * d.N_beta) / V
    damping = -(d.Y_beta + V * d.N_r) / V
    return Approximation("dutch_roll", _upper_root(stiffness, damping), "Nelson, section 5.3")


def _upper_root(stiffness: float, damping: float) -> complex:
    """The root of s^2 + damping s + stiffness with the larger imaginary part; of two real roots the slower."""
    root = cmath.sqrt(damping * damping / 4.0 - stiffness)
    return -damping / 2.0 + (root if root.imag > 0.0 or damping > 0.0 else -root)


@dataclass(frozen=True)
class StaticFigures:
    """What balance and a steady pull-up or roll say of an aircraft, lengths in fractions of the mean chord.

    static_margin: -Cm_alpha / CL_alpha. maneuver_margin: with the damping of a pull-up. n_alpha: load factor per
    radian of angle of attack [1/rad]. roll_rate: steady roll rate per radian of aileron [1/s].
    """

    static_margin: float
    neutral_point: float | None
    maneuver_margin: float
    maneuver_point: float | None
    n_alpha: float
    roll_rate: float


def static_figures(condition: FlightCondition, cg: float | None = None) -> StaticFigures:
    """Static margin and its relatives. `cg` in fractions of the mean chord places the points; None leaves them out.

    Nelson, sections 2.3 and 3.4; Etkin and Reid, Dynamics of Flight, 3rd ed., eq. 3.1,8 for the maneuver margin.
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
        n_alpha=qS * k.CL_alpha / (ref.m * ref.g),
        roll_rate=-k.Cl_da / k.Cl_p * 2.0 * ref.V / ref.b if k.Cl_p else float("inf"),
    )
