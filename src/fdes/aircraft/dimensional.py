"""Dimensional derivatives in an aircraft file, under [conditions.dimensional], as a report prints them.

    axes    = "body"       # of the derivatives: along the fuselage; or "stability", along the velocity
    lateral = "primed"     # L and N contain the product of inertia; or "unprimed"
    units   = "ft, s, rad" # divided by mass or moment of inertia; "m, s, rad"; or "N, m, s, rad", not divided

They make a linear plant and nothing else: A and B in stability axes. What a table leaves out is zero.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Literal, Self

from pydantic import AfterValidator, Field, model_validator

from fdes.aircraft.number import Confidence, Derivative, Number, Part
from fdes.physics.derivatives import Matrices, Reference, primed
from fdes.physics.published_axes import AxesDerivatives, stability_axis_matrices

# The unit of each derivative: divided by mass or moment of inertia, with {} for the length; and as force or moment.
_UNITS: dict[str, tuple[str, str]] = {
    **dict.fromkeys(("X_u", "X_w", "Z_u", "Z_w", "Y_v"), ("1/s", "N s/m")),
    **dict.fromkeys(("Z_q", "Y_p", "Y_r"), ("{}/s", "N s")),
    **dict.fromkeys(("X_de", "Z_de"), ("{}/s^2", "N")),
    **dict.fromkeys(("Ystar_da", "Ystar_dr"), ("1/s", "1/s")),
    **dict.fromkeys(("M_u", "M_w", "L_v", "N_v"), ("1/({} s)", "N s")),
    **dict.fromkeys(("M_q", "L_p", "L_r", "N_p", "N_r"), ("1/s", "N m s")),
    **dict.fromkeys(("M_de", "L_beta", "L_da", "L_dr", "N_beta", "N_da", "N_dr"), ("1/s^2", "N m")),
    "Z_wdot": ("1", "kg"),
    "M_wdot": ("1/{}", "N s^2"),
}


def _without_unit(number: Number) -> Number:
    if number.unit is not None:
        raise ValueError(f"has a unit of its own, {number.unit!r}: it is that of the table, given once under units")
    return number


Printed = Annotated[Number, AfterValidator(_without_unit)]


class ControlCoefficients(Part):
    """Nondimensional control derivatives, for a source that gives the others as dimensional; the same axes."""

    CX_de: Derivative | None = None
    CZ_de: Derivative
    Cm_de: Derivative
    Cy_da: Derivative | None = None
    Cl_da: Derivative
    Cn_da: Derivative
    Cy_dr: Derivative
    Cl_dr: Derivative
    Cn_dr: Derivative


class DimensionalDerivatives(Part):
    """The table. Each derivative is as the report prints it; `confidence` and `sources` are those of all of them."""

    axes: Literal["body", "stability"]
    lateral: Literal["primed", "unprimed"]
    units: Literal["ft, s, rad", "m, s, rad", "N, m, s, rad"]
    confidence: Confidence | None = None
    sources: tuple[str, ...] = Field(default=(), strict=False)

    X_u: Printed
    X_w: Printed
    X_de: Printed | None = None
    Z_u: Printed
    Z_w: Printed
    Z_wdot: Printed | None = None
    Z_q: Printed | None = None
    Z_de: Printed | None = None
    M_u: Printed
    M_w: Printed
    M_wdot: Printed | None = None
    M_q: Printed
    M_de: Printed | None = None

    Y_v: Printed
    Y_p: Printed | None = None
    Y_r: Printed | None = None
    Ystar_da: Printed | None = None
    Ystar_dr: Printed | None = None
    L_beta: Printed | None = None
    L_v: Printed | None = None
    L_p: Printed
    L_r: Printed
    L_da: Printed | None = None
    L_dr: Printed | None = None
    N_beta: Printed | None = None
    N_v: Printed | None = None
    N_p: Printed
    N_r: Printed
    N_da: Printed | None = None
    N_dr: Printed | None = None
    controls: ControlCoefficients | None = None

    @model_validator(mode="after")
    def _complete(self) -> Self:
        for moment in "LN":
            by_beta, by_v = getattr(self, f"{moment}_beta"), getattr(self, f"{moment}_v")
            if (by_beta is None) == (by_v is None):
                raise ValueError(f"needs {moment}_beta or {moment}_v, one of the two")
        surfaces = ("Z_de", "M_de", "L_da", "N_da", "Ystar_dr", "L_dr", "N_dr")
        absent = [name for name in surfaces if getattr(self, name) is None]
        if self.controls is None and absent:
            raise ValueError(f"lacks {', '.join(absent)}: give them, or nondimensional ones under controls")
        if self.controls is not None and len(absent) < len(surfaces):
            raise ValueError("has control derivatives both in the table and under controls: keep one of the two")
        return self

    @property
    def divided(self) -> bool:
        """Whether the source divides forces by the mass and moments by the moments of inertia."""
        return not self.units.startswith("N")

    @property
    def needs(self) -> set[str]:
        """What of geometry and mass the derivatives cannot do without."""
        inertia = {"Ix", "Iy", "Iz"} if not self.divided or self.controls else set()
        lateral = {"Ix", "Iz"} if self.lateral == "unprimed" else set()
        return inertia | lateral | ({"S", "b", "c"} if self.controls else set())

    def numbers(self) -> dict[str, Number]:
        """Each derivative that is given, with its unit, confidence and sources."""
        said = {"confidence": self.confidence, "sources": self.sources}
        length = self.units.split(",")[0]
        found = {
            name: number.model_copy(update={"unit": _UNITS[name][0 if self.divided else 1].format(length)})
            for name, number in self
            if isinstance(number, Number)
        }
        found |= {name: n for name, n in self.controls or () if isinstance(n, Number)}
        return {name: n.model_copy(update={} if n.confidence else said) for name, n in found.items()}

    def matrices(self, value: Mapping[str, float], ref: Reference) -> Matrices:
        """A and B in stability axes, from the `value` of each derivative in SI, by its name."""
        alpha = ref.alpha if self.axes == "body" else 0.0
        d = {name: value[name] for name in (*AxesDerivatives._fields, "L_v", "N_v") if name in value}
        by = dict.fromkeys("XZY", ref.m) | {"M": ref.Iy, "L": ref.Ix, "N": ref.Iz}
        if not self.divided:
            d = {name: v if name.startswith("Ystar") else v / by[name[0]] for name, v in d.items()}
        if self.controls:
            d |= _controls(value, ref, by)
        for moment in "LN":
            if f"{moment}_v" in d:
                d[f"{moment}_beta"] = ref.V * d.pop(f"{moment}_v")
        if self.lateral == "unprimed":
            for of in ("beta", "p", "r", "da", "dr"):
                d[f"L_{of}"], d[f"N_{of}"] = primed(d[f"L_{of}"], d[f"N_{of}"], ref.Ix, ref.Iz, ref.Ixz)
        return stability_axis_matrices(AxesDerivatives(**d), ref.V, ref.g, alpha, ref.gamma, ref.T_max / ref.m)


@dataclass(frozen=True)
class DimensionalTable:
    """The derivatives of a file as they are used: their `value` in SI by name, and the `derivatives` that say how."""

    derivatives: DimensionalDerivatives
    value: Mapping[str, float]

    def matrices(self, ref: Reference) -> Matrices:
        """A and B in stability axes."""
        return self.derivatives.matrices(self.value, ref)


def _controls(value: Mapping[str, float], ref: Reference, by: Mapping[str, float]) -> dict[str, float]:
    qS = 0.5 * ref.rho * ref.V**2 * ref.S
    return {
        "X_de": value.get("CX_de", 0.0) * qS / ref.m,
        "Z_de": value["CZ_de"] * qS / ref.m,
        "M_de": value["Cm_de"] * qS * ref.c / by["M"],
        **{f"Ystar_{s}": value.get(f"Cy_{s}", 0.0) * qS / (ref.m * ref.V) for s in ("da", "dr")},
        **{f"L_{s}": value[f"Cl_{s}"] * qS * ref.b / by["L"] for s in ("da", "dr")},
        **{f"N_{s}": value[f"Cn_{s}"] * qS * ref.b / by["N"] for s in ("da", "dr")},
    }
