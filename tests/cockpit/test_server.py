"""The server without a page: what it answers, what it refuses, and what it survives."""

import json
import math
import socket
import struct
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any, Self

import httpx
import pytest
import uvicorn
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from fdes.aircraft import load
from fdes.cockpit import cabins as cabins_module
from fdes.cockpit import wire
from fdes.cockpit.cabins import Cabins
from fdes.cockpit.fleet import Fleet
from fdes.cockpit.serve import Server, listening, url_of
from fdes.cockpit.server import application
from fdes.errors import SpecError
from fdes.flight import list_recordings, open_recording

PATIENCE = 20.0  # s: how long anything may take on a busy computer
NAMES = [c.name for c in wire.CHANNELS]


class Served:
    """A server in a thread of this process."""

    def __init__(self, recordings: Path) -> None:
        self.cabins = Cabins(Fleet(load("A-4D"), None, "corrected", "full", "rk4"), recordings)
        listener = listening("127.0.0.1", 0)
        self.url = url_of(listener)
        ready = threading.Event()
        config = uvicorn.Config(
            application(self.cabins),
            log_config=None,
            log_level="warning",
            ws_max_size=1 << 16,
            timeout_graceful_shutdown=1,
        )
        self._server = Server(config, self.cabins, ready.set)
        self._thread = threading.Thread(target=self._server.run, args=([listener],))
        self._thread.start()
        assert ready.wait(PATIENCE)

    def stop(self) -> None:
        self._server.should_exit = True
        self._thread.join(PATIENCE)
        assert not self._thread.is_alive()


@pytest.fixture
def recordings(tmp_path: Path) -> Path:
    folder = tmp_path / "recordings"
    folder.mkdir()
    return folder


@pytest.fixture
def served(recordings: Path) -> Iterator[Served]:
    running = Served(recordings)
    yield running
    running.stop()


