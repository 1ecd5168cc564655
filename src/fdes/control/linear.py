"""Linear models that know their names, and the exact zero-order hold of the linear plant."""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.physics.derivatives import Matrices, Matrix, Reference
from fdes.physics.small_perturbation import ExactHold

Array = NDArray[np.float64]


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
    C: Array = field(default_factory=lambda: np.zeros((0, 0)))
    D: Array = field(default_factory=lambda: np.zeros((0, 0)))
    dt: float | None = None

    def __post_init__(self) -> None:
        if not self.outputs:  # no rows, but as many columns as there are states and inputs
            object.__setattr__(self, "C", np.zeros((0, len(self.states))))
            object.__setattr__(self, "D", np.zeros((0, len(self.inputs))))

    def part(self, states: tuple[str, ...], inputs: tuple[str, ...]) -> "LinearModel":
        """The model of these states and inputs alone, all others held at zero. It keeps all outputs."""
        rows = [self.states.index(s) for s in states]
        columns = [self.inputs.index(i) for i in inputs]
        units = {name: self.units[name] for name in (*states, *inputs, *self.outputs)}
        A, B = self.A[np.ix_(rows, rows)], self.B[np.ix_(rows, columns)]
        C, D = self.C[:, rows], self.D[:, columns]
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
        return replace(self, A=Phi, B=Gamma, dt=dt)

    def to_latex(self) -> str:
        """The equation of state as LaTeX in math mode, rows named with their units; it needs the package amsmath."""
        from fdes.control.matrix_files import latex

        return latex(self)

    def to_mat(self, path: Path) -> None:
        """Write `model`, a struct with A, B, states, inputs and their units, for MATLAB."""
        from fdes.control.matrix_files import save_mat

        save_mat(path, model=self)

    def _repr_latex_(self) -> str:
        """The equation of state, for notebooks."""
        return f"$$\n{self.to_latex()}\n$$"


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
