"""Asking for a core on time."""

import ctypes
import platform
import sys
import threading

import pytest

from fdes.cockpit.punctual import SCHED_SETATTR, wake_me_on_time


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux is asked")
def test_linux_takes_the_request_of_an_unprivileged_thread() -> None:
    if platform.machine() not in SCHED_SETATTR:
        pytest.skip(f"the system call's number on {platform.machine()} is not known")
    answers: list[bool] = []
    thread = threading.Thread(target=lambda: answers.append(wake_me_on_time()))
    thread.start()
    thread.join()
    assert answers == [True]


def test_nothing_is_asked_of_an_unknown_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platform, "machine", lambda: "sparc64")
    monkeypatch.setattr(ctypes, "CDLL", lambda _: pytest.fail("the system was called"))
    assert wake_me_on_time() is False
