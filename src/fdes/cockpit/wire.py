"""The wire between server and page, version 1: the layout of binary frames, and how commands are read.

Binary messages are little-endian. A state frame is a header of 32 bytes and a float32 for each of `CHANNELS`:

    u8 type = 1 · u8 version · u16 flags · u32 sequence · f64 t [s]
    u32 sequence of the input it was flown with · u32 zero · f64 client stamp of that input [ms, the client's clock]

An input frame is 32 bytes, the stick as `fdes.control.Stick` has it (aft, right and right pedal positive):

    u8 type = 2 · u8 version · u16 buttons · u32 sequence · f64 client stamp [ms] · f32 pitch, roll, yaw, throttle

A measured history is a header of 8 bytes and up to `MOST_ROWS` rows, in SI; its reply bears its id:

    u8 type = 3 · u8 version · u16 place of the channel in INPUT_CHANNELS · u32 id · f64 t [s], f64 value for each row

A document is a header of 8 bytes and a text in UTF-8, an aircraft file or an experiment; its reply bears its id:

    u8 type = 4 · u8 version · u16 place in DOCUMENTS · u32 id · text

Everything else is JSON text with a "type".
"""

import json
import struct
from collections.abc import Iterable
from dataclasses import MISSING, fields
from math import isfinite
from types import NoneType
from typing import Any, NamedTuple, get_args, get_origin, get_type_hints

from fdes.cockpit.commands import COMMANDS, Command, OpenAircraft, OpenExperiment, PutInHistory
from fdes.control import Stick
from fdes.errors import SpecError, nearest
from fdes.flight.excitation import UNITS
from fdes.physics.signals import Outputs, Surfaces, channels

VERSION = 1
CHANNELS = (
    *channels(Outputs),
    *channels(Stick, "stick_"),
    *channels(Surfaces, "excitation_"),
    *channels(Surfaces, "command_"),
)

INPUT_CHANNELS = tuple(UNITS)  # what inputs move: surfaces, then gusts

FROZEN = 1
RECORDING = 2
REPLAY = 4
OUTSIDE = 8  # beyond the angle to which the linear plant may be believed
ENDED = 16
LATE = 32  # the machine fell behind within the last second
STALLED = 64  # lift is at the largest that is assumed of the nonlinear plant

STATE_TYPE = 1
INPUT_TYPE = 2
HISTORY_TYPE = 3
DOCUMENT_TYPE = 4
DOCUMENTS: tuple[type[OpenAircraft | OpenExperiment], ...] = (OpenAircraft, OpenExperiment)
MAX_TEXT = 4096  # bytes
MOST_TEXTS = 64  # in a list
MOST_ROWS = 4000  # of a history: less than the largest message that the server takes

_STATE = struct.Struct(f"<BBHIdIId{len(CHANNELS)}f")
_INPUT = struct.Struct("<BBHIdffff")
_HISTORY = _DOCUMENT = struct.Struct("<BBHI")
_ROW = struct.Struct("<dd")


class Input(NamedTuple):
    """The newest word of a pilot: where the controls are, and the client's own mark and time [ms] of it."""

    stick: Stick
    sequence: int = 0
    stamp: float = 0.0


_SAID = {bool: "true or false", str: "a text", float: "a finite number", NoneType: "null"}


def pack_state(flags: int, sequence: int, t: float, echo: Input, values: Iterable[float]) -> bytes:
    """A state frame. `values` [SI] are as many as `CHANNELS` and in their order."""
    return _STATE.pack(STATE_TYPE, VERSION, flags, sequence & 0xFFFFFFFF, t, echo.sequence, 0, echo.stamp, *values)


def unpack_input(data: bytes) -> Input:
    """Read an input frame, the stick limited to its travel. Raises SpecError when it is none."""
    if len(data) != _INPUT.size:
        raise SpecError(f"An input frame has {_INPUT.size} bytes; {len(data)} came.")
    kind, version, _, sequence, stamp, pitch, roll, yaw, throttle = _INPUT.unpack(data)
    if kind != INPUT_TYPE or version != VERSION:
        raise SpecError(
            f"The binary message has type {kind} and version {version}; an input frame has {INPUT_TYPE} and {VERSION}."
        )
    if not isfinite(stamp + pitch + roll + yaw + throttle):  # of float32, and no sum of four overflows a float
        raise SpecError(
            "The input frame holds a number that is not finite. Center the stick and check its calibration."
        )
    stick = Stick(
        min(max(pitch, -1.0), 1.0), min(max(roll, -1.0), 1.0), min(max(yaw, -1.0), 1.0), min(max(throttle, 0.0), 1.0)
    )
    return Input(stick, sequence, stamp)


def is_command(data: bytes) -> bool:
    """Whether a binary message is meant as a command: a measured history, or a document."""
    return len(data) > 0 and data[0] in (HISTORY_TYPE, DOCUMENT_TYPE)


def unpack_command(data: bytes) -> tuple[int, Command]:
    """Read a binary command: its id, and what it asks. Raises SpecError when it is none."""
    return unpack_history(data) if data[0] == HISTORY_TYPE else unpack_document(data)


