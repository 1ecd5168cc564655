"""The hub on a clock of its own: deadlines, slips, and sessions that fail."""

import asyncio
import itertools
import threading

import pytest

from fdes.cockpit.hub import CATCH_UP, Hub, Ring, percentiles


class Session:
    """Shows a frame every second tick."""

    def __init__(self) -> None:
        self.changed = False
        self.ticks: list[tuple[int, bool]] = []
        self.troubles: list[Exception] = []

    def tick(self, number: int, late: bool) -> bytes | None:
        self.ticks.append((number, late))
        return b"frame" if number % 2 else None

    def fail(self, trouble: Exception) -> None:
        self.troubles.append(trouble)


class Broken(Session):
    def tick(self, number: int, late: bool) -> bytes | None:
        super().tick(number, late)
        raise ValueError("a bug")


class Machine:
    """A clock that sleeping moves, stalling for `stall` s in sleep number `at`; after `sleeps` the hub stops."""

    def __init__(self, sleeps: int, at: int = -1, stall: float = 0.0) -> None:
        self.time, self.at, self.stall = 0.0, at, stall
        self.hub: Hub[Session] = Hub(100, lambda: self.time, self.sleep)
        self.left = sleeps
        self.count = 0

    def sleep(self, seconds: float) -> None:
        self.time += seconds
        if self.count == self.at:
            self.time += self.stall
        self.count += 1
        if self.count >= self.left:
            self.hub._stopping.set()

    def run(self) -> list[Session]:
        shown: list[Session] = []
        self.hub.run(lambda batch: shown.extend(session for session, _ in batch))
        return shown


def test_ticks_fall_on_absolute_deadlines() -> None:
    machine = Machine(sleeps=200)
    session = machine.hub.sessions["one"] = Session()
    machine.run()
    assert [number for number, _ in session.ticks] == list(range(200))
    assert machine.time == pytest.approx(2.0)
    assert machine.hub.slips == 0
    assert percentiles(machine.hub.lateness.last(200)).p99 == pytest.approx(0.0, abs=1e-9)
    assert machine.hub.real_time_factor() == pytest.approx(1.0, abs=1e-3)


def test_lateness_is_judged_once_a_second() -> None:
    machine = Machine(sleeps=150, at=120, stall=0.05)
    machine.run()
    assert machine.hub.lateness_p99() == pytest.approx(0.04, abs=1e-9)  # the second latest of 150: 50 ms, 40, 30 ...
    machine.hub.lateness.add(9.0)
    machine.hub.lateness.add(9.0)
    assert machine.hub.lateness_p99() == pytest.approx(0.04, abs=1e-9)
    for _ in range(100):
        machine.hub.lateness.add(9.0)
    assert machine.hub.lateness_p99() == 9.0


def test_a_short_stall_is_caught_up() -> None:
    machine = Machine(sleeps=100, at=20, stall=CATCH_UP - 0.02)
    session = machine.hub.sessions["one"] = Session()
    machine.run()
    assert machine.hub.slips == 0
    assert len(session.ticks) == pytest.approx(machine.time * 100, abs=1)
    assert any(late for _, late in session.ticks)
    assert not session.ticks[10][1]


def test_a_long_stall_is_dropped_and_counted() -> None:
    machine = Machine(sleeps=150, at=80, stall=3.0)
    session = machine.hub.sessions["one"] = Session()
    machine.run()
    assert machine.hub.slips == 1
    assert len(session.ticks) == 150
    assert machine.time == pytest.approx(4.5)
    assert machine.hub.real_time_factor() < 0.5


def test_late_is_said_for_a_second() -> None:
    machine = Machine(sleeps=300, at=20, stall=0.05)
    session = machine.hub.sessions["one"] = Session()
    machine.run()
    late = [number for number, late in session.ticks if late]
    assert late == list(range(late[0], late[-1] + 1))
    assert 95 <= len(late) <= 106


def test_a_session_that_raises_is_told_and_the_others_go_on(caplog: pytest.LogCaptureFixture) -> None:
    machine = Machine(sleeps=10)
    broken = machine.hub.sessions["broken"] = Broken()
    sound = machine.hub.sessions["sound"] = Session()
    machine.run()
    assert len(sound.ticks) == len(broken.ticks) == len(broken.troubles) == 10
    assert "a session failed" in caplog.text


def test_only_what_has_something_to_show_is_handed_over() -> None:
    machine = Machine(sleeps=11)
    machine.hub.sessions["one"] = Session()
    assert len(machine.run()) == 5
    quiet = Machine(sleeps=11)
    changed = quiet.hub.sessions["one"] = Session()
    changed.changed = True
    assert len(quiet.run()) == 10


def test_the_loop_is_woken_once_per_tick() -> None:
    async def fly() -> list[int]:
        hub: Hub[Session] = Hub(500)
        hub.sessions.update({str(i): Session() for i in range(7)})
        sizes: list[int] = []
        enough = asyncio.Event()

        def show(batch: list[tuple[Session, bytes | None]]) -> None:
            sizes.append(len(batch))
            if len(sizes) >= 20:
                enough.set()

        hub.start(asyncio.get_running_loop(), show)
        await asyncio.wait_for(enough.wait(), 10.0)
        hub.stop()
        assert "fdes hub" not in [t.name for t in threading.enumerate()]
        return sizes

    assert set(asyncio.run(fly())) == {7}


def test_a_ring_keeps_the_newest() -> None:
    ring = Ring(4)
    assert ring.last(10) == []
    for number, _ in zip(itertools.count(1.0), range(6), strict=False):
        ring.add(number)
    assert ring.last(3) == [4.0, 5.0, 6.0]
    assert ring.last(10) == [3.0, 4.0, 5.0, 6.0]
    assert ring.added == 6


def test_handovers_are_those_of_the_last_ticks() -> None:
    async def fly() -> tuple[int, int]:
        hub: Hub[Session] = Hub(500)
        hub.sessions["one"] = Session()
        enough = asyncio.Event()
        hub.start(asyncio.get_running_loop(), lambda _: enough.set() if hub.lateness.added > 20 else None)
        await asyncio.wait_for(enough.wait(), 10.0)
        hub.sessions.clear()
        await asyncio.sleep(0.2)  # 100 ticks in which nothing is shown
        hub.stop()
        return len(hub.handovers(5)), len(hub.handovers(hub.lateness.added))

    few, all_of_them = asyncio.run(fly())
    assert few == 0
    assert all_of_them >= 10


def test_percentiles() -> None:
    assert percentiles([]) == (0, 0.0, 0.0)
    assert percentiles(range(1000)) == (1000, 500, 990)
