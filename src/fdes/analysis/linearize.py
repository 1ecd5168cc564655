"""From an aircraft in a flight condition to a linear model with names."""

from typing import Any

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.control import LinearModel
from fdes.physics.derivatives import Form, Matrices
from fdes.physics.signals import Surfaces, channels
from fdes.physics.small_perturbation import PerturbationState

STATES = ("u", "w", "q", "theta", "beta", "p", "r", "phi")
INPUTS = ("elevator", "throttle", "aileron", "rudder")


def linear_model(condition: FlightCondition, form: Form = "full") -> LinearModel:
    """The small-perturbation model of `condition`: eight states, four inputs, longitudinal and lateral decoupled."""
    point = {
        "aircraft": condition.aircraft_id,
        "condition": condition.condition,
        "variant": condition.variant,
        "form": form,
        **condition.reference._asdict(),
    }
    return joined(condition.equations(form), point)


def joined(equations: Matrices, point: dict[str, Any]) -> LinearModel:
    """The longitudinal and the lateral set as one model about `point`."""
    A, B = np.zeros((8, 8)), np.zeros((8, 4))
    A[:4, :4], A[4:, 4:] = equations.A_lon, equations.A_lat
    B[:4, :2], B[4:, 2:] = equations.B_lon, equations.B_lat
    unit = {c.name: c.unit for c in (*channels(PerturbationState), *channels(Surfaces))}
    return LinearModel(A, B, STATES, INPUTS, {name: unit[name] for name in (*STATES, *INPUTS)}, point)
