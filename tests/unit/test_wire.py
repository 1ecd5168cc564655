"""The wire: byte layouts that a page in another language relies on, and what is said of messages that are wrong."""

import json
import math
import struct
from typing import Any

import pytest

from fdes.cockpit import commands, wire
from fdes.control import Stick
from fdes.errors import SpecError
from fdes.physics.signals import Outputs


def command(**said: Any) -> str:
    return json.dumps({"type": "command", "version": 1, "id": 7, **said})


def test_channels_are_the_outputs_and_then_the_stick() -> None:
    names = [c.name for c in wire.CHANNELS]
    assert names[: len(Outputs._fields)] == list(Outputs._fields)
    assert names[len(Outputs._fields) :] == [
        *("stick_pitch", "stick_roll", "stick_yaw", "stick_throttle"),
        *("excitation_elevator", "excitation_aileron", "excitation_rudder", "excitation_throttle"),
        *("command_elevator", "command_aileron", "command_rudder", "command_throttle"),
    ]
    assert wire.CHANNELS[names.index("phi")].unit == "rad"


def test_a_state_frame_is_laid_out_as_documented() -> None:
    values = [float(i) for i in range(len(wire.CHANNELS))]
    frame = wire.pack_state(wire.FROZEN | wire.LATE, 2**32 + 5, 1.25, wire.Input(Stick(), 9, 1234.5), values)
    assert len(frame) == 32 + 4 * len(values)
    assert frame[0] == 1
    assert frame[1] == 1
    assert struct.unpack_from("<H", frame, 2) == (1 | 32,)
    assert struct.unpack_from("<I", frame, 4) == (5,)
    assert struct.unpack_from("<d", frame, 8) == (1.25,)
    assert struct.unpack_from("<II", frame, 16) == (9, 0)
    assert struct.unpack_from("<d", frame, 24) == (1234.5,)
    assert list(struct.unpack_from(f"<{len(values)}f", frame, 32)) == values


def input_frame(*stick: float, kind: int = 2, version: int = 1, stamp: float = 99.0) -> bytes:
    return struct.pack("<BBHIdffff", kind, version, 0, 3, stamp, *stick)


