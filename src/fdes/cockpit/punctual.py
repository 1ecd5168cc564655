"""Being awake on time: the operating system has to give the core, and then the interpreter its lock.

Linux shares a core by slices of some milliseconds. A thread that sleeps until its deadline and finds another on the
core may have to wait for the end of that one's slice: with a browser on the same two cores one tick in a hundred was
1 to 2 ms late. A thread that asks for short slices for itself gets the core at once, and needs no privilege for that.

Python lets one thread run at a time, and one that wants to run asks the other to give way after a switching interval.
One interval cannot suit the hub: asleep it wants a short one, so that its tick begins on time; at work a long one, or
the threads of page loads and of recorders take turns with it in the midst of a tick. So it sets both itself.
"""

import ctypes
import platform
import sys
import time
from typing import ClassVar

SLICE = 100_000  # ns, the shortest that Linux grants
FOR_ITSELF = 1  # SCHED_FLAG_RESET_ON_FORK: not for the threads that it starts
READILY, RELUCTANTLY = 0.2e-3, 5e-3  # s: how soon a thread has to give way while the hub is asleep, and at work
SCHED_SETATTR = {"x86_64": 314, "aarch64": 274, "riscv64": 274}  # the number of the system call, by machine


class _Attributes(ctypes.Structure):
    """`struct sched_attr` of Linux, sched_setattr(2). For an ordinary thread `runtime` [ns] is its slice."""

    _fields_: ClassVar = [
        ("size", ctypes.c_uint32),
        ("policy", ctypes.c_uint32),
        ("flags", ctypes.c_uint64),
        ("nice", ctypes.c_int32),
        ("priority", ctypes.c_uint32),
        ("runtime", ctypes.c_uint64),
        ("deadline", ctypes.c_uint64),
        ("period", ctypes.c_uint64),
    ]


def wake_me_on_time() -> bool:
    """Ask for short slices for the thread that calls. True if Linux took the request: before 6.12 it changes nothing.

    Elsewhere nothing is asked: Windows and macOS give a thread that wakes the core by themselves.
    """
    number = SCHED_SETATTR.get(platform.machine())
    if sys.platform != "linux" or number is None:
        return False
    asked = _Attributes(size=ctypes.sizeof(_Attributes), flags=FOR_ITSELF, runtime=SLICE)
    refused: int = ctypes.CDLL(None).syscall(number, 0, ctypes.byref(asked), 0)
    return not refused


def sleep_lightly(seconds: float) -> None:
    """Sleep; whoever runs Python at the end of it has to give way at once, but nobody has to from then on."""
    sys.setswitchinterval(READILY)
    time.sleep(seconds)
    sys.setswitchinterval(RELUCTANTLY)
