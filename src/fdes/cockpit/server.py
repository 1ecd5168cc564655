"""The server: the page, what it asks for over HTTP, and the WebSocket of a session."""

import asyncio
import contextlib
import logging
import time
from collections.abc import AsyncIterator, Callable, Iterator
from dataclasses import replace
from io import StringIO
from math import isfinite, nan
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import JSONResponse, Response, StreamingResponse
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket

from fdes import __version__
from fdes.cockpit import commands, draft, wire
from fdes.cockpit.cabin import Cabin
from fdes.cockpit.cabins import Cabins
from fdes.cockpit.columns import chosen_columns
from fdes.cockpit.files import Folder
from fdes.cockpit.guard import Guard
from fdes.cockpit.hub import percentiles
from fdes.cockpit.viewer import FLOOD, MAX_RATE, RateLimit, Viewer
from fdes.errors import FdesError, RecordingError
from fdes.flight import Recording, list_recordings, open_recording

if TYPE_CHECKING:
    from fdes.flight.recording import Listed

HERE = Path(__file__).parent
BLOCK = 500  # rows of CSV made at a time
TRY_LATER = 1013
PIECE = 1 << 18  # bytes of a file sent at a time

log = logging.getLogger(__name__)


class Site:
    """What the server answers, request by request."""

    def __init__(self, cabins: Cabins) -> None:
        self._cabins = cabins
        self._listing: asyncio.Future[list[Listed]] | None = None
        self._page, self._instruments = Folder(HERE / "page"), Folder(HERE / "instruments")

    async def index(self, request: Request) -> Response:
        """The page."""
        return self._page.respond(request, "index.html")

    async def page(self, request: Request) -> Response:
        """A file of the page."""
        return self._page.respond(request, request.path_params["name"])

    async def instrument(self, request: Request) -> Response:
        """An instrument."""
        return self._instruments.respond(request, request.path_params["name"])

    async def instruments(self, request: Request) -> Response:
        """The names of the instruments on the shelf."""
        return JSONResponse(sorted(path.stem for path in (HERE / "instruments").glob("*.js")))

    async def version(self, request: Request) -> Response:
        """The version of FDES and of the wire."""
        return JSONResponse({"fdes": __version__, "wire": wire.VERSION})

    async def aircraft(self, request: Request) -> Response:
        """All aircraft that can be chosen."""
        fleet = self._cabins.fleet
        return Response(await asyncio.to_thread(lambda: fleet.pictures), media_type="application/json")

    async def choices(self, request: Request) -> Response:
        """What the form for a new aircraft offers."""
        fleet = self._cabins.fleet
        return JSONResponse(await asyncio.to_thread(lambda: draft.choices(fleet.aircraft)))

    async def document(self, request: Request) -> Response:
        """The content of one aircraft's file."""
        fleet, name = self._cabins.fleet, request.path_params["name"]
        return JSONResponse(await asyncio.to_thread(lambda: fleet.named(name).document))

    async def review(self, request: Request) -> Response:
        """What is wrong with an aircraft that is being written. Nothing of it is kept."""
        return JSONResponse(await asyncio.to_thread(draft.reviewed, await small_body(request)))

    async def read_file(self, request: Request) -> Response:
        """The content of an aircraft file that comes as TOML."""
        return JSONResponse(await asyncio.to_thread(draft.content_of, await small_body(request)))

    async def recordings(self, request: Request) -> Response:
        """All recordings, newest first. Those who ask while the folder is being read share what is found."""
        if self._listing is None or self._listing.done():
            self._listing = asyncio.ensure_future(asyncio.to_thread(list_recordings, self._cabins.recordings))
        listed = await asyncio.shield(self._listing)
        return JSONResponse([in_a_list(recording) for recording in listed])

    async def csv(self, request: Request) -> Response:
        """A recording as CSV."""
        name = request.path_params["name"]
        recording = await asyncio.to_thread(lambda: open_recording(found(self._cabins, name)))
        return StreamingResponse(csv_blocks(recording), media_type="text/csv", headers=attached(f"{name}.csv"))

    async def netcdf(self, request: Request) -> Response:
        """A recording as NetCDF."""
        return await self._written(request, "nc", Recording.to_netcdf)

    async def mat(self, request: Request) -> Response:
        """A recording for MATLAB."""
        return await self._written(request, "mat", Recording.to_mat)

    async def columns(self, request: Request) -> Response:
        """The ``?columns=`` of a recording, for charts."""
        name, asked = request.path_params["name"], request.query_params.get("columns", "")

        def made() -> Response:
            return JSONResponse(chosen_columns(open_recording(found(self._cabins, name)), asked))

        return await asyncio.to_thread(made)

    async def _written(self, request: Request, suffix: str, write: Callable[[Recording, Path], None]) -> Response:
        """A recording in a format that is made whole before it is sent."""
        name = request.path_params["name"]

        def made() -> bytes:
            with TemporaryDirectory() as folder:
                path = Path(folder) / f"recording.{suffix}"
                write(open_recording(found(self._cabins, name)), path)
                return path.read_bytes()

        body = await asyncio.to_thread(made)
        return Response(body, media_type="application/octet-stream", headers=attached(f"{name}.{suffix}"))

    async def native(self, request: Request) -> Response:
        """A recording as it is, up to here if it is being written."""
        name = request.path_params["name"]
        path = await asyncio.to_thread(found, self._cabins, name)
        size = path.stat().st_size
        headers = attached(path.name) | {"content-length": str(size)}
        return StreamingResponse(file_pieces(path, size), media_type="application/octet-stream", headers=headers)

    async def stats(self, request: Request) -> Response:
        """How the server fares, over the last ``?seconds=``."""
        try:
            seconds = float(request.query_params.get("seconds", 10.0))
        except ValueError:
            seconds = nan
        if not isfinite(seconds):
            raise HTTPException(400, "seconds must be a number.")
        return JSONResponse(figures(self._cabins, seconds))

    async def socket(self, websocket: WebSocket) -> None:
        """Fly or watch a session."""
        await websocket.accept()
        try:
            cabin, viewer = self._cabins.join(websocket.path_params["session"])
        except FdesError as no:
            await websocket.send_json({"type": "error", "error": str(no)})
            await websocket.close(TRY_LATER, "no seat")
            return
        sending = asyncio.create_task(viewer.pump(websocket))
        try:
            await listen(websocket, self._cabins, cabin, viewer)
        finally:
            self._cabins.leave(cabin, viewer)
            sending.cancel()
            await asyncio.gather(sending, return_exceptions=True)


