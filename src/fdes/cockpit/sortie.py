"""One flight of a craft, from undisturbed flight to its end, and the recording of it.

A sortie knows neither time nor threads: whoever calls sees to it that calls follow one another.
"""

import re
import threading
from datetime import datetime
from itertools import count
from math import inf, isfinite
from pathlib import Path
from typing import Any

from fdes.cockpit.craft import Craft
from fdes.cockpit.handover import NOTHING, OVER, handover
from fdes.cockpit.wire import Input
from fdes.control import Stick
from fdes.errors import Departed, FdesError, SpecError
from fdes.flight import Edit, Excitation, Frame, GustyAir, Recorder, fly
from fdes.flight.actuated import recorded_type, surfaces_left
from fdes.flight.crossing import anew, can_carry, carried, crosses
from fdes.flight.excitation import NO_GUSTS, Gusts
from fdes.flight.inputs.step import Step
from fdes.flight.recorder import SUFFIX
from fdes.flight.response import disturbed
from fdes.flight.simulation import NO_EXCITATION
from fdes.physics.signals import Surfaces

SLOWEST = 1.0  # m/s
MOVED = 0.005  # how far a control must go from where it was at the start to count as moved
LONGEST_RECORDING = 3600.0  # s: some 200 MB
MOST_INPUTS = 64  # under way at once: each costs time in every frame
PLACING = 0.5  # s: how long a page may take to put its throttle lever where another aircraft is in trim
AGAIN = "Press R to start again."
TOO_FAR = (
    "The flight was too far from undisturbed flight for the linear plant: "
    "more than 15 degrees, or a quarter of the speed. It begins anew where it is, in trim."
)


