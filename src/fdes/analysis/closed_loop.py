"""An aircraft with its control law, as one linear model: continuous, or from frame to frame as it is flown.

Continuous, surfaces follow the law's `linear()` without delay. Sampled, the law sees outputs once per frame, and its
command is held until the next, as `fly` does it: that is exact, and shows what half a frame of delay costs.
"""

from dataclasses import replace

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.linearize import linear_model
from fdes.control import LinearModel
from fdes.control.law import STICKS, Law
from fdes.errors import SpecError
from fdes.physics.actuators import Actuator, Actuators
from fdes.physics.derivatives import Form
from fdes.physics.signals import Surfaces


def close(
    of: FlightCondition | LinearModel,
    law: Law,
    dt: float | None = None,
    actuators: Actuators | None = None,
    form: Form = "full",
) -> LinearModel:
    """The closed loop of an aircraft, or of a linear model with all outputs that the law measures.

    Without `dt` it is continuous; with `dt` [s] it is the exact sampled-data model of the flight at that step. Its
    states are the aircraft's, then the actuators', then the law's; sampled, a law that measures what a surface moves at
    once adds the surfaces held. Its inputs are what is added to the law's command, and the stick.
    Raises SpecError where the law measures what the model does not show.
    """
    return _joined(*_plant_and_law(of, law, dt, actuators, form))


def open_loop(
    of: FlightCondition | LinearModel,
    law: Law,
    surface: str,
    dt: float | None = None,
    actuators: Actuators | None = None,
    form: Form = "full",
) -> LinearModel:
    """The loop of `close` broken at the command of one surface, all others closed: one input, one output, n states.

    From a command of `surface` to what the law makes of it, with its sign turned: closed again by u = -y. Its units are
    rad, or 1 for the throttle. Raises SpecError as `close` does.
    """
    plant, controller, measured = _plant_and_law(of, law, dt, actuators, form)
    row, column = Surfaces._fields.index(surface), plant.inputs.index(surface)
    others = np.array([name != surface for name in Surfaces._fields])[:, None]
    whole = _joined(plant, replace(controller, C=controller.C * others, D=controller.D * others), measured)
    rows = [whole.outputs.index(name) for name in measured]
    gains = controller.D[row, [controller.inputs.index(name) for name in measured]]
    remembered = np.concatenate([np.zeros(len(plant.states)), controller.C[row]])
    return replace(
        whole,
        B=whole.B[:, [column]],
        C=-(gains @ whole.C[rows] + remembered)[None, :],
        D=np.array([[-float(gains @ whole.D[rows, column])]]),
        inputs=(surface,),
        outputs=(f"returned_{surface}",),
        units=whole.units | {f"returned_{surface}": whole.units[surface]},
    )


def _plant_and_law(
    of: FlightCondition | LinearModel, law: Law, dt: float | None, actuators: Actuators | None, form: Form
) -> tuple[LinearModel, LinearModel, tuple[str, ...]]:
    """What flies, with actuators and from frame to frame; the law; and the outputs that it measures."""
    controller = law.linear(dt)
    measured = tuple(name for name in controller.inputs if name not in STICKS)
    plant = linear_model(of, form, measured) if isinstance(of, FlightCondition) else of
    for name in measured:
        if name not in plant.outputs:
            raise SpecError(f"The law measures {name}, and the linear model does not show it: give it that output.")
    if actuators is not None:
        plant = with_actuators(plant, actuators)
    if dt is not None:
        plant = _with_held_surfaces(plant.held(dt), measured)
    return plant, controller, measured