def application(cabins: Cabins, *, loopback: bool = True) -> Starlette:
    """The whole application. Flying begins and ends with its lifespan."""

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        cabins.open()
        yield
        await cabins.close()

    site = Site(cabins)
    return Starlette(
        routes=[
            Route("/", site.index),
            Route("/page/{name:path}", site.page),
            Route("/instruments/{name:path}", site.instrument),
            Route("/api/instruments", site.instruments),
            Route("/api/version", site.version),
            Route("/api/aircraft", site.aircraft),
            Route("/api/new-aircraft", site.choices),
            Route("/api/new-aircraft", site.review, methods=["POST"]),
            Route("/api/new-aircraft/from", site.read_file, methods=["POST"]),
            Route("/api/new-aircraft/from/{name}", site.document),
            Route("/api/recordings", site.recordings),
            Route("/api/recordings/{name}.csv", site.csv),
            Route("/api/recordings/{name}.json", site.columns),
            Route("/api/recordings/{name}.fdes", site.native),
            Route("/api/recordings/{name}.nc", site.netcdf),
            Route("/api/recordings/{name}.mat", site.mat),
            Route("/api/stats", site.stats),
            WebSocketRoute("/ws/{session}", site.socket),
        ],
        middleware=[Middleware(Guard, loopback=loopback)],
        exception_handlers={FdesError: told},
        lifespan=lifespan,
    )


async def listen(websocket: WebSocket, cabins: Cabins, cabin: Cabin, viewer: Viewer) -> None:
    """Take what a viewer sends until it goes. What cannot be used is answered, and costs nobody else anything."""
    rate = RateLimit()
    while (message := await websocket.receive())["type"] != "websocket.disconnect":
        rest = rate.note()
        if rate.count > MAX_RATE:
            if rate.count == MAX_RATE + 1:
                viewer.complain(f"More than {MAX_RATE} messages came within a second. Those beyond are dropped.")
            if rate.count > FLOOD:
                await asyncio.sleep(rest)
            continue
        try:
            if (data := message.get("bytes")) is None:
                asked = wire.read_text(message["text"])
                await reply(cabins, cabin, viewer, asked["id"], asked)
            elif wire.is_command(data):
                number, given = wire.unpack_command(data)
                await reply(cabins, cabin, viewer, number, given)
            else:
                cabins.stick(cabin, viewer, wire.unpack_input(data))
        except FdesError as wrong:
            viewer.complain(str(wrong))


