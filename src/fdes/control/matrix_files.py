"""A and B on paper and in other programs: LaTeX with named rows and units, and MATLAB files."""

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fdes.control.linear import Array, LinearModel

DIGITS = 4
GREEK = ("alpha", "beta", "gamma", "phi", "psi", "theta")
SURFACES = {"elevator": r"\delta_e", "aileron": r"\delta_a", "rudder": r"\delta_r", "throttle": r"\delta_T"}


def latex(model: "LinearModel") -> str:
    """The equation of state as LaTeX in math mode, to four digits; it needs the package amsmath."""
    rate = r"\frac{d}{dt}" if model.dt is None else ""
    states = _column(_symbol(name, model.units[name]) for name in model.states)
    inputs = _column(_symbol(name, model.units[name]) for name in model.inputs)
    return f"{rate}{states}\n= {_matrix(model.A)}\n{states}\n+ {_matrix(model.B)}\n{inputs}"


def _symbol(name: str, unit: str) -> str:
    symbol = SURFACES.get(
        name, f"\\{name}" if name in GREEK else name if len(name) == 1 else rf"\text{{{_plain(name)}}}"
    )
    return symbol if unit == "1" else rf"{symbol}\ [\mathrm{{{unit}}}]"


def _plain(name: str) -> str:
    return name.replace("_", r"\_")


def _column(entries: Iterable[str]) -> str:
    return r"\begin{pmatrix} " + r" \\ ".join(entries) + r" \end{pmatrix}"


def _matrix(values: "Array") -> str:
    return _column(" & ".join(map(_number, row)) for row in values.tolist())


def _number(value: float) -> str:
    mantissa, _, exponent = f"{value + 0.0:.{DIGITS}g}".partition("e")  # + 0.0: no negative zero
    return rf"{mantissa} \times 10^{{{int(exponent)}}}" if exponent else mantissa


def save_mat(path: Path, **models: "LinearModel") -> None:
    """Write each model as a struct with A, B, states, inputs and units, for MATLAB, version 5."""
    from scipy.io import savemat

    savemat(path, {name: as_struct(model) for name, model in models.items()})


def as_struct(model: "LinearModel") -> dict[str, Any]:
    """A and B, and their names and SI units in the same order."""
    import numpy as np

    found: dict[str, Any] = {"A": model.A, "B": model.B}
    for kind in ("states", "inputs"):
        names = getattr(model, kind)
        found[kind] = np.array(names, dtype=object)
        found[f"{kind[:-1]}_units"] = np.array([model.units[name] for name in names], dtype=object)
    return found
