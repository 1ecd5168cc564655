"""A recording flown again: the same stick, test inputs and air, frame by frame, on the same aircraft or on another.

On the engine, version and machine that its header names, an unchanged flight comes out bit for bit as it was; elsewhere
to rounding, which an unstable aircraft multiplies.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from fdes import __version__
from fdes.control import Stick
from fdes.control.blocks import Past
from fdes.errors import Departed, RecordingError
from fdes.flight.actuated import WithActuators, fitted, plant_type, recorded_type, surfaces_left
from fdes.flight.recorder import ENGINE, columns_of, row_of
from fdes.flight.recording import Recording
from fdes.flight.response import disturbed
from fdes.flight.simulation import Clock, Edit, Frame, Plant, Setup, fly
from fdes.physics.signals import Air, Outputs, Surfaces, channels

if TYPE_CHECKING:
    from numpy.typing import NDArray

Record = TypeVar("Record")

SHOWN = 4  # of the columns that are lacking
DEFLECTION = "state_elevator_position"  # a recording that has it has those of all surfaces, and their rates
OF_THE_FRAME = {"t", "reset", "disturb", "memory"}  # in the note of an edit; all else says what flies from then on

Remake = Callable[[Mapping[str, Any]], Setup]
"""Makes what flies from a recording's header, on which the notes of its edits have been laid up to some time."""
Relabel = Callable[[Mapping[str, Any]], dict[str, Any]]


@dataclass(frozen=True)
class Reflight:
    """What came of a flight flown again. `departed` says why it ended before the recording did, or is None."""

    recording: Recording
    departed: str | None


def fly_again(recording: Recording, remake: Remake, relabel: Relabel = dict) -> Reflight:
    """Fly the inputs of `recording` once more, with what `remake` makes of its header and of each of its edits.

    `relabel` says what the header of what comes out is. Raises RecordingError where the recording lacks what it needs.
    """
    table = _Table(recording)
    edits = {float(e["t"]): e for e in recording.edits}
    header = dict(recording.header)
    first = edits.pop(float(table.t[0]), {})
    header |= _setup_in(first)
    setup = remake(header)
    stick = table.stick(0)
    air = table.row("air_", 0)
    held = Surfaces(*table.row("held_", 0))
    start = table.state(0, setup.plant)
    y = setup.plant.observe(start, held, Air(*air))
    fresh = setup.law.start(y, stick)
    memory = _like(fresh, first["memory"]) if "memory" in first and _same_shape(fresh, first["memory"]) else fresh
    after = Frame(0.0, stick, Surfaces(), held, held, start, Air(*air), y, memory, None)

    now, flying = dict(header), setup
    kind = recorded_type(type(start)) if _has_actuators(recording, setup.plant) else type(start)

    def edit(t: float) -> Edit | None:
        nonlocal flying
        note = edits.get(t)
        if note is None:
            return None
        if _setup_in(note):
            now.update(_setup_in(note))
            flying = remake(now)
        (plant, law), held, text = flying, after.command, note.get("disturb")
        return Edit(
            plant=plant,
            law=law,
            state=table.state(table.at(t), plant) if note.get("reset") else None,
            disturb=lambda x: disturbed(fitted(x, plant, held), [] if text is None else [text]),
            left=lambda x, held: surfaces_left(x, plant, held),
            note={key: value for key, value in note.items() if key != "t"},
        )

    frames: list[tuple[float, ...]] = []
    notes: list[dict[str, Any]] = [first] if first else []
    departed = None
    try:
        flight = fly(
            start,
            setup,
            lambda t: table.stick(table.at(t)),
            _SameAir(table),
            table.clock,
            lambda t: Surfaces(*table.row("excitation_", table.at(t))),
            edit,
            after,
        )
        for frame in flight:
            after = frame
            frames.append(row_of(frame, kind))
            if frame.edit is not None:
                notes.append({"t": frame.t, **frame.edit.note})
    except Departed as ending:
        departed = str(ending)
    data = np.array(frames).reshape(len(frames), -1)
    columns = columns_of(kind)
    flown = relabel(header) | {"engine": ENGINE, "fdes": __version__, "columns": [c._asdict() for c in columns]}
    return Reflight(Recording(flown, columns, data, tuple(notes), complete=departed is None), departed)


def _has_actuators(recording: Recording, plant: Plant) -> bool:
    """Whether the surfaces have states of their own, at the start or after an edit, or were recorded as if."""
    said = any(edit.get("actuators") for edit in recording.edits)
    return said or isinstance(plant, WithActuators) or DEFLECTION in [c.name for c in recording.columns]


def _setup_in(note: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in note.items() if key not in OF_THE_FRAME}


