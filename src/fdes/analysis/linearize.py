"""From an aircraft in a flight condition to a linear model with names."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.aircraft import FlightCondition, in_a_condition
from fdes.control import LinearModel
from fdes.errors import NoSuchPart, SpecError
from fdes.flight import plant_of
from fdes.flight.response import NO_LIMITS
from fdes.physics.derivatives import Form, Matrices
from fdes.physics.signals import Air, Outputs, Surfaces, channels
from fdes.physics.small_perturbation import PerturbationState

STATES = ("u", "w", "q", "theta", "beta", "p", "r", "phi")
INPUTS = ("elevator", "throttle", "aileron", "rudder")
_KNOWN = {c.name: c.unit for c in (*channels(PerturbationState), *channels(Surfaces))}
UNITS = {name: _KNOWN[name] for name in (*STATES, *INPUTS)}
AS_THEY_ARE = ("p", "q", "r", "phi")  # states that the plant shows as they are: most of what laws measure
STEP = 2.0**-7  # of differences, in SI: a power of two, so that what is linear is differentiated without rounding


def linear_model(condition: FlightCondition, form: Form = "full", outputs: Sequence[str] = ()) -> LinearModel:
    """The small-perturbation model of `condition`: eight states, four inputs, longitudinal and lateral decoupled.

    `outputs` are fields of `Outputs`, from their values in undisturbed flight. Raises NoSuchPart for another name or an
    unknown form, and SpecError for one that hangs on heading or place, which are no states of this model, and for what
    is no flight condition.
    """
    condition = in_a_condition(condition)
    point = {
        "aircraft": condition.aircraft_id,
        "condition": condition.condition,
        "variant": condition.variant,
        "form": form,
        **condition.reference._asdict(),
    }
    model = joined(condition.equations(form), point)
    if not (np.isfinite(model.A).all() and np.isfinite(model.B).all()):
        raise SpecError(
            f"{condition.aircraft_id} {condition.condition} has no finite equations of motion: a number of it is far "
            "too great or too small."
        )
    if outputs and set(outputs) <= set(AS_THEY_ARE):  # at once: the cockpit closes loops with each move of a slider
        C = np.array([[float(state == name) for state in STATES] for name in outputs])
        return replace(model, outputs=tuple(outputs), C=C, D=np.zeros((len(outputs), len(INPUTS))))
    return _observed(model, condition, form, tuple(outputs)) if outputs else model


def _observed(model: LinearModel, condition: FlightCondition, form: Form, outputs: tuple[str, ...]) -> LinearModel:
    """The model with C and D: differences of what the plant shows, extrapolated to the fourth order."""
    unit = {c.name: c.unit for c in channels(Outputs)}
    for name in outputs:
        if name not in unit:
            raise NoSuchPart("output", name, unit)
    plant = plant_of(condition, form)._replace(limits=NO_LIMITS)
    rest, trim, calm = plant.start(), plant.trim(), Air()

    def shown(x: PerturbationState, held: Surfaces) -> NDArray[np.float64]:
        y = plant.observe(x, held, calm)
        return np.array([getattr(y, name) for name in outputs])

    def slope(name: str, h: float) -> NDArray[np.float64]:
        def moved(by: float) -> NDArray[np.float64]:
            if name in INPUTS:
                return shown(rest, trim._replace(**{name: getattr(trim, name) + by}))
            return shown(rest._replace(**{name: getattr(rest, name) + by}), trim)

        return (moved(h) - moved(-h)) / (2.0 * h)

    def derivative(name: str) -> NDArray[np.float64]:
        return (4.0 * slope(name, STEP / 2.0) - slope(name, STEP)) / 3.0

    for name in PerturbationState._fields:
        if name not in STATES and derivative(name).any():
            culprit = outputs[int(np.flatnonzero(derivative(name))[0])]
            raise SpecError(
                f"The linear model cannot show {culprit}: it changes with {name}, which is not among its states."
            )
    C = np.column_stack([derivative(name) for name in STATES])
    D = np.column_stack([derivative(name) for name in INPUTS])
    units = model.units | {name: unit[name] for name in outputs}
    return replace(model, outputs=outputs, C=C, D=D, units=units)


def joined(equations: Matrices, point: dict[str, Any]) -> LinearModel:
    """The longitudinal and the lateral set as one model about `point`."""
    A, B = np.zeros((8, 8)), np.zeros((8, 4))
    A[:4, :4], A[4:, 4:] = equations.A_lon, equations.A_lat
    B[:4, :2], B[4:, 2:] = equations.B_lon, equations.B_lat
    return LinearModel(A, B, STATES, INPUTS, dict(UNITS), point)
