"""What if it had been another aircraft, another derivative, another law: a recording's own stick, flown again.

>>> what_if = Variation.parse("Cm_q*=0.5; integrator=euler")
>>> what_if.changes, what_if.instead
(('Cm_q*=0.5',), {'integrator': 'euler'})
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from fdes.aircraft import FlightCondition, edited, load, parse
from fdes.analysis.design import law_for
from fdes.analysis.flown_plant import plant_in
from fdes.errors import RecordingError, SpecError
from fdes.flight import Recording, Setup
from fdes.flight.actuated import with_actuators
from fdes.flight.reflight import Reflight, fly_again
from fdes.flight.response import NO_LIMITS
from fdes.shelf import shelf

WORDS = ("aircraft", "condition", "variant", "form", "integrator", "law")  # what can be put instead of what was flown
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
            else:
                instead[name] = value
        return cls(text, tuple(changes), instead)


def what_if(recording: Recording, variation: Variation | str = "") -> Reflight:
    """`recording` flown again, unchanged or with a `variation`: same stick, same test inputs, same air.

    A variation may be given as its text, which `Variation.parse` reads.
    On another aircraft the throttle lever is moved by as much as its trim is elsewhere. Raises FdesError where the
    variation cannot be, RecordingError where the recording does not say enough.
    """
    if isinstance(variation, str):
        variation = Variation.parse(variation)
    other = _Other(variation)
    if "law" in variation.instead:  # gains designed once, and kept through whatever is changed in flight
        new = other.header(recording.header)
        gains = law_for(new["law"], condition_of(new), new["form"], frame=new["dt"]).text
        other = _Other(replace(variation, instead={**variation.instead, "law": gains}))
    if variation.instead.keys() & set(OF_THE_AIRCRAFT):
        lever = other.condition(recording.header).trim_throttle - condition_of(recording.header).trim_throttle
        moved = recording.data.copy()
        moved[:, [c.name for c in recording.columns].index("stick_throttle")] += lever
        recording = replace(recording, data=moved)
    return fly_again(recording, other.setup, lambda header: other.header(header) | {"what_if": variation.text})


def condition_of(header: Mapping[str, Any]) -> FlightCondition:
    """The aircraft that a header names, from the file in it, with its changes. Raises RecordingError, FdesError."""
    lacking = [key for key in ("document", "condition", "variant", "form", "integrator", "dt") if key not in header]
    if lacking:
        raise RecordingError(f"The recording does not say what was flown: its header lacks {', '.join(lacking)}.")
    flown = parse(header["document"], "The aircraft in the recording").at(header["condition"], header["variant"])
    return edited(flown, header.get("changes", ()))


@dataclass(frozen=True)
class _Other:
    """What flies instead."""

    variation: Variation

    def header(self, recorded: Mapping[str, Any]) -> dict[str, Any]:
        """The header of what is flown, where `recorded` was."""
        instead = self.variation.instead
        new = dict(recorded) | {key: instead[key] for key in ("form", "integrator", "law") if key in instead}
        if instead.keys() & set(OF_THE_AIRCRAFT):
            new |= self._aircraft(recorded)
        return new | {"changes": [*recorded.get("changes", ()), *self.variation.changes]}

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
        }

    def condition(self, recorded: Mapping[str, Any]) -> FlightCondition:
        """The aircraft of that header."""
        return condition_of(self.header(recorded))

    def setup(self, recorded: Mapping[str, Any]) -> Setup:
        """What flies."""
        return setup_of(self.header(recorded))


def setup_of(header: Mapping[str, Any]) -> Setup:
    """Plant and law of a header. Raises FdesError."""
    condition = condition_of(header)
    flown = condition if header.get("limits", True) else replace(condition, limits=NO_LIMITS)
    law = law_for(header.get("law", "direct"), condition, header["form"], frame=header["dt"]).law
    plant = plant_in(header, flown)
    return Setup(with_actuators(plant, condition) if header.get("actuators") else plant, law)
