"""Who sits in which session: joining, leaving, commands, and what everybody in it is told. All in the event loop."""

import asyncio
import contextlib
import re
from collections.abc import Coroutine
from pathlib import Path
from typing import Any

from fdes import __version__
from fdes.cockpit import commands, wire
from fdes.cockpit.answers import Question, answer
from fdes.cockpit.at_once import obey_at_once
from fdes.cockpit.cabin import Cabin
from fdes.cockpit.craft import Craft
from fdes.cockpit.excite import excite
from fdes.cockpit.experiment import experiment_of, opened
from fdes.cockpit.fleet import Fleet, craft_of
from fdes.cockpit.hub import RATE, Hub
from fdes.cockpit.laboratory import Editing, laboratory, ready, wanted
from fdes.cockpit.reflights import Reflights
from fdes.cockpit.replay import replay_of
from fdes.cockpit.session import EVERY_MOVING, Session
from fdes.cockpit.viewer import Viewer
from fdes.errors import FdesError, RecordingError, SpecError
from fdes.flight import open_recording
from fdes.flight.recorder import SUFFIX

MAX_SESSIONS = 64
MAX_VIEWERS = 16  # per session
GRACE = 10.0  # s that a session waits, standing still, for someone to come back
PARTING = 0.5  # s
LARGEST_REPLAY = 300e6  # bytes

Exciting = commands.PutIn | commands.PutInHistory | commands.Hold
Choosing = commands.ChooseAircraft | commands.Equations | commands.OpenAircraft | commands.OpenExperiment

_NAME = re.compile(r"[A-Za-z0-9_-]{1,40}")


