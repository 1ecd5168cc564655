"""An aircraft made ready for the cockpit: what flies, and what page and recording are told of it."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

from fdes.aircraft import FlightCondition, edited
from fdes.aircraft.edit import editable, value_of
from fdes.aircraft.knobs import knobs
from fdes.aircraft.role import Role, role_of
from fdes.analysis import Mode, linear_model, modes
from fdes.analysis.approximations import mode_report
from fdes.analysis.flown_plant import LINEAR, NONLINEAR, Trimmed, must_be_a_plant, trimmed
from fdes.analysis.measured import measure
from fdes.analysis.qualities import charts, judge
from fdes.analysis.step_limit import step_limit
from fdes.cockpit.flight_control import Control, Fitted, control_message, fitted
from fdes.cockpit.hub import RATE
from fdes.errors import SpecError
from fdes.flight import Clock, Setup, plant_of
from fdes.flight.actuated import with_actuators
from fdes.flight.header import header_of
from fdes.units import FOOT

if TYPE_CHECKING:
    from fdes.physics.derivatives import Form
    from fdes.physics.small_perturbation import SmallPerturbation

DT = 1.0 / RATE
LONGEST_STEP = 0.5  # s
START_HEIGHT = 1500.0 * FOOT  # lowest start: room to make a mistake, still with a view of the ground


@dataclass(frozen=True)
class Craft:
    """An aircraft in a flight condition, its equations chosen, ready to fly.

    `plant` is linear or nonlinear; `trimmed` is the latter, in the flight in which it begins.
    `base` is the aircraft as its file has it, `condition` the same with the changes made to it in flight. `role` is by
    what its flying qualities are judged, and `fit` its control law and actuators.
    `briefing` is the part of the wire's AIRCRAFT that it answers for, `modes` the mode dictionaries of the same plant.
    """

    base: FlightCondition
    condition: FlightCondition
    role: Role
    form: str
    plant: str
    integrator: str
    setup: Setup
    start: Any
    clock: Clock
    briefing: dict[str, Any]
    modes: list[dict[str, Any]]
    natural: list[Mode]
    bare: list[Mode]
    fit: Fitted
    trimmed: Trimmed | None

    def header(self) -> dict[str, Any]:
        """What a recording of it says first: enough to make the same craft again."""
        control = self.fit.control
        return header_of(
            self.condition, self.form, self.integrator, self.clock, control.law, actuators=control.actuators,
            **self._plant_note(),
        )  # fmt: skip

    def setup_note(self) -> dict[str, Any]:
        """What a recording says where, in flight, it becomes this craft: its part of the header that edits change."""
        return {
            "changes": [str(change) for change in self.condition.changes],
            "law": self.fit.control.law,
            "actuators": self.fit.control.actuators,
        } | self._plant_note()

    def _plant_note(self) -> dict[str, Any]:
        if self.trimmed is None:
            return {"plant": self.plant}
        return {"plant": self.plant, "trim": {"V": self.trimmed.V, "h": self.trimmed.h}}

    @property
    def trim_throttle(self) -> float:
        """Where the throttle lever holds undisturbed flight."""
        return self.condition.trim_throttle if self.trimmed is None else self.trimmed.throttle

    def moved_from(self, before: "Craft") -> str:
        """What an edit moves in flight, as a perturbation: with another altitude of its condition the linear plant.

        The air at it is what its equations are made of. The nonlinear one is trimmed for height and speed, and goes to
        both.
        """
        climb = self.briefing["h"] - before.briefing["h"]
        faster = 0.0 if self.trimmed is None else self.briefing["V"] - before.briefing["V"]
        return ", ".join(f"{name}={by!r}{unit}" for name, by, unit in (("h", climb, "m"), ("u", faster, "m/s")) if by)

    @property
    def changes(self) -> tuple[str, ...]:
        """What was changed of `base`, in order, as text."""
        return tuple(str(change) for change in self.condition.changes[len(self.base.changes) :])

    def edited(self, changes: Iterable[str], role: Role | None = None) -> "Craft":
        """The same with these changes to `base` instead of its own; gains stay. Raises NoSuchPart, SpecError."""
        return self.but(changes=changes, role=role or self.role)

    def but(
        self,
        *,
        form: str | None = None,
        integrator: str | None = None,
        step: float | None = None,
        changes: Iterable[str] | None = None,
        role: Role | None = None,
        control: Control | None = None,
        plant: str | None = None,
    ) -> "Craft":
        """The same aircraft with what is given instead of its own. Raises NoSuchPart, SpecError."""
        return make_craft(
            self.base,
            form or self.form,
            integrator or self.integrator,
            step or self.clock.dt,
            self.changes if changes is None else changes,
            role or self.role,
            control or self.fit.control,
            plant or self.plant,
        )

    @cached_property
    def knobs(self) -> list[dict[str, Any]]:
        """All that can be changed of `base`: see `fdes.aircraft.knobs`."""
        shifts = self.base.cg is None
        return [vars(knob) | {"shifts": shifts and knob.name == "cg"} for knob in knobs(self.base)]

    @cached_property
    def stability(self) -> dict[str, Any]:
        """The changes, and the present value of each number that can be changed, SI, by name."""
        names = editable(self.condition)
        return {"changes": list(self.changes), "values": {name: value_of(self.condition, name) for name in names}}

    @property
    def modes_message(self) -> dict[str, Any]:
        """The wire's MODES: those of the whole, and the eigenvalues without law and actuators where there are any."""
        bare = [] if self.fit.bare else [[m.eigenvalue.real, m.eigenvalue.imag] for m in self.bare]
        return {"type": "modes", "modes": self.modes, "bare": bare}

    @property
    def control(self) -> dict[str, Any]:
        """The wire's CONTROL: its law and its actuators."""
        return control_message(self.fit, self.condition)

    @cached_property
    def qualities(self) -> dict[str, Any]:
        """The verdicts on its flying qualities, with their charts, and by which Class and Category."""
        airframe = linear_model(self.condition, cast("Form", self.form))
        measured = measure(self.fit.model, None, self.natural, airframe)
        return {
            "role": {**vars(self.role), "says": str(self.role)},
            "verdicts": [verdict.as_dict() for verdict in judge(measured, self.role)],
            "charts": [chart.as_dict() for chart in charts(measured, self.role)],
        }