class Client:
    """Someone at a page: what it is told, and what it says."""

    def __init__(self, url: str, session: str = "test", **options: Any) -> None:
        self._connecting = connect(f"{url.replace('http', 'ws')}/ws/{session}", close_timeout=0.2, **options)
        self.texts: list[dict[str, Any]] = []
        self.passed: list[dict[str, Any]] = []
        self.number = 0

    def __enter__(self) -> Self:
        self.socket: ClientConnection = self._connecting.__enter__()
        self.hello = self.text("hello", "error")
        return self

    def __exit__(self, *_: object) -> None:
        self._connecting.__exit__(None, None, None)

    def messages(self) -> Iterator[str | bytes]:
        """All that comes, for as long as is reasonable."""
        ends = time.monotonic() + PATIENCE
        while time.monotonic() < ends:
            yield self.socket.recv(PATIENCE)
        raise AssertionError(f"what was waited for did not come, but {self.texts[-5:]}")

    def text(self, *kinds: str, where: Callable[[dict[str, Any]], bool] = lambda _: True) -> dict[str, Any]:
        """The next text of one of these kinds; what came while a frame was waited for counts, but for a status."""
        for i, said in enumerate(self.passed):
            if said["type"] in kinds and where(said):
                return self.passed.pop(i)
        for message in self.messages():
            if isinstance(message, str):
                said = self.note(message)
                if said["type"] in kinds and where(said):
                    return said
                if said["type"] in {"aircraft", "modes"}:
                    self.passed.append(said)
        raise AssertionError

    def note(self, message: str) -> dict[str, Any]:
        said: dict[str, Any] = json.loads(message)
        self.texts.append(said)
        return said

    def status(self, where: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        return self.text("status", where=where)

    def frame(self, where: Callable[["Frame"], bool] = lambda _: True) -> "Frame":
        """The next state frame of that sort."""
        for message in self.messages():
            if isinstance(message, str):
                if (said := self.note(message))["type"] != "status":
                    self.passed.append(said)
            elif where(frame := Frame(message)):
                return frame
        raise AssertionError

    def command(self, name: str, **said: Any) -> dict[str, Any]:
        """Give a command, and wait for its reply."""
        self.number += 1
        number = self.number
        self.socket.send(json.dumps({"type": "command", "version": 1, "id": number, "name": name, **said}))
        return self.text("reply", where=lambda reply: reply["id"] == number)

    def stick(self, pitch: float = 0.0, roll: float = 0.0, yaw: float = 0.0, throttle: float = 0.24) -> None:
        self.number += 1
        self.socket.send(struct.pack("<BBHIdffff", 2, 1, 0, self.number, 1e3 * time.time(), pitch, roll, yaw, throttle))


class Frame:
    """A state frame taken apart."""

    def __init__(self, data: bytes) -> None:
        kind, version, self.flags, self.sequence, self.t, self.echo, zero, self.stamp = struct.unpack_from(
            "<BBHIdIId", data
        )
        assert (kind, version, zero) == (1, 1, 0)
        assert len(data) == 32 + 4 * len(NAMES)
        self.values = dict(zip(NAMES, struct.unpack_from(f"<{len(NAMES)}f", data, 32), strict=True))

    def __getitem__(self, name: str) -> float:
        return self.values[name]


def flying(frame: Frame) -> bool:
    return not frame.flags & wire.FROZEN


def frozen(frame: Frame) -> bool:
    return bool(frame.flags & wire.FROZEN)


def eventually(holds: Callable[[], bool]) -> None:
    ends = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < ends, "it did not come true"
        time.sleep(0.02)


def test_hello_tells_everything_a_page_needs(served: Served) -> None:
    with Client(served.url) as pilot:
        hello = pilot.hello
        assert (hello["version"], hello["session"], hello["role"], hello["rate"], hello["frame_rate"]) == (
            1,
            "test",
            "pilot",
            120,
            60,
        )
        assert [c["name"] for c in hello["channels"]] == NAMES
        assert {c["name"]: c["unit"] for c in hello["channels"]}["theta"] == "rad"
        aircraft = hello["aircraft"]
        assert (aircraft["id"], aircraft["condition"], aircraft["variant"]) == ("A-4D", "M0.4_SL", "corrected")
        assert (aircraft["form"], aircraft["integrator"]) == ("full", "rk4")
        assert aircraft["condition_name"] == "M 0.40, sea level"
        assert aircraft["h"] == pytest.approx(1500 * 0.3048)
        assert aircraft["full_stick"]["elevator"] < 0.0 < aircraft["full_stick"]["aileron"]
        assert {"name", "value", "unit", "reason"} <= aircraft["assumed"][0].keys()
        names = {mode["name"] for mode in hello["modes"]["modes"]}
        assert names == {"short_period", "phugoid", "roll", "dutch_roll", "spiral"}
        assert hello["status"]["frozen"] is False
        assert hello["status"]["viewers"] == 1


def test_a_fresh_session_flies_at_the_pace_of_the_clock(served: Served) -> None:
    with Client(served.url) as pilot:
        first = pilot.frame()
        began = time.monotonic()
        last = pilot.frame(lambda f: f.t > first.t + 1.0)
        assert time.monotonic() - began == pytest.approx(last.t - first.t, abs=0.5)
        assert last["V"] == pytest.approx(pilot.hello["aircraft"]["V"], abs=1e-3)
        assert last["h"] == pytest.approx(1500 * 0.3048, abs=0.1)


def test_the_stick_moves_the_aircraft_and_its_stamp_comes_back(served: Served) -> None:
    with Client(served.url) as pilot:
        pilot.stick(roll=0.5)
        echoed = pilot.frame(lambda f: f.echo == 1)
        assert echoed["stick_roll"] == 0.5
        assert echoed.stamp == pytest.approx(1e3 * time.time(), abs=1e4)
        assert pilot.frame(lambda f: f["phi"] > 0.05)["p"] > 0.0


def test_freeze_step_and_go_on(served: Served) -> None:
    with Client(served.url) as pilot:
        assert pilot.command("freeze", value=True)["ok"]
        still = pilot.frame(frozen)
        assert pilot.frame(frozen).t == still.t
        assert pilot.command("step")["ok"]
        assert pilot.frame(lambda f: f.t > still.t).t == pytest.approx(still.t + 1 / 120)
        assert pilot.command("freeze", value=False)["ok"]
        pilot.frame(lambda f: f.t > still.t + 0.2 and flying(f))


def test_reset_is_seen_while_frozen_too(served: Served) -> None:
    with Client(served.url) as pilot:
        pilot.stick(pitch=0.5, roll=0.5)
        pilot.frame(lambda f: f["phi"] > 0.2)
        pilot.command("freeze", value=True)
        pilot.stick()
        pilot.command("reset")
        back = pilot.frame(lambda f: f["phi"] == 0.0)
        assert frozen(back)
        assert back["theta"] == pytest.approx(pilot.hello["aircraft"]["theta_trim"])


def test_the_ground_ends_a_flight_and_reset_begins_another(served: Served) -> None:
    first = served.cabins.fleet.first
    served.cabins.fleet.first = replace(first, start=first.start._replace(h=60.0))
    with Client(served.url) as pilot:
        pilot.stick(pitch=-1.0)
        ended = pilot.frame(lambda f: bool(f.flags & wire.ENDED))
        assert frozen(ended)
        assert ended["h"] <= 0.0
        status = pilot.status(lambda s: s["notice"] is not None)
        assert status["notice"] == "You met the ground. Press R to start again."
        assert pilot.command("freeze", value=False)["error"] == "The flight has ended. Press R to start again."
        pilot.stick()
        assert pilot.command("reset")["ok"]
        again = pilot.frame(lambda f: flying(f) and not f.flags & wire.ENDED)
        assert again["h"] > 40.0
        assert pilot.status(lambda s: s["notice"] is None)["recording"] is None


def test_a_fault_in_one_session_freezes_it_and_no_other(served: Served, caplog: pytest.LogCaptureFixture) -> None:
    with Client(served.url, "sound") as sound, Client(served.url, "broken") as broken:
        session = served.cabins.cabins["broken"].session

        def fault(*_: object) -> None:
            raise ZeroDivisionError("planted")

        session._sortie.advance = fault  # type: ignore[method-assign]
        ended = broken.frame(lambda f: bool(f.flags & wire.ENDED))
        assert frozen(ended)
        notice = broken.status(lambda s: s["notice"] is not None)["notice"]
        assert notice.startswith("A fault in FDES stopped the flight (ZeroDivisionError: planted): please report it.")
        t = sound.frame().t
        sound.frame(lambda f: f.t > t + 0.3)
        assert broken.command("reset")["ok"]
        broken.frame(flying)
    assert "a session failed" in caplog.text


def test_choosing_an_aircraft_tells_everybody(served: Served) -> None:
    with Client(served.url) as pilot, Client(served.url) as observer:
        assert observer.hello["role"] == "observer"
        assert pilot.command("aircraft", aircraft="NAVION", condition=None, variant="printed")["ok"]
        for viewer in (pilot, observer):
            told = viewer.text("aircraft")
            assert (told["id"], told["condition"], told["variant"]) == ("NAVION", "M0.158_SL", "printed")
            assert viewer.text("modes")["modes"]
        assert pilot.frame(lambda f: f["V"] < 60.0)["V"] == pytest.approx(told["V"])


def test_commands_that_cannot_be_obeyed_are_answered_with_a_sentence(served: Served) -> None:
    with Client(served.url) as pilot:
        refused: list[tuple[dict[str, Any], str]] = [
            ({"name": "frieze"}, "There is no command 'frieze'. Did you mean 'freeze'?"),
            ({"name": "freeze"}, "The command 'freeze' needs 'value'."),
            ({"name": "aircraft", "aircraft": "NAVYON"}, "There is no aircraft named 'NAVYON'. Did you mean 'NAVION'?"),
            ({"name": "aircraft", "aircraft": "../../etc/passwd"}, "There is no aircraft named"),
            ({"name": "aircraft", "aircraft": "/srv/mine.toml"}, "There is no aircraft named"),
            (
                {"name": "aircraft", "aircraft": "A-4D", "condition": "M9"},
                "There is no flight condition of the A-4D named 'M9'",
            ),
            ({"name": "aircraft", "aircraft": "A-4D", "variant": "nicer"}, "There is no variant named 'nicer'"),
            ({"name": "replay", "recording": "none"}, "There is no recording named 'none'."),
            ({"name": "seek", "t": 1.0}, "No recording is being replayed."),
            ({"name": "stop_replay"}, "No recording is being replayed."),
            ({"name": "record", "value": False}, "Nothing is being recorded."),
        ]
        for said, words in refused:
            reply = pilot.command(**said)
            assert not reply["ok"]
            assert reply["error"].startswith(words)
        assert pilot.command("ping")["ok"]


def test_an_observer_watches_and_touches_nothing(served: Served) -> None:
    with Client(served.url) as pilot, Client(served.url) as observer:
        assert observer.frame()["V"] > 0.0
        assert "observing" in observer.command("reset")["error"]
        observer.stick(roll=1.0)
        assert "observing" in observer.text("error")["error"]
        assert observer.command("ping")["ok"]
        assert pilot.status(lambda s: s["viewers"] == 2)


def test_the_seat_of_a_pilot_who_left_is_for_the_next_to_come(served: Served) -> None:
    with Client(served.url) as pilot, Client(served.url) as observer:
        pilot.stick(roll=1.0, throttle=0.7)
        observer.frame(lambda f: f["stick_roll"] == 1.0)
        pilot.socket.close()
        hands_off = observer.frame(lambda f: f["stick_roll"] == 0.0)
        assert hands_off["stick_throttle"] == pytest.approx(0.7)
        assert "The pilot has left this session" in observer.command("reset")["error"]
        with Client(served.url) as next_pilot:
            assert next_pilot.hello["role"] == "pilot"
            assert next_pilot.command("reset")["ok"]


def test_a_reload_finds_the_flight_where_it_was(served: Served) -> None:
    with Client(served.url) as before:
        left = before.frame(lambda f: f.t > 0.5)
    eventually(lambda: not served.cabins.cabins["test"].viewers)
    time.sleep(0.5)
    with Client(served.url) as after:
        assert after.hello["role"] == "pilot"
        assert left.t <= after.frame().t < left.t + 0.45


def test_an_empty_session_ends_after_a_grace(served: Served, monkeypatch: pytest.MonkeyPatch, recordings: Path) -> None:
    monkeypatch.setattr(cabins_module, "GRACE", 0.1)
    with Client(served.url) as pilot:
        pilot.stick(roll=0.1)
        pilot.status(lambda s: s["recording"])
    eventually(lambda: not served.cabins.cabins and not served.cabins.hub.sessions)
    eventually(lambda: open_recording(next(recordings.iterdir())).complete)


def test_first_movement_is_recorded_and_comes_back_in_every_form(served: Served, recordings: Path) -> None:
    with Client(served.url) as pilot:
        pilot.stick(throttle=pilot.hello["aircraft"]["trim_throttle"])
        pilot.frame(lambda f: f.echo == 1)
        assert list(recordings.iterdir()) == []
        pilot.stick(roll=0.3)
        name = pilot.status(lambda s: s["recording"])["recording"]["name"]
        pilot.frame(lambda f: bool(f.flags & wire.RECORDING))
        pilot.frame(lambda f: f["phi"] > 0.3)
        assert "is being recorded" in pilot.command("record", value=True)["error"]
        assert pilot.command("record", value=False)["recording"] == name
        pilot.stick(roll=-0.3)
        pilot.frame(lambda f: f["phi"] < 0.0 and not f.flags & wire.RECORDING)
    eventually(lambda: open_recording(recordings / f"{name}.fdes").complete)
    with httpx.Client(base_url=served.url) as http:
        (listed,) = http.get("/api/recordings").json()
        assert (listed["name"], listed["aircraft"], listed["condition"]) == (name, "A-4D", "M0.4_SL")
        assert (listed["condition_name"], listed["plant"], listed["law"]) == ("Mach 0.4, sea level", "linear", "direct")
        assert listed["bytes"] == (recordings / f"{name}.fdes").stat().st_size
        csv = http.get(f"/api/recordings/{name}.csv")
        assert f'filename="{name}.csv"' in csv.headers["content-disposition"]
        head, *lines = csv.text.splitlines()
        recording = open_recording(recordings / f"{name}.fdes")
        assert head.startswith("t [s],V [m/s]")
        assert len(lines) == len(recording.data) > 30
        assert [float(v) for v in lines[-1].split(",")] == pytest.approx(recording.data[-1])
        assert http.get(f"/api/recordings/{name}.fdes").content == (recordings / f"{name}.fdes").read_bytes()
    assert recording.header["document"]["id"] == "A-4D"
    assert recording["stick_roll"][0] == pytest.approx(0.3)


def test_a_recording_can_be_asked_for_and_each_has_its_name(served: Served, recordings: Path) -> None:
    with Client(served.url) as pilot:
        names = []
        for _ in range(3):
            names.append(pilot.command("record", value=True)["recording"])
            assert pilot.command("record", value=False)["recording"] == names[-1]
        assert len(set(names)) == 3
        eventually(lambda: {r.name for r in list_recordings(recordings)} == set(names))


def record_a_turn(url: str, recordings: Path, seconds: float = 1.0) -> str:
    with Client(url, "recorded") as pilot:
        pilot.command("aircraft", aircraft="NAVION")
        pilot.stick(roll=0.4)
        name = str(pilot.status(lambda s: s["recording"])["recording"]["name"])
        began = pilot.frame().t
        pilot.frame(lambda f: f.t > began + seconds)
        pilot.command("record", value=False)
    eventually(lambda: open_recording(recordings / f"{name}.fdes").complete)
    return name


def test_replay_seek_and_back_to_the_flight(served: Served, recordings: Path) -> None:
    name = record_a_turn(served.url, recordings)
    flown = open_recording(recordings / f"{name}.fdes")
    with Client(served.url) as pilot:
        flight = pilot.frame(lambda f: f.t > 0.1)
        assert pilot.command("replay", recording=name)["ok"]
        shown = pilot.frame(lambda f: bool(f.flags & wire.REPLAY) and f.t > 0.3)
        row = round(shown.t * 120)
        assert shown["phi"] == pytest.approx(flown["phi"][row], abs=0.02)
        assert pilot.text("aircraft")["id"] == "NAVION"
        assert pilot.status(lambda s: s["replay"])["replay"]["name"] == name
        at_end = pilot.frame(lambda f: bool(f.flags & wire.REPLAY) and frozen(f))
        assert at_end["phi"] == pytest.approx(flown["phi"][-1], rel=1e-6)
        assert at_end.t == pytest.approx(flown["t"][-1] - flown["t"][0])
        assert pilot.command("seek", t=0.5)["ok"]
        assert pilot.frame(lambda f: abs(f.t - 0.5) < 1e-9)["phi"] == pytest.approx(flown["phi"][60], rel=1e-6)
        assert pilot.command("freeze", value=False)["ok"]
        pilot.frame(lambda f: f.t > 0.6 and flying(f))
        assert pilot.command("stop_replay")["ok"]
        back = pilot.frame(lambda f: not f.flags & wire.REPLAY)
        assert frozen(back)
        assert back.t < flight.t + 1.0
        assert back["V"] > 100.0
        assert pilot.text("aircraft")["id"] == "A-4D"
        assert pilot.command("freeze", value=False)["ok"]
        pilot.frame(flying)


def test_reset_leaves_a_replay(served: Served, recordings: Path) -> None:
    name = record_a_turn(served.url, recordings, 0.2)
    with Client(served.url) as pilot:
        pilot.command("replay", recording=name)
        pilot.frame(lambda f: bool(f.flags & wire.REPLAY))
        pilot.command("reset")
        back = pilot.frame(lambda f: not f.flags & wire.REPLAY)
        assert not frozen(back)


def test_a_recording_without_frames_says_so(served: Served, recordings: Path) -> None:
    with Client(served.url) as pilot:
        pilot.command("freeze", value=True)
        name = pilot.command("record", value=True)["recording"]
        assert "holds no frames" in pilot.command("replay", recording=name)["error"]
        (recordings / "noise.fdes").write_bytes(b"nothing of ours")
        assert "is not an FDES recording" in pilot.command("replay", recording="noise")["error"]
        assert httpx.get(f"{served.url}/api/recordings/noise.csv").status_code == 400


@pytest.mark.parametrize(
    "path",
    [
        "/api/recordings/none.csv",
        "/api/recordings/..%2Fsecret.fdes",
        "/api/recordings/../secret.fdes",
        "/api/recordings/%2e%2e%2fsecret.csv",
        "/page/../server.py",
        "/page/..%2fserver.py",
        "/page/%2e%2e/server.py",
        "/page/%00",
        "/page/" + "x" * 3000,
        "/page//etc/passwd",
        "/page/",
        "/instruments/none.js",
        "/nowhere",
    ],
)
def test_nothing_else_can_be_read(served: Served, recordings: Path, path: str) -> None:
    (recordings.parent / "secret.fdes").write_bytes(b"secret")
    with socket.create_connection(
        ("127.0.0.1", int(served.url.rpartition(":")[2]))
    ) as raw:  # httpx would tidy the path
        raw.sendall(f"GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n".encode())
        answer = b"".join(iter(lambda: raw.recv(65536), b""))
    assert answer.startswith(b"HTTP/1.1 404")
    assert b"secret" not in answer.partition(b"\r\n\r\n")[2].replace(b"secret.fdes", b"").replace(b"'../secret'", b"")


def test_http(served: Served) -> None:
    with httpx.Client(base_url=served.url) as http:
        page = http.get("/")
        assert page.headers["content-type"] == "text/html; charset=utf-8"
        assert page.headers["content-encoding"] == "gzip"
        assert page.headers["cache-control"] == "no-cache"
        assert "default-src 'self'" in page.headers["content-security-policy"]
        assert page.headers["x-content-type-options"] == "nosniff"
        assert http.get("/", headers={"if-none-match": page.headers["etag"]}).status_code == 304
        plain = http.get("/", headers={"accept-encoding": "identity"})
        assert "content-encoding" not in plain.headers
        assert plain.text == page.text
        assert http.get("/page/link.js").headers["content-type"] == "text/javascript; charset=utf-8"
        assert http.get("/api/version").json().keys() == {"fdes", "wire"}
        assert http.post("/api/version").status_code == 405
        pictures = http.get("/api/aircraft").json()
        assert [a["id"] for a in pictures][:3] == ["A-4D", "F-104A", "NAVION"]
        condition = pictures[0]["conditions"][0]
        assert (condition["id"], condition["mach"]) == ("M0.4_SL", 0.4)
        assert pictures[0]["three_view"]["span"] == pytest.approx(27.5 * 0.3048)
        stats = http.get("/api/stats?seconds=5").json()
        assert stats["slips"] >= 0
        assert http.get("/api/stats?seconds=soon").status_code == 400


FOREIGN = "http://evil.example"


def test_pages_of_others_are_refused(served: Served) -> None:
    port = served.url.rpartition(":")[2]
    for origin in (
        FOREIGN,
        "null",
        "http://127.0.0.1:1",
        f"https://evil.example:{port}",
        f"http://localhost.evil.example:{port}",
        "[",
    ):
        with pytest.raises(InvalidStatus) as refused:
            Client(served.url, origin=origin).__enter__()
        assert refused.value.response.status_code == 403
        assert httpx.post(served.url, headers={"origin": origin}).status_code == 403
    for origin in (f"http://127.0.0.1:{port}", f"http://localhost:{port}", f"http://[::1]:{port}"):
        with Client(served.url, origin=origin) as ours:
            assert ours.hello["version"] == 1
    assert not list(served.cabins.cabins)[1:]


def test_a_name_that_is_not_this_machine_is_refused(served: Served) -> None:
    port = served.url.rpartition(":")[2]
    for host in ("evil.example", f"evil.example:{port}", "", "["):
        assert httpx.get(served.url, headers={"host": host}).status_code in (400, 403)
    for host in ("localhost", f"LOCALHOST:{port}", f"[::1]:{port}", "127.0.0.1"):
        assert httpx.get(served.url, headers={"host": host}).status_code == 200
    with pytest.raises(InvalidStatus):
        Client(served.url, additional_headers={"Host": "evil.example"}).__enter__()


RUBBISH: list[str | bytes] = [
    "",
    "{",
    "null",
    "[" * 3000,
    '{"type": "dance"}',
    "x" * 5000,
    "\u20ac" * 3000,
    b"",
    b"\x02",
    bytes(32),
]
RUBBISH += [bytes(33), b"\xff" * 60_000, struct.pack("<BBHIdffff", 2, 1, 0, 1, 0.0, math.nan, 0, 0, 0)]


@pytest.mark.parametrize("rubbish", RUBBISH, ids=range(len(RUBBISH)))
def test_rubbish_is_answered_and_the_flight_goes_on(served: Served, rubbish: str | bytes) -> None:
    with Client(served.url) as pilot:
        pilot.socket.send(rubbish)
        assert pilot.text("error")["error"]
        t = pilot.frame().t
        pilot.frame(lambda f: f.t > t and flying(f))
        assert pilot.command("ping")["ok"]


def test_a_message_far_too_large_costs_its_sender_the_connection_alone(served: Served) -> None:
    with Client(served.url) as watcher, Client(served.url) as sender:
        sender.socket.send(b"x" * 2_000_000)
        with pytest.raises(ConnectionClosed) as closed:
            sender.frame(lambda _: False)
        assert closed.value.rcvd
        assert closed.value.rcvd.code == 1009
        assert watcher.command("ping")["ok"]


def test_a_thousand_messages_a_second_are_too_many(served: Served) -> None:
    with Client(served.url) as pilot, Client(served.url, "other") as other:
        for _ in range(1000):
            pilot.stick(roll=0.1)
        assert "More than 200 messages" in pilot.text("error")["error"]
        t = other.frame().t
        other.frame(lambda f: f.t > t + 0.5)
        time.sleep(1.1)
        assert pilot.command("ping")["ok"]
        complaints = [said for said in pilot.texts if said["type"] == "error"]
        assert len(complaints) <= 4


def test_connections_that_break_off_do_no_harm(served: Served) -> None:
    with Client(served.url) as observer:
        for _ in range(5):
            with Client(served.url, "broken") as broken:
                broken.stick(roll=1.0)
                raw = broken.socket.socket
                raw.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))  # a reset, no goodbye
                raw.close()
        with Client(served.url, "half") as half:
            half.socket.socket.shutdown(socket.SHUT_WR)
            eventually(lambda: served.cabins.viewers() == 1)
        assert observer.command("ping")["ok"]