def with_actuators(plant: LinearModel, actuators: Actuators) -> LinearModel:
    """A continuous model with actuators before its surfaces, away from their limits."""
    n = len(plant.states)
    names: list[str] = []
    rows: list[tuple[str, Actuator]] = []
    for surface, actuator in actuators._asdict().items():
        names += [f"{surface}_actuator", *([f"{surface}_actuator_rate"] if actuator.damping else [])]
        rows.append((surface, actuator))
    size = n + len(names)
    A, B = np.zeros((size, size)), np.zeros((size, len(plant.inputs)))
    C, D = np.zeros((len(plant.outputs), size)), plant.D.copy()
    A[:n, :n], B[:n] = plant.A, plant.B
    C[:, :n] = plant.C
    for surface, a in rows:
        column, k = plant.inputs.index(surface), n + names.index(f"{surface}_actuator")
        A[:n, k], B[:n, column] = plant.B[:, column], 0.0
        C[:, k], D[:, column] = plant.D[:, column], 0.0
        w = a.bandwidth
        if a.damping:
            A[k, k + 1] = 1.0
            A[k + 1, k], A[k + 1, k + 1], B[k + 1, column] = -w * w, -2.0 * a.damping * w, w * w
        else:
            A[k, k], B[k, column] = -w, w
    units = plant.units | {name: "rad/s" if name.endswith("_rate") else "rad" for name in names}
    return replace(plant, A=A, B=B, C=C, D=D, states=(*plant.states, *names), units=units)


def _with_held_surfaces(plant: LinearModel, measured: tuple[str, ...]) -> LinearModel:
    """In flight, outputs are observed under the surfaces of the frame before: where they matter, they are states."""
    rows = [plant.outputs.index(name) for name in measured]
    felt = [i for i, name in enumerate(plant.inputs) if np.any(plant.D[rows, i])]
    if not felt:
        return plant
    n, k = len(plant.states), len(felt)
    names = tuple(f"held_{plant.inputs[i]}" for i in felt)
    A, B = np.zeros((n + k, n + k)), np.zeros((n + k, len(plant.inputs)))
    A[:n, :n], B[:n] = plant.A, plant.B
    B[range(n, n + k), felt] = 1.0
    C, D = np.hstack([plant.C, plant.D[:, felt]]), plant.D.copy()
    D[:, felt] = 0.0
    units = plant.units | {name: plant.units[plant.inputs[i]] for name, i in zip(names, felt, strict=True)}
    return replace(plant, A=A, B=B, C=C, D=D, states=(*plant.states, *names), units=units)


def _joined(plant: LinearModel, law: LinearModel, measured: tuple[str, ...]) -> LinearModel:
    """Plant and law around each other: u = law(y) + what is added, y of the plant under u."""
    order = [Surfaces._fields.index(name) for name in plant.inputs]
    seen = [law.inputs.index(name) for name in measured]
    pushed = [law.inputs.index(name) for name in STICKS]
    rows = [plant.outputs.index(name) for name in measured]
    C, D = plant.C[rows], plant.D[rows]
    F, G, H = law.C[order], law.D[np.ix_(order, seen)], law.D[np.ix_(order, pushed)]
    # u = F m + G (C x + D u) + H stick + added; the loop in u is broken here once
    solved = np.linalg.inv(np.eye(len(order)) - G @ D)
    u_x, u_m, u_added, u_stick = solved @ G @ C, solved @ F, solved, solved @ H
    y_x, y_m, y_added, y_stick = C + D @ u_x, D @ u_m, D @ u_added, D @ u_stick
    M, N = law.B[:, seen], law.B[:, pushed]
    A = np.block([[plant.A + plant.B @ u_x, plant.B @ u_m], [M @ y_x, law.A + M @ y_m]])
    B = np.block([[plant.B @ u_added, plant.B @ u_stick], [M @ y_added, N + M @ y_stick]])
    units = plant.units | law.units
    return replace(
        plant,
        A=A,
        B=B,
        C=np.hstack([plant.C + plant.D @ u_x, plant.D @ u_m]),
        D=np.hstack([plant.D @ u_added, plant.D @ u_stick]),
        states=(*plant.states, *law.states),
        inputs=(*plant.inputs, *STICKS),
        units=units,
    )