def unpack_document(data: bytes) -> tuple[int, OpenAircraft | OpenExperiment]:
    """Read a document: its id, and what it asks. Raises SpecError when it is none."""
    if len(data) < _DOCUMENT.size:
        raise SpecError(f"A document has {_DOCUMENT.size} bytes and a text; {len(data)} bytes came.")
    _, version, kind, number = _DOCUMENT.unpack_from(data)
    if version != VERSION:
        raise SpecError(f"The document has version {version}; this server speaks version {VERSION}.")
    if kind >= len(DOCUMENTS):
        raise SpecError(f"There is no document of kind {kind}: 0 is an aircraft file, 1 an experiment.")
    try:
        text = data[_DOCUMENT.size :].decode()
    except UnicodeDecodeError:
        raise SpecError("The file is not text in UTF-8.") from None
    return number, DOCUMENTS[kind](text)


def unpack_history(data: bytes) -> tuple[int, PutInHistory]:
    """Read a measured history: its id, and what it asks. Raises SpecError when it is none."""
    rows, rest = divmod(len(data) - _HISTORY.size, _ROW.size)
    if rest or not 0 <= rows <= MOST_ROWS:
        raise SpecError(
            f"A measured history has {_HISTORY.size} bytes and {_ROW.size} for each of at most {MOST_ROWS} rows; "
            f"{len(data)} bytes came."
        )
    _, version, channel, number = _HISTORY.unpack_from(data)
    if version != VERSION:
        raise SpecError(f"The measured history has version {version}; this server speaks version {VERSION}.")
    if channel >= len(INPUT_CHANNELS):
        raise SpecError(f"There is no input channel number {channel}: they are {', '.join(INPUT_CHANNELS)}, from 0 on.")
    numbers = list(_ROW.iter_unpack(data[_HISTORY.size :]))
    return number, PutInHistory(INPUT_CHANNELS[channel], tuple(t for t, _ in numbers), tuple(v for _, v in numbers))


def read_text(text: str) -> dict[str, Any]:
    """Read a text message as the JSON object it must be. Raises SpecError."""
    if len(text) > MAX_TEXT or len(text.encode()) > MAX_TEXT:
        raise SpecError(f"The message is longer than {MAX_TEXT} bytes.")
    try:
        message = json.loads(text)
    except (ValueError, RecursionError):
        raise SpecError("The message is not JSON.") from None
    if not isinstance(message, dict):
        raise SpecError('The message is not a JSON object such as {"type": "command", ...}.')
    if message.get("type") != "command":
        raise SpecError(f"The server takes messages of type 'command', not {_shown(message.get('type'))}.")
    if message.get("version") != VERSION:
        raise SpecError(
            f"This server speaks version {VERSION}; the command has version {_shown(message.get('version'))}."
        )
    number = message.get("id")
    if type(number) is not int or abs(number) >= 2**53:
        raise SpecError(f"A command needs an 'id', a whole number, for its reply; this one has {_shown(number)}.")
    return message


def command_of(message: dict[str, Any]) -> Command:
    """The command a message gives. Raises SpecError for an unknown command, a missing or a misshapen argument."""
    name = message.get("name")
    if not isinstance(name, str) or name not in COMMANDS:
        near = nearest(name, COMMANDS) if isinstance(name, str) else None
        hint = f" Did you mean {near!r}?" if near else ""
        raise SpecError(f"There is no command {_shown(name)}.{hint} Known: {', '.join(COMMANDS)}.")
    kind = COMMANDS[name]
    hints = get_type_hints(kind)
    given: dict[str, Any] = {}
    for field in fields(kind):
        if field.name in message:
            given[field.name] = _fitting(name, field.name, message[field.name], hints[field.name])
        elif field.default is MISSING:
            raise SpecError(f"The command {name!r} needs {field.name!r}.")
    return kind(**given)


def _fitting(command: str, key: str, value: Any, hint: Any) -> Any:
    if get_origin(hint) is tuple:
        return _texts(command, key, value)
    wanted = get_args(hint) or (hint,)
    if float in wanted and isinstance(value, int) and not isinstance(value, bool):
        value = float(value) if abs(value) < 2**53 else float("inf")
    if type(value) not in wanted or (isinstance(value, float) and not isfinite(value)):
        said = " or ".join(_SAID[w] for w in wanted)
        raise SpecError(f"{key!r} of the command {command!r} is {_shown(value)}; it must be {said}.")
    return value


def _texts(command: str, key: str, value: Any) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(text, str) for text in value):
        raise SpecError(f"{key!r} of the command {command!r} is {_shown(value)}; it must be a list of texts.")
    if len(value) > MOST_TEXTS:
        raise SpecError(f"{key!r} of the command {command!r} has {len(value)} texts; it can have {MOST_TEXTS}.")
    return tuple(value)


def _shown(value: Any) -> str:
    """A value from outside as an error message may quote it: never long."""
    text = repr(value)
    return text if len(text) <= 40 else f"{text[:40]}..."
