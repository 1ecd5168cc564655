"""The response of the nonlinear plant to the inputs that the linear one takes, from a trimmed flight."""

from collections.abc import Iterable
from dataclasses import replace
from math import cos, inf, sin
from typing import NamedTuple

from fdes import __version__
from fdes.aircraft import FlightCondition
from fdes.analysis.jacobian import perturbed
from fdes.analysis.trim import TrimPoint, TrimSpec, trim
from fdes.control import Law
from fdes.control.laws.direct import Direct
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.excitation import Excitation, GustyAir
from fdes.flight.header import header_of
from fdes.flight.nonlinear import assumptions, six_dof_of
from fdes.flight.pilot import HandsOff
from fdes.flight.recorder import columns_of, row_of
from fdes.flight.recording import Recording, frames_to_recording
from fdes.flight.response import disturbed
from fdes.flight.simulation import Clock, Setup, fly
from fdes.flight.table_ends import beyond_tables, table_ends
from fdes.flight.trim_over_earth import Over, trim_over
from fdes.physics.earth import EARTHS
from fdes.physics.plant import SixDof, State
from fdes.physics.signals import Surfaces
from fdes.physics.small_perturbation import Limits, PerturbationState
from fdes.units import Radian

NO_LIMITS = Limits(Surfaces(-inf, -inf, -inf, 0.0), Surfaces(inf, inf, inf, 1.0))


class Place(NamedTuple):
    """Where on which Earth a flight begins, and to where: `heading` from north."""

    earth: str
    latitude: Radian = 0.0
    longitude: Radian = 0.0
    heading: Radian = 0.0


def over_earth(point: TrimPoint, place: Place) -> SixDof:
    """The plant of `point`, trimmed again over a round Earth at the same speed, height and flight-path angle.

    Raises NoSuchPart for an Earth that does not exist, SpecError over a flat one and for a flight that turns or
    sideslips, TrimError.
    """
    if place.earth not in EARTHS:
        raise NoSuchPart("Earth", place.earth, EARTHS)
    spec = point.spec
    if spec.turn or spec.beta or spec.q:
        raise SpecError("Over a round Earth flight begins straight and level, or climbing: give V, h and gamma alone.")
    level = spec.V * cos(spec.gamma)
    north, east = level * cos(place.heading), level * sin(place.heading)
    at = Over(place.latitude, place.longitude, spec.h, north, east, -spec.V * sin(spec.gamma))
    return trim_over(point.plant, EARTHS[place.earth], at)


def simulate_nonlinear(
    condition: FlightCondition,
    inputs: Iterable[str] = (),
    *,
    clock: Clock,
    spec: TrimSpec | None = None,
    integrator: str = "rk4",
    initial: Iterable[str] = (),
    limits: bool = False,
    law: Law | None = None,
    said: str = "direct",
    place: Place | None = None,
) -> Recording:
    """Fly the nonlinear plant of `condition` from the steady flight `spec`, else from that of the condition, hands off.

    inputs, initial, limits, law, said: as for the linear plant (`fdes.simulate`); `initial` is along the stability axes
    of the trim. place: where on Earth, and on which one; else over a flat Earth, to the north. The throttle stays
    within its range. Rates and load factors are along body axes.
    Raises SpecError, NoSuchPart, TrimError or Departed.
    """
    inputs, initial = list(inputs), list(initial)
    plant = six_dof_of(condition, integrator)
    asked = spec or TrimSpec(condition.reference.V, condition.reference.h)
    point = trim(plant, asked)
    begun = point.plant if place is None else over_earth(point, place)
    flown = begun if limits else begun._replace(limits=NO_LIMITS)
    by = disturbed(PerturbationState(), initial)
    if initial and place is not None:
        raise SpecError(
            "A flight over a round Earth takes no initial perturbation: leave it out, or fly over a flat one."
        )
    if initial and (point.spec.turn or point.spec.beta or point.spec.q):
        raise SpecError("A flight that turns or sideslips takes no initial perturbation: leave one of the two out.")
    excitation = Excitation.parse(inputs, files=True)
    setup = Setup(flown, law or Direct(condition.full_stick))
    pilot, weather = HandsOff(begun.rest.throttle), GustyAir(excitation.gusts, point.spec.V)
    start = perturbed(point, by) if initial else flown.start()
    frames = fly(start, setup, pilot, weather, clock, excitation)
    header = header_of(
        condition, "nonlinear", integrator, clock, said, inputs=inputs, initial=initial, limits=limits,
        trim=point.spec.flight(), earth="flat" if place is None else place.earth,
        assumptions=assumptions(condition, plant),
    )  # fmt: skip
    header = {"fdes": __version__, "engine": "frame by frame, Python", **header}
    flight = frames_to_recording(header, columns_of(State), map(row_of, frames))
    left = beyond_tables(flown, {name: flight[name].tolist() for name in table_ends(flown)}, flight["t"].tolist())
    return replace(flight, header={**header, "assumptions": [*header["assumptions"], *left]})
