"""The flight itself: one loop, one frame at a time, whoever pilots, whatever flies.

Command line, cockpit and tests differ only in the clock, the pilot, and who takes the frames.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import count
from math import isfinite
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

from fdes.control import Law, Stick
from fdes.control.law import alike
from fdes.errors import Departed, SpecError
from fdes.physics.signals import Air, Outputs, Surfaces

NO_EXCITATION = Surfaces()
BOUND = 1e9  # of every state, in its unit: far outside flight


class Plant(Protocol):
    """What flies. Each plant owns its state; all answer the same questions."""

    def start(self, height: float | None = None) -> Any:
        """The state of undisturbed flight, at `height` [m] or at the height of the condition."""
        ...

    def trim(self) -> Surfaces:
        """The surfaces that hold undisturbed flight."""
        ...

    def observe(self, x: Any, held: Surfaces, air: Air) -> Outputs:
        """All outputs in state `x` with the surfaces `held`."""
        ...

    def advance(self, x: Any, command: Surfaces, air: Air, dt: float, substeps: int) -> Any:
        """The state `dt` [s] later, in `substeps` steps of the integrator."""
        ...


class Weather(Protocol):
    """How the air moves, with its memory passed through."""

    def start(self) -> tuple[Air, Any]:
        """The air at the start, and what the weather remembers."""
        ...

    def step(self, memory: Any, y: Outputs, dt: float) -> tuple[Air, Any]:
        """The air of the next frame, and what the weather remembers."""
        ...


class Setup(NamedTuple):
    """What may be changed in flight."""

    plant: Plant
    law: Law


class Edit(NamedTuple):
    """A change at a frame boundary. What is None stays; `note` is what the recording says of it.

    `state` begins the flight anew from there, surfaces at trim; `disturb` changes the state that is. `left` says of the
    state before that and of the surfaces held until now where the surfaces are.
    """

    plant: Plant | None = None
    law: Law | None = None
    state: Any = None
    disturb: Callable[[Any], Any] | None = None
    left: Callable[[Any, Surfaces], Surfaces] | None = None
    note: Mapping[str, Any] = MappingProxyType({})


class Frame(NamedTuple):
    """One instant, complete: the outputs follow from state, held and air, the command from outputs, stick and memory.

    `held` are the surfaces under which the outputs were observed, `command` those of the frame that begins.
    """

    t: float
    stick: Stick
    excitation: Surfaces
    held: Surfaces
    command: Surfaces
    state: Any
    air: Air
    outputs: Outputs
    memory: Any
    edit: Edit | None


@dataclass(frozen=True)
class Clock:
    """Frame times t = k dt, from k = `first` on. `duration` [s] includes its last instant; None runs until nobody asks
    for more.
    """

    dt: float
    substeps: int = 1
    duration: float | None = None
    first: int = 0

    def __post_init__(self) -> None:
        if not (isfinite(self.dt) and self.dt > 0.0):
            raise SpecError(f"The time step is {self.dt:g} s; it must be a positive number, such as 0.01.")
        if self.substeps < 1:
            raise SpecError(f"The number of substeps is {self.substeps}; it must be at least 1.")
        if self.duration is not None and not (isfinite(self.duration) and self.duration >= 0.0):
            raise SpecError(f"The duration is {self.duration:g} s; it must be a finite number, zero or more.")

    def __iter__(self) -> Iterator[float]:
        first = self.first
        frames: Iterable[int] = (
            count(first) if self.duration is None else range(first, first + round(self.duration / self.dt) + 1)
        )
        return (k * self.dt for k in frames)


@dataclass(frozen=True)
class SteadyAir:
    """Weather that does not change. Without arguments: calm."""

    air: Air = field(default_factory=Air)

    def start(self) -> tuple[Air, None]:
        """The air, and nothing to remember."""
        return self.air, None

    def step(self, memory: None, y: Outputs, dt: float) -> tuple[Air, None]:
        """The same air."""
        return self.air, None


def no_excitation(t: float) -> Surfaces:
    """Nothing added to what the law commands."""
    return NO_EXCITATION


def no_edits(t: float) -> None:
    """Nothing changed in flight."""
    return


def fly(
    x: Any,
    setup: Setup,
    pilot: Callable[[float], Stick],
    weather: Weather,
    clock: Clock,
    excitation: Callable[[float], Surfaces] = no_excitation,
    edits: Callable[[float], Edit | None] = no_edits,
    after: Frame | None = None,
) -> Iterator[Frame]:
    """Fly from state `x`, one frame at a time, for as long as the clock runs.

    `excitation` is added to the law's command, as a test input is. `edits` may change plant, law or state at a frame
    boundary; a law of the same kind goes on with what the one before it remembered, unless the flight begins anew. A
    flight begins with the surfaces at trim and the law without a bump; or, to be flown again from its middle, with
    those that were `held` in the frame `after` and the memory that the law had there.
    Raises Departed when the state leaves what numbers can hold.
    """
    plant, law = setup
    held = plant.trim() if after is None else after.held
    air, weather_memory = weather.start()
    y = plant.observe(x, held, air)
    memory = law.start(y, pilot(clock.first * clock.dt)) if after is None else after.memory
    for t in clock:
        edit = edits(t)
        stick = pilot(t)
        if edit is not None:
            before = law
            plant, law = edit.plant or plant, edit.law or law
            if edit.state is not None:
                x, held = edit.state, plant.trim()
            if edit.left is not None:
                held = edit.left(x, held)
            if edit.disturb is not None:
                x = edit.disturb(x)
            y = plant.observe(x, held, air)
            if edit.state is not None or not alike(law, before):
                memory = law.start(y, stick)
        commanded, remembered = law.step(y, stick, memory, clock.dt)
        added = excitation(t)
        command = commanded if added is NO_EXCITATION else Surfaces(*map(float.__add__, commanded, added))
        yield Frame(t, stick, added, held, command, x, air, y, memory, edit)
        x = plant.advance(x, command, air, clock.dt, clock.substeps)
        _must_be_finite(x, t + clock.dt)
        air, weather_memory = weather.step(weather_memory, y, clock.dt)
        held, memory = command, remembered
        y = plant.observe(x, held, air)


def _must_be_finite(x: Any, t: float) -> None:
    """Stop before numbers overflow. The bound is far outside flight, so that an unstable integrator can be watched."""
    if max(x) < BOUND and min(x) > -BOUND:
        return
    name, value = next((n, v) for n, v in x._asdict().items() if not abs(v) < BOUND)
    raise Departed.of(t, name, value)
