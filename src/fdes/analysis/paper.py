"""The figures and tables of the paper that FDES continues, flown again and held against what it says of them.

Mansor and Perumal name no aircraft for figures 8, 10 and 11 and no input for figure 7. Assumed here: the A-4D at Mach
0.4, sea level, as printed, in the paper's own equations (2.1, 2.2), and 0.2618 rad on aileron and elevator.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import load
from fdes.analysis.verify import checks
from fdes.control.laws.direct import Direct
from fdes.errors import Departed
from fdes.flight import Clock, Excitation, HandsOff, Setup, SteadyAir, fly, plant_of
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import Limits
from fdes.sources import sources

AIRCRAFT, CONDITION = "A-4D", "M0.4_SL"
INPUT = 0.2618  # rad, the input that figures 10 and 11 state
FARTHER = Surfaces(1e3, 1e3, 1e3, 1e3)  # no stops: the paper's program had none

Series = NDArray[np.float64]


@dataclass(frozen=True)
class Response:
    """One response: times [s] and a rate [rad/s]."""

    label: str
    t: Series
    rate: Series


@dataclass(frozen=True)
class Claim:
    """What the paper shows, and what was found when it was done again."""

    says: str
    found: str
    passed: bool


@dataclass(frozen=True)
class Figure:
    """One figure of the paper, flown again: each response, and the exact one [rad/s] on a fine grid."""

    name: str
    title: str
    rate: str
    exact: Response
    responses: tuple[Response, ...]
    claims: tuple[Claim, ...]


def paper_figures() -> list[Figure]:
    """Figures 7, 8, 10 and 11."""
    return [_figure_7(), _figure_8(), _figure_10(), _figure_11()]


def response(surface: Literal["aileron", "elevator"], integrator: str, step: float, duration: float = 6.0) -> Response:
    """Roll rate after a step of aileron, or pitch rate after one of elevator (trailing edge up), both of `INPUT`.

    A response that departs is returned as far as it went.
    """
    condition = load(AIRCRAFT).at(CONDITION, variant="printed")
    plant = plant_of(condition, "paper", integrator, step)
    plant = plant._replace(limits=Limits(Surfaces(*[-v for v in FARTHER]), FARTHER))
    amount = INPUT if surface == "aileron" else -INPUT
    excitation = Excitation.parse([f"step {surface} {amount}rad at 0s"])
    pilot = HandsOff(condition.trim_throttle)
    setup = Setup(plant, Direct(condition.full_stick))
    t, rate = [], []
    try:
        for frame in fly(plant.start(), setup, pilot, SteadyAir(), Clock(step, 1, duration), excitation):
            t.append(frame.t)
            rate.append(frame.outputs.p if surface == "aileron" else frame.outputs.q)
    except Departed:
        pass
    return Response(f"{integrator.replace('_', '-')}, {step:g} s", np.array(t), np.array(rate))


def largest_error(found: Response, exact: Response) -> float:
    """The largest difference [rad/s] at the times that both have. The grid of `exact` must contain that of `found`."""
    every = round((found.t[1] - found.t[0]) / (exact.t[1] - exact.t[0]))
    return float(np.max(np.abs(found.rate - exact.rate[::every][: len(found.rate)])))


def execution_times(repeat: int = 3) -> list[dict[str, Any]]:
    """Table 5.1 then and now: seconds for 100 s of flight by integrator and step, the fastest of `repeat` flights."""
    (table,) = sources()["mansor_perumal"]["execution_times"]
    rows = []
    for row in table["rows"]:
        fly_it = partial(response, "aileron", row["integrator"], row["step"], 100.0)
        times = [_seconds(fly_it) for _ in range(repeat)]
        rows.append({**row, "now": min(times)})
    return rows


def table_claims() -> list[Claim]:
    """The paper's two tables agree with each other: table 5.2 is table 5.1 divided by the number of loops."""
    found = checks({"mansor_perumal": sources()["mansor_perumal"]})
    return [
        Claim(f"{c.quantity}: {c.published:g} in table 5.2", f"table 5.1 by its loops gives {c.computed:.4g}", c.passed)
        for c in found
    ]


def _seconds(work: Callable[[], object]) -> float:
    begun = time.perf_counter()
    work()
    return time.perf_counter() - begun


def _figure_7() -> Figure:
    exact = response("elevator", "exact", 0.02, 20.0)
    euler = response("elevator", "euler", 0.04, 20.0)
    peak = float(np.max(exact.rate))
    above = float(np.max(euler.rate)) / peak - 1.0
    claim = Claim(
        "Euler's method at 0.04 s follows the exact pitch rate and overshoots it somewhat",
        f"peak {100 * above:.1f} % above the exact {peak:.3f} rad/s",
        0.0 < above < 0.15,
    )
    return Figure("7", "Pitch rate, Euler's method, 0.04 s", "q [rad/s]", exact, (euler,), (claim,))


def _figure_8() -> Figure:
    exact = response("aileron", "exact", 0.01)
    coarse, middle, fine = (response("aileron", "euler", step) for step in (0.1, 0.04, 0.01))
    peak = float(np.max(exact.rate))
    grown = float(np.max(np.abs(response("aileron", "euler", 0.1, 30.0).rate))) / peak
    above = float(np.max(middle.rate)) / peak - 1.0
    claims = (
        Claim("Euler at 0.1 s is unstable", f"after 30 s it is {grown:.0f} times the exact peak", grown > 10.0),
        Claim("Euler at 0.04 s overshoots", f"peak {100 * above:.1f} % above the exact one", 0.02 < above < 0.2),
        Claim(
            "Euler at 0.01 s is close to the exact response",
            f"largest error {largest_error(fine, exact):.3f} rad/s",
            largest_error(fine, exact) < 0.01 * peak,
        ),
    )
    return Figure("8", "Roll rate, Euler's method", "p [rad/s]", exact, (coarse, middle, fine), claims)


def _figure_10() -> Figure:
    exact = response("aileron", "exact", 0.01)
    both = (response("aileron", "rk4", 0.04), response("aileron", "kutta_merson", 0.04))
    claims = tuple(
        Claim(
            f"{found.label} cannot be told from the exact response",
            f"largest error {largest_error(found, exact):.2g} rad/s",
            largest_error(found, exact) < 1e-4,
        )
        for found in both
    )
    return Figure("10", "Roll rate, Runge-Kutta 4 and Kutta-Merson, 0.04 s", "p [rad/s]", exact, both, claims)


def _figure_11() -> Figure:
    exact = response("aileron", "exact", 0.01, 10.0)
    allowed = {0.1: 1e-4, 0.2: 2e-3, 0.3: 1e-2, 0.5: 0.1}
    flown = {step: response("aileron", "kutta_merson", step, 10.0) for step in allowed}
    claims = tuple(
        Claim(
            f"Kutta-Merson at {step:g} s is stable and close to the exact response",
            f"largest error {largest_error(flown[step], exact):.2g} rad/s, our bound {bound:g}",
            largest_error(flown[step], exact) < bound,
        )
        for step, bound in allowed.items()
    )
    return Figure(
        "11", "Roll rate, Kutta-Merson, steps from 0.1 to 0.5 s", "p [rad/s]", exact, tuple(flown.values()), claims
    )
