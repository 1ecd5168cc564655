"""What a pitot-static system says: Mach number, impact pressure, calibrated and equivalent airspeed.

Reference: R. P. G. Collinson, Introduction to Avionics Systems, 3rd ed., ch. 7; the supersonic pitot equation is
Rayleigh's (NACA Report 1135, eq. 100).
"""

from fdes.elementary import pow, sqrt
from fdes.physics.atmosphere import A0, P0, RHO0
from fdes.units import KilogramPerMeter3, MeterPerSecond, Number, Pascal


def impact_pressure(mach: Number, p: Pascal) -> Pascal:
    """Pitot minus static pressure of air with a specific-heat ratio of 1.4, behind a normal shock above Mach 1."""
    if mach.real <= 1.0:
        ratio: float = pow(1.0 + 0.2 * mach * mach, 3.5)
    else:
        ratio = 166.921580 * pow(mach, 7.0) / pow(7.0 * mach * mach - 1.0, 2.5)  # NACA 1135 eq. 100
    return p * (ratio - 1.0)


def calibrated_airspeed(q_c: Pascal) -> MeterPerSecond:
    """The speed that would give impact pressure `q_c` at sea level on a standard day."""
    cas: float = A0 * sqrt(5.0 * (pow(q_c / P0 + 1.0, 2.0 / 7.0) - 1.0))
    if cas.real <= A0:
        return cas
    # Above the speed of sound Rayleigh's equation has no inverse in closed form, and this fixed point contracts.
    for _ in range(60):
        m = cas / A0
        nearer: float = A0 * 0.881285 * sqrt((q_c / P0 + 1.0) * pow(1.0 - 1.0 / (7.0 * m * m), 2.5))
        if abs(nearer - cas) < 1e-9 * A0:
            return nearer
        cas = nearer
    return cas


def equivalent_airspeed(V: MeterPerSecond, rho: KilogramPerMeter3) -> MeterPerSecond:
    """The speed that would give the same dynamic pressure in sea-level air."""
    eas: float = V * sqrt(rho / RHO0)
    return eas
