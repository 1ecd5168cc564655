"""One connection as the server sees it: what waits to be sent to it, and how much it may send."""

import asyncio
import json
import time
from collections import deque
from collections.abc import Callable
from typing import Any

from starlette.websockets import WebSocket

GOING_AWAY = 1001
MAX_WAITING = 64  # texts that wait for a slow viewer; the oldest are dropped
MAX_RATE = 200  # messages per second that are listened to
FLOOD = 5 * MAX_RATE  # messages per second beyond which the connection is no longer read for the rest of that second


class Viewer:
    """Someone who watches. All that is sent goes through `pump`; of the frames that wait, the newest alone is sent."""

    def __init__(self, role: str) -> None:
        self.role = role
        self.dropped = 0
        self._texts: deque[str] = deque(maxlen=MAX_WAITING)
        self._frame: bytes | None = None
        self._wake = asyncio.Event()
        self._dismissed = False
        self._complaint, self._complained = "", 0.0

    def offer(self, frame: bytes) -> None:
        """Show `frame`, unless a newer one comes before it is sent."""
        self.dropped += self._frame is not None
        self._frame = frame
        self._wake.set()

    def complain(self, sentence: str) -> None:
        """Send an error message, though not the same one again within a second."""
        now = time.monotonic()
        if sentence != self._complaint or now - self._complained >= 1.0:
            self._complaint, self._complained = sentence, now
            self.tell(type="error", error=sentence)

    def dismiss(self) -> None:
        """Close the connection: the server is going away."""
        self._dismissed = True
        self._wake.set()

    def tell(self, **message: Any) -> None:
        """Send a JSON message."""
        self.tell_text(json.dumps(message, allow_nan=False))

    def tell_text(self, text: str) -> None:
        """Send a message that is JSON already."""
        self._texts.append(text)
        self._wake.set()

    async def pump(self, socket: WebSocket) -> None:
        """Send what waits, texts first, until dismissed or cancelled."""
        while not self._dismissed:
            await self._wake.wait()
            self._wake.clear()
            while self._texts:
                await socket.send_text(self._texts.popleft())
            frame, self._frame = self._frame, None
            if frame is not None:
                await socket.send_bytes(frame)
        await socket.close(GOING_AWAY, "the server is stopping")


class RateLimit:
    """Counts messages second by second."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._second = now()
        self.count = 0

    def note(self) -> float:
        """Count one message. The time [s] until its second ends."""
        now = self._now()
        if now - self._second >= 1.0:
            self._second, self.count = now, 0
        self.count += 1
        return 1.0 - (now - self._second)
