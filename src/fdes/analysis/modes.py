"""Natural modes: eigenvalues, named by which states take part in them, and what follows from them.

How a root gets its name is told in `mode_names`.
"""

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.linearize import linear_model
from fdes.analysis.mode_names import Axis, NamedRoot, named_roots
from fdes.control import LinearModel
from fdes.physics.derivatives import Form


@dataclass(frozen=True)
class Mode:
    """One natural mode. A complex pair is one mode, given by its eigenvalue with positive imaginary part [rad/s].

    omega_n [rad/s]; zeta, for a real root 1 (stable), 0 (neutral) or -1 (unstable); times [s], None where they do not
    apply.
    participation: share of each state in the mode, adding up to 1.
    """

    name: str
    axis: Axis
    eigenvalue: complex
    omega_n: float
    zeta: float
    time_constant: float | None
    time_to_half: float | None
    time_to_double: float | None
    period: float | None
    participation: dict[str, float]

    @property
    def oscillatory(self) -> bool:
        """Whether the mode is a complex pair."""
        return self.eigenvalue.imag > 0.0

    @property
    def cycles_to_half(self) -> float | None:
        """How many periods until half the amplitude is left; None where it does not swing or does not decay."""
        return self.time_to_half / self.period if self.time_to_half and self.period else None

    @property
    def cycles_to_double(self) -> float | None:
        """How many periods until the amplitude has doubled; None where it does not swing or does not grow."""
        return self.time_to_double / self.period if self.time_to_double and self.period else None

    def as_dict(self) -> dict[str, Any]:
        """The mode as JSON has it: the eigenvalue is ``[real, imaginary]``."""
        return asdict(self) | {
            "eigenvalue": [self.eigenvalue.real, self.eigenvalue.imag],
            "cycles_to_half": self.cycles_to_half,
            "cycles_to_double": self.cycles_to_double,
        }

    def _repr_html_(self) -> str:
        """The mode as a table, for notebooks."""
        value = f"{self.eigenvalue.real:.4g}" + (f" \u00b1 {self.eigenvalue.imag:.4g}i" if self.oscillatory else "")
        rows = [
            ("eigenvalue", value, "rad/s"),
            ("omega_n", f"{self.omega_n:.4g}", "rad/s"),
            ("zeta", f"{self.zeta:.4g}", ""),
        ]
        for name in ("time_constant", "time_to_half", "time_to_double", "period"):
            seconds = getattr(self, name)
            rows += [] if seconds is None else [(name, f"{seconds:.4g}", "s")]
        for name in ("cycles_to_half", "cycles_to_double"):
            cycles = getattr(self, name)
            rows += [] if cycles is None else [(name, f"{cycles:.3g}", "")]
        share = ", ".join(f"{state} {part:.0%}" for state, part in self.participation.items())
        body = "".join(f"<tr><th>{name}</th><td>{value} {unit}</td></tr>" for name, value, unit in rows)
        caption = f"{self.name.replace('_', ' ')}, {self.axis}: {share}"
        return f"<table><caption>{caption}</caption>{body}</table>"


# The columns of a table of modes: head, unit, and how a mode fills it.
COLUMNS: tuple[tuple[str, str, Callable[[Mode], str]], ...] = (
    ("mode", "", lambda m: m.name.replace("_", " ")),
    ("eigenvalue", "rad/s", lambda m: f"{m.eigenvalue.real:.4g}" + f" \u00b1 {m.eigenvalue.imag:.4g}i" * m.oscillatory),
    ("omega_n", "rad/s", lambda m: _or_nothing(m.omega_n)),
    ("zeta", "", lambda m: _or_nothing(m.zeta)),
    ("time constant", "s", lambda m: _or_nothing(m.time_constant)),
    ("to half", "s", lambda m: _or_nothing(m.time_to_half)),
    ("to double", "s", lambda m: _or_nothing(m.time_to_double)),
    ("period", "s", lambda m: _or_nothing(m.period)),
    ("cycles to half", "", lambda m: _or_nothing(m.cycles_to_half)),
)


def _or_nothing(value: float | None) -> str:
    return "" if value is None else f"{value:#.3g}".rstrip(".")


class ModeList(list[Mode]):
    """Modes, shown as a table. Everything else about it is a list."""

    def __repr__(self) -> str:
        """The table in plain text; columns that no mode fills are left out."""
        rows = self._rows()
        wide = [max(map(len, column)) for column in zip(*rows, strict=True)]
        return "\n".join(
            "  ".join(
                cell.rjust(n) if k else cell.ljust(n) for k, (cell, n) in enumerate(zip(row, wide, strict=True))
            ).rstrip()
            for row in rows
        )

    def _repr_html_(self) -> str:
        """The table for notebooks."""
        head, *body = ("".join(f"<t{{0}}>{cell}</t{{0}}>" for cell in row) for row in self._rows())
        rows = "".join(f"<tr>{row.format('d')}</tr>" for row in body)
        return f"<table><thead><tr>{head.format('h')}</tr></thead><tbody>{rows}</tbody></table>"

    def _rows(self) -> list[list[str]]:
        filled = [(head, unit, fill) for head, unit, fill in COLUMNS if any(map(fill, self)) or head == "mode"]
        heads = [f"{head} [{unit}]" if unit else head for head, unit, _ in filled]
        return [heads, *[[fill(mode) for _, _, fill in filled] for mode in self]]


def modes(of: LinearModel | FlightCondition, form: Form = "full") -> ModeList:
    """The modes of a linear model, or of an aircraft in a flight condition in the given form of its equations.

    Longitudinal modes come first; within an axis the fastest first. Heading, position and height are integrals of the
    states and no modes. What a law, an actuator or a sensor remembers adds modes, named after it. The roots z of a
    sampled model are shown as ln(z) / dt.
    """
    model = of if isinstance(of, LinearModel) else linear_model(of, form)
    return ModeList(_mode(named) for named in named_roots(model))


def _mode(named: NamedRoot) -> Mode:
    name, axis, (value, shares, _) = named
    sigma, omega = value.real, value.imag
    omega_n = abs(value)
    of_a_real_root = float(np.sign(-sigma))
    return Mode(
        name=name,
        axis=axis,
        eigenvalue=value,
        omega_n=omega_n,
        zeta=-sigma / omega_n if omega > 0.0 else of_a_real_root,
        time_constant=-1.0 / sigma if sigma < 0.0 else None,
        time_to_half=-math.log(2.0) / sigma if sigma < 0.0 else None,
        time_to_double=math.log(2.0) / sigma if sigma > 0.0 else None,
        period=2.0 * math.pi / omega if omega > 0.0 else None,
        participation=shares,
    )
