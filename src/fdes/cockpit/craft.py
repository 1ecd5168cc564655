"""An aircraft made ready for the cockpit: what flies, and what page and recording are told of it."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

from fdes.aircraft import FlightCondition
from fdes.analysis import Mode, modes
from fdes.analysis.approximations import mode_report
from fdes.analysis.step_limit import step_limit
from fdes.cockpit.hub import RATE
from fdes.control.laws.direct import Direct
from fdes.errors import SpecError
from fdes.flight import Clock, Setup, plant_of
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

    `briefing` is the part of the wire's AIRCRAFT that it answers for, `modes` the mode dictionaries of the same plant.
    """

    condition: FlightCondition
    form: str
    integrator: str
    setup: Setup
    start: Any
    clock: Clock
    briefing: dict[str, Any]
    modes: list[dict[str, Any]]

    def header(self) -> dict[str, Any]:
        """What a recording of it says first: enough to make the same craft again."""
        return header_of(self.condition, self.form, self.integrator, self.clock)


def make_craft(condition: FlightCondition, form: str = "full", integrator: str = "rk4", step: float = DT) -> Craft:
    """Make `condition` ready to fly, one integrator step of `step` [s] a frame.

    Raises NoSuchPart for a form or an integrator that does not exist, SpecError for a step the cockpit cannot show.
    """
    if not DT - 1e-9 <= step <= LONGEST_STEP:
        raise SpecError(
            f"A step of {step:g} s cannot be flown: the cockpit shows every step, of 1/{RATE} to {LONGEST_STEP:g} s."
        )
    plant = plant_of(condition, form, integrator, step)
    start = plant.start(max(condition.reference.h, START_HEIGHT))
    wanted = cast("Form", form)  # plant_of has checked it
    natural = modes(condition, wanted)
    told = mode_report(condition, wanted, natural)
    return Craft(
        condition=condition,
        form=form,
        integrator=integrator,
        setup=Setup(plant, Direct(condition.full_stick)),
        start=start,
        clock=Clock(step),
        briefing=_briefing(condition, form, integrator, step, start.h)
        | {"step_limit": _limit(plant, natural), "static": told["static"]},
        modes=told["modes"],
    )


def _limit(plant: "SmallPerturbation", natural: list[Mode]) -> dict[str, Any] | None:
    """The step beyond which the integrator is unstable, and the mode that says so."""
    found = step_limit(plant.integrator, natural)
    return found and {"step": found[0], "mode": found[1].name}


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
