"""What commands say of a control law: its gains, and what was wanted beside what is had and what is flown."""

from typing import TYPE_CHECKING

from fdes.cli.output import note, number, screen, table

if TYPE_CHECKING:
    from fdes.analysis.designed import Designed

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
    for sentence in designed.notes:
        note(sentence)
