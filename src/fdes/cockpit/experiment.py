"""A whole experiment as a small JSON object: what flies, how it was changed, by which law, and what is put in.

It is data and nothing else. Aircraft, laws, forms and integrators go by the names of what the server offers; an
aircraft that it does not offer is in the experiment as the content of its file. No name in it is ever taken for a path
or for code.
"""

import json
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from fdes.aircraft import parse
from fdes.aircraft.across import MACH
from fdes.aircraft.role import role_of
from fdes.analysis.flown_plant import LINEAR
from fdes.cockpit.commands import Hold, PutIn
from fdes.cockpit.craft import Craft, make_craft
from fdes.cockpit.excite import held as held_by_hand
from fdes.cockpit.excite import must_be_soon
from fdes.cockpit.fleet import Fleet
from fdes.cockpit.flight_control import Control
from fdes.errors import SpecError
from fdes.flight import Excitation
from fdes.flight.excitation import UNITS

MOST = 64  # changes, and inputs
LONGEST = 400  # characters of a text
LONGEST_LAW = 2000  # six laws with all digits of their gains


class Experiment(BaseModel):
    """What an experiment may say. `inputs` begin `after` so many seconds, by their order; all at once without it.

    `wanted` is, by law, what its gains were designed for.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)

    format: Literal["fdes experiment 1"]
    aircraft: str = Field(max_length=LONGEST)
    condition: str = Field(max_length=LONGEST)
    variant: Literal["corrected", "printed"] = "corrected"
    form: str = Field(default="full", max_length=LONGEST)
    plant: str = Field(default=LINEAR, max_length=LONGEST)
    across: str | None = Field(default=None, max_length=LONGEST)
    spool: bool = False
    integrator: str = Field(default="rk4", max_length=LONGEST)
    step: float
    changes: list[str] = Field(default=[], max_length=MOST)
    law: str = Field(default="direct", max_length=LONGEST_LAW)
    sampled: bool = False
    wanted: dict[str, float] = Field(default={}, max_length=MOST)
    actuators: bool = False
    inputs: list[str] = Field(default=[], max_length=MOST)
    after: list[float] = Field(default=[], max_length=MOST)
    held: list[str] = Field(default=[], max_length=MOST)
    airplane_class: str | None = None
    category: str | None = None
    phase: str | None = None
    document: dict[str, Any] | None = None

    def put_in(self) -> list[PutIn | Hold]:
        """What to put in when it flies."""
        after = self.after or [0.0] * len(self.inputs)
        return [*map(PutIn, self.inputs, after), *map(Hold, self.held)]


def experiment_of(
    craft: Craft,
    fleet: Fleet,
    inputs: Sequence[tuple[float, str]],
    held: Mapping[str, float] = MappingProxyType({}),
) -> dict[str, Any]:
    """The experiment that `craft`, its test inputs, each when [s] and what, and the values held by hand [SI] are."""
    base, control = craft.base, craft.fit.control
    offered = fleet.aircraft.get(base.aircraft_id)
    own = role_of(base.document, base.condition)
    said = {
        "airplane_class": craft.role.airplane_class,
        "category": craft.role.category,
        "phase": craft.role.phase,
    }
    asked = {key: value for key, value in said.items() if value != getattr(own, key)}
    return Experiment(
        format="fdes experiment 1",
        aircraft=base.aircraft_id,
        condition=base.condition,
        variant=base.variant,
        form=craft.form,
        plant=craft.plant,
        across=MACH if base.across else None,
        spool=base.spool,
        integrator=craft.integrator,
        step=craft.clock.dt,
        changes=list(craft.changes),
        law=control.law,
        sampled=control.sampled,
        actuators=control.actuators,
        wanted=dict(control.wanted),
        inputs=[text for _, text in inputs],
        after=[t for t, _ in inputs] if any(t for t, _ in inputs) else [],
        held=[f"{channel} {value!r} {UNITS[channel]}".removesuffix(" 1") for channel, value in held.items()],
        document=None if offered and offered.document == base.document else dict(base.document),
        **asked,
    ).model_dump(exclude_defaults=True)


def opened(text: str, fleet: Fleet) -> tuple[Craft, Experiment]:
    """The craft of an experiment's text, and the experiment: what to put in when it flies. Raises FdesError."""
    try:
        said = Experiment.model_validate(json.loads(text))
    except ValidationError as wrong:
        first = wrong.errors()[0]
        key = ".".join(map(str, first["loc"])) or "it"
        raise SpecError(f"The experiment cannot be used: {key}: {first['msg']}.") from None
    except (ValueError, RecursionError):
        raise SpecError("The experiment cannot be used: it is not JSON.") from None
    if said.document is None:
        aircraft = fleet.named(said.aircraft)
    else:
        aircraft = parse(said.document, "The aircraft in the experiment")
    base = aircraft.at(said.condition, said.variant, across=said.across, spool=said.spool)
    role = role_of(base.document, base.condition).but(said.airplane_class, said.category, said.phase)
    if said.after and len(said.after) != len(said.inputs):
        raise SpecError(f"The experiment cannot be used: it has {len(said.inputs)} inputs and {len(said.after)} times.")
    Excitation.parse(said.inputs)  # complains now, if it must
    for seconds in said.after:
        must_be_soon(seconds)
    for text_of_one in said.held:
        held_by_hand(text_of_one)
    control = Control(law=said.law, actuators=said.actuators, sampled=said.sampled, wanted=said.wanted)
    craft = make_craft(base, said.form, said.integrator, said.step, said.changes, role, control, said.plant)
    return craft, said
