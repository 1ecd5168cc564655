"""What everybody in a session sees: a flight, or a recording instead of it. What a tick does, what a pilot may ask for.

The hub ticks a session from its own thread; all other calls come from elsewhere. They hold the session's lock for some
microseconds, and none waits for a disk while it does.
"""

import threading
import zlib
from math import radians
from pathlib import Path
from typing import Any

from fdes.cockpit import wire
from fdes.cockpit.craft import DT, Craft
from fdes.cockpit.hub import RATE
from fdes.cockpit.replay import Replay
from fdes.cockpit.sortie import AGAIN, Sortie, open_recorder
from fdes.control import Stick
from fdes.errors import SpecError
from fdes.flight import Excitation, Recorder
from fdes.flight.crossing import crosses

EVERY_MOVING, EVERY_STILL = 2, 12  # ticks from frame to frame on the wire: 60 Hz, and 10 Hz while nothing moves
OUTSIDE_ANGLE = radians(15.0)  # Mansor and Perumal: how far small perturbations may be believed
SLACK = 1e-9  # s: ticks and steps are sums of fractions
EXCURSION, ALPHA = ([c.name for c in wire.CHANNELS].index(name) for name in ("excursion", "alpha"))


class Session:
    """A flight that goes on while it is `watched`. `changed` says that those who watch should be told how it stands."""

    def __init__(self, name: str, craft: Craft, recordings: Path, *, record: bool = True) -> None:
        """Begin to fly `craft`. With `record`, a recording in `recordings` begins when the stick first moves."""
        self.name = name
        self.watched = False
        self.changed = True
        self._recordings, self._record = recordings, record
        self._lock = threading.Lock()
        self._sortie = Sortie(craft, Stick(throttle=craft.trim_throttle))
        self._replay: Replay | None = None
        self._replayed = craft
        self._show = True
        self._sequence = 0
        self._sent = 0  # the tick of the last frame
        self._led = False  # whether that was the first to fly an input
        self._flown_with = self._sortie.flown_with  # the input that was flown in the last tick
        self._held = False  # whether it was a replay that froze the flight
        self._owed = 0.0  # s of flight that are due: a step may be longer than a tick
        self._phase = zlib.crc32(name.encode()) % RATE  # sessions take turns in telling how they stand

    @property
    def shown(self) -> Craft:
        """The craft of which frames are sent: that of the flight, or that of the replay."""
        return self._sortie.craft if self._replay is None else self._replayed

    @property
    def flown(self) -> Craft:
        """The craft of the flight."""
        return self._sortie.craft

    @property
    def t(self) -> float:
        """The time of the flight [s]."""
        return self._sortie.frame.t

    @property
    def held(self) -> dict[str, float]:
        """What is held by hand [SI], by channel."""
        return self._sortie.held

    def recording_name(self) -> str | None:
        """The name of the recording under way."""
        recorder = self._sortie.recorder
        return None if recorder is None else recorder.path.stem

    def tick(self, number: int, late: bool) -> bytes | None:
        """One period of the hub: fly or replay one frame, unless frozen; the state frame, when one is due."""
        if not self.watched:
            return None
        with self._lock:
            moving = not self._frozen()
            if moving:
                self._go_on()
            self.changed |= (number + self._phase) % RATE == 0
            if not self._due(number, moving):
                return None
            self._sent, self._show = number, False
            return self._pack(late)

    def fail(self, trouble: Exception) -> None:
        """End the flight because of a fault that nobody foresaw."""
        with self._lock:
            self._replay = None
            self._sortie.end(
                f"A fault in FDES stopped the flight ({type(trouble).__name__}: {trouble}): please report it."
            )
            self._show = self.changed = True

    def status(self) -> dict[str, Any]:
        """How it stands: the session's part of the wire's STATUS."""
        with self._lock:
            recorder, replay = self._sortie.recorder, self._replay
            return {
                "frozen": self._frozen(),
                "recording": recorder and {"name": recorder.path.stem, "seconds": round(self._sortie.recorded, 1)},
                "replay": replay
                and {"name": replay.name, "t": round(replay.t, 3), "duration": round(replay.duration, 3)},
                "held": self._sortie.held,
                "notice": self._sortie.notice,
            }

    def put(self, given: wire.Input) -> bool:
        """Take the pilot's newest input, without waiting for a tick. True when with it a recording should begin."""
        sortie = self._sortie
        return sortie.take(given) and self._record and sortie.recorder is None

    def let_go(self) -> None:
        """Nobody holds the stick any more: it centers, and the throttle stays."""
        with self._lock:
            self._sortie.given = wire.Input(Stick(throttle=self._sortie.given.stick.throttle))

    def freeze(self) -> None:
        """Stop the flight or the replay. Raises SpecError for a flight that has ended."""
        with self._lock:
            if self._replay is not None:
                self._replay.paused = True
            else:
                self._flying().frozen = True
            self._show = self.changed = True

    def run(self) -> None:
        """Go on. Raises SpecError for a flight that has ended."""
        with self._lock:
            if self._replay is not None:
                self._replay.resume()
            else:
                self._flying().frozen = self._held = False
            self._show = self.changed = True

    def step(self) -> None:
        """One frame, then frozen. Raises SpecError for a flight that has ended."""
        with self._lock:
            if self._replay is not None:
                self._replay.paused = True
                self._replay.seek(self._replay.t + DT)
            else:
                self._flying().frozen = True
                self._sortie.advance()
            self._show = self.changed = True

    def reset(self) -> None:
        """Back to undisturbed flight; out of a replay, after one, or after the end of a flight, running."""
        with self._lock:
            if self._replay is not None or self._held:
                self._replay, self._sortie.frozen = None, self._sortie.ended
            self._held = False
            if self._sortie.ended:
                self._sortie = Sortie(self._sortie.craft, self._sortie.given.stick)
            else:
                self._sortie.reset()
            self._show = self.changed = True

    def put_in(self, given: Excitation) -> bool:
        """Begin test inputs. True when a recording should begin. Raises SpecError."""
        with self._lock:
            return self._recorded_from(self._flying().put_in(given))

    def hold(self, channel: str, value: float) -> bool:
        """Hold `value` [SI] on a channel; zero lets go. True when a recording should begin. Raises SpecError."""
        with self._lock:
            return self._recorded_from(self._flying().hold(channel, value))

    def clear_inputs(self) -> None:
        """End all test inputs, and let go of what is held."""
        with self._lock:
            self._sortie.clear_inputs()
            self._show = self.changed = True

    def disturb(self, text: str) -> None:
        """Disturb the state. Raises SpecError, NoSuchPart."""
        with self._lock:
            self._flying().disturb(text)
            self._show = self.changed = True

    def change(self, craft: Craft) -> None:
        """Fly another craft. A recording of the present one ends."""
        with self._lock:
            self._sortie.release("aircraft changed")
            self._sortie = Sortie(craft, Stick(throttle=craft.trim_throttle), placed=False)
            self._owed = 0.0
            self._replay = None
            self._show = self.changed = True

    def edit(self, craft: Craft) -> bool:
        """Fly on as `craft`, the same aircraft with other changes or another law, from the next frame on.

        True when another recording should begin: the other plant has other columns to record.
        Raises SpecError.
        """
        with self._lock:
            if self._replay is not None:
                raise SpecError("A recording is being replayed: end the replay before you edit the aircraft.")
            other = crosses(self._sortie.craft.setup.plant, craft.setup.plant)
            again = other and self._sortie.recorder is not None
            if again:
                self._sortie.release("plant switched")
            self._sortie.craft = craft
            self._show = self.changed = True
            return again

    def play(self, replay: Replay, craft: Craft | None = None) -> None:
        """Show a recording, of `craft` where that is known, and keep the flight frozen meanwhile."""
        with self._lock:
            self._replay, self._replayed = replay, craft or self._sortie.craft
            self._held = not self._sortie.frozen  # by the replay, not by the pilot
            self._sortie.frozen = True
            self._show = self.changed = True

    def seek(self, t: float) -> None:
        """Show the replay at `t` [s] after its start. Raises SpecError when there is none."""
        with self._lock:
            self._playing().seek(t)
            self._show = self.changed = True

    def stop_replay(self) -> None:
        """Back to the flight, frozen where it was. Raises SpecError when there is no replay."""
        with self._lock:
            self._playing()
            self._replay = None
            self._show = self.changed = True

    def start_recording(self) -> str:
        """Begin a recording, and return its name; waits for the disk. Raises SpecError when it cannot begin."""
        sortie = self._sortie
        if sortie.recorder is not None:
            raise SpecError(f"{sortie.recorder.path.stem} is being recorded. End it before you start another.")
        try:
            craft = sortie.craft
            recorder = open_recorder(self._recordings, craft)
        except OSError as trouble:
            why = f"{self._recordings} cannot be written ({trouble.strerror or trouble})"
            with self._lock:
                sortie.notice, self.changed = f"The flight is not recorded: {why}.", True
            raise SpecError(f"The flight is not recorded: {why}.") from trouble
        if self._record_with(recorder, sortie, craft):
            return recorder.path.stem
        recorder.close("never begun")
        recorder.path.unlink(missing_ok=True)
        raise SpecError("The flight that was to be recorded has ended meanwhile, or is being recorded already.")

    def stop_recording(self) -> str:
        """End the recording and keep it; returns its name. Raises SpecError when there is none."""
        with self._lock:
            recorder = self._sortie.recorder
            if recorder is None:
                raise SpecError("Nothing is being recorded.")
            self._sortie.release("stopped")
            self.changed = True
        return recorder.path.stem

    def close(self) -> None:
        """End the session; its recording is written to the end by a thread that the interpreter waits for."""
        with self._lock:
            self.watched = False
            self._sortie.release("session closed")

    def _recorded_from(self, first: bool) -> bool:
        """Show what was done; whether a recording should begin with it, it being the `first` of the flight."""
        self._show = self.changed = True
        return first and self._record and self._sortie.recorder is None

    def _record_with(self, recorder: Recorder, sortie: Sortie, craft: Craft) -> bool:
        """Record `sortie`, if it is still the one that is flown and is not recorded yet; the header says `craft`."""
        with self._lock:
            if sortie is not self._sortie or sortie.ended or sortie.recorder is not None:
                return False
            sortie.recorder, sortie.touched, self.changed = recorder, True, True
            sortie.announced = sortie.craft is craft  # it may have been edited while the disk was waited for
            return True

    def _go_on(self) -> None:
        recorder = self._sortie.recorder
        if self._replay is not None:
            self._replay.advance(DT)
        else:
            self._owed += DT
            while self._owed >= self._sortie.craft.clock.dt - SLACK and not self._sortie.frozen:
                self._owed -= self._sortie.craft.clock.dt
                self._sortie.advance()
        if self._frozen() or self._sortie.recorder is not recorder:
            self._show = self.changed = True

    def _due(self, number: int, moving: bool) -> bool:
        """Whether a frame should be sent. While inputs come, they lead: a frame goes with the first tick of each.

        A page sends its stick as often as its screen draws. Frames that answer come in step with that screen; others
        would show the stick up to a frame later, and drift through the rhythm of the screen.
        """
        since = number - self._sent
        fresh = self._sortie.flown_with is not self._flown_with
        self._flown_with = self._sortie.flown_with
        if not moving:
            return self._show or since >= EVERY_STILL
        patience = EVERY_MOVING + self._led - fresh
        due = self._show or since >= patience
        if due:
            self._led = fresh
        return due

    def _frozen(self) -> bool:
        return self._sortie.frozen if self._replay is None else self._replay.paused

    def _flying(self) -> Sortie:
        if self._sortie.ended:
            raise SpecError(f"The flight has ended. {AGAIN}")
        return self._sortie

    def _stalled(self, alpha: float) -> bool:
        """Whether lift is at the largest that is assumed of the nonlinear plant."""
        point = self.shown.trimmed
        return point is not None and point.stall is not None and not point.stall[0] <= alpha <= point.stall[1]

    def _playing(self) -> Replay:
        if self._replay is None:
            raise SpecError("No recording is being replayed.")
        return self._replay

    def _pack(self, late: bool) -> bytes:
        sortie, replay = self._sortie, self._replay
        frame = sortie.frame
        flown = (*frame.outputs, *frame.stick, *frame.excitation, *frame.command)
        t, values = (frame.t, flown) if replay is None else (replay.t, replay.frame())
        flags = (
            wire.FROZEN * self._frozen()
            | wire.RECORDING * (sortie.recorder is not None)
            | wire.REPLAY * (replay is not None)
            | wire.OUTSIDE * (self.shown.trimmed is None and values[EXCURSION] > OUTSIDE_ANGLE)
            | wire.STALLED * self._stalled(values[ALPHA])
            | wire.ENDED * (sortie.ended and replay is None)
            | wire.LATE * late
        )
        self._sequence += 1
        return wire.pack_state(flags, self._sequence, t, sortie.flown_with, values)
