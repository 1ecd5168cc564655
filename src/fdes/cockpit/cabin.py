"""A session with those who are in it, and what was put in since the flight began: that belongs to the experiment."""

import asyncio
from dataclasses import dataclass, field

from fdes.cockpit import commands
from fdes.cockpit.craft import Craft
from fdes.cockpit.excite import LATEST
from fdes.cockpit.history import History
from fdes.cockpit.session import Session
from fdes.cockpit.sortie import MOST_INPUTS
from fdes.cockpit.viewer import Viewer

DIGITS = 6  # of the times of inputs [s]: to the microsecond


@dataclass
class Cabin:
    """A session with those who are in it. `told` is the craft that they have been told of, `past` what was edited."""

    session: Session
    told: Craft
    past: History = field(default_factory=History)
    viewers: set[Viewer] = field(default_factory=set)
    pilot: Viewer | None = None
    leaving: asyncio.TimerHandle | None = None
    inputs: list[tuple[float, str]] = field(default_factory=list)  # test inputs: when [s], and what
    over: bool = False  # whether the flight of those inputs is, so that the next one begins a new list

    def fly(self, craft: Craft) -> None:
        """Begin another flight."""
        self.session.change(craft)
        self.past, self.inputs = History(), []

    def remember(self, command: commands.Command) -> None:
        """Keep a test input for the experiment; a reset begins its inputs anew, once there is another to keep.

        What is cleared is kept no more. Of very many, the newest are kept.
        """
        match command:
            case commands.PutIn(text, after):
                before = [] if self.over else self.inputs
                self.inputs = [*before, (self.session.t + after, text)][-MOST_INPUTS:]
                self.over = False
            case commands.Reset():
                self.over = True
            case commands.ClearInputs():
                self.inputs = []

    def given(self) -> list[tuple[float, str]]:
        """The test inputs in their order, and how long after the first [s] each was put in.

        Those so long before the last that an experiment could not wait for it are left out.
        """
        end = max((t for t, _ in self.inputs), default=0.0)
        kept = [(t, text) for t, text in self.inputs if end - t <= LATEST]
        begin = min((t for t, _ in kept), default=0.0)
        return [(round(t - begin, DIGITS), text) for t, text in kept]