class Cabins:
    """All sessions of a server, recording in the folder `recordings`."""

    def __init__(self, fleet: Fleet, recordings: Path, *, record: bool = True) -> None:
        self.hub: Hub[Session] = Hub()
        self.fleet, self.recordings, self.record = fleet, recordings, record
        self.cabins: dict[str, Cabin] = {}
        self.may_delete = True
        self._nobody = asyncio.Event()
        self._nobody.set()
        self._reflights = Reflights()
        self._background: set[asyncio.Task[None]] = set()

    def open(self) -> None:
        """Begin to fly. To be called in the event loop that serves the viewers."""
        self._loop = asyncio.get_running_loop()
        self.hub.start(self._loop, self._show)

    async def dismiss(self) -> None:
        """Send everybody away; whoever has not gone within `PARTING` is left to the server."""
        for cabin in self.cabins.values():
            for viewer in cabin.viewers:
                viewer.dismiss()
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(self._nobody.wait(), PARTING)

    async def close(self) -> None:
        """Stop flying, and end every recording."""
        await asyncio.to_thread(self.hub.stop)
        for cabin in self.cabins.values():
            cabin.session.close()

    def viewers(self) -> int:
        """How many watch, in all sessions."""
        return sum(len(cabin.viewers) for cabin in self.cabins.values())

    def join(self, name: str) -> tuple[Cabin, Viewer]:
        """Take a seat: the pilot's if it is free. Raises SpecError when there is no room, or no such name can be."""
        if not _NAME.fullmatch(name):
            raise SpecError("A session's name is 1 to 40 letters, digits, hyphens and underscores.")
        cabin = self.cabins.get(name) or self._new_cabin(name)
        if len(cabin.viewers) >= MAX_VIEWERS:
            raise SpecError(
                f"{MAX_VIEWERS} already watch the session {name}, which is the limit. Open another session."
            )
        viewer = Viewer("observer" if cabin.pilot else "pilot")
        cabin.viewers.add(viewer)
        self._nobody.clear()
        cabin.pilot = cabin.pilot or viewer
        viewer.tell(**self._hello(cabin, viewer))
        for message in laboratory(cabin.session.shown, cabin.past):
            viewer.tell(**message)
        if cabin.leaving is not None:
            cabin.leaving.cancel()
            cabin.leaving = None
        cabin.session.watched = cabin.session.changed = True
        return cabin, viewer

    def leave(self, cabin: Cabin, viewer: Viewer) -> None:
        """Leave the seat. A flight without a pilot goes on hands off; without anybody it waits, then ends."""
        cabin.viewers.discard(viewer)
        if not self.viewers():
            self._nobody.set()
        cabin.session.changed = True
        if cabin.pilot is viewer:
            cabin.pilot = None
            cabin.session.let_go()
        if not cabin.viewers:
            cabin.session.watched = False
            cabin.leaving = self._loop.call_later(GRACE, self._forget, cabin)

    def stick(self, cabin: Cabin, viewer: Viewer, given: wire.Input) -> None:
        """Take an input frame. Raises SpecError when it is not the pilot's."""
        if viewer is not cabin.pilot:
            raise SpecError(_observing(cabin, "has the stick"))
        if cabin.session.put(given):
            self._later(cabin.session.start_recording)

    async def obey(self, cabin: Cabin, viewer: Viewer, command: commands.Command) -> dict[str, Any]:
        """Carry out a command; what the reply says besides "ok". Raises FdesError when it cannot be."""
        if isinstance(command, Question):
            return await asyncio.to_thread(answer, command, cabin.session.shown)
        if viewer is not cabin.pilot:
            raise SpecError(_observing(cabin, "gives the commands"))
        session = cabin.session
        match command:
            case commands.Record(begin):
                work = session.start_recording if begin else session.stop_recording
                return {"recording": await asyncio.to_thread(work)}
            case commands.Share():
                said = (session.flown, self.fleet, cabin.given(), session.held)
                return {"experiment": await asyncio.to_thread(experiment_of, *said)}
            case commands.ChooseAircraft() | commands.Equations() | commands.OpenAircraft() | commands.OpenExperiment():
                await self._fly(cabin, command)
            case _ if isinstance(command, Editing):
                await self._edit(cabin, command)
            case _ if isinstance(command, Exciting):
                self._excite(cabin, command)
            case commands.Delete() | commands.WhatIf() | commands.PlayBack():
                await self._with_recording(cabin, command)
            case _:
                obey_at_once(session, command)
                cabin.remember(command)
        return {}

    async def _fly(self, cabin: Cabin, command: Choosing) -> None:
        """Begin another flight; an experiment brings its inputs along."""
        if isinstance(command, commands.OpenExperiment):
            craft, experiment = await asyncio.to_thread(opened, command.text, self.fleet)
            cabin.fly(craft)
            for again in experiment.put_in():
                self._excite(cabin, again)
        else:
            cabin.fly(await asyncio.to_thread(self._craft, cabin.session.flown, command))

    def _excite(self, cabin: Cabin, command: Exciting) -> None:
        """Put something in, and remember it as part of the experiment."""
        if excite(cabin.session, command):
            self._later(cabin.session.start_recording)
        cabin.remember(command)

    async def _edit(self, cabin: Cabin, command: Editing) -> None:
        """Change what flies, and tell at once. The work is done in a thread: it never costs a tick."""
        flown, past = cabin.session.flown, cabin.past
        asked = wanted(command, flown, past)
        if cabin.session.edit(await asyncio.to_thread(ready, flown, asked)):
            self._later(cabin.session.start_recording)
        match command:
            case commands.Edit(dragging=dragging):
                past.note(flown.changes, dragging=dragging)
            case commands.Undo():
                past.undone(flown.changes)
            case commands.Redo():
                past.redone(flown.changes)
        self._tell_how_it_stands(cabin)

    def recording(self, name: str) -> Path:
        """The file of a recording. Only a name that the folder lists is one: nothing else is ever looked for."""
        for path in self.recordings.glob(f"*{SUFFIX}"):
            if path.stem == name:
                return path
        raise RecordingError(f"There is no recording named {name[:80]!r}.")

    def _craft(
        self, flown: Craft, asked: commands.ChooseAircraft | commands.Equations | commands.OpenAircraft
    ) -> Craft:
        match asked:
            case commands.Equations(form, integrator, step):
                return flown.but(form=form, integrator=integrator, step=step)
            case commands.OpenAircraft(text):
                return self.fleet.opened(text, flown)
            case commands.ChooseAircraft(aircraft, condition, variant):
                return self.fleet.craft(aircraft, condition, variant, flown)

    def _delete(self, name: str) -> None:
        if not self.may_delete:
            raise SpecError("This server is open to the network, where nobody may delete what others recorded.")
        path = self.recording(name)
        if any(name == cabin.session.recording_name() for cabin in self.cabins.values()):
            raise RecordingError(f"{name} is being recorded. End it first.")
        path.unlink(missing_ok=True)

    def status(self, cabin: Cabin) -> dict[str, Any]:
        """The wire's STATUS."""
        return {
            "type": "status",
            **cabin.session.status(),
            "real_time_factor": self.hub.real_time_factor(),
            "lateness_p99_ms": round(1e3 * self.hub.lateness_p99(), 3),
            "slips": self.hub.slips,
            "viewers": len(cabin.viewers),
        }

    def _new_cabin(self, name: str) -> Cabin:
        if len(self.cabins) >= MAX_SESSIONS:
            empty = next((c for c in self.cabins.values() if not c.viewers), None)
            if empty is None:
                raise SpecError(
                    f"{MAX_SESSIONS} sessions are open, which is the limit. Watch another, or try again later."
                )
            self._forget(empty)
        session = Session(name, self.fleet.first, self.recordings, record=self.record)
        cabin = self.cabins[name] = Cabin(session, session.shown)
        self.hub.sessions[name] = session
        return cabin

    def _forget(self, cabin: Cabin) -> None:
        if cabin.leaving is not None:
            cabin.leaving.cancel()
        del self.cabins[cabin.session.name], self.hub.sessions[cabin.session.name]
        cabin.session.close()

    def _later(self, work: Any) -> None:
        """Do `work`, which waits for a disk, in a thread. What goes wrong is the session's notice."""

        async def quietly() -> None:
            with contextlib.suppress(FdesError):
                await asyncio.to_thread(work)

        self._begin(quietly())

    def _begin(self, work: Coroutine[Any, Any, None]) -> None:
        task = self._loop.create_task(work)
        self._background.add(task)
        task.add_done_callback(self._background.discard)

    async def _with_recording(
        self, cabin: Cabin, command: commands.Delete | commands.WhatIf | commands.PlayBack
    ) -> None:
        match command:
            case commands.Delete(name):
                await asyncio.to_thread(self._delete, name)
            case commands.PlayBack(name):
                await asyncio.to_thread(self._play, cabin.session, name)
            case commands.WhatIf(name, variations):
                await self._what_if(cabin, name, variations)

    async def _what_if(self, cabin: Cabin, name: str, variations: tuple[str, ...]) -> None:
        """Begin to fly a recording again; what comes of it is told to everybody in the cabin when it has."""
        path = await asyncio.to_thread(lambda: self.recording(name).resolve())
        self._reflights.must_be_possible(variations)

        async def flown() -> None:
            came: dict[str, Any] = {"flown": [], "error": None}
            try:
                came["flown"] = await self._reflights.fly(path, variations)
            except FdesError as no:
                came["error"] = str(no)
            for viewer in cabin.viewers:
                viewer.tell(type="what_if", recording=name, **came)

        self._begin(flown())

    def _play(self, session: Session, name: str) -> None:
        path = self.recording(name)
        size = path.stat().st_size
        if size > LARGEST_REPLAY:
            limit = f"{LARGEST_REPLAY / 1e6:.0f} MB"
            raise RecordingError(
                f"{name} has {size / 1e6:.0f} MB; the cockpit replays up to {limit}. Download it instead."
            )
        replay = replay_of(name, open_recording(path))
        session.play(replay, craft_of(name, replay.header))

    def _show(self, shown: list[tuple[Session, bytes | None]]) -> None:
        """Hand on what a tick of the hub has to show."""
        for session, frame in shown:
            cabin = self.cabins.get(session.name)
            if cabin is None or cabin.session is not session:
                continue
            if frame is not None:
                for viewer in cabin.viewers:
                    viewer.offer(frame)
            if session.changed:
                session.changed = False
                self._tell_how_it_stands(cabin)

    def _tell_how_it_stands(self, cabin: Cabin) -> None:
        messages, before, now = [], cabin.told, cabin.session.shown
        if now is not before:
            cabin.told = now
            messages = [{"type": "aircraft", **now.briefing}, now.modes_message]
            messages += laboratory(now, cabin.past, whole=now.base is not before.base)
        for message in (*messages, self.status(cabin)):
            for viewer in cabin.viewers:
                viewer.tell(**message)

    def _hello(self, cabin: Cabin, viewer: Viewer) -> dict[str, Any]:
        shown = cabin.session.shown
        return {
            "type": "hello",
            "version": wire.VERSION,
            "fdes": __version__,
            "session": cabin.session.name,
            "role": viewer.role,
            "channels": [c._asdict() for c in wire.CHANNELS],
            "inputs": list(wire.INPUT_CHANNELS),
            "rate": RATE,
            "frame_rate": RATE // EVERY_MOVING,
            "aircraft": shown.briefing,
            "modes": shown.modes_message,
            "status": self.status(cabin),
        }


def _observing(cabin: Cabin, does: str) -> str:
    """Why an observer may not."""
    if cabin.pilot is None:
        return "The pilot has left this session: reload the page to take the stick."
    return f"You are observing: the pilot of this session {does}."
