"""Short period: damping (table IV), and frequency against n/alpha (figures 1 to 3), of which the worse one counts.

Reference: MIL-F-8785C, 1980, paragraphs 3.2.2.1.1 and 3.2.2.1.2, pages 13 to 16. The lines of the figures are lines of
constant CAP = omega_sp^2 / (n/alpha); the values printed at them are used. The limits of omega_sp alone and of n/alpha
alone are read off the figures' grid, to some 2 %.
"""

import math
from dataclasses import replace
from typing import NamedTuple

from fdes.aircraft.role import AirplaneClass, Category, Role
from fdes.analysis.measured import Measured, frequency_in_words
from fdes.analysis.quality_charts import Boundary, Chart, ChartAxis, spaced
from fdes.analysis.verdict import Band, Criterion, Requirement, Verdict, asked, worst

__all__ = ["SHORT_PERIOD"]

NAME = "mil_f_8785c_short_period"
PRECISE: tuple[Band, ...] = ((0.35, 1.30), (0.25, 2.00), (0.15, None))  # table IV, Categories A and C
GRADUAL: tuple[Band, ...] = ((0.30, 2.00), (0.20, 2.00), (0.15, None))  # table IV, Category B
CAP: dict[Category, tuple[Band, ...]] = {
    "A": ((0.28, 3.6), (0.16, 10.0), (0.16, None)),
    "B": ((0.085, 3.6), (0.038, 10.0), (0.038, None)),
    "C": ((0.16, 3.6), (0.096, 10.0), (0.096, None)),
}
FIGURE: dict[Category, str] = {"A": "figure 1, page 14", "B": "figure 2, page 15", "C": "figure 3, page 16"}
FREE: tuple[Band, ...] = ((None, None), (None, None), (None, None))
LARGE: tuple[AirplaneClass, ...] = ("II-L", "III")


class Floors(NamedTuple):
    """The limits of omega_sp [rad/s] and of n/alpha [1/rad] that the figures draw beside the lines of CAP."""

    omega: tuple[Band, ...]
    n_alpha: tuple[Band, ...]


def floors(role: Role) -> Floors:
    """Those of the figure for `role`."""
    if role.category == "A":
        return Floors(((1.0, None), (0.6, None), (None, None)), FREE)
    if role.category == "B":
        return Floors(FREE, FREE)
    if role.airplane_class in LARGE:
        return Floors(((0.7, None), (0.4, None), (None, None)), ((2.0, None), (1.0, None), (None, None)))
    return Floors(((0.87, None), (0.6, None), (0.6, None)), ((2.7, None), (1.7, None), (None, None)))


def damping(role: Role) -> tuple[Band, ...]:
    """Table IV for `role`."""
    return GRADUAL if role.category == "B" else PRECISE


def control_anticipation(omega: float, n_alpha: float) -> float:
    """CAP = omega^2 / (n/alpha), with the sign of omega."""
    return omega * abs(omega) / n_alpha


def evaluate(m: Measured, role: Role) -> Verdict:
    """The worse of damping and frequency; what is not known is left out, and the reason says so."""
    parts = [_damping(m, role), *_frequency(m, role)]
    governing = worst(parts)
    if governing.level is None:
        return replace(governing, reason=m.missing.get("omega_sp", parts[0].reason + " " + parts[1].reason))
    what = "Damping" if governing.requirement == parts[0].requirement else "Frequency"
    others = [part.reason for part in parts if part.requirement != governing.requirement]
    split = m.notes.get("short_period", "")
    return replace(governing, reason=" ".join(filter(None, (split, f"{what} governs: {governing.reason}", *others))))


def _damping(m: Measured, role: Role) -> Verdict:
    bands = damping(role)
    whose = f"(Category {role.category}; above 20,000 ft Level 3 may ask less, if approved)"
    asks = Requirement(
        criterion=NAME,
        mode="short_period",
        unit="1",
        requirement=f"{asked('zeta_sp', bands)} {whose}",
        reference="MIL-F-8785C, paragraph 3.2.2.1.2, table IV, page 13",
    )
    if m.zeta_sp is None:
        return asks.not_applicable(m.missing.get("zeta_sp", "Without zeta_sp the damping is not judged."))
    return asks.graded(m.zeta_sp, bands, f"zeta_sp is {m.zeta_sp:.3g}")