def test_a_viewer_who_does_not_read_holds_nobody_up(served: Served) -> None:
    with Client(served.url) as pilot, Client(served.url, max_queue=1) as sleeper:
        t = pilot.frame().t
        pilot.frame(lambda f: f.t > t + 2.0)
        assert sleeper.hello["role"] == "observer"


def test_there_is_an_end_to_sessions_and_to_viewers(served: Served, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cabins_module, "MAX_SESSIONS", 2)
    monkeypatch.setattr(cabins_module, "MAX_VIEWERS", 2)

    def refusal(session: str) -> str:
        with Client(served.url, session) as late, pytest.raises(ConnectionClosed) as closed:
            late.frame(lambda _: False)
        assert closed.value.rcvd
        assert closed.value.rcvd.code == 1013
        return str(late.hello["error"])

    with ExitStack() as seats:
        seats.enter_context(Client(served.url, "one"))
        seats.enter_context(Client(served.url, "one"))
        assert refusal("one") == "2 already watch the session one, which is the limit. Open another session."
        with Client(served.url, "two"):
            assert refusal("three") == "2 sessions are open, which is the limit. Watch another, or try again later."
        assert refusal("a.b").startswith("A session's name is 1 to 40 letters")
        eventually(lambda: not served.cabins.cabins["two"].viewers)
        seats.enter_context(Client(served.url, "three"))  # in the place of one that nobody watches


