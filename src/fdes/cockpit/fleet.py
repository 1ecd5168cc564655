"""The aircraft that a server offers: the hangar's, and the one that was named when it was started.

The network names aircraft by id. An id that is not offered is reported, never looked for as a file.
"""

import json
from contextlib import suppress
from functools import cached_property
from typing import Any

from fdes.aircraft import Aircraft, catalogue, parse
from fdes.aircraft.load import aircraft_of
from fdes.analysis.flown_plant import LINEAR
from fdes.cockpit.craft import Craft, make_craft
from fdes.cockpit.flight_control import NONE, Control
from fdes.errors import FdesError, NoSuchPart, SpecError
from fdes.flight.header import condition_in, how_at


class Fleet:
    """What can be flown; a session starts with `first`."""

    def __init__(
        self,
        own: Aircraft,
        condition: str | None,
        variant: str,
        form: str,
        integrator: str,
        plant: str = LINEAR,
        **more: Any,
    ) -> None:
        """`more` is what else `Aircraft.at` takes, for the first.

        Raises NoSuchPart for a condition, variant, form, integrator or plant that does not exist, SpecError for what
        `Aircraft.at` refuses.
        """
        self._own = own
        self.first = make_craft(own.at(condition, variant, **more), form, integrator, plant=plant)

    @cached_property
    def aircraft(self) -> dict[str, Aircraft]:
        """All aircraft by id, the hangar's in its own order."""
        return {a.id: a for a in catalogue()} | {self._own.id: self._own}

    def named(self, aircraft: str) -> Aircraft:
        """The aircraft of that id. Raises NoSuchPart for one that is not offered."""
        if aircraft not in self.aircraft:
            raise NoSuchPart("aircraft", aircraft, self.aircraft)
        return self.aircraft[aircraft]

    def craft(self, aircraft: str, condition: str | None, variant: str, like: Craft) -> Craft:
        """An aircraft made ready, with the equations and the step of `like`.

        Another condition of the aircraft that flies is interpolated across Mach, and its engine lags, if that one is
        and does, as far as it can be. Raises NoSuchPart for an id, condition or variant that is not offered.
        """
        named = self.named(aircraft)
        wanted = named.at(condition, variant)
        if named.document == like.base.document:
            for name, how in how_at(like.base).items():
                with suppress(SpecError):
                    wanted = named.at(condition, variant, **{**how_at(wanted), name: how})
        return make_craft(wanted, like.form, like.integrator, like.clock.dt, plant=like.plant)

    def opened(self, text: str, like: Craft) -> Craft:
        """The aircraft of a file's `text`, in its first condition, with the equations and the step of `like`.

        It is data and nothing else: no name in it is looked for as a file. Raises AircraftFileError.
        """
        aircraft = aircraft_of(text, "The file")
        return make_craft(aircraft.at(), like.form, like.integrator, like.clock.dt, plant=like.plant)

    @cached_property
    def pictures(self) -> bytes:
        """What a picker shows of each aircraft, in SI, as JSON."""
        return json.dumps([_picture(a) for a in self.aircraft.values()], allow_nan=False).encode()


def craft_of(name: str, header: dict[str, Any]) -> Craft | None:
    """The craft that the recording `name` was flown with, made from the recording's own copy of the aircraft file.

    None when the header has no such copy, or one that this FDES cannot use.
    """
    try:
        flown = condition_in(parse(header["document"], name), header)
        control = Control(header.get("law", NONE), header.get("actuators", False))
        changes, plant = header.get("changes", ()), header.get("plant", LINEAR)
        form, integrator, dt = header["form"], header["integrator"], header["dt"]
        return make_craft(flown, form, integrator, dt, changes, control=control, plant=plant)
    except (FdesError, KeyError, TypeError):
        return None


def _picture(aircraft: Aircraft) -> dict[str, Any]:
    size = aircraft.at().reference
    return {
        "id": aircraft.id,
        "name": aircraft.name,
        "summary": aircraft.summary,
        "conditions": [
            {
                "id": c.id,
                "name": c.name,
                "mach": c.mach,
                "h": c.altitude,
                "V": aircraft.at(c.id).reference.V,
                "mass_kg": aircraft.at(c.id).reference.m,
                "confidence": c.confidence,
            }
            for c in aircraft.conditions
        ],
        "source": aircraft.source,
        "three_view": {"span": size.b, "chord": size.c, "area": size.S},
    }
