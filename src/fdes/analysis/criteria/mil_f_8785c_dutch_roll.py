"""Dutch roll: damping, with more of it where it rolls much, and frequency.

Reference: MIL-F-8785C, 1980, paragraph 3.3.1.1, table VI, page 22. Of the two damping requirements, on zeta and on
zeta omega_n, the one that gives the larger zeta governs; of Class III no more than 0.7 is required.
"""

from dataclasses import replace
from typing import NamedTuple

from fdes.aircraft.role import Role
from fdes.analysis.measured import Measured, frequency_in_words
from fdes.analysis.quality_charts import Boundary, Chart, ChartAxis, spaced
from fdes.analysis.verdict import Band, Criterion, Requirement, Verdict, asked, graded, worst

__all__ = ["DUTCH_ROLL"]

NAME = "mil_f_8785c_dutch_roll"
REFERENCE = "MIL-F-8785C, paragraph 3.3.1.1, table VI, page 22"
ROLLING = 20.0  # (rad/s)^2, omega^2 |phi/beta| above which more damping is asked
MORE = (0.014, 0.009, 0.005)  # s/rad, of zeta omega for each (rad/s)^2 above it, Levels 1 to 3
MOST = 0.7  # zeta, of Class III


class Row(NamedTuple):
    """One row of table VI: least zeta, least zeta omega_n [rad/s], least omega_n [rad/s]."""

    zeta: float
    product: float
    omega: float


def row(role: Role, level: int) -> Row:
    """That of table VI for `role`."""
    if level == 3:
        return Row(0.0, 0.0, 0.4)
    if level == 2:
        return Row(0.02, 0.05, 0.4)
    agile, large = role.airplane_class in {"I", "IV"}, role.airplane_class in {"II-L", "III"}
    if role.category == "A":
        if role.airplane_class == "IV" and role.phase in {"CO", "GA"}:
            return Row(0.4, 0.0, 1.0)
        return Row(0.19, 0.35, 1.0 if agile else 0.4)
    if role.category == "B":
        return Row(0.08, 0.15, 0.4)
    return Row(0.08, 0.10, 0.4) if large else Row(0.08, 0.15, 1.0)


def product(role: Role, level: int, omega: float, phi_beta: float | None) -> float:
    """The least zeta omega_n [rad/s], with what rolling adds."""
    rolling = 0.0 if phi_beta is None else omega * omega * phi_beta
    return row(role, level).product + MORE[level - 1] * max(0.0, rolling - ROLLING)


def least_damping(role: Role, level: int, omega: float, phi_beta: float | None) -> float:
    """The zeta that `level` asks at `omega` [rad/s]."""
    least = max(row(role, level).zeta, product(role, level, omega, phi_beta) / omega)
    return min(least, MOST) if role.airplane_class == "III" else least


def evaluate(m: Measured, role: Role) -> Verdict:
    """The worse of damping and frequency; what is not known is left out, and the reason says so."""
    frequency = _frequency(m, role)
    parts = [_damping(m, role), frequency]
    governing = worst(parts)
    if governing.level is None:
        return replace(governing, reason=m.missing.get("omega_dr", f"{parts[0].reason} {parts[1].reason}"))
    what = "Frequency" if governing.requirement == frequency.requirement else "Damping"
    others = [part.reason for part in parts if part.requirement != governing.requirement]
    return replace(governing, reason=" ".join([*_split(m), f"{what} governs: {governing.reason}", *others]))


def _split(m: Measured) -> list[str]:
    note = m.notes.get("dutch_roll")
    return [note] if note else []


