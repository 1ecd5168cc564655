"""What a pilot may ask for: one small class for each command, and the names they have on the wire."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Freeze:
    """Stop or go on, flight or replay."""

    value: bool


@dataclass(frozen=True)
class Reset:
    """Back to undisturbed flight."""


@dataclass(frozen=True)
class Step:
    """One frame, then frozen."""


@dataclass(frozen=True)
class Record:
    """Start a new recording, or end the present one and keep it."""

    value: bool


@dataclass(frozen=True)
class ChooseAircraft:
    """Fly another aircraft, or another condition of it."""

    aircraft: str
    condition: str | None = None
    variant: str = "corrected"


@dataclass(frozen=True)
class Equations:
    """Fly the same aircraft on, from trim, with other equations, another integrator, or another step [s]."""

    form: str
    integrator: str
    step: float


@dataclass(frozen=True)
class PutIn:
    """Begin a test input, such as ``doublet elevator 2deg for 1s``, `after` s; its times count from then."""

    text: str
    after: float = 0.0


@dataclass(frozen=True)
class PutInHistory:
    """Begin a measured history on `channel` now: `times` [s] and `values` [SI]. It comes as a binary message."""

    channel: str
    times: tuple[float, ...]
    values: tuple[float, ...]


@dataclass(frozen=True)
class Hold:
    """Hold a constant value on a channel, such as ``elevator 2deg``, until another is held, or all are cleared."""

    text: str


@dataclass(frozen=True)
class Preview:
    """What a test input will be, without putting it in."""

    text: str


@dataclass(frozen=True)
class ClearInputs:
    """End all test inputs, and let go of all values held."""


@dataclass(frozen=True)
class Disturb:
    """Add a perturbation to the state, such as ``beta=5deg``."""

    text: str


@dataclass(frozen=True)
class Delete:
    """Delete a recording for good."""

    recording: str


@dataclass(frozen=True)
class PlayBack:
    """Show a recording instead of the flight."""

    recording: str


@dataclass(frozen=True)
class WhatIf:
    """Fly a recording's stick again for each variation, such as ``Cm_q*=0.5; law=yaw_damper``; "" is as it was."""

    recording: str
    variations: tuple[str, ...]


@dataclass(frozen=True)
class Seek:
    """Jump to `t` [s] after the start of the recording that is shown."""

    t: float


@dataclass(frozen=True)
class StopReplay:
    """Back to the flight, frozen where it was."""


@dataclass(frozen=True)
class Ping:
    """Nothing but an answer."""


@dataclass(frozen=True)
class Edit:
    """Fly on with these changes to the aircraft, all of them, in their order: variable stability.

    `dragging` says that a slider is still moving: what one movement does is undone by one `Undo`.
    """

    changes: tuple[str, ...]
    dragging: bool = False


@dataclass(frozen=True)
class Undo:
    """Fly on with the changes before the last edit."""


@dataclass(frozen=True)
class Redo:
    """Fly on with the changes that the last undo took back."""


@dataclass(frozen=True)
class Judge:
    """Judge flying qualities by this Class, Category and Flight Phase; null leaves the aircraft's own."""

    airplane_class: str | None = None
    category: str | None = None
    phase: str | None = None


@dataclass(frozen=True)
class Improve:
    """Which number to change, and to what, so that a criterion of flying qualities gives the next Level."""

    criterion: str


@dataclass(frozen=True)
class Calculate:
    """The dimensional derivatives and the matrices of what is flown, as numbers."""


@dataclass(frozen=True)
class Margins:
    """How far each loop of the control laws in use is from growing."""


@dataclass(frozen=True)
class Airspeeds:
    """One speed in all its forms: `kind` is mach, tas, eas or cas; `value` [m/s], or a Mach number; at `h` [m]."""

    kind: str
    value: float
    h: float


@dataclass(frozen=True)
class SaveAircraft:
    """What is flown as an aircraft file, which is TOML."""


@dataclass(frozen=True)
class Share:
    """The whole experiment as JSON."""


@dataclass(frozen=True)
class OpenExperiment:
    """Fly this experiment, which is JSON. It comes as a binary message."""

    text: str


@dataclass(frozen=True)
class OpenAircraft:
    """Fly the aircraft of this file, which is TOML. It comes as a binary message."""

    text: str


@dataclass(frozen=True)
class Engage:
    """Fly on with this law, such as ``yaw_damper zeta=0.4; pitch_rate_damper gain=0.2``; ``direct`` is none.

    It is designed now, for what flies now; with `sampled` in z, at the step of the flight, else in s.
    """

    text: str
    sampled: bool = False


@dataclass(frozen=True)
class UseActuators:
    """Fly on with actuators before the surfaces, or without."""

    on: bool


@dataclass(frozen=True)
class ChoosePlant:
    """Fly on with this plant, linear or nonlinear, from where the aircraft is."""

    plant: str


Command = (
    Freeze
    | Reset
    | Step
    | Record
    | ChooseAircraft
    | Equations
    | PutIn
    | PutInHistory
    | Hold
    | Preview
    | ClearInputs
    | Disturb
    | Delete
    | PlayBack
    | WhatIf
    | Seek
    | StopReplay
    | Ping
    | Edit
    | Undo
    | Redo
    | Judge
    | Improve
    | Calculate
    | Margins
    | Airspeeds
    | OpenAircraft
    | OpenExperiment
    | SaveAircraft
    | Share
    | Engage
    | UseActuators
    | ChoosePlant
)

COMMANDS: dict[str, type[Command]] = {
    "freeze": Freeze,
    "reset": Reset,
    "step": Step,
    "record": Record,
    "aircraft": ChooseAircraft,
    "equations": Equations,
    "input": PutIn,
    "hold": Hold,
    "preview": Preview,
    "clear_inputs": ClearInputs,
    "disturb": Disturb,
    "delete": Delete,
    "replay": PlayBack,
    "what_if": WhatIf,
    "seek": Seek,
    "stop_replay": StopReplay,
    "ping": Ping,
    "edit": Edit,
    "undo": Undo,
    "redo": Redo,
    "judge": Judge,
    "improve": Improve,
    "save_aircraft": SaveAircraft,
    "share": Share,
    "calculate": Calculate,
    "margins": Margins,
    "airspeeds": Airspeeds,
    "law": Engage,
    "actuators": UseActuators,
    "plant": ChoosePlant,
}
