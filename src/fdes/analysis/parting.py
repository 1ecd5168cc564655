"""Where the linear plant and the nonlinear one part company: the same input on both, larger and larger.

The two are compared where the aircraft says the same of both: angles, speed, and rates along the stability axes of the
trim, for the linear plant has no others (docs/decisions, 0003 and 0008). The difference in a signal is the largest over
the flight, as a share of the largest excursion of the linear one; that of a flight is the worst signal's, of those that
the input moves.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import cos, sin, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import FlightCondition
from fdes.analysis import nonlinear_response
from fdes.analysis.trim import TrimPoint, TrimSpec, trim
from fdes.control import Stick
from fdes.control.laws.direct import Direct
from fdes.errors import Departed, SpecError, TrimError
from fdes.flight import Clock, HandsOff, Recording, Setup, fly, plant_of
from fdes.flight.excitation import Excitation, GustyAir
from fdes.flight.nonlinear import six_dof_of
from fdes.flight.recorder import columns_of, row_of
from fdes.flight.recording import frames_to_recording
from fdes.flight.response import NO_LIMITS
from fdes.flight.trajectory import trajectory
from fdes.physics.plant import State
from fdes.physics.signals import Surfaces

Column = NDArray[np.float64]

# What an input moves most. What it moves by the way, such as beta by the aileron, is small in both plants, and differs
# much: the nonlinear one finds its own trim, a tenth of a degree from the angle of attack that is printed.
TELLING: Mapping[str, tuple[str, ...]] = {
    "elevator": ("alpha", "q", "theta"),
    "throttle": ("V", "theta"),
    "aileron": ("p", "phi"),
    "rudder": ("beta", "r"),
    "gust_u": ("V", "theta"),
    "gust_v": ("beta", "r"),
    "gust_w": ("alpha", "q", "theta"),
    "alpha_g": ("alpha", "q", "theta"),
    "beta_g": ("beta", "r"),
}
ROUND = {"phi", "theta", "psi"}  # angles that begin anew after half a turn
SMALL, LARGE = 1.0 / 64.0, 64.0  # of the input that is asked for: between these is looked
FINE = 1.01  # how near an amplitude is found, as a ratio


@dataclass(frozen=True)
class Apart:
    """The same input on both plants. shares: the difference of each signal that the input moves, and of the worst.

    linear, nonlinear: the flights; the rates p and r of the second are along the stability axes of the trim. scale: of
    the input that was asked for. departed: why the nonlinear flight ended early, or empty.
    """

    scale: float
    linear: Recording
    nonlinear: Recording
    shares: Mapping[str, float]
    departed: str = ""

    @property
    def worst(self) -> float:
        """The difference of the signal that differs most; infinite where the nonlinear flight departed."""
        return np.inf if self.departed else max(self.shares.values())


class Parting(NamedTuple):
    """The scale of the input at which the worst difference reaches what was allowed, the flights there, and the nearest
    that were further apart.

    scale: infinite where they stay together to the largest input that is looked at, zero where they never were.
    """

    scale: float
    flights: Apart
    beyond: Apart


def apart(condition: FlightCondition, inputs: Sequence[str], clock: Clock, scale: float = 1.0) -> Apart:
    """Fly `scale` times the `inputs`, such as "doublet elevator 2deg for 2s", on both plants of `condition`.

    The linear plant is of the form ``full``; both begin in the condition's own flight, surfaces without stops. Raises
    SpecError, NoSuchPart, TrimError.

    >>> import fdes
    >>> a4d = fdes.load("A-4D").at()
    >>> found = apart(a4d, ["doublet elevator 0.5deg for 2s"], Clock(0.02, duration=4.0))
    >>> found.worst < 0.05
    True
    """
    excitation = _scaled(Excitation.parse(inputs, files=True), scale)
    told = _telling(excitation)
    linear_plant = plant_of(replace(condition, limits=NO_LIMITS))
    linear = trajectory(linear_plant, linear_plant.start(), clock, Stick(throttle=condition.trim_throttle), excitation)
    point = _trimmed(condition)
    nonlinear, departed = _flown(point, condition, excitation, clock)
    nonlinear = _along_stability_axes(nonlinear, point.alpha)
    return Apart(scale, linear, nonlinear, _shares(linear, nonlinear, told), departed)


def parting(condition: FlightCondition, inputs: Sequence[str], clock: Clock, allowed: float = 0.1) -> Parting:
    """The scale of `inputs` at which the plants differ by the share `allowed`, found to 1 % by halving.

    The difference grows with the amplitude: it is of second order. Raises SpecError, NoSuchPart, TrimError.
    """
    if not 0.0 < allowed < 1.0:
        raise SpecError(f"The difference allowed is {allowed:g}; it must be a share between 0 and 1, such as 0.1.")
    here = apart(condition, inputs, clock)
    step = 2.0 if here.worst <= allowed else 0.5
    largest = _largest(condition, inputs)
    while (here.worst <= allowed) == (step > 1.0):
        if not SMALL < here.scale < largest:
            return Parting(np.inf if step > 1.0 else 0.0, here, here)
        before, here = here, apart(condition, inputs, clock, min(here.scale * step, max(largest, here.scale * 0.5)))
    near, far = (before, here) if step > 1.0 else (here, before)
    while far.scale > near.scale * FINE:
        middle = apart(condition, inputs, clock, sqrt(near.scale * far.scale))
        near, far = (middle, far) if middle.worst <= allowed else (near, middle)
    return Parting(near.scale, near, far)


def amplitude(inputs: Sequence[str], scale: float) -> list[tuple[str, float]]:
    """The channel and the amplitude [SI] of each input, `scale` times as large as it was said."""
    return [(channel, _size(shape)) for channel, shape in _scaled(Excitation.parse(inputs, files=True), scale).parts]


def _scaled(excitation: Excitation, scale: float) -> Excitation:
    parts = []
    for channel, shape in excitation.parts:
        parts.append((channel, replace(shape, amplitude=scale * _size(shape))))
    if not parts:
        raise SpecError("There is no input: say one, such as 'doublet elevator 2deg for 2s'.")
    return Excitation(tuple(parts))


def _size(shape: Any) -> float:
    if not hasattr(shape, "amplitude"):
        raise SpecError("An input from a file has no amplitude that could grow. Say one of the shapes.")
    return float(shape.amplitude)


def _largest(condition: FlightCondition, inputs: Sequence[str]) -> float:
    """The scale at which the first surface is at its assumed stop; of gusts there is no end but `LARGE`."""
    stops = {name: max(-low, high) for name, low, high in zip(Surfaces._fields, *condition.limits, strict=True)}
    ratios = [stops[channel] / abs(size) for channel, size in amplitude(inputs, 1.0) if channel in stops and size]
    return min([LARGE, *ratios])


def _telling(excitation: Excitation) -> tuple[str, ...]:
    """The signals that the inputs move, each once."""
    return tuple(dict.fromkeys(name for channel, _ in excitation.parts for name in TELLING[channel]))


def _trimmed(condition: FlightCondition) -> TrimPoint:
    ref = condition.reference
    try:
        return trim(six_dof_of(condition), TrimSpec(ref.V, ref.h, ref.gamma))
    except TrimError as no:
        raise SpecError(
            f"The nonlinear plant cannot fly {condition.condition}, so there is nothing to compare: {no}"
        ) from no


def _flown(point: TrimPoint, condition: FlightCondition, excitation: Excitation, clock: Clock) -> tuple[Recording, str]:
    """The nonlinear flight, as far as it goes, and why it goes no further."""
    plant = point.plant._replace(limits=nonlinear_response.NO_LIMITS)
    setup = Setup(plant, Direct(condition.full_stick))
    frames = fly(
        plant.start(), setup, HandsOff(plant.rest.throttle), GustyAir(excitation.gusts, point.spec.V), clock, excitation
    )
    rows: list[tuple[float, ...]] = []
    try:
        rows.extend(map(row_of, frames))
        why = ""
    except Departed as end:
        why = str(end)
    return frames_to_recording({}, columns_of(State), rows), why


def _along_stability_axes(flight: Recording, alpha: float) -> Recording:
    """`flight` with its roll and yaw rates turned by the angle of attack of the trim."""
    names = [c.name for c in flight.columns]
    data = flight.data.copy()
    p, r = flight["p"], flight["r"]
    data[:, names.index("p")] = p * cos(alpha) + r * sin(alpha)
    data[:, names.index("r")] = r * cos(alpha) - p * sin(alpha)
    return replace(flight, data=data)


def _shares(linear: Recording, nonlinear: Recording, told: Sequence[str]) -> dict[str, float]:
    count = len(nonlinear.data)
    found = {}
    for name in told:
        moved = linear[name] - linear[name][0]
        most = float(np.abs(moved).max())
        if most > 0.0:
            difference = nonlinear[name] - nonlinear[name][0] - moved[:count]
            if name in ROUND:
                difference = np.remainder(difference + np.pi, 2.0 * np.pi) - np.pi
            found[name] = float(np.abs(difference).max()) / most
    if not found:
        raise SpecError("Nothing moved: let the input begin before the end of the flight.")
    return found