def _damping(m: Measured, role: Role) -> Verdict:
    zeta, omega = m.zeta_dr, m.omega_dr
    phase = f", {role.phase}" if role.phase else ""
    whose = f"Category {role.category}, Class {role.airplane_class}{phase}"
    if zeta is None or omega is None or omega <= 0.0:
        bands: tuple[Band, ...] = tuple((row(role, level).zeta, None) for level in (1, 2, 3))
        absent = [name for name, value in (("zeta_dr", zeta), ("omega_dr", omega)) if value is None]
        without = " and ".join(absent) or "a frequency above zero"
        default = f"Without {without} the damping is not judged{_at_best(zeta, role)}."
        asks = Requirement(NAME, "dutch_roll", "1", f"{asked('zeta_dr', bands)} ({whose})", REFERENCE)
        return asks.not_applicable(m.missing.get("zeta_dr", default))
    bands = tuple((least_damping(role, level, omega, m.phi_beta), None) for level in (1, 2, 3))
    products = ", ".join(f"{product(role, level, omega, m.phi_beta):.3g}" for level in (1, 2, 3))
    rolling = omega * omega * (m.phi_beta or 0.0)
    more = f", raised for omega_dr^2 |phi/beta| = {rolling:.3g} > 20 (rad/s)^2" if rolling > ROLLING else ""
    asks = Requirement(
        criterion=NAME,
        mode="dutch_roll",
        unit="1",
        requirement=f"{asked('zeta_dr', bands)} at {omega:.3g} rad/s ({whose}; zeta omega_n at least {products}{more})",
        reference=REFERENCE,
    )
    unknown = "" if m.phi_beta is not None else "; |phi/beta| is not known, and what it may add is left out"
    return asks.graded(zeta, bands, f"zeta_dr is {zeta:.3g}, zeta omega_n {zeta * omega:.3g} rad/s{unknown}")


def _at_best(zeta: float | None, role: Role) -> str:
    """What a damping ratio can be whatever the frequency: a product of the two may ask more."""
    if zeta is None:
        return ""
    level = next((level for level in (1, 2, 3) if zeta >= row(role, level).zeta), None)
    return f"; zeta_dr {zeta:.3g} is {'worse than Level 3' if level is None else f'Level {level} at best'}"


def _frequency(m: Measured, role: Role) -> Verdict:
    bands: tuple[Band, ...] = tuple((row(role, level).omega, None) for level in (1, 2, 3))
    whose = f"Category {role.category}, Class {role.airplane_class}"
    exception = "; Class III may be excepted, with approval" if role.airplane_class == "III" else ""
    text = f"{asked('omega_dr', bands, 'rad/s')} ({whose}{exception})"
    asks = Requirement(NAME, "dutch_roll", "rad/s", text, REFERENCE)
    if m.omega_dr is None:
        return asks.not_applicable(m.missing.get("omega_dr", "Without omega_dr the frequency is not judged."))
    if m.omega_dr <= 0.0:
        level, margin = graded(m.omega_dr, bands)
        says = f"There is no omega_dr: {frequency_in_words('omega_dr', m.omega_dr)}."
        return replace(asks, unit="(rad/s)^2").found(level, margin, -m.omega_dr * m.omega_dr, says)
    return asks.graded(m.omega_dr, bands, f"omega_dr is {m.omega_dr:.3g} rad/s")


def charts(m: Measured, role: Role) -> list[Chart]:
    """Frequency against damping, with the boundaries at the aircraft's own |phi/beta|."""
    omega, zeta = m.omega_dr, m.zeta_dr
    known = omega is not None and zeta is not None and omega > 0.0
    top = max(5.0, 1.4 * (omega or 0.0))
    return [
        Chart(
            criterion=NAME,
            title=f"Dutch roll, Category {role.category}, Class {role.airplane_class}",
            reference="MIL-F-8785C, table VI, page 22",
            x=ChartAxis("zeta_dr", "1", min(-0.1, 1.2 * (zeta or 0.0)), max(0.8, 1.2 * (zeta or 0.0)), log=False),
            y=ChartAxis("omega_dr", "rad/s", 0.0, top, log=False),
            boundaries=tuple(_boundary(level, role, m.phi_beta, top) for level in (1, 2, 3)),
            point=(zeta, omega) if known and omega is not None and zeta is not None else None,
            level=evaluate(m, role).level,
        )
    ]


def _boundary(level: int, role: Role, phi_beta: float | None, top: float) -> Boundary:
    """Right along the least frequency, then up along the least damping."""
    up = spaced(row(role, level).omega, top)
    least = [least_damping(role, level, omega, phi_beta) for omega in up]
    right = max(0.8, least[0])
    return Boundary(level, f"Level {level}", (right, *least), (up[0], *up))


DUTCH_ROLL = Criterion(
    name=NAME,
    mode="dutch_roll",
    title="Dutch-roll damping and frequency",
    reads=("zeta_dr", "omega_dr", "phi_beta"),
    evaluate=evaluate,
    charts=charts,
)
