"""What if it had been another aircraft, another derivative, another law: a recording's own stick, flown again.

>>> what_if = Variation.parse("Cm_q*=0.5; integrator=euler")
>>> what_if.changes, what_if.instead
(('Cm_q*=0.5',), {'integrator': 'euler'})
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from fdes.aircraft import FlightCondition, edited, load, parse
from fdes.analysis.design import law_for
from fdes.analysis.flown_plant import form_in, is_nonlinear, plant_in
from fdes.errors import RecordingError, SpecError
from fdes.flight import Recording, Setup
from fdes.flight.actuated import actuators_of, recorded_type, with_actuators
from fdes.flight.crossing import as_far
from fdes.flight.header import condition_in
from fdes.flight.recorder import columns_of
from fdes.flight.reflight import DEFLECTION, Reflight, fly_again
from fdes.flight.response import NO_LIMITS
from fdes.shelf import shelf

WORDS = (
    "aircraft",
    "condition",
    "variant",
    "plant",
    "form",
    "integrator",
    "law",
    "actuators",
)  # what can be put instead of what was flown
SWITCHED = {"on": True, "off": False}
OF_THE_AIRCRAFT = ("aircraft", "condition", "variant")


@dataclass(frozen=True)
class Variation:
    """What is different from the recording: changes made after its own, and what is put instead of what its header has.

    Nothing given is the flight as it was.
    """

    text: str = ""
    changes: tuple[str, ...] = ()
    instead: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def parse(cls, text: str) -> "Variation":
        """From ``Cm_q*=0.5; law=yaw_damper gain=0.5``: changes, and words such as law=, form=, aircraft=.

        A law may be several, one after the other: ``law=yaw_damper; roll_rate_damper``.
        Raises SpecError for what is no change and for what is said twice; whether it can be flown shows when it is.
        """
        changes: list[str] = []
        instead: dict[str, str] = {}
        for part in (p.strip() for p in text.split(";") if p.strip()):
            if "law" in instead and part.split()[0] in shelf("laws").names():
                instead["law"] += f"; {part}"
                continue
            name, equals, value = (p.strip() for p in part.partition("="))
            if not equals or not value:
                raise SpecError(
                    f"{part!r} says nothing that could be different. Write it like 'Cm_q*=0.5', 'law=yaw_damper' or "
                    f"'aircraft=NAVION'; what can be put instead is {', '.join(WORDS)}."
                )
            if name not in WORDS:
                changes.append(part)
            elif name in instead:
                raise SpecError(f"{text!r} says {name} twice.")
            elif name == "actuators" and value not in SWITCHED:
                raise SpecError(f"{part} says neither on nor off.")
            else:
                instead[name] = value
        return cls(text, tuple(changes), instead)


def what_if(recording: Recording, variation: Variation | str = "") -> Reflight:
    """`recording` flown again, unchanged or with a `variation`: same stick, same test inputs, same air.

    A variation may be given as its text, which `Variation.parse` reads.
    On another aircraft, and with the other plant, the flight begins as far from trim as it did, and the throttle lever
    is moved by as much as trim is elsewhere. Raises FdesError where the
    variation cannot be, RecordingError where the recording does not say enough.
    """
    if not isinstance(recording, Recording):
        raise SpecError(f"A recording is needed, and this is {recording!r}. Open one: fdes.open_recording(PATH).")
    if isinstance(variation, str):
        variation = Variation.parse(variation)
    other = _Other(variation)
    if "law" in variation.instead:  # gains designed once, and kept through whatever is changed in flight
        new = other.header(recording.header)
        flown = condition_of(new)
        moved = actuators_of(flown) if new.get("actuators") else None
        gains = law_for(new["law"], flown, form_in(new), frame=new["dt"], actuators=moved).text
        other = _Other(replace(variation, instead={**variation.instead, "law": gains}))
    if variation.instead.keys() & {*OF_THE_AIRCRAFT, "plant"}:
        recording = _begun_by(recording, other)
    return fly_again(recording, other.setup, lambda header: other.header(header) | {"what_if": variation.text})


def condition_of(header: Mapping[str, Any]) -> FlightCondition:
    """The aircraft that a header names, from the file in it, with its changes. Raises RecordingError, FdesError."""
    lacking = [key for key in ("document", "condition", "variant", "form", "integrator", "dt") if key not in header]
    if lacking:
        raise RecordingError(f"The recording does not say what was flown: its header lacks {', '.join(lacking)}.")
    aircraft = parse(header["document"], "The aircraft in the recording")
    return edited(condition_in(aircraft, header), header.get("changes", ()))


@dataclass(frozen=True)
class _Other:
    """What flies instead."""

    variation: Variation

    def header(self, recorded: Mapping[str, Any]) -> dict[str, Any]:
        """The header of what is flown, where `recorded` was."""
        instead = self.variation.instead
        new = dict(recorded) | {key: instead[key] for key in ("plant", "form", "integrator", "law") if key in instead}
        if "actuators" in instead:
            new["actuators"] = SWITCHED[instead["actuators"]]
        if "plant" in instead:
            new["form"] = form_in(new)
        if instead.keys() & set(OF_THE_AIRCRAFT):
            new |= self._aircraft(recorded)
        new |= {"changes": [*recorded.get("changes", ()), *self.variation.changes]}
        return new | _trim_of(new, recorded) if is_nonlinear(new) else new

    def _aircraft(self, recorded: Mapping[str, Any]) -> dict[str, Any]:
        """Another aircraft of the hangar, or another condition or variant of the same."""
        instead = self.variation.instead
        name = instead.get("aircraft")
        if name is None:
            found = parse(recorded["document"], "The aircraft in the recording")
        elif name.endswith(".toml") or "/" in name or "\\" in name:
            raise SpecError(f"aircraft={name} is a file; what a recording is flown on is an aircraft of the hangar.")
        else:
            found = load(name)
        wanted = instead.get("condition", None if name else recorded["condition"])
        flown = found.at(wanted, instead.get("variant", recorded["variant"]))
        return {
            "aircraft": flown.aircraft_id,
            "condition": flown.condition,
            "variant": flown.variant,
            "document": flown.document,
            **(dict.fromkeys({"across", "spool"} & recorded.keys()) if name else {}),  # not every aircraft can be so
        }

    def setup(self, recorded: Mapping[str, Any]) -> Setup:
        """What flies."""
        return setup_of(self.header(recorded))


def _trim_of(new: Mapping[str, Any], recorded: Mapping[str, Any]) -> dict[str, Any]:
    """Where the nonlinear plant of the header `new` is trimmed: as far from its condition as `recorded` was."""
    before, after = condition_of(recorded).reference, condition_of(new).reference
    said = recorded.get("trim", {})
    V, h = said.get("V", before.V), said.get("h", before.h)
    return {"trim": {**said, "V": V + (after.V - before.V), "h": h + (after.h - before.h)}}


def _begun_by(recording: Recording, other: _Other) -> Recording:
    """`recording` with the first state as what flies instead has it, and the throttle lever about its trim.

    Raises RecordingError where the aircraft was reset after an edit: the state of the reset is that of what flew.
    """
    header = dict(recording.header)
    names = [c.name for c in recording.columns]
    changed = False
    for edit in recording.edits:
        changed = changed or list(edit.get("changes", header.get("changes", ()))) != list(header.get("changes", ()))
        if edit.get("reset") and changed and (is_nonlinear(header) or is_nonlinear(other.header(header))):
            raise RecordingError(
                f"The recording was reset at {edit['t']:g} s, after the aircraft was edited: from there it cannot be "
                "flown by another aircraft or plant. End a recording before the reset."
            )
    if "trim" not in header and "h" in names:
        header["trim"] = {"V": condition_of(header).reference.V, "h": float(recording["h"][0])}
    before, after = setup_of(header).plant, other.setup(header).plant
    starts = [0, *(int(np.argmin(np.abs(recording["t"] - e["t"]))) for e in recording.edits if e.get("reset"))]
    kind = type(before.start())
    state = type(after.start())
    columns = columns_of(recorded_type(state) if DEFLECTION in names else state)
    own = [names.index(f"state_{name}") for name in kind._fields]
    data = np.zeros((len(recording.data), len(columns)))
    for k, column in enumerate(columns):
        if column.name in names and not column.name.startswith("state_"):
            data[:, k] = recording.data[:, names.index(column.name)]
    at = {column.name: k for k, column in enumerate(columns)}
    for row in starts:
        x = as_far(kind(*recording.data[row, own].tolist()), before, after, before.trim())
        data[row, [at[f"state_{name}"] for name in x._fields]] = x
    data[:, at["stick_throttle"]] += after.trim().throttle - before.trim().throttle
    return replace(recording, header=header, columns=columns, data=data)


def setup_of(header: Mapping[str, Any]) -> Setup:
    """Plant and law of a header. Raises FdesError."""
    condition = condition_of(header)
    flown = condition if header.get("limits", True) else replace(condition, limits=NO_LIMITS)
    law = law_for(header.get("law", "direct"), condition, form_in(header), frame=header["dt"]).law
    plant = plant_in(header, flown)
    return Setup(with_actuators(plant, condition) if header.get("actuators") else plant, law)
