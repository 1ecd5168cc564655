"""Published numbers against computed ones: every item of `fdes.sources` becomes checks, each with its error.

The tests and ``fdes verify`` read the same list, so nothing is verified for show.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from fdes.aircraft import load
from fdes.analysis.approximations import Approximation, approximate_modes
from fdes.analysis.linearize import INPUTS, STATES, linear_model
from fdes.analysis.modes import Mode, modes
from fdes.control import LinearModel
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Dimensional, Reference, matrices
from fdes.sources import sources
from fdes.units import FOOT, to_si

Source = Mapping[str, Any]


@dataclass(frozen=True)
class Check:
    """One published number beside ours. `tolerance` is relative to the published value, plus `floor` [its unit]."""

    item: str
    quantity: str
    published: float
    computed: float
    tolerance: float
    floor: float
    citation: str
    where: str

    @property
    def error(self) -> float:
        """How far apart they are, relative to the published value; absolute where that is zero."""
        difference = abs(self.computed - self.published)
        return difference / abs(self.published) if self.published else difference

    @property
    def passed(self) -> bool:
        """Whether they agree. What is not a number never does."""
        return abs(self.computed - self.published) <= self.tolerance * abs(self.published) + self.floor


def checks(published: Mapping[str, Source] | None = None) -> list[Check]:
    """All checks of the given sources, or of those that come with FDES."""
    chosen = sources() if published is None else published
    return [check for source in chosen.values() for check in _of_source(source)]


def _of_source(source: Source) -> Iterator[Check]:
    for item in source.get("modes", []):
        yield from _modes(item, modes(_condition(item), form=item["form"]), source)
    for item in source.get("matrices", []):
        yield from _matrix(item, source)
    for item in source.get("derivative_modes", []):
        yield from _modes(item, modes(_model_of_derivatives(item)), source)
    for item in source.get("approximations", []):
        yield from _modes(item, approximate_modes(_condition(item), form=item["form"]), source)
    for item in source.get("atmosphere", []):
        yield from _atmosphere(item, source)
    for item in source.get("execution_times", []):
        yield from _execution_times(item, source)


def _condition(item: Source) -> Any:
    condition = load(item["aircraft"]).at(item["condition"], variant=item["variant"])
    return replace(condition, aerodynamics=condition.coefficients._replace(**item.get("with", {})))


def _modes(item: Source, found: Sequence[Mode | Approximation], source: Source) -> Iterator[Check]:
    by_name = {mode.name: mode for mode in found}
    for name, values in item["published"].items():
        ours = _figures(by_name[name]) if name in by_name else {}
        if "eigenvalue" in values:
            real, imaginary = values["eigenvalue"]
            wanted = {"real": real, "imag": imaginary}
        else:
            wanted = {key: values[key] for key in ("zeta", "omega_n")}
        for quantity, expected in wanted.items():
            yield Check(
                item=item["id"],
                quantity=f"{name} {quantity}",
                published=expected,
                computed=ours.get(quantity, float("nan")),
                tolerance=values.get("rtol", item["rtol"]),
                floor=0.0,
                citation=source["citation"],
                where=item["where"],
            )


def _figures(mode: Mode | Approximation) -> dict[str, float]:
    value = mode.eigenvalue
    return {"real": value.real, "imag": value.imag, "zeta": -value.real / abs(value), "omega_n": abs(value)}


def _matrix(item: Source, source: Source) -> Iterator[Check]:
    model = linear_model(_condition(item), form=item["form"])
    part = model.longitudinal() if item["axis"] == "longitudinal" else model.lateral()
    feet = np.array([1.0 / FOOT if part.units[s] == "m/s" else 1.0 for s in part.states])
    ours = part.A * np.outer(feet, 1.0 / feet)
    for (i, j), expected in np.ndenumerate(np.array(item["A"])):
        where = f"A[{part.states[i]}, {part.states[j]}]"
        yield Check(
            item["id"], where, float(expected), float(ours[i, j]), item["rtol"], item["atol"], *_cited(item, source)
        )


def _model_of_derivatives(item: Source) -> LinearModel:
    """The equations alone, fed with a report's own dimensional derivatives."""
    given = dict(item["derivatives"])
    V, g = (to_si(item[k]["value"], item[k]["unit"]) for k in ("V", "g"))
    given["Y_beta"] = given.pop("Y_v") * V
    for name in ("M_u", "M_w", "M_wdot"):
        given[name] = given.get(name, 0.0) / to_si(1.0, item["length"])
    d = Dimensional(**{name: given.get(name, 0.0) for name in Dimensional._fields})
    unit_inertia = dict.fromkeys(Reference._fields, 0.0) | {"V": V, "g": g, "Ix": 1.0, "Iy": 1.0, "Iz": 1.0}
    A_lon, B_lon, A_lat, B_lat = matrices(d, Reference(**unit_inertia), item["form"])
    A, B = np.zeros((8, 8)), np.zeros((8, 4))
    A[:4, :4], A[4:, 4:], B[:4, :2], B[4:, 2:] = A_lon, A_lat, B_lon, B_lat
    return LinearModel(A, B, STATES, INPUTS, dict.fromkeys((*STATES, *INPUTS), ""), {"source": item["id"]})


def _atmosphere(item: Source, source: Source) -> Iterator[Check]:
    for height, *expected in item["rows"]:
        for name, value, ours in zip(item["columns"][1:], expected, standard_atmosphere(height), strict=True):
            yield Check(item["id"], f"{name} at {height} m", value, ours, item["rtol"], 0.0, *_cited(item, source))


def _execution_times(item: Source, source: Source) -> Iterator[Check]:
    """A table of times per loop is a table of whole times divided by the number of loops."""
    for row in item["rows"]:
        quantity, computed = f"{row['integrator']} {row['step']:g} s, s per loop", row["total"] / row["loops"]
        yield Check(item["id"], quantity, row["loop"], computed, item["rtol"], 0.0, *_cited(item, source))


def _cited(item: Source, source: Source) -> tuple[str, str]:
    return source["citation"], item["where"]
