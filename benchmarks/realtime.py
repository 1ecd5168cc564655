"""How well the cockpit keeps time: one pilot, a class of thirty, and a class that reloads its pages all at once.

    python benchmarks/realtime.py [--pilots 30] [--seconds 15] [--loads 30] [--plant nonlinear]

Starts `fdes fly` in a process of its own and flies it over WebSockets from this one: both share the computer's cores.
Each pilot keeps a rhythm of its own, as thirty computers do. Beside the cockpit a third process does nothing but tick:
where that is late, the computer is, and not the cockpit.
Prints what was measured beside what is demanded. It judges nothing: gates belong on a quiet computer.
"""

import argparse
import asyncio
import contextlib
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import AsyncIterator, Iterator
from concurrent.futures import ProcessPoolExecutor
from importlib.resources import files
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlsplit
from urllib.request import urlopen

from websockets.asyncio.client import ClientConnection, connect

from fdes.cockpit.hub import RATE, Hub, Percentiles, percentiles

INPUT = struct.Struct("<BBHIdffff")
HEADER = struct.Struct("<BBHIdIId")
LOADING = 5.0  # s of flying that page loads are in the middle of
FRAME_RATE = 60  # Hz, and so often a page sends its stick
GOLDEN = 0.618034  # of a frame from one pilot's rhythm to the next one's: however many there are, they spread evenly


class Row(NamedTuple):
    """One measured figure beside its demand."""

    figure: str
    measured: str
    demand: str


def main(argv: list[str] | None = None) -> list[Row]:
    """Measure, print the table, and return it."""
    options = argparse.ArgumentParser(description="How well the cockpit keeps time.")
    options.add_argument("--pilots", type=int, default=30)
    options.add_argument("--seconds", type=float, default=15.0, help="length of each measurement")
    options.add_argument("--loads", type=int, default=30, help="page loads at once, while all pilots fly")
    options.add_argument("--plant", default="linear", help="linear or nonlinear")
    chosen = options.parse_args(argv)
    with tempfile.TemporaryDirectory() as data, cockpit(Path(data), chosen.plant) as (url, listening_after):
        busy = os.getloadavg()[0] if hasattr(os, "getloadavg") else math.nan
        rows = [Row("load of the computer at the start", f"{busy:.1f}", "0")]
        rows += [Row("fdes fly to listening", f"{listening_after:.2f} s", "1 s")]
        rows += asyncio.run(measure(url, chosen.pilots, chosen.seconds, chosen.loads))
    width = [max(len(row[i]) for row in rows) for i in range(3)]
    for row in (Row("figure", "measured", "demand"), *rows):
        print("  ".join(text.ljust(w) for text, w in zip(row, width, strict=True)).rstrip())
    return rows