class _Table:
    """The rows of a recording by what they mean."""

    def __init__(self, recording: Recording) -> None:
        if len(recording.data) < 2:
            raise RecordingError("The recording holds fewer than two frames: there is nothing to fly again.")
        names = [c.name for c in recording.columns]
        wanted = [c.name for record, prefix in _NEEDED for c in channels(record, prefix)]
        lacking = [name for name in wanted if name not in names]
        if lacking:
            more = f" and {len(lacking) - SHOWN} more columns" if len(lacking) > SHOWN else ""
            raise RecordingError(f"The recording cannot be flown again: it lacks {', '.join(lacking[:SHOWN])}{more}.")
        if "dt" not in recording.header:
            raise RecordingError("The recording cannot be flown again: its header lacks the time step, dt.")
        dt = float(recording.header["dt"])
        self.t: NDArray[np.float64] = recording.data[:, names.index("t")]
        self.first = round(float(self.t[0]) / dt)
        self.clock = Clock(dt, int(recording.header.get("substeps", 1)), (len(self.t) - 1) * dt, self.first)
        if not np.array_equal(self.t, np.array(list(self.clock))):
            raise RecordingError(f"The recording cannot be flown again: its frames are not {dt:g} s apart throughout.")
        self._rows: list[list[float]] = recording.data.tolist()
        prefixes = ("stick_", "excitation_", "held_", "air_")
        self._columns = {prefix: [i for i, n in enumerate(names) if n.startswith(prefix)] for prefix in prefixes}
        self._states = {n.removeprefix("state_"): i for i, n in enumerate(names) if n.startswith("state_")}

    def at(self, t: float) -> int:
        """The row of time `t`."""
        return round(t / self.clock.dt) - self.first

    def row(self, prefix: str, k: int) -> list[float]:
        """The columns that begin with `prefix`, in row `k`."""
        row = self._rows[k]
        return [row[i] for i in self._columns[prefix]]

    def state(self, k: int, plant: Plant) -> Any:
        """The state of `plant` in row `k`; actuators that were not recorded are at rest there.

        Raises RecordingError where the row has no state of such a plant.
        """
        kind, row = type(plant.start()), self._rows[k]
        known = all(name in self._states for name in kind._fields)
        wanted = kind if known or not isinstance(plant, WithActuators) else plant_type(kind)
        lacking = next((name for name in wanted._fields if name not in self._states), None)
        if lacking:
            raise RecordingError(f"The recording cannot be flown again: it lacks state_{lacking}.")
        x = wanted(*(row[self._states[name]] for name in wanted._fields))
        return fitted(x, plant, Surfaces(*self.row("held_", k)))

    def stick(self, k: int) -> Stick:
        """The stick in row `k`."""
        return Stick(*self.row("stick_", k))


_NEEDED: tuple[tuple[type, str], ...] = (
    (Outputs, ""),
    (Stick, "stick_"),
    (Surfaces, "excitation_"),
    (Surfaces, "held_"),
    (Air, "air_"),
)


@dataclass(frozen=True)
class _SameAir:
    """The air of a recording, row by row."""

    table: _Table

    def start(self) -> tuple[Air, int]:
        """The air of the first row."""
        return Air(*self.table.row("air_", 0)), 0

    def step(self, memory: int, y: Outputs, dt: float) -> tuple[Air, int]:
        """The air of the next row; after the last, that of the last."""
        k = min(memory + 1, len(self.table.t) - 1)
        return Air(*self.table.row("air_", k)), k


def _like(pattern: Record, values: Any) -> Record:
    """Plain numbers and lists, as JSON has them, in the tuples of `pattern`."""
    if not isinstance(pattern, tuple):
        return values  # type: ignore[no-any-return]  # a number, or None
    if isinstance(pattern, Past):
        return Past(values)  # type: ignore[return-value]
    parts = [_like(part, value) for part, value in zip(pattern, values, strict=True)]
    return type(pattern)(*parts) if hasattr(pattern, "_fields") else tuple(parts)  # type: ignore[return-value]


def _same_shape(pattern: Any, values: Any) -> bool:
    """Whether `values` can be put into `pattern`: another law remembers other things."""
    if not isinstance(pattern, tuple):
        return not isinstance(values, list | tuple) and (pattern is None) == (values is None)
    if not isinstance(values, list | tuple):
        return False
    if isinstance(pattern, Past):  # which fills up in flight
        return not any(isinstance(value, list | tuple) or value is None for value in values)
    if len(pattern) != len(values):
        return False
    return all(map(_same_shape, pattern, values))


def differences(one: Recording, other: Recording) -> Iterator[tuple[str, str, float, float, float]]:
    """Name, unit, greatest difference, its time and root mean square of each output that differs, in SI.

    The time is that since the recording began, as the clock of a replay has it.
    Both are compared as long as both last, `other` minus `one`.
    """
    count = min(len(one.data), len(other.data))
    units = {c.name: c.unit for c in one.columns}
    for channel in channels(Outputs):
        if channel.name not in units:
            continue
        apart = other[channel.name][:count] - one[channel.name][:count]
        k = int(np.argmax(np.abs(apart))) if count else 0
        if count and apart[k] != 0.0:
            rms = float(np.sqrt(np.mean(apart**2)))
            yield channel.name, channel.unit, float(apart[k]), float(one["t"][k] - one["t"][0]), rms
