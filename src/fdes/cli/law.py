"""What commands say of a control law: its gains, and what was wanted beside what is had and what is flown."""

from math import degrees, isfinite
from typing import TYPE_CHECKING

from fdes.cli.output import note, number, screen, table

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from fdes.analysis.designed import Designed
    from fdes.analysis.margins import Margins

DIGITS = 4


def show_law(designed: "Designed") -> None:
    """Print the law with its gains, a table of what it was designed for, and what should be known of it."""
    show = screen()
    for name, gains in designed.gains.items():
        settings = ", ".join(f"{field} {number(value, DIGITS)}" for field, value in gains.items() if abs(value) < 1e9)
        show.print(f"{name}: {settings or 'no gains'}", soft_wrap=True)
    if designed.achieved:
        rate = f"{1.0 / designed.frame:.4g} Hz"
        drawn = table("law", "of the mode", "wanted", "before", "designed", "in s", f"at {rate}")
        drawn.columns[1].justify = "left"
        for a in designed.achieved:
            unit = "" if a.unit == "1" else f" [{a.unit}]"
            values = (a.wanted, a.before, a.designed, a.continuous, a.flown)
            said = [number(v, DIGITS) if v is None or abs(v) < 1e9 else "none" for v in values]
            drawn.add_row(a.law, f"{a.mode.replace('_', ' ')}, {a.quantity.replace('_', ' ')}{unit}", *said)
        show.print(drawn)
    show_notes(designed)


def show_notes(designed: "Designed | None") -> None:
    """Say what should be known of a law; nothing of none."""
    for sentence in designed.notes if designed else ():
        note(sentence)


def show_margins(found: "Mapping[str, Sequence[Margins]]") -> None:
    """Print the margins at each surface, and what sensors, actuators and the frame each take of them."""
    from fdes.analysis.margins import decibels

    by_surface: dict[str, list[tuple[str, Margins]]] = {}
    for step, margins in found.items():
        for m in margins:
            by_surface.setdefault(m.surface, []).append((step, m))
    if not by_surface:
        return
    title = "Margins, the loop broken at one surface: how far to where it grows"
    drawn = table(
        "loop at",
        "with",
        "less gain\n[dB]",
        "more gain\n[dB]",
        "at\n[rad/s]",
        "phase\n[deg]",
        "at\n[rad/s]",
        "delay\n[ms]",
        title=title,
    )
    drawn.padding = 0  # eight columns in 80 characters
    drawn.columns[1].justify = "left"
    for surface, rows in by_surface.items():
        for step, m in rows:
            drawn.add_row(
                surface if step == rows[0][0] else "",
                step if m.stable else f"{step}, grows",
                _or_none(decibels(m.gain_reduction)),
                _or_none(decibels(m.gain_margin)),
                number(m.phase_crossover, 3) if m.phase_crossover is not None else "",
                _or_none(degrees(m.phase_margin)),
                number(m.gain_crossover, 3) if m.gain_crossover is not None else "",
                _or_none(1000.0 * m.delay_margin),
                style=None if m.stable else "red",
            )
    screen().print(drawn)


def _or_none(value: float | None) -> str:
    return number(value, 3) if value is not None and isfinite(value) else "no end"
