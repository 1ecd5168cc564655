"""What FDES draws: modes in the s-plane, and the response of an aircraft over time."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from fdes.analysis.drawing import COLORS, GRID, LINES, Curve, Drawing, Note, Panel
from fdes.analysis.modes import Mode
from fdes.flight import Recording
from fdes.units import UNIT_SYSTEMS

# The s-plane.
SLOW = 0.12  # share of the fastest mode's frequency below which a mode goes into the magnified plane
DAMPING = (0.2, 0.4, 0.6, 0.8)
AXIS_COLOR = {"longitudinal": COLORS[0], "lateral": COLORS[1]}
QUIET = "#5a6772"
PANE = 4.6  # inches, side of a plane
POINTS = 72.0  # per inch

# A response: signals that are looked at together, from the input to what comes of it.
GROUPS = (
    ("elevator", "aileron", "rudder"),
    ("throttle",),
    ("gust_u", "gust_v", "gust_w"),
    ("p", "q", "r"),
    ("alpha", "beta"),
    ("theta", "gamma"),
    ("phi", "psi"),
    ("V",),
    ("n_z", "n_y"),
    ("h",),
)
MOST_POINTS = 4000  # of a curve: more than any screen is wide


def s_plane(modes: Sequence[Mode], title: str) -> Drawing:
    """The modes [rad/s] with lines of constant damping ratio and frequency; slow ones again, magnified."""
    fastest = max(mode.omega_n for mode in modes)
    slow = [mode for mode in modes if mode.omega_n < SLOW * fastest]
    magnified = 0 < len(slow) < len(modes)
    fast = [mode for mode in modes if mode not in slow] if magnified else list(modes)
    panels = [_plane(fast, modes, "all modes" if magnified else "", legend=True)]
    if magnified:
        panels.append(_plane(slow, slow, "near the origin", legend=False))
    return Drawing(title, tuple(panels), stacked=False, width=(PANE + 0.6) * len(panels), height=PANE + 1.3)


def _plane(named: Sequence[Mode], all_of_them: Sequence[Mode], title: str, *, legend: bool) -> Panel:
    reach = max(mode.omega_n for mode in named)
    left = 1.25 * min(*(m.eigenvalue.real for m in named), -0.25 * reach)
    right = max(1.4 * max(m.eigenvalue.real for m in named), -0.28 * left)
    top = 1.18 * max(*(m.eigenvalue.imag for m in named), 0.3 * reach)
    side = max(right - left, 2.0 * top)  # a square, so that a circle of frequency is a circle
    left -= 0.75 * (side - (right - left))
    right = left + side
    top = side / 2.0
    curves = [
        Curve((left, right), (0.0, 0.0), color=QUIET, width=0.8),
        Curve((0.0, 0.0), (-top, top), color=QUIET, width=0.8),
    ]
    notes = []
    for omega in _round_steps(side / 5.0, math.hypot(left, top)):
        angle = [math.pi * k / 90.0 for k in range(181)]
        curves.append(
            Curve([omega * math.cos(a) for a in angle], [omega * math.sin(a) for a in angle], color=GRID, width=0.7)
        )
        if omega < 0.97 * top:
            notes.append(Note(0.0, -omega, f"{omega:g}", dx=3.0, dy=4.0, color=QUIET, size=7.5))
    for zeta in DAMPING:
        x, y = -zeta, math.sqrt(1.0 - zeta * zeta)
        length = min(left / x, top / y)
        ray = [(length * x, up * length * y) for up in (1.0, -1.0)]
        curves += [Curve((0.0, to_x), (0.0, to_y), color=GRID, line="dot", width=1.0) for to_x, to_y in ray]
        notes.append(Note(0.96 * length * x, -0.96 * length * y, f"ζ {zeta:g}", dx=3.0, dy=3.0, color=QUIET, size=7.5))
    for axis, color in AXIS_COLOR.items():
        roots = [r for m in all_of_them if m.axis == axis for r in {m.eigenvalue, m.eigenvalue.conjugate()}]
        label = axis if legend else ""
        if roots:
            curves.append(Curve([r.real for r in roots], [r.imag for r in roots], label, color, line="none"))
    notes += _names(named, all_of_them, POINTS * PANE / side)
    return Panel(
        "real part [rad/s]",
        "imaginary part [rad/s]",
        tuple(curves),
        tuple(notes),
        (left, right),
        (-top, top),
        title,
        equal=True,
    )


def _names(named: Sequence[Mode], all_of_them: Sequence[Mode], scale: float) -> list[Note]:
    """A name at each upper root, where it touches neither a cross nor another name; `scale` is points per rad/s."""
    crosses = [(m.eigenvalue.real * scale, m.eigenvalue.imag * scale) for m in all_of_them]
    taken = [(x - 6.0, x + 6.0, y - 6.0, y + 6.0) for x, y in crosses]
    notes = []
    for mode in sorted(named, key=lambda m: -m.omega_n):
        x, y = mode.eigenvalue.real * scale, mode.eigenvalue.imag * scale
        words = mode.name.replace("_", " ")
        half = 2.6 * len(words)
        places = [(-half - 9.0, 0.0), (half + 9.0, 0.0)] if y else []
        places += [(dx * half, dy) for dy in (13.0, 25.0, -13.0, -25.0, 37.0, -37.0) for dx in (0.0, -0.9, 0.9)]
        boxes = [(x + dx - half, x + dx + half, y + dy - 5.0, y + dy + 5.0) for dx, dy in places]
        free = [k for k, box in enumerate(boxes) if not any(_touch(box, other) for other in taken)]
        best = free[0] if free else 0
        taken.append(boxes[best])
        dx, dy = places[best]
        color = AXIS_COLOR[mode.axis]
        notes.append(Note(mode.eigenvalue.real, mode.eigenvalue.imag, words, dx, dy, "center", color))
    return notes


def _touch(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    return one[0] < other[1] and other[0] < one[1] and one[2] < other[3] and other[2] < one[3]


def _round_steps(about: float, end: float) -> list[float]:
    """Multiples of 1, 2 or 5 times a power of ten near `about`, up to `end`."""
    power = 10.0 ** math.floor(math.log10(about))
    step = min((1.0, 2.0, 5.0, 10.0), key=lambda f: abs(math.log(f * power / about))) * power
    return [step * k for k in range(1, int(end / step) + 1)]


def responses(flight: Recording, title: str, units: str = "si") -> Drawing:
    """The inputs and all that moved, stacked over time; `units` is ``si`` or ``us``."""
    t, every = flight["t"], _every(flight)
    unit_of = {c.name: UNIT_SYSTEMS[units].get(c.unit, (c.unit, 1.0)) for c in flight.columns}
    panels = []
    for group in GROUPS:
        moved = [name for name in group if name in unit_of and _moved(flight[name])]
        if not moved:
            continue
        unit = unit_of[moved[0]][0]
        curves = tuple(
            Curve(
                t[::every].tolist(),
                (flight[name][::every] * unit_of[name][1]).tolist(),
                name,
                COLORS[group.index(name)],
                LINES[group.index(name)],
            )
            for name in moved
        )
        panels.append(Panel("time [s]", f"[{unit}]", curves))
    return Drawing(title, tuple(panels), height=1.0 + 1.25 * max(1, len(panels)))


OVERLAID = ("elevator", "aileron", "rudder", "p", "q", "r", "alpha", "beta", "theta", "phi", "V", "n_z", "h")


def overlay(flights: Sequence[tuple[str, Recording]], title: str, units: str = "si") -> Drawing:
    """Flights with their labels, one over the other: a panel for each signal that moved in any of them."""
    _, first = flights[0]
    panels: list[Panel] = []
    for channel in (c for name in OVERLAID for c in first.columns if c.name == name):
        if not any(_moved(flight[channel.name]) for _, flight in flights):
            continue
        unit, factor = UNIT_SYSTEMS[units].get(channel.unit, (channel.unit, 1.0))
        curves = tuple(
            Curve(
                (flight["t"] - flight["t"][0])[:: _every(flight)].tolist(),
                (flight[channel.name] * factor)[:: _every(flight)].tolist(),
                label,
                COLORS[k % len(COLORS)],
                LINES[k % len(LINES)],
                in_legend=not panels,
            )
            for k, (label, flight) in enumerate(flights)
        )
        panels.append(Panel("time from the start [s]", f"{channel.name} [{unit}]", curves))
    return Drawing(title, tuple(panels), height=1.0 + 1.25 * max(1, len(panels)))


def _every(flight: Recording) -> int:
    return max(1, len(flight.data) // MOST_POINTS)


def _moved(signal: NDArray[np.float64]) -> bool:
    return bool(np.ptp(signal) > 1e-9 * max(1.0, abs(float(signal[0]))))
