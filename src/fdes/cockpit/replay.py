"""A recording on the screen again, at the pace at which it was flown."""

from bisect import bisect_right
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.cockpit.wire import CHANNELS
from fdes.errors import RecordingError
from fdes.flight import Recording


@dataclass
class Replay:
    """A recording and where it is. Times [s] count from its first frame; at its end it stays, paused.

    `values` are (frames, channels of the wire) in float32; a channel that the recording lacks is not a number.
    """

    name: str
    header: dict[str, Any]
    times: list[float]
    values: NDArray[np.float32]
    t: float = 0.0
    paused: bool = False

    @property
    def duration(self) -> float:
        """Time [s] of the last frame."""
        return self.times[-1]

    def advance(self, dt: float) -> None:
        """Go on by `dt` [s], unless paused."""
        if not self.paused:
            self.seek(self.t + dt)
            self.paused = self.t >= self.duration

    def seek(self, t: float) -> None:
        """Go to `t` [s], or to the nearest end."""
        self.t = min(max(t, 0.0), self.duration)

    def resume(self) -> None:
        """Go on; from the start if it was at its end."""
        if self.t >= self.duration:
            self.seek(0.0)
        self.paused = False

    def frame(self) -> list[float]:
        """The channels as they were at the newest frame not after the present time."""
        index = max(0, bisect_right(self.times, self.t + 1e-9) - 1)
        row: list[float] = self.values[index].tolist()
        return row


def replay_of(name: str, recording: Recording) -> Replay:
    """Make `recording` ready to be shown. Raises RecordingError when there is nothing in it."""
    if len(recording.data) == 0:
        raise RecordingError(f"The recording {name} holds no frames: the program ended before the first was written.")
    at = {c.name: i for i, c in enumerate(recording.columns)}
    values = np.full((len(recording.data), len(CHANNELS)), np.nan, dtype=np.float32)
    for i, channel in enumerate(CHANNELS):
        if channel.name in at:
            values[:, i] = recording.data[:, at[channel.name]]
    times = recording.data[:, at["t"]]
    return Replay(name, recording.header, (times - times[0]).tolist(), values)