def test_thirty_pilots(served: Served) -> None:
    with ExitStack() as seats:
        pilots = [seats.enter_context(Client(served.url, f"pilot{i}")) for i in range(30)]
        for pilot in pilots:
            pilot.stick(roll=0.2)
        ticks = served.cabins.hub.lateness.added
        time.sleep(3.0)
        assert served.cabins.hub.lateness.added - ticks > 250
        for pilot in pilots:
            pilot.frame(lambda f: f["phi"] > 0.1)
        assert len({id(c.session) for c in served.cabins.cabins.values()}) == 30
    eventually(lambda: served.cabins.viewers() == 0)


def test_stopping_says_goodbye_and_ends_recordings(recordings: Path) -> None:
    served = Served(recordings)
    with Client(served.url) as pilot:
        pilot.stick(roll=0.2)
        pilot.status(lambda s: s["recording"])
        began = time.monotonic()
        stopper = threading.Thread(target=served.stop)
        stopper.start()
        with pytest.raises(ConnectionClosed) as closed:
            pilot.frame(lambda _: False)
        stopper.join()
        assert time.monotonic() - began < 2.0
    assert closed.value.rcvd
    assert closed.value.rcvd.code == 1001
    eventually(lambda: open_recording(next(recordings.iterdir())).complete)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_a_killed_server_leaves_the_flight_but_for_its_last_second(serve: Callable[..., Any], tmp_path: Path) -> None:
    cockpit = serve(data=tmp_path / "kept")
    with Client(cockpit.url) as pilot:
        pilot.stick(roll=0.2)
        pilot.status(lambda s: s["recording"])
        t = pilot.frame().t
        flown = pilot.frame(lambda f: f.t > t + 2.5).t
        cockpit.process.kill()
        cockpit.process.wait()
    (listed,) = list_recordings(tmp_path / "kept" / "recordings")
    recording = open_recording(listed.path)
    assert not recording.complete
    assert recording["t"][-1] > flown - 1.2
    assert recording["phi"].max() > 0.1


def test_addresses_that_cannot_be_had_are_explained() -> None:
    with listening("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(SpecError, match=rf"^Port {port} is in use\. Use --port \d+, which is free\.$"):
            listening("127.0.0.1", port)
    with pytest.raises(SpecError, match=r"There is no host 'no\.such\.host\.invalid' here"):
        listening("no.such.host.invalid", 0)
    with pytest.raises(SpecError, match="70000 is no port"):
        listening("127.0.0.1", 70000)
    with pytest.raises(SpecError, match=r"is not an address of this machine\. Use --host 127"):
        listening("192.0.2.1", 0)
