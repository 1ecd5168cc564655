"""What a command law takes from its aircraft: how much full stick commands, and where the elevator stops."""

from math import radians

from fdes.aircraft import FlightCondition
from fdes.analysis.linearize import linear_model
from fdes.physics.derivatives import Form

# Full stick commands the pitch rate that the bare aircraft has at full stick, up to this: near neutral stability that
# rate says nothing, for it grows without limit, and of an aircraft with no maneuver margin at all there is none.
# Assumed: half as much again as the quickest of the hangar that has a margin, 13 deg/s of the F-16 at Mach 0.53.
FASTEST = radians(20.0)  # rad/s


def command_settings(law: str, condition: FlightCondition, form: Form) -> dict[str, float]:
    """The settings of `law` that follow from the aircraft [rad/s, rad]; none for a law that commands nothing.

    The steady pitch rate is that of the short-period approximation: Nelson, 2nd ed., section 4.4.
    """
    if law != "pitch_rate_pi":
        return {}
    short = linear_model(condition, form).part(("w", "q"), ("elevator",))
    (z_w, z_q), (m_w, m_q) = short.A
    z_elevator, m_elevator = short.B[:, 0]
    moment = abs((z_w * m_elevator - m_w * z_elevator) * condition.full_stick.elevator)
    stiffness = abs(z_w * m_q - z_q * m_w)  # the square of the natural frequency: zero without maneuver margin
    rate = moment / stiffness if moment < FASTEST * stiffness else FASTEST
    limits = condition.limits
    return {"full_rate": float(rate), "lower": limits.lower.elevator, "upper": limits.upper.elevator}