@contextlib.contextmanager
def cockpit(data: Path, plant: str = "linear") -> Iterator[tuple[str, float]]:
    """A cockpit in a process of its own: its address, and how long [s] it took until it listened."""
    command = shutil.which("fdes", path=str(Path(sys.executable).parent)) or "fdes"
    began = time.perf_counter()
    with subprocess.Popen(
        [command, "fly", "--no-browser", "--port", "0", "--json", "--plant", plant, "--data", str(data)],
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout
        url = json.loads(process.stdout.readline())["url"]
        try:
            yield url, time.perf_counter() - began
        finally:
            process.terminate()


async def measure(url: str, pilots: int, seconds: float, loads: int) -> list[Row]:
    """All figures, one situation after the other."""
    async with flying(url, 1, seconds) as flight:
        alone = await watch(url, seconds)
        delays = flight.delays
    async with flying(url, pilots, seconds):
        crowd, idle = await asyncio.gather(watch(url, seconds), beside(seconds))
        _, during = await asyncio.gather(reload_pages(url, loads, LOADING), watch(url, LOADING))
    return [
        Row(
            "stick sent to frame received, 1 pilot, p50 / p99",
            f"{at(delays, 0.5):.1f} / {at(delays, 0.99):.1f} ms",
            "-",
        ),
        *lateness("1 pilot", alone, "1 ms"),
        *lateness(f"{pilots} pilots", crowd, "1 ms"),
        Row(
            "lateness of a process beside it that only ticks, p50 / p99",
            f"{1e3 * idle.p50:.2f} / {1e3 * idle.p99:.2f} ms",
            "-",
        ),
        *lateness(f"{pilots} pilots, {loads} page loads at once", during, "5 ms"),
        Row("ticks the machine gave up (slips)", str(during["slips"]), "0"),
        Row(f"CPU, {pilots} pilots, all recording", f"{100.0 * crowd['cpu_share']:.0f} % of a core", "25 %"),
        Row("CPU, 1 pilot", f"{100.0 * alone['cpu_share']:.0f} % of a core", "-"),
    ]


def lateness(who: str, stats: dict[str, Any], demand: str) -> list[Row]:
    """What the server said of its ticks."""
    late, busy, hand = stats["lateness_ms"], stats["busy_ms"], stats["handover_ms"]
    return [
        Row(f"tick lateness, {who}, p50 / p99", f"{late['p50']:.2f} / {late['p99']:.2f} ms", demand),
        Row(f"tick work, {who}, p50 / p99", f"{busy['p50']:.2f} / {busy['p99']:.2f} ms", "-"),
        Row(f"frame to event loop, {who}, p50 / p99", f"{hand['p50']:.2f} / {hand['p99']:.2f} ms", "-"),
    ]


class Flight:
    """Pilots who stir the stick, and how long [ms] each of their inputs took to come back in a frame."""

    def __init__(self) -> None:
        self.delays: list[float] = []

    async def pilot(self, url: str, number: int, until: asyncio.Event) -> None:
        """Fly one session, sending the stick as often as a page does."""
        async with connect(f"{url.replace('http', 'ws')}/ws/bench{number}", compression=None) as socket:
            trim = json.loads(await socket.recv())["aircraft"]["trim_throttle"]
            reading = asyncio.create_task(self.read(socket))
            sequence = 0
            due = time.perf_counter() + number * GOLDEN % 1.0 / FRAME_RATE
            while not until.is_set():
                sequence += 1
                t = sequence / FRAME_RATE
                roll, pitch = 0.2 * math.sin(2.0 * t + number), 0.02 * math.sin(t)
                await socket.send(INPUT.pack(2, 1, 0, sequence, 1e3 * time.perf_counter(), pitch, roll, 0.0, trim))
                due += 1.0 / FRAME_RATE
                await asyncio.sleep(due - time.perf_counter())
            reading.cancel()

    async def read(self, socket: ClientConnection) -> None:
        """Take frames; note the delay of each input the first time it comes back."""
        newest = 0
        async for message in socket:
            if isinstance(message, bytes):
                *_, echoed, _, stamp = HEADER.unpack_from(message)
                if echoed > newest:
                    newest = echoed
                    self.delays.append(1e3 * time.perf_counter() - stamp)


@contextlib.asynccontextmanager
async def flying(url: str, pilots: int, settle: float) -> AsyncIterator[Flight]:
    """So many pilots in the air, once they have settled."""
    flight, until = Flight(), asyncio.Event()
    tasks = [asyncio.create_task(flight.pilot(url, number, until)) for number in range(pilots)]
    await asyncio.sleep(min(3.0, settle))
    flight.delays.clear()
    yield flight
    until.set()
    await asyncio.gather(*tasks)


async def watch(url: str, seconds: float) -> dict[str, Any]:
    """The server's own figures over `seconds`, and the share of a core that it took."""

    def stats() -> dict[str, Any]:
        with urlopen(f"{url}/api/stats?seconds={seconds}") as answer:
            return dict(json.load(answer))

    before = await asyncio.to_thread(stats)
    await asyncio.sleep(seconds)
    after = await asyncio.to_thread(stats)
    return after | {"cpu_share": (after["cpu_s"] - before["cpu_s"]) / (after["wall_s"] - before["wall_s"])}


async def beside(seconds: float) -> Percentiles:
    """How late the ticks of a hub without sessions are, in a process of its own."""
    with ProcessPoolExecutor(1, get_context("spawn")) as process:
        return await asyncio.get_running_loop().run_in_executor(process, tick_alone, seconds)


def tick_alone(seconds: float) -> Percentiles:
    """The lateness of a hub that has nothing to do."""
    hub: Hub[Any] = Hub()
    threading.Timer(seconds, hub.stop).start()
    hub.run(lambda _: None)
    return percentiles(hub.lateness.last(int(RATE * seconds)))


async def reload_pages(url: str, loads: int, seconds: float) -> None:
    """So many browsers that load the page and all of its files at once, in the middle of `seconds`."""
    here = files("fdes.cockpit")
    paths = ["/", "/api/aircraft", "/api/recordings"]
    paths += [
        f"/{folder}/{f.name}" for folder in ("page", "instruments") for f in (here / folder).iterdir() if f.is_file()
    ]
    await asyncio.sleep(0.4 * seconds)
    await asyncio.gather(*[load(url, paths) for _ in range(loads)])


async def load(url: str, paths: list[str]) -> None:
    """All files, one after the other on one connection."""
    server = urlsplit(url)
    reader, writer = await asyncio.open_connection(server.hostname, server.port)
    for path in paths:
        writer.write(f"GET {path} HTTP/1.1\r\nHost: {server.netloc}\r\nAccept-Encoding: gzip\r\n\r\n".encode())
        head = (await reader.readuntil(b"\r\n\r\n")).lower()
        if not head.startswith(b"http/1.1 200"):
            raise RuntimeError(f"{path}: {head[:60]!r}")
        await reader.readexactly(int(head.partition(b"content-length: ")[2].split(b"\r\n")[0]))
    writer.close()


def at(values: list[float], share: float) -> float:
    """The value below which that share lies."""
    return sorted(values)[int(share * len(values))] if values else math.nan


if __name__ == "__main__":
    main()