def test_an_input_frame_is_read_and_limited_to_the_stops() -> None:
    assert wire.unpack_input(input_frame(0.5, -0.25, 0.0, 0.75)) == wire.Input(Stick(0.5, -0.25, 0.0, 0.75), 3, 99.0)
    assert wire.unpack_input(input_frame(7.0, -7.0, 1e30, -3.0)).stick == Stick(1.0, -1.0, 1.0, 0.0)
    assert wire.unpack_input(input_frame(0.0, 0.0, 0.0, 3.0)).stick.throttle == 1.0


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "An input frame has 32 bytes; 0 came."),
        (bytes(33), "An input frame has 32 bytes; 33 came."),
        (input_frame(0, 0, 0, 0, kind=9), "type 9 and version 1; an input frame has 2 and 1"),
        (input_frame(0, 0, 0, 0, version=2), "type 2 and version 2"),
        (input_frame(math.nan, 0, 0, 0), "not finite. Center the stick"),
        (input_frame(0, 0, math.inf, 0), "not finite"),
        (input_frame(0, 0, 0, 0, stamp=math.nan), "not finite"),
    ],
)
def test_says_what_is_wrong_with_an_input_frame(data: bytes, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        wire.unpack_input(data)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ({"name": "freeze", "value": True}, commands.Freeze(True)),
        ({"name": "reset"}, commands.Reset()),
        ({"name": "step", "more": "is passed over"}, commands.Step()),
        ({"name": "record", "value": False}, commands.Record(False)),
        ({"name": "aircraft", "aircraft": "NAVION"}, commands.ChooseAircraft("NAVION", None, "corrected")),
        (
            {"name": "aircraft", "aircraft": "A-4D", "condition": "M0.4_SL", "variant": "printed"},
            commands.ChooseAircraft("A-4D", "M0.4_SL", "printed"),
        ),
        ({"name": "aircraft", "aircraft": "A-4D", "condition": None}, commands.ChooseAircraft("A-4D")),
        ({"name": "replay", "recording": "one"}, commands.PlayBack("one")),
        ({"name": "seek", "t": 3}, commands.Seek(3.0)),
        ({"name": "stop_replay"}, commands.StopReplay()),
        ({"name": "ping"}, commands.Ping()),
    ],
)
def test_reads_commands(said: dict[str, Any], meant: commands.Command) -> None:
    assert wire.command_of(wire.read_text(command(**said))) == meant


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "not JSON"),
        ("{", "not JSON"),
        ("[" * 4000, "not JSON"),
        ("[1, 2]", "not a JSON object"),
        ("7", "not a JSON object"),
        (json.dumps({"type": "dance"}), "messages of type 'command', not 'dance'"),
        (json.dumps({"type": "command", "version": 2, "id": 1}), "speaks version 1; the command has version 2"),
        (json.dumps({"type": "command", "version": 1}), "needs an 'id', a whole number"),
        (json.dumps({"type": "command", "version": 1, "id": True}), "needs an 'id'"),
        (json.dumps({"type": "command", "version": 1, "id": 10**400}), "needs an 'id'"),
        ('"' + "x" * 5000 + '"', "longer than 4096 bytes"),
        ('"' + "\u20ac" * 2000 + '"', "longer than 4096 bytes"),
    ],
)
def test_says_what_is_wrong_with_a_text(text: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        wire.read_text(text)


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"name": "frieze"}, "no command 'frieze'. Did you mean 'freeze'?"),
        ({"name": 5}, "no command 5"),
        ({}, "no command None"),
        ({"name": "freeze"}, "The command 'freeze' needs 'value'."),
        ({"name": "freeze", "value": 1}, "'value' of the command 'freeze' is 1; it must be true or false"),
        ({"name": "seek", "t": "soon"}, "'t' of the command 'seek' is 'soon'; it must be a finite number"),
        ({"name": "seek", "t": True}, "it must be a finite number"),
        ({"name": "seek", "t": math.nan}, "it must be a finite number"),
        ({"name": "seek", "t": 10**300}, "it must be a finite number"),
        ({"name": "aircraft", "aircraft": ["A-4D"]}, "it must be a text"),
        ({"name": "aircraft", "aircraft": "A-4D", "condition": 4}, "it must be a text or null"),
        ({"name": "x" * 3000}, r"no command 'x{39}\.\.\."),
    ],
)
def test_says_what_is_wrong_with_a_command(said: dict[str, Any], words: str) -> None:
    with pytest.raises(SpecError, match=words):
        wire.command_of(wire.read_text(command(**said)))


def history(*rows: tuple[float, float], kind: int = 3, version: int = 1, channel: int = 1, number: int = 9) -> bytes:
    return struct.pack("<BBHI", kind, version, channel, number) + b"".join(struct.pack("<dd", *row) for row in rows)


def test_a_measured_history_is_laid_out_as_documented() -> None:
    data = history((0.0, 0.1), (0.5, -0.1))
    assert wire.is_command(data)
    assert not wire.is_command(input_frame(0, 0, 0, 0))
    assert wire.unpack_history(data) == (9, commands.PutInHistory("aileron", (0.0, 0.5), (0.1, -0.1)))
    assert wire.INPUT_CHANNELS[4:] == ("gust_u", "gust_v", "gust_w", "alpha_g", "beta_g")


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"\x03", "A measured history has 8 bytes and 16 for each of at most 4000 rows; 1 bytes came."),
        (history((0.0, 0.0))[:-1], "23 bytes came"),
        (history(*[(0.0, 0.0)] * 4001), "at most 4000 rows; 64024 bytes came"),
        (history(version=2), "The measured history has version 2; this server speaks version 1."),
        (history(channel=9), "There is no input channel number 9: they are elevator, aileron"),
    ],
)
def test_says_what_is_wrong_with_a_history(data: bytes, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        wire.unpack_history(data)


def test_no_command_carries_a_history_or_a_path() -> None:
    assert commands.PutInHistory not in commands.COMMANDS.values()
