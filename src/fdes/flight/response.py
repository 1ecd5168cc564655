"""The response of an aircraft to test inputs and initial perturbations, hands off: the commonest exercise of all."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf
from typing import Any

import numpy as np

from fdes import __version__
from fdes.aircraft import FlightCondition, in_a_condition
from fdes.control import Law, Stick
from fdes.control.laws.direct import Direct
from fdes.errors import NoSuchPart, SpecError
from fdes.flight.actuated import WithActuators, actuators_of
from fdes.flight.crossing import displaced
from fdes.flight.excitation import Excitation, GustyAir
from fdes.flight.header import header_of
from fdes.flight.pilot import HandsOff
from fdes.flight.plants import plant_of
from fdes.flight.recorder import columns_of, row_of
from fdes.flight.recording import Recording
from fdes.flight.simulation import Clock, Setup, fly
from fdes.flight.trajectory import trajectory
from fdes.physics.signals import Surfaces, channels
from fdes.physics.small_perturbation import Limits, PerturbationState
from fdes.units import parse

LOWEST, HIGHEST = -500.0, 86000.0  # m: the Dead Sea, and the end of the standard atmosphere
NO_LIMITS = Limits(Surfaces(-inf, -inf, -inf, -inf), Surfaces(inf, inf, inf, inf))


def simulate(
    condition: FlightCondition,
    inputs: Iterable[str] = (),
    *,
    clock: Clock,
    form: str = "full",
    integrator: str = "rk4",
    initial: Iterable[str] = (),
    height: float | None = None,
    limits: bool = False,
    law: Law | None = None,
    said: str = "direct",
    actuators: bool = False,
) -> Recording:
    """Fly `condition` from trim, hands off, with `inputs` such as ``step aileron 15deg at 0s``, ``step gust_w -5m/s``.

    `initial` disturbs states at the start: ``beta=5deg``, ``u=+10kt``; of either, a text is one. `height` [m] is where
    the flight starts, else the condition's. Surfaces go as far as they are asked unless `limits` stops them at what is
    assumed of them.
    `law` is a control law, made for this aircraft, and `said` what the recording calls it (`fdes.analysis.design`);
    `actuators` moves the surfaces by those that are assumed. Raises SpecError, NoSuchPart or Departed.

    >>> import fdes
    >>> flight = simulate(fdes.load("A-4D").at(), ["step aileron 1deg"], clock=Clock(0.01, duration=2.0))
    >>> bool(flight["p"][-1] > 0.0)
    True
    """
    if height is not None and not LOWEST <= height <= HIGHEST:
        raise SpecError(
            f"A flight cannot begin at {height:,.0f} m: it can between {LOWEST:,.0f} m and {HIGHEST:,.0f} m."
        )
    condition = in_a_condition(condition)
    inputs, initial = ([one] if isinstance(one, str) else list(one) for one in (inputs, initial))
    flown = condition if limits else replace(condition, limits=NO_LIMITS)
    plant = plant_of(flown, form, integrator, clock.dt / clock.substeps)
    excitation, throttle = Excitation.parse(inputs, files=True), condition.trim_throttle
    more = {"inputs": inputs, "initial": initial, "limits": limits}
    if law is None and not actuators:
        start = disturbed(plant.start(height), initial)
        flight = trajectory(plant, start, clock, Stick(throttle=throttle), excitation)
        engine = "whole columns, NumPy"
    else:
        moved = WithActuators(plant, actuators_of(condition)) if actuators else plant
        setup = Setup(moved, law or Direct(condition.full_stick))
        weather = GustyAir(excitation.gusts, plant.reference.V)
        start = disturbed(moved.start(height), initial)
        frames = fly(start, setup, HandsOff(throttle), weather, clock, excitation)
        rows = np.array([row_of(frame) for frame in frames])
        flight = Recording({}, columns_of(type(start)), rows, (), complete=True)
        engine, more = "frame by frame, Python", more | {"actuators": actuators}
    header = header_of(condition, form, integrator, clock, said, **more)
    return replace(flight, header={"fdes": __version__, "engine": engine, **header})


def disturbed(state: Any, initial: Iterable[str]) -> Any:
    """`state`, of either plant, with what is said added to it; commas or semicolons may be between several in a text.

    What can be said are the states of the linear plant; the nonlinear one takes them along the axes of its flow.

    >>> disturbed(PerturbationState(), ["beta=5deg, u=+10kt"]).u
    5.144444444444445
    """
    if "e0" in state._fields:
        return displaced(state, disturbed(PerturbationState(), initial))
    unit = {c.name: c.unit for c in channels(PerturbationState)}
    for said in (one.strip() for text in initial for one in text.replace(";", ",").split(",") if one.strip()):
        name, equals, value = (part.strip() for part in said.partition("="))
        if not equals:
            raise SpecError(f"The initial perturbation {said!r} is not understood. Write it like 'beta=5deg'.")
        if name not in unit:
            raise NoSuchPart("state", name, unit)
        if unit[name] != "1" and value and value[-1].isdigit():
            raise SpecError(f"The initial perturbation {said!r} has no unit. Write it like 'beta=5deg' or 'u=+10kt'.")
        state = state._replace(**{name: getattr(state, name) + parse(value, unit[name])})
    return state
