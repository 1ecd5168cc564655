"""Asking for a core on time."""

import ctypes
import platform
import sys
import threading
import time
from collections.abc import Iterator

import pytest

from fdes.cockpit.punctual import SCHED_SETATTR, sleep_lightly, wake_me_on_time


@pytest.fixture
def interval() -> Iterator[None]:
    """The interpreter's switching interval is put back."""
    before = sys.getswitchinterval()
    yield
    sys.setswitchinterval(before)


KNOWN = sys.platform == "linux" and platform.machine() in SCHED_SETATTR


@pytest.mark.skipif(not KNOWN, reason="only Linux is asked, by a system call whose number differs between processors")
def test_linux_takes_the_request_of_an_unprivileged_thread() -> None:
    answers: list[bool] = []
    thread = threading.Thread(target=lambda: answers.append(wake_me_on_time()))
    thread.start()
    thread.join()
    assert answers == [True]


def test_nothing_is_asked_of_an_unknown_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platform, "machine", lambda: "sparc64")
    monkeypatch.setattr(ctypes, "CDLL", lambda _: pytest.fail("the system was called"))
    assert wake_me_on_time() is False


@pytest.mark.usefixtures("interval")
def test_others_give_way_at_once_when_it_wakes_and_may_wait_while_it_works(monkeypatch: pytest.MonkeyPatch) -> None:
    asleep: list[tuple[float, float]] = []
    monkeypatch.setattr(time, "sleep", lambda seconds: asleep.append((seconds, sys.getswitchinterval())))
    sleep_lightly(0.004)
    ((seconds, waking),) = asleep
    assert seconds == 0.004
    assert waking < 0.5e-3
    assert sys.getswitchinterval() > 3e-3
