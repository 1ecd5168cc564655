"""Every published number in `fdes.sources` against what FDES computes, at the tolerance its source allows."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis import linear_model, modes
from fdes.control import LinearModel
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.derivatives import Dimensional, Reference, matrices
from fdes.sources import sources
from fdes.units import FOOT, to_si

SOURCES = sources()


def items(kind: str) -> list[Any]:
    """All items of one kind, of all sources, named by their id."""
    return [pytest.param(item, id=item["id"]) for source in SOURCES.values() for item in source.get(kind, [])]


def assert_modes(found: list[Any], item: dict[str, Any]) -> None:
    by_name = {mode.name: mode for mode in found}
    for name, published in item["published"].items():
        rtol = published.get("rtol", item["rtol"])
        if "eigenvalue" in published:
            expected = complex(*published["eigenvalue"])
            assert by_name[name].eigenvalue.real == pytest.approx(expected.real, rel=rtol), name
            assert by_name[name].eigenvalue.imag == pytest.approx(expected.imag, rel=rtol), name
        else:
            assert by_name[name].zeta == pytest.approx(published["zeta"], rel=rtol), name
            assert by_name[name].omega_n == pytest.approx(published["omega_n"], rel=rtol), name


@pytest.mark.parametrize("item", items("modes"))
def test_modes(item: dict[str, Any]) -> None:
    condition = load(item["aircraft"]).at(item["condition"], variant=item["variant"])
    condition = replace(condition, coefficients=condition.coefficients._replace(**item.get("with", {})))
    assert_modes(modes(condition, form=item["form"]), item)


@pytest.mark.parametrize("item", items("matrices"))
def test_matrices(item: dict[str, Any]) -> None:
    condition = load(item["aircraft"]).at(item["condition"], variant=item["variant"])
    model = linear_model(condition, form=item["form"])
    part = model.longitudinal() if item["axis"] == "longitudinal" else model.lateral()
    feet = np.array([1.0 / FOOT if part.units[s] == "m/s" else 1.0 for s in part.states])
    np.testing.assert_allclose(part.A * np.outer(feet, 1.0 / feet), item["A"], rtol=item["rtol"], atol=item["atol"])


@pytest.mark.parametrize("item", items("derivative_modes"))
def test_modes_of_published_derivatives(item: dict[str, Any]) -> None:
    """The equations alone, without our way from coefficients to dimensional derivatives."""
    given = dict(item["derivatives"])
    V, g = (to_si(item[k]["value"], item[k]["unit"]) for k in ("V", "g"))
    per_length = 1.0 / to_si(1.0, item["length"])
    given["Y_beta"] = given.pop("Y_v") * V
    for name in ("M_w", "M_wdot"):
        given[name] *= per_length
    d = Dimensional(**{name: given.get(name, 0.0) for name in Dimensional._fields})
    ref = Reference(**dict.fromkeys(Reference._fields, 0.0))._replace(V=V, g=g, Ix=1.0, Iy=1.0, Iz=1.0)
    A_lon, B_lon, A_lat, B_lat = (np.array(m) for m in matrices(d, ref, item["form"]))
    states = ("u", "w", "q", "theta", "beta", "p", "r", "phi")
    inputs = ("elevator", "throttle", "aileron", "rudder")
    A, B = np.zeros((8, 8)), np.zeros((8, 4))
    A[:4, :4], A[4:, 4:], B[:4, :2], B[4:, 2:] = A_lon, A_lat, B_lon, B_lat
    units = dict.fromkeys((*states, *inputs), "")
    assert_modes(modes(LinearModel(A, B, states, inputs, units, {})), item)


@pytest.mark.parametrize("row", SOURCES["usstd_1976"]["rows"], ids=lambda row: f"{row[0]} m")
def test_standard_atmosphere(row: list[float]) -> None:
    height, *expected = row
    assert standard_atmosphere(height) == pytest.approx(tuple(expected), rel=SOURCES["usstd_1976"]["rtol"])


def test_every_source_says_what_it_is() -> None:
    for name, source in SOURCES.items():
        assert len(source["citation"]) > 20, name