class Sortie:
    """A flight under way. `frame` is the newest, `flown_with` the input in it, `given` the newest input.

    `notice` is what the pilot should read: why the flight ended, or why it is no longer recorded.
    """

    def __init__(self, craft: Craft, stick: Stick, *, placed: bool = True) -> None:
        """Begin, with the controls where `stick` has them, and the pilot's throttle lever too if it is `placed`."""
        self.craft = craft
        self._placed = placed
        self.announced = True  # whether the recording says what flies
        self._aloft = craft  # what flew in the newest frame
        self.frozen = False
        self.ended = False
        self.touched = False
        self.notice: str | None = None
        self.recorder: Recorder | None = None
        self.given = self.flown_with = Input(stick)
        self._rest = stick
        self._edits: list[Edit] = []  # to be made, one a frame
        self._inputs = self._everything = Excitation(())  # the test inputs; with what is held by hand
        self.held: dict[str, float] = {}
        self._fading = OVER
        self._frames = fly(
            craft.start,
            craft.setup,
            self._pilot,
            GustyAir(self._gusts, craft.condition.reference.V),
            craft.clock,
            self._put_in,
            edits=self._take_edit,
        )
        self.frame: Frame = next(self._frames)

    def take(self, given: Input) -> bool:
        """Take an input. True when it is the first that moves a control."""
        given = self._as_placed(given)
        self.given = given
        if self.touched or all(abs(a - b) <= MOVED for a, b in zip(given.stick, self._rest, strict=True)):
            return False
        self.touched = True
        return True

    def _as_placed(self, given: Input) -> Input:
        """`given`, or with the throttle in trim while the lever still stands where the aircraft before had it."""
        rest = self._rest.throttle
        self._placed = self._placed or self.frame.t > PLACING or abs(given.stick.throttle - rest) <= MOVED
        return given if self._placed else given._replace(stick=given.stick._replace(throttle=rest))

    def advance(self) -> None:
        """Fly one frame, which may be the last."""
        try:
            frame = next(self._frames)
            y = frame.outputs
            if not isfinite(sum(y)):
                raise Departed(f"The flight departed at t = {frame.t:.3f} s: an output is no longer a finite number.")
            self.frame = frame
            self._record(frame)
            if y.h <= 0.0:
                self.end("You met the ground.")
            elif y.V < SLOWEST:
                self.end(f"The flight departed at t = {frame.t:.3f} s: the airspeed fell to {y.V:.2f} m/s.")
        except FdesError as ending:
            self.end(str(ending))
        except ArithmeticError as ending:
            self.end(f"The flight departed after t = {self.frame.t:.3f} s: {ending}.")

    @property
    def recorded(self) -> float:
        """How long the recording is by now [s]."""
        return 0.0 if self.recorder is None else self.recorder.frames * self.craft.clock.dt

    def reset(self) -> None:
        """Be back in undisturbed flight with the next frame, the controls as they were at the start.

        A recording under way goes on; else one begins again when a control is moved.
        """
        self.touched = self.recorder is not None
        self.given = self.given._replace(stick=self._rest)
        self.clear_inputs()
        self._fading = OVER
        self._edits = [Edit(state=self.craft.start, note={"reset": True})]
        if self.frozen:
            self.advance()

    def put_in(self, given: Excitation) -> bool:
        """Begin test inputs with the next frame. True when a recording should begin. Raises SpecError."""
        now = self.frame.t + self.craft.clock.dt
        going_on = [part for part in self._inputs.parts if not _is_over(part[1], now)]
        if len(going_on) + len(given.parts) > MOST_INPUTS:
            raise SpecError(
                f"{len(going_on)} test inputs are under way, and {MOST_INPUTS} can be at once. "
                "End them all before you put in another."
            )
        self._inputs = Excitation((*going_on, *given.later(now).parts))
        return self._excite()

    def hold(self, channel: str, value: float) -> bool:
        """Add `value` [SI] to `channel` from the next frame on; zero lets go. True when a recording should begin."""
        self.held = {**self.held, channel: value}
        if value == 0.0:
            del self.held[channel]
        return self._excite()

    def clear_inputs(self) -> None:
        """End all test inputs, and let go of what is held."""
        self._inputs = self._everything = Excitation(())
        self.held = {}

    def _excite(self) -> bool:
        by_hand = ((channel, Step(value)) for channel, value in self.held.items())
        self._everything = Excitation((*self._inputs.parts, *by_hand))
        touched, self.touched = self.touched, True
        return not touched

    def disturb(self, text: str) -> None:
        """Add a perturbation to the state at the next frame. Raises SpecError, NoSuchPart."""
        disturbed(self.craft.start, [text])  # raises now, while there is somebody to tell
        self._edits.append(Edit(disturb=lambda x: disturbed(x, [text]), note={"disturb": text}))
        if self.frozen and not self.ended:
            self.advance()

    def end(self, message: str) -> None:
        """Stop for good, and keep the recording."""
        self.frozen = self.ended = True
        self.notice = f"{message} {AGAIN}"
        self.release(message)

    def release(self, reason: str) -> None:
        """End the recording, if there is one: a thread that the interpreter waits for writes it to its end."""
        recorder, self.recorder = self.recorder, None
        if recorder is not None:
            threading.Thread(target=recorder.close, args=(reason,), name=f"closing {recorder.path.name}").start()

    def _pilot(self, t: float) -> Stick:
        given = self.flown_with = self.given  # read once: another thread may give the next
        return given.stick

    def _put_in(self, t: float) -> Surfaces:
        added = self._everything(t) if self._everything.parts else NO_EXCITATION
        fading = self._fading(t)
        return added if fading is NOTHING else Surfaces(*map(float.__add__, added, fading))

    def _gusts(self, t: float) -> Gusts:
        return self._everything.gusts(t) if self._everything.parts else NO_GUSTS

    def _take_edit(self, t: float) -> Edit | None:
        edit = self._edits.pop(0) if self._edits else None
        if self.announced and self.craft.setup is self._aloft.setup:
            return edit
        return self._refitted(edit or Edit())

    def _refitted(self, edit: Edit) -> Edit:
        """`edit`, and with it the present craft instead of that which flew until now.

        The state is kept: the deviations from undisturbed flight. With another altitude of the flight condition the
        height goes along, for the air at it is what the equations are made of.
        """
        aloft, now = self._aloft, self.craft
        switched = crosses(aloft.setup.plant, now.setup.plant)
        if edit.state is not None:
            edit = edit._replace(state=now.start)
        self._aloft, self.announced = now, True
        note = {**edit.note, **now.setup_note()}
        said = note.get("disturb")
        moved = "" if switched else now.moved_from(aloft)
        if moved and edit.state is None:
            said = moved if said is None else f"{moved}, {said}"
            note["disturb"] = said
        plant, law = now.setup
        surfaces = self.frame.command
        if switched and edit.state is None and not can_carry(self.frame.state, aloft.setup.plant, plant):
            self.notice = TOO_FAR
            edit = edit._replace(state=anew(self.frame.state, aloft.setup.plant, plant))
            note["reset"] = True
        begun, before = edit.state is not None, aloft.setup.law
        if switched:
            self._rest = self._rest._replace(throttle=now.trim_throttle)

        def refit(x: Any) -> Any:
            if begun:
                here = x
            else:
                here, left = carried(x, aloft.setup.plant, plant, surfaces), surfaces_left(x, plant, surfaces)
                if law != before or left != surfaces:
                    fading = self._fading(self.frame.t)
                    self._fading = handover(self.frame, before, law, fading, now.clock.dt, left)
            return disturbed(here, [] if said is None else [said])

        def left(x: Any, held: Surfaces) -> Surfaces:
            return surfaces_left(x, plant, held)

        return edit._replace(plant=plant, law=law, disturb=refit, left=left, note=note)

    def _record(self, frame: Frame) -> None:
        recorder = self.recorder
        if recorder is None:
            return
        if recorder.trouble is not None:
            self.notice = f"The recording ended: {recorder.trouble}"
            self.release("trouble")
        elif self.recorded >= LONGEST_RECORDING:
            self.notice = f"The recording ended after {LONGEST_RECORDING / 60.0:.0f} minutes, and was kept."
            self.release("full")
        else:
            recorder.append(frame)


def _is_over(shape: Any, t: float) -> bool:
    """Whether an input adds nothing any more from `t` [s] on."""
    return bool(t > shape.at + getattr(shape, "lasting", inf) and shape(t) == 0.0)


def open_recorder(folder: Path, craft: Craft) -> Recorder:
    """A new recording in `folder`, named after the local time and the aircraft. Waits for the disk; raises OSError."""
    flown = re.sub(r"[^A-Za-z0-9.-]+", "_", f"{craft.condition.aircraft_id}_{craft.condition.condition}")
    stem = f"{datetime.now().astimezone():%Y-%m-%d_%H-%M-%S}_{flown}"
    names = (stem if number == 1 else f"{stem}_{number}" for number in count(1))
    while True:
        try:
            return Recorder(folder / f"{next(names)}{SUFFIX}", recorded_type(type(craft.start)), craft.header())
        except FileExistsError:  # another session began within this second
            continue