async def reply(
    cabins: Cabins, cabin: Cabin, viewer: Viewer, number: int, asked: commands.Command | dict[str, Any]
) -> None:
    """Carry out the command of that `number`, read already or still a message, and say how it went."""
    try:
        command = wire.command_of(asked) if isinstance(asked, dict) else asked
        said = await cabins.obey(cabin, viewer, command)
    except FdesError as no:
        viewer.tell(type="reply", id=number, ok=False, error=str(no))
    except Exception as fault:
        log.exception("a command failed")
        error = f"The command failed by a fault in FDES ({type(fault).__name__}: {fault}). Please report it."
        viewer.tell(type="reply", id=number, ok=False, error=error)
    else:
        viewer.tell(type="reply", id=number, ok=True, **said)


def found(cabins: Cabins, name: str) -> Path:
    """The file of a recording. Raises HTTPException 404 when there is none of that name."""
    try:
        return cabins.recording(name)
    except RecordingError as none:
        raise HTTPException(404, str(none)) from none


def in_a_list(recording: "Listed") -> dict[str, Any]:
    """What tells a recording from others: which aircraft, when, how long, and with what it began."""
    header = recording.header
    said = ("aircraft", "condition", "variant", "changes", "law", "plant", "started", "what_if")
    conditions = {each.get("id"): each.get("name") for each in header.get("document", {}).get("conditions", [])}
    return {
        "name": recording.name,
        **{key: header.get(key) for key in said},
        "condition_name": conditions.get(header.get("condition")),
        "seconds": round(recording.seconds, 2),
        "bytes": recording.bytes,
    }


async def small_body(request: Request) -> bytes:
    """What was sent. Raises HTTPException 413 as soon as it is more than an aircraft may have."""
    body = b""
    async for piece in request.stream():
        body += piece
        if len(body) > draft.LARGEST:
            raise HTTPException(413, f"The aircraft is too large: {draft.LARGEST} bytes are the most.")
    return body


def csv_blocks(recording: Recording) -> Iterator[str]:
    """The recording as CSV, some rows at a time. Starlette runs it in a worker thread."""
    for start in range(0, max(1, len(recording.data)), BLOCK):
        text = StringIO()
        replace(recording, data=recording.data[start : start + BLOCK]).to_csv(text)
        head, _, rows = text.getvalue().partition("\n")
        yield rows if start else f"{head}\n{rows}"


def file_pieces(path: Path, size: int) -> Iterator[bytes]:
    """The first `size` bytes of a file, which may be growing."""
    with path.open("rb") as file:
        while size > 0 and (piece := file.read(min(size, PIECE))):
            size -= len(piece)
            yield piece


def attached(name: str) -> dict[str, str]:
    """Headers of a download that is to be kept as `name`."""
    plain = quote(name) == name
    said = f'filename="{name}"' if plain else f"filename*=utf-8''{quote(name)}"
    return {"content-disposition": f"attachment; {said}", "cache-control": "no-store"}


def figures(cabins: Cabins, seconds: float) -> dict[str, Any]:
    """How the server fares: times in ms over the last `seconds`, CPU time in s since the start."""
    hub = cabins.hub
    ticks = int(min(max(seconds, 0.0), 60.0) * hub.rate)
    times = {
        "lateness_ms": hub.lateness.last(ticks),
        "busy_ms": hub.busy.last(ticks),
        "handover_ms": hub.handovers(ticks),
    }
    measured = {name: percentiles(taken) for name, taken in times.items()}
    return {
        **{
            name: {"n": p.n, "p50": round(1e3 * p.p50, 4), "p99": round(1e3 * p.p99, 4)} for name, p in measured.items()
        },
        "ticks": hub.lateness.added,
        "slips": hub.slips,
        "real_time_factor": hub.real_time_factor(),
        "sessions": len(cabins.cabins),
        "viewers": cabins.viewers(),
        "cpu_s": time.process_time(),
        "wall_s": time.monotonic(),
    }


async def told(request: Request, error: Exception) -> Response:
    """An error that a user can act on, as JSON."""
    return JSONResponse({"error": str(error)}, status_code=400)
