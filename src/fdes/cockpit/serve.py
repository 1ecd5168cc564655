"""Running the server: the socket, the address that is printed, and how it ends."""

import errno
import gc
import json
import socket
import threading
import webbrowser
from collections.abc import Callable
from pathlib import Path
from types import FrameType

import uvicorn

from fdes.aircraft import load
from fdes.cockpit.cabins import Cabins
from fdes.cockpit.fleet import Fleet
from fdes.cockpit.guard import is_loopback
from fdes.cockpit.punctual import wake_me_on_time
from fdes.cockpit.server import application
from fdes.errors import SpecError
from fdes.flight.storage import recordings_folder

PORT = 8010
EVERYWHERE = ("", "0.0.0.0", "::")  # noqa: S104  recognized here, chosen by the user
# Collect when a hundred thousand objects are left over. Frames that wait for the recorders live for a second; to look
# at them again and again, as Python does by itself, stopped thirty pilots for 50 ms every few seconds.
GARBAGE = (100_000, 10, 10)
# bytes: a longer message costs its sender the connection; one between this and the wire's limits is answered.
LARGEST_MESSAGE = 1 << 16
LOST_AFTER = 5.0  # s without an answer to a ping, asked as often


def serve(
    *,
    host: str = "127.0.0.1",
    port: int = PORT,
    data: str | Path | None = None,
    open_browser: bool = True,
    json_line: bool = False,
    aircraft: str | Path = "A-4D",
    condition: str | None = None,
    variant: str = "corrected",
    form: str = "full",
    integrator: str = "rk4",
    plant: str = "linear",
    across: str | None = None,
    spool: bool = False,
    record: bool = True,
) -> None:
    """Serve the cockpit until SIGINT or SIGTERM, then return.

    `port` 0 takes any free one. `data` is the data folder. With `record`, every flight is recorded from the first
    movement of its stick. The address is printed when it can be used: a sentence or, with `json_line`, a line of JSON.
    Raises FdesError for what cannot be flown, a folder that cannot be written, or an address that cannot be had.
    """
    fleet = Fleet(load(aircraft), condition, variant, form, integrator, plant, across=across, spool=spool)
    cabins = Cabins(fleet, recordings_folder(data), record=record)
    with listening(host, port) as listener:
        url = url_of(listener)
        loopback = is_loopback(listener.getsockname()[0])
        cabins.may_delete = loopback

        def ready() -> None:
            line = json.dumps({"url": url}) if json_line else greeting(listener)
            print(line, flush=True)  # noqa: T201  the one line a server prints
            if open_browser:  # in a thread, for some browsers return only when they are closed
                threading.Thread(target=webbrowser.open, args=(url,), daemon=True).start()

        gc.set_threshold(*GARBAGE)
        config = uvicorn.Config(
            application(cabins, loopback=loopback),
            log_config=None,
            log_level="warning",
            access_log=False,
            server_header=False,
            proxy_headers=False,
            ws_max_size=LARGEST_MESSAGE,
            ws_per_message_deflate=False,
            ws_ping_interval=LOST_AFTER,
            ws_ping_timeout=LOST_AFTER,
            timeout_graceful_shutdown=1,
        )
        Server(config, cabins, ready).run([listener])


class Server(uvicorn.Server):
    """A uvicorn that says when it can be used, says goodbye to its viewers, and takes being stopped for success."""

    def __init__(self, config: uvicorn.Config, cabins: Cabins, when_ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._cabins, self._when_ready = cabins, when_ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start, then say so."""
        await super().startup(sockets)
        gc.collect()
        gc.freeze()  # what is here now stays: collections need not look at it again
        wake_me_on_time()
        self._when_ready()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Dismiss the viewers, then stop."""
        await self._cabins.dismiss()
        await super().shutdown(sockets)

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Stop; at the second signal at once. Unlike uvicorn's own, it does not raise the signal again afterwards."""
        self.force_exit = self.should_exit
        self.should_exit = True


def listening(host: str, port: int) -> socket.socket:
    """A socket that listens at `host`, a name or an address, and `port`. Raises SpecError, with a port that is free."""
    if not 0 <= port <= 65535:
        raise SpecError(f"{port} is no port; ports are 0 to 65535. Use --port 0 for any free one.")
    try:
        found = socket.getaddrinfo(host or None, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
        family, *_, address = found[0]
        return socket.create_server(address[:2], family=family, backlog=256)
    except (socket.gaierror, UnicodeError):
        raise SpecError(
            f"There is no host {host!r} here. Use 127.0.0.1 for this machine, 0.0.0.0 for its whole network."
        ) from None
    except OSError as trouble:
        if trouble.errno == errno.EADDRNOTAVAIL:
            raise SpecError(f"{host} is not an address of this machine. Use --host 127.0.0.1.") from None
        taken = {errno.EADDRINUSE: "is in use", errno.EACCES: "is reserved for the system"}.get(trouble.errno or 0)
        if port == 0 or taken is None:
            raise SpecError(f"{host}, port {port}, cannot be listened to: {trouble.strerror}.") from None
        raise SpecError(f"Port {port} {taken}. Use --port {free_port(host)}, which is free.") from None


def free_port(host: str) -> int:
    """A port that nobody listens at just now."""
    with listening(host, 0) as found:
        port: int = found.getsockname()[1]
    return port


def greeting(listener: socket.socket) -> str:
    """What is said to whoever started the server."""
    host, port = listener.getsockname()[:2]
    others = f"For others on the network: http://{socket.gethostname()}:{port}. " if host in EVERYWHERE else ""
    return f"FDES flies at {url_of(listener)}. {others}Press Ctrl+C to stop."


def url_of(listener: socket.socket) -> str:
    """The address at which a browser on this machine finds the server."""
    host, port = listener.getsockname()[:2]
    name = "localhost" if host in EVERYWHERE else host
    return f"http://[{name}]:{port}" if ":" in name else f"http://{name}:{port}"