def make_craft(
    base: FlightCondition,
    form: str = "full",
    integrator: str = "rk4",
    step: float = DT,
    changes: Iterable[str] = (),
    role: Role | None = None,
    control: Control = Control(),  # noqa: B008  it cannot be changed
    plant: str = LINEAR,
) -> Craft:
    """Make `base` with `changes` ready to fly, one integrator step of `step` [s] a frame.

    `plant` is linear or nonlinear; the latter is trimmed at the speed of its condition and the height of the start.
    Raises NoSuchPart for a form, a plant or an integrator that does not exist, TrimError for what cannot be trimmed,
    SpecError for a step the cockpit cannot show, and the first and the last of these for changes that cannot be made
    and for a law that cannot be.
    """
    if not DT - 1e-9 <= step <= LONGEST_STEP:
        raise SpecError(
            f"A step of {step:g} s cannot be flown: the cockpit shows every step, of 1/{RATE} to {LONGEST_STEP:g} s."
        )
    condition = edited(base, changes)
    must_be_a_plant(plant, integrator)
    linear = plant_of(condition, form, integrator, step)
    height = max(condition.reference.h, START_HEIGHT)
    point = None if plant == LINEAR else trimmed(condition, integrator, condition.reference.V, height)
    flying = linear if point is None else point.plant
    wanted = cast("Form", form)  # plant_of has checked it
    bare = modes(condition, wanted)
    told = mode_report(condition, wanted, bare)
    fit = fitted(control, condition, wanted, step)
    natural = bare if fit.bare else modes(fit.model)
    flown = with_actuators(flying, condition) if control.actuators else flying
    start = flown.start(height)
    return Craft(
        base=base,
        condition=condition,
        role=role or role_of(base.document, base.condition),
        form=form,
        plant=plant,
        integrator=integrator,
        setup=Setup(flown, fit.designed.law),
        start=start,
        clock=Clock(step),
        briefing=_briefing(condition, form, integrator, step, height)
        | _nonlinear(condition, point)
        | {"step_limit": _limit(linear, natural if control.actuators else bare), "static": told["static"]},
        modes=told["modes"] if fit.bare else [mode.as_dict() | {"approximation": None} for mode in natural],
        natural=natural,
        bare=bare,
        fit=fit,
        trimmed=point,
    )


def _limit(plant: "SmallPerturbation", natural: list[Mode]) -> dict[str, Any] | None:
    """The step beyond which the integrator is unstable, and the mode that says so."""
    found = step_limit(plant.integrator, natural)
    return found and {"step": found[0], "mode": found[1].name}


def _nonlinear(condition: FlightCondition, point: Trimmed | None) -> dict[str, Any]:
    """What the page is told otherwise of the nonlinear plant."""
    if point is None:
        return {"plant": LINEAR}
    return {
        "plant": NONLINEAR,
        "alpha_trim": point.alpha,
        "theta_trim": point.theta,
        "trim_throttle": point.throttle,
        "notes": [*condition.notes, *point.assumptions],
    }


def _briefing(condition: FlightCondition, form: str, integrator: str, step: float, height: float) -> dict[str, Any]:
    """What the page shows of an aircraft: numbers in SI and radians."""
    ref = condition.reference
    return {
        "id": condition.aircraft_id,
        "name": condition.aircraft_name,
        "condition": condition.condition,
        "condition_name": condition_name(ref.mach, ref.h),
        "variant": condition.variant,
        "form": form,
        "integrator": integrator,
        "dt": step,
        "mass_kg": ref.m,
        "size": {"span": ref.b, "chord": ref.c, "area": ref.S},
        "V": ref.V,
        "mach": ref.mach,
        "h": height,
        "alpha_trim": ref.alpha,
        "theta_trim": ref.alpha + ref.gamma,
        "full_stick": condition.full_stick._asdict(),
        "limits": {"lower": condition.limits.lower._asdict(), "upper": condition.limits.upper._asdict()},
        "notes": list(condition.notes),
        "assumed": [{"name": name, **said} for name, said in condition.assumed.items()],
        "trim_throttle": condition.trim_throttle,
    }


def condition_name(mach: float, h: float) -> str:
    """A flight condition as a pilot says it, `h` in m: ``M 0.40, sea level`` or ``M 0.80, 35,000 ft``."""
    feet = h / FOOT
    return f"M {mach:.2f}, {'sea level' if abs(feet) < 50.0 else f'{feet:,.0f} ft'}"
