"""Published numbers against computed ones: every item of `fdes.sources` becomes checks, each with its error.

The tests and ``fdes verify`` read the same list, so nothing is verified for show. A check that fails may name a
misprint of `fdes.sources.misprints`: it is excused if it holds with the right number in the place of the misprinted
one. What is known not to be comparable is shown with the reason, and is no check.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from fdes.aircraft import FlightCondition, load
from fdes.analysis.approximations import Approximation, approximate_modes
from fdes.analysis.linearize import joined, linear_model
from fdes.analysis.modes import Mode, modes
from fdes.control import LinearModel
from fdes.errors import NoSuchPart
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Matrices
from fdes.physics.published_axes import AxesDerivatives, stability_axis_matrices
from fdes.sources import misprints, sources
from fdes.units import FOOT, to_si

Source = Mapping[str, Any]
Verdict = Literal["ok", "misprint", "failed", "no check"]


@dataclass(frozen=True)
class Check:
    """One published number beside ours. `tolerance` is relative to the published value, plus `floor` [its unit].

    tolerance: None for what is shown without being held. mended: what is computed when the misprint that the check
    names is put right. note: the evidence for that misprint, or why the number is not held.
    """

    item: str
    quantity: str
    published: float
    computed: float
    tolerance: float | None
    floor: float
    citation: str
    where: str
    note: str = ""
    mended: float = math.nan

    @property
    def error(self) -> float:
        """How far apart they are, relative to the published value; absolute where that is zero."""
        difference = abs(self.computed - self.published)
        return difference / abs(self.published) if self.published else difference

    @property
    def verdict(self) -> Verdict:
        """What the check says. What is not a number never agrees."""
        if self.tolerance is None:
            return "no check"
        allowed = self.tolerance * abs(self.published) + self.floor
        if abs(self.computed - self.published) <= allowed:
            return "ok"
        return "misprint" if abs(self.mended - self.published) <= allowed else "failed"

    @property
    def passed(self) -> bool:
        """Whether nothing is wrong that is not known to be a misprint."""
        return self.verdict != "failed"


def checks(published: Mapping[str, Source] | None = None) -> list[Check]:
    """All checks of the given sources, or of those that come with FDES."""
    chosen = sources() if published is None else published
    return [check for source in chosen.values() for check in _of_source(source)]


def _of_source(source: Source) -> Iterator[Check]:
    for item in source.get("modes", []):
        yield from _modes(item, modes(_condition(item), form=item["form"]), source)
    for item in source.get("matrices", []):
        yield from _matrix(item, source)
    for item in source.get("matrix_modes", []):
        yield from _modes(item, modes(_model_of_matrices(item, source)), source)
    for item in source.get("derivative_modes", []):
        yield from _modes(item, modes(_model_of_derivatives(item)), source)
    for item in source.get("approximations", []):
        yield from _modes(item, approximate_modes(_condition(item), form=item["form"]), source)
    for item in source.get("atmosphere", []):
        yield from _atmosphere(item, source)
    for item in source.get("execution_times", []):
        yield from _execution_times(item, source)


def _condition(item: Source) -> FlightCondition:
    """The flight condition of an item, with what the item says of its reference, such as another alpha."""
    condition = load(item["aircraft"]).at(item["condition"], variant=item["variant"])
    return replace(condition, reference=condition.reference._replace(**item.get("reference", {})))


def _modes(item: Source, found: Sequence[Mode | Approximation], source: Source) -> Iterator[Check]:
    for name, values in item["published"].items():
        ours = _figures(name, found)
        mended = _figures(name, _without_misprint(item, values["misprint"])) if "misprint" in values else {}
        reason = values.get("no_check", item.get("no_check", ""))
        evidence = (
            "{misprint}: {}".format(_accepted(values["misprint"])["evidence"], **values) if "misprint" in values else ""
        )
        if "eigenvalue" in values:
            real, imaginary = values["eigenvalue"]
            wanted = {"real": real, "imag": imaginary}
        else:
            wanted = {key: values[key] for key in ("zeta", "omega_n")}
        for quantity, expected in wanted.items():
            allowed = values.get(f"rtol_{quantity}", values.get("rtol", item.get("rtol")))
            yield Check(
                item=item["id"],
                quantity=f"{name} {quantity}",
                published=expected,
                computed=ours.get(quantity, math.nan),
                tolerance=None if reason else allowed,
                floor=0.0,
                citation=source["citation"],
                where=item["where"],
                note=reason or evidence,
                mended=mended.get(quantity, math.nan),
            )


def _figures(name: str, found: Sequence[Mode | Approximation]) -> dict[str, float]:
    """The figures of the mode of that name; none where it is not found."""
    for mode in found:
        if mode.name == name:
            value = mode.eigenvalue
            return {"real": value.real, "imag": value.imag, "zeta": -value.real / abs(value), "omega_n": abs(value)}
    return {}


def _accepted(name: str) -> Source:
    known = misprints()
    if name not in known:
        raise NoSuchPart("accepted misprint", name, known)
    return known[name]


def _without_misprint(item: Source, name: str) -> list[Mode]:
    """The modes of an item with one misprinted derivative put right."""
    misprint, condition = _accepted(name), _condition(item)
    right = condition.coefficients._replace(**{misprint["number"]: misprint["instead"]})
    return modes(replace(condition, aerodynamics=right), form=item["form"])


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


def _model_of_matrices(item: Source, source: Source) -> LinearModel:
    """The printed matrices themselves: no equations of ours, only eigenvalues."""
    printed = {matrix["id"]: matrix["A"] for matrix in source["matrices"]}
    no_input = ((0.0, 0.0),) * 4
    equations = Matrices(printed[item["longitudinal"]], no_input, printed[item["lateral"]], no_input)
    return joined(equations, {"source": item["id"]})


def _model_of_derivatives(item: Source) -> LinearModel:
    """The equations alone, fed with a report's own dimensional derivatives in stability axes."""
    V, g = (to_si(item[k]["value"], item[k]["unit"]) for k in ("V", "g"))
    by_length = dict.fromkeys(("M_u", "M_w", "M_wdot"), 1.0 / to_si(1.0, item["length"]))
    d = AxesDerivatives(**{name: value * by_length.get(name, 1.0) for name, value in item["derivatives"].items()})
    return joined(stability_axis_matrices(d, V, g, alpha=0.0, gamma=0.0, X_dT=0.0), {"source": item["id"]})


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