def _frequency(m: Measured, role: Role) -> list[Verdict]:
    """CAP, and where the figure draws them the least omega_sp and n/alpha."""
    omega, n_alpha = m.omega_sp, m.n_alpha
    limits = CAP[role.category]
    whose = f" (Category {role.category}, Class {role.airplane_class})"
    asks = Requirement(
        criterion=NAME,
        mode="short_period",
        unit="1/(g s^2)",
        requirement=asked("CAP", limits, "1/(g s^2)") + whose,
        reference=f"MIL-F-8785C, paragraph 3.2.2.1.1, {FIGURE[role.category]}",
    )
    if omega is None or n_alpha is None:
        absent = [name for name, value in (("omega_sp", omega), ("n_alpha", n_alpha)) if value is None]
        default = f"Without {' and '.join(absent)} the frequency is not judged."
        return [asks.not_applicable(m.missing.get(absent[0], default))]
    if n_alpha <= 0.0:
        return [asks.not_applicable(f"n/alpha is {n_alpha:.3g} g/rad: figures 1 to 3 begin above zero.")]
    cap = control_anticipation(omega, n_alpha)
    source = f"{frequency_in_words('omega_sp', omega)} and n/alpha {n_alpha:.3g} g/rad"
    parts = [asks.graded(cap, limits, f"CAP is {cap:#.3g} 1/(g s^2), from {source}")]
    for symbol, value, unit, bands in (
        ("omega_sp", omega, "rad/s", floors(role).omega),
        ("n/alpha", n_alpha, "g/rad", floors(role).n_alpha),
    ):
        if bands != FREE and (symbol != "omega_sp" or omega > 0.0):  # else CAP has said it
            beside = replace(asks, unit=unit, requirement=asked(symbol, bands, unit) + whose)
            parts.append(beside.graded(value, bands, f"{symbol} is {value:.3g} {unit}"))
    return parts


def charts(m: Measured, role: Role) -> list[Chart]:
    """The figure of the specification, and CAP against damping."""
    verdict = evaluate(m, role)
    known = m.omega_sp is not None and m.omega_sp > 0.0 and m.n_alpha is not None and m.n_alpha > 0.0
    omega, n_alpha = (m.omega_sp or 1.0, m.n_alpha or 1.0) if known else (1.0, 1.0)
    cap = control_anticipation(omega, n_alpha)
    zeta = m.zeta_sp if known and m.zeta_sp is not None and m.zeta_sp > 0.0 else None
    x, y = _axis("n/alpha", "g/rad", 1.0, 100.0, n_alpha), _axis("omega_sp", "rad/s", 0.1, 20.0, omega)
    figure = Chart(
        criterion=NAME,
        title=f"Short-period frequency, Category {role.category}",
        reference=f"MIL-F-8785C, {FIGURE[role.category]}",
        x=x,
        y=y,
        boundaries=tuple(line for level in (1, 2, 3) for line in _lines(level, role, x, y)),
        point=(n_alpha, omega) if known else None,
        level=verdict.level,
    )
    x, y = _axis("zeta_sp", "1", 0.05, 5.0, zeta or 1.0), _axis("CAP", "1/(g s^2)", 0.01, 20.0, cap)
    plane = Chart(
        criterion=NAME,
        title=f"Short-period damping and CAP, Category {role.category}",
        reference=f"MIL-F-8785C, table IV, page 13, and {FIGURE[role.category]}",
        x=x,
        y=y,
        boundaries=tuple(_box(level, role, x, y) for level in (1, 2, 3)),
        point=None if zeta is None else (zeta, cap),
        level=verdict.level,
    )
    return [figure, plane]


def _axis(label: str, unit: str, low: float, high: float, value: float) -> ChartAxis:
    """The axis of the figure, longer where the point would not be on it."""
    return ChartAxis(label, unit, min(low, value / 1.5), max(high, 1.5 * value), log=True)


def _lines(level: int, role: Role, x: ChartAxis, y: ChartAxis) -> list[Boundary]:
    """The boundary of a Level in the figure: the lower line with the limits beside it, and the upper one."""
    low, high = CAP[role.category][level - 1]
    floor, left = floors(role).omega[level - 1][0] or 0.0, floors(role).n_alpha[level - 1][0]
    along = spaced(left or x.low, x.high)
    top = math.sqrt(high * along[0]) if high else y.high
    lower = tuple(max(floor, math.sqrt((low or 0.0) * n)) for n in along)
    wall = ((along[0],), (top,)) if left else ((), ())
    lines = [Boundary(level, f"Level {level}, lower", (*wall[0], *along), (*wall[1], *lower))]
    if high:
        lines.append(Boundary(level, f"Level {level}, upper", along, tuple(math.sqrt(high * n) for n in along)))
    return lines


def _box(level: int, role: Role, x: ChartAxis, y: ChartAxis) -> Boundary:
    """What a Level allows, open to where it has no limit."""
    (left, right), (low, high) = damping(role)[level - 1], CAP[role.category][level - 1]
    x0, x1, y0, y1 = left or x.low, right or x.high, low or y.low, high or y.high
    if right is None and high is None:
        return Boundary(level, f"Level {level}", (x0, x0, x1), (y1, y0, y0))
    return Boundary(level, f"Level {level}", (x0, x1, x1, x0, x0), (y0, y0, y1, y1, y0))


SHORT_PERIOD = Criterion(
    name=NAME,
    mode="short_period",
    title="Short-period damping and frequency",
    reads=("zeta_sp", "omega_sp", "n_alpha"),
    evaluate=evaluate,
    charts=charts,
)
