"""The hub: one thread that steps every session in real time, and hands what they show to the event loop.

Ticks fall on absolute deadlines, so that errors of one sleep do not add up. A machine that is up to `CATCH_UP` seconds
behind makes good; one that is later has all it owes dropped, and counted as a slip: the simulation clock then runs
slow, and says so. Sockets live in the event loop, in another thread: a crowd of page loads delays messages,
never the flight. The loop is woken once per tick, however many sessions have something to show.
"""

import asyncio
import logging
import threading
import time
from array import array
from collections.abc import Callable, Iterable
from typing import Generic, NamedTuple, Protocol, TypeVar

from fdes.cockpit.punctual import sleep_lightly, wake_me_on_time

RATE = 120  # Hz
CATCH_UP = 0.25  # s
RECENT = 10  # s over which lateness is judged
NOTICEABLE = 1.0 / 60.0  # s: a lateness that costs a frame on the screen

log = logging.getLogger(__name__)


class Stepped(Protocol):
    """What the hub steps."""

    changed: bool

    def tick(self, number: int, late: bool) -> bytes | None:
        """Go on by one period; the frame to show, if one is due."""
        ...

    def fail(self, trouble: Exception) -> None:
        """Take note that `tick` raised."""
        ...


S = TypeVar("S", bound=Stepped)


class Percentiles(NamedTuple):
    """How `n` times [s] are distributed."""

    n: int
    p50: float
    p99: float


def percentiles(times: Iterable[float]) -> Percentiles:
    """The median and the 99th percentile of `times` [s], zero where there are none."""
    ranked = sorted(times)
    if not ranked:
        return Percentiles(0, 0.0, 0.0)
    return Percentiles(len(ranked), ranked[len(ranked) // 2], ranked[int(len(ranked) * 0.99)])


class Ring:
    """The last `size` numbers, in memory that never grows. One thread adds; any may look."""

    def __init__(self, size: int) -> None:
        self._numbers = array("d", bytes(8 * size))
        self.added = 0

    def add(self, number: float) -> None:
        """Put `number` in the place of the oldest."""
        self._numbers[self.added % len(self._numbers)] = number
        self.added += 1

    def last(self, count: int) -> list[float]:
        """The newest `count` numbers, or as many as there are, oldest first."""
        end, size = self.added, len(self._numbers)
        return [self._numbers[i % size] for i in range(max(0, end - min(count, size)), end)]


class Hub(Generic[S]):
    """Steps sessions `rate` times a second until it is stopped. Only the event loop's thread changes `sessions`."""

    def __init__(
        self,
        rate: int = RATE,
        now: Callable[[], float] = time.perf_counter,
        sleep: Callable[[float], None] = sleep_lightly,
    ) -> None:
        self.rate = rate
        self.sessions: dict[str, S] = {}
        self.slips = 0
        memory = 60 * rate
        self.lateness, self.busy = Ring(memory), Ring(memory)
        self._handovers, self._handed_over = Ring(memory), Ring(memory)  # how long each took, and in which tick
        self._wakes = Ring(rate + 1)
        self._judged = -1, 0.0  # in which second, and the lateness p99 then
        self._now, self._sleep = now, sleep
        self._late_until = 0.0
        self._stopping = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self, loop: asyncio.AbstractEventLoop, show: Callable[[list[tuple[S, bytes | None]]], None]) -> None:
        """Begin to tick. `show` is called in the thread of `loop` after each tick with something to show."""

        def receive(shown: list[tuple[S, bytes | None]], sent: float) -> None:
            self._handovers.add(self._now() - sent)
            self._handed_over.add(self.lateness.added)
            show(shown)

        def hand_over(shown: list[tuple[S, bytes | None]]) -> None:
            try:
                loop.call_soon_threadsafe(receive, shown, self._now())
            except RuntimeError:  # the loop was closed in a hurry
                self._stopping.set()

        self._stopping.clear()
        self._thread = threading.Thread(target=self.run, args=(hand_over,), name="fdes hub", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """End after the present tick, and wait for it."""
        self._stopping.set()
        if self._thread is not None:
            self._thread.join()

    def run(self, hand_over: Callable[[list[tuple[S, bytes | None]]], None]) -> None:
        """Tick until stopped: what the thread does."""
        wake_me_on_time()
        period = 1.0 / self.rate
        due = self._now() + period
        number = 0
        while not self._stopping.is_set():
            wait = due - self._now()
            if wait > 0.0:
                self._sleep(wait)
            began = self._now()
            late = began - due
            if late > CATCH_UP:
                self.slips += 1
                due = began
            if late > NOTICEABLE:
                self._late_until = began + 1.0
            shown = self.step_all(number, began < self._late_until)
            if shown and not self._stopping.is_set():
                hand_over(shown)
            self.lateness.add(late)
            self.busy.add(self._now() - began)
            self._wakes.add(began)
            number += 1
            due += period

    def step_all(self, number: int, late: bool) -> list[tuple[S, bytes | None]]:
        """Step every session once. One that raises is told so; the others do not notice."""
        shown: list[tuple[S, bytes | None]] = []
        for session in list(self.sessions.values()):
            try:
                frame = session.tick(number, late)
            except Exception as trouble:
                log.exception("a session failed")
                session.fail(trouble)
                frame = None
            if frame is not None or session.changed:
                shown.append((session, frame))
        return shown

    def handovers(self, ticks: int) -> list[float]:
        """How long [s] each frame of the last `ticks` took to the event loop: for that loop's own thread."""
        taken, when = self._handovers.last(ticks), self._handed_over.last(ticks)
        first = self.lateness.added - ticks
        return [seconds for seconds, tick in zip(taken, when, strict=True) if tick >= first]

    def lateness_p99(self) -> float:
        """The 99th percentile of the lateness [s] in the last `RECENT` seconds: for the event loop's thread.

        Sorted once a second and not for every session that tells it, for that would keep the interpreter from ticks.
        """
        second = self.lateness.added // self.rate
        if self._judged[0] != second:
            self._judged = second, percentiles(self.lateness.last(RECENT * self.rate)).p99
        return self._judged[1]

    def real_time_factor(self) -> float:
        """Simulated over real time in the last second: 1 unless the machine cannot keep up."""
        wakes = self._wakes.last(self.rate + 1)
        if len(wakes) <= self.rate:
            return 1.0
        return min(1.0, round(1.0 / (wakes[-1] - wakes[0]), 3)) if wakes[-1] > wakes[0] else 1.0
