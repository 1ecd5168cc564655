"""Linear models that know their names, and the exact zero-order hold of the linear plant."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.physics.derivatives import Matrices, Matrix, Reference
from fdes.physics.small_perturbation import ExactHold

Array = NDArray[np.float64]


def _nothing() -> Array:
    return np.zeros((0, 0))


@dataclass(frozen=True)
class LinearModel:
    """dx/dt = A x + B u, y = C x + D u about an operating point; every state, input and output with its name.

    A is (n, n), B (n, m), C (k, n), D (k, m); a model that names no outputs needs neither C nor D. `units` maps each
    name to its SI unit; `point` says what the model was linearized about. dt [s]: where it is given, the model steps
    from frame to frame: x_next = A x + B u.
    """

    A: Array
    B: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    units: dict[str, str]
    point: dict[str, Any]
    outputs: tuple[str, ...] = ()
    C: Array = field(default_factory=_nothing)
    D: Array = field(default_factory=_nothing)
    dt: float | None = None

    def part(self, states: tuple[str, ...], inputs: tuple[str, ...]) -> "LinearModel":
        """The model of these states and inputs alone, all others held at zero. It keeps all outputs."""
        rows = [self.states.index(s) for s in states]
        columns = [self.inputs.index(i) for i in inputs]
        units = {name: self.units[name] for name in (*states, *inputs, *self.outputs)}
        A, B = self.A[np.ix_(rows, rows)], self.B[np.ix_(rows, columns)]
        C, D = (self.C[:, rows], self.D[:, columns]) if self.outputs else (self.C, self.D)
        return LinearModel(A, B, states, inputs, units, self.point, self.outputs, C, D, self.dt)

    def longitudinal(self) -> "LinearModel":
        """States u, w, q, theta; inputs elevator, throttle."""
        return self.part(("u", "w", "q", "theta"), ("elevator", "throttle"))

    def lateral(self) -> "LinearModel":
        """States beta, p, r, phi; inputs aileron, rudder."""
        return self.part(("beta", "p", "r", "phi"), ("aileron", "rudder"))

    def held(self, dt: float) -> "LinearModel":
        """The model from frame to frame, its inputs held through each `dt` [s]: exact, by one matrix exponential.

        Reference: C. F. Van Loan, IEEE Trans. Automatic Control AC-23 (1978) 395-404.
        """
        Phi, Gamma = _hold(self.A, self.B, dt)
        return LinearModel(
            Phi, Gamma, self.states, self.inputs, self.units, self.point, self.outputs, self.C, self.D, dt
        )


def exact_hold(matrices: Matrices, ref: Reference, h: float) -> ExactHold:
    """Phi and Gamma of the linear plant for a step of `h` [s], inputs and gusts held.

    One matrix exponential of the augmented system: C. F. Van Loan, IEEE Trans. Automatic Control AC-23 (1978) 395-404.
    """
    A_lon, B_lon, A_lat, B_lat = (np.array(m) for m in matrices)
    # A gust is felt by the aerodynamics as the opposite motion of the aircraft.
    lon_in = np.column_stack([B_lon, -A_lon[:, 0], -A_lon[:, 1]])
    lat_in = np.column_stack([B_lat, -A_lat[:, 0] / ref.V])
    heading = np.zeros((5, 5))
    heading[:4, :4] = A_lat
    heading[4, 2] = 1.0 / np.cos(ref.gamma)
    lon = _hold(A_lon, lon_in, h)
    lat = _hold(heading, np.vstack([lat_in, np.zeros(3)]), h)
    return ExactHold(h, *map(_rows, lon), *map(_rows, lat))


def _hold(A: Array, B: Array, h: float) -> tuple[Array, Array]:
    from scipy.linalg import expm  # imported here: only the exact hold needs SciPy, and flying must start at once

    n, m = B.shape
    augmented = np.zeros((n + m, n + m))
    augmented[:n, :n], augmented[:n, n:] = A, B
    E = expm(augmented * h)
    return E[:n, :n], E[:n, n:]


def _rows(M: Array) -> Matrix:
    return tuple(tuple(float(v) for v in row) for row in M)
