"""A verdict: which Level of flying qualities, by what margin, by which requirement; and how a number gets its Level.

Levels are those of MIL-F-8785C, section 1.5: 1 clearly adequate, 2 adequate with some increase in workload, 3
controllable but with excessive workload. 4 says worse than Level 3; None that the requirement does not apply.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fdes.aircraft.role import Role
    from fdes.analysis.measured import Measured
    from fdes.analysis.quality_charts import Chart

WORSE = 4  # than Level 3
Band = tuple[float | None, float | None]  # lower and upper limit of a Level, None where there is none
ANYTHING: Band = (None, None)


@dataclass(frozen=True)
class Verdict:
    """What one criterion says of one mode.

    level: 1, 2 or 3; 4 where it is worse than Level 3; None where the criterion does not apply, as `reason` says.
    value, unit: the quantity that governs. margin: (value - limit) / limit to the nearest edge of the Level attained,
    positive inside and (limit - value) / limit at an upper edge; below Level 3 it is that to the Level 3 edge missed,
    and negative. Where the limit is zero, the limit of the next better Level divides.
    requirement: what is asked, with its numbers. reference: paragraph, table or figure, page.
    parts: the verdicts on each quantity, where the criterion looks at several; this one is the worst of them.
    """

    criterion: str
    mode: str
    level: int | None
    margin: float | None
    value: float | None
    unit: str
    requirement: str
    reference: str
    reason: str
    parts: "tuple[Verdict, ...]" = field(default=(), repr=False)

    def as_dict(self) -> dict[str, Any]:
        """The verdict as JSON has it."""
        return {
            "criterion": self.criterion,
            "mode": self.mode,
            "level": self.level,
            "margin": self.margin,
            "value": self.value,
            "unit": self.unit,
            "requirement": self.requirement,
            "reference": self.reference,
            "reason": self.reason,
        }

    def __str__(self) -> str:
        margin = "" if self.margin is None else f", margin {self.margin:+.0%}"
        return f"{self.mode.replace('_', ' ')}: {level_name(self.level)}{margin}. {self.reason} [{self.reference}]"


@dataclass(frozen=True)
class Requirement:
    """One requirement on one quantity, from which verdicts are made; the fields are those of `Verdict`."""

    criterion: str
    mode: str
    unit: str
    requirement: str
    reference: str

    def graded(self, value: float, bands: "Sequence[Band]", says: str) -> Verdict:
        """The verdict on `value` by the bands of Levels 1, 2, 3; `says` what the value is, without a full stop."""
        level, margin = graded(value, bands)
        return self.found(level, margin, value, f"{says}: {level_name(level)}.")

    def found(self, level: int, margin: float, value: float, reason: str) -> Verdict:
        """A verdict that was reached in another way."""
        return Verdict(level=level, margin=margin, value=value, reason=reason, **vars(self))

    def not_applicable(self, reason: str) -> Verdict:
        """A verdict that is none."""
        return Verdict(level=None, margin=None, value=None, reason=reason, **vars(self))


def _no_charts(_measured: "Measured", _role: "Role") -> "list[Chart]":
    return []


@dataclass(frozen=True)
class Criterion:
    """A part of the shelf `criteria`.

    reads: the fields of `Measured` it looks at. evaluate: its verdict on them. charts: its figures, with the point in.
    """

    name: str
    mode: str
    title: str
    reads: tuple[str, ...]
    evaluate: "Callable[[Measured, Role], Verdict]"
    charts: "Callable[[Measured, Role], list[Chart]]" = _no_charts


def level_name(level: int | None) -> str:
    """A Level in words."""
    return "not applicable" if level is None else "worse than Level 3" if level == WORSE else f"Level {level}"


def graded(value: float, bands: Sequence[Band]) -> tuple[int, float]:
    """The Level of `value` and its margin, from the bands of Levels 1, 2, 3. Limits themselves are inside."""
    for number, band in enumerate(bands, start=1):
        low, high = band
        if (low is None or value >= low) and (high is None or value <= high):
            return number, _margin(value, bands, number)
    return WORSE, _margin(value, bands, len(bands))


def _margin(value: float, bands: Sequence[Band], number: int) -> float:
    """To the nearest edge of the band of Level `number`; 1 where it has no edge at all."""
    low, high = bands[number - 1]
    edges = []
    if low is not None:
        edges.append((value - low) / _scale(bands, number, 0))
    if high is not None:
        edges.append((high - value) / _scale(bands, number, 1))
    return min(edges, default=1.0)


def _scale(bands: Sequence[Band], number: int, side: int) -> float:
    """What a margin is a fraction of: the limit, or where it is zero that of the next better Level, or else 1."""
    limits = (bands[k][side] for k in range(number - 1, -1, -1))
    return next((abs(limit) for limit in limits if limit), 1.0)


def asked(symbol: str, bands: Sequence[Band], unit: str = "") -> str:
    """The bands as a sentence: ``zeta_ph: Level 1 at least 0.04, Level 2 at least 0``."""
    said = [f"Level {k} {_band(band)}" for k, band in enumerate(bands, start=1)]
    return f"{symbol}{f' [{unit}]' if unit not in {'', '1'} else ''}: {', '.join(said)}"


def _band(band: Band) -> str:
    low, high = band
    if low is not None and high is not None:
        return f"{low:.4g} to {high:.4g}"
    if low is not None:
        return f"at least {low:.4g}"
    return "any" if high is None else f"at most {high:.4g}"


def worst(parts: Sequence[Verdict]) -> Verdict:
    """The part that governs, the others with it: the worst Level, and among equals the smallest margin."""
    judged = [part for part in parts if part.level is not None]
    if not judged:
        return parts[0]
    governing = max(judged, key=lambda part: (part.level or 0, -(part.margin if part.margin is not None else math.inf)))
    return replace(governing, parts=tuple(parts)) if len(parts) > 1 else governing
