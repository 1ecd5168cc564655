"""What a pilot puts in by command: test inputs, measured histories, values held by hand; and a look at it beforehand.

No text from the network names a file: `Excitation.parse` is never told here that it may.
"""

from math import inf, isfinite
from typing import Any

from fdes.cockpit import commands
from fdes.cockpit.session import Session
from fdes.errors import SpecError
from fdes.flight import Excitation
from fdes.flight.excitation import UNITS
from fdes.flight.inputs.measured import Measured

LATEST = 3600.0  # s that an input may wait
POINTS = 400  # of a preview
REST = 0.15  # of the time an input lasts, shown before and after it


def excite(session: Session, command: commands.PutIn | commands.PutInHistory | commands.Hold) -> bool:
    """Put something in. True when a recording should begin. Raises SpecError, NoSuchPart."""
    match command:
        case commands.PutIn(text, after):
            must_be_soon(after)
            return session.put_in(Excitation.parse([text]).later(after))
        case commands.PutInHistory(channel, times, values):
            return session.put_in(Excitation(((channel, Measured(times, values)),)))
        case commands.Hold(text):
            return session.hold(*held(text))


def must_be_soon(after: float) -> None:
    """Raises SpecError for an input that would wait too long [s]."""
    if not 0.0 <= after <= LATEST:
        raise SpecError(f"An input cannot be put in {after:g} s from now: it can from 0 s to {LATEST:g} s.")


def held(text: str) -> tuple[str, float]:
    """Channel and value [SI] of what is to be held, such as ``elevator 2deg``. Raises SpecError, NoSuchPart."""
    parts = Excitation.parse([f"step {text}"]).parts
    if len(parts) != 1 or parts[0][1].at != 0.0:
        raise SpecError(f"{text[:40]!r} cannot be held: say one channel and its value, such as 'elevator 2deg'.")
    ((channel, step),) = parts
    return channel, step.amplitude


def preview(text: str) -> dict[str, Any]:
    """The first input of `text`, evenly spaced, from a little before it begins. Raises SpecError, NoSuchPart."""
    channel, shape = Excitation.parse([text]).parts[0]
    lasting = getattr(shape, "lasting", inf)
    if not isfinite(lasting):
        lasting = 4.0 * getattr(shape, "period", 1.0)
    start, end = shape.at - REST * lasting, shape.at + (1.0 + REST) * lasting
    dt = (end - start) / (POINTS - 1)
    try:
        values = [float(f"{shape(start + k * dt):.6g}") for k in range(POINTS)]
    except (ArithmeticError, ValueError):
        values = [inf]
    if not all(map(isfinite, values)):
        raise SpecError(f"The input {text[:80]!r} cannot be flown: its times are too far apart. Choose others.")
    return {"channel": channel, "unit": UNITS[channel], "start": start, "dt": dt, "values": values}
