"""Every file of the hangar keeps what its readers rely on."""

import math
import tomllib
from importlib.resources import files
from typing import Any

import pytest

from fdes.aircraft import Aircraft, FlightCondition, catalogue, load
from fdes.aircraft.load import fold
from fdes.aircraft.schema import UNLESS_SAID, Derivatives
from fdes.physics.derivatives import Coefficients
from fdes.physics.signals import Surfaces

FILES = sorted((f for f in (files("fdes.aircraft") / "hangar").iterdir()), key=lambda f: f.name)
AIRCRAFT = catalogue()
READY = [
    pytest.param(a.at(c.id, variant=v), id=f"{a.id} {c.id} {v}")
    for a in AIRCRAFT
    for c in a.conditions
    for v in ("corrected", "printed")
]


@pytest.mark.parametrize("file", FILES, ids=lambda f: f.name)
def test_the_file_is_named_by_the_id(file: Any) -> None:
    document = tomllib.loads(file.read_text("utf-8"))
    assert file.name == f"{fold(document['id'])}.toml"
    assert load(document["id"]).document == document


def test_no_two_aircraft_answer_to_one_name() -> None:
    owner: dict[str, str] = {}
    for aircraft in AIRCRAFT:
        for name in {fold(n) for n in (aircraft.id, aircraft.name, *aircraft.aliases)}:
            assert owner.setdefault(name, aircraft.id) == aircraft.id, name


@pytest.mark.parametrize("aircraft", AIRCRAFT, ids=lambda a: a.id)
def test_every_source_is_cited_and_every_correction_reasoned(aircraft: Aircraft) -> None:
    cited = set()
    for condition in aircraft.conditions:
        for variant in ("corrected", "printed"):
            for p in aircraft.at(condition.id, variant=variant).provenance.values():
                cited |= set(p.sources)
                assert (p.reason is not None) == (p.corrected is not None)
    for block in ("geometry", "mass", "terms", "turbofan"):
        part = aircraft.document.get(block, {})
        cited |= {*part.get("sources", ()), *([part["source"]] if part else [])}
    cited |= {c["mass"]["source"] for c in aircraft.document["conditions"] if "mass" in c}
    (main,) = {c["source"] for c in aircraft.document["conditions"]}
    assert cited | {main} == set(aircraft.sources)
    assert aircraft.source == aircraft.sources[main]
    assert aircraft.summary.endswith(".")


@pytest.mark.parametrize("fc", READY)
def test_numbers_are_finite_and_fly(fc: FlightCondition) -> None:
    entries = [v for matrix in fc.equations("full") for row in matrix for v in row]
    assert all(map(math.isfinite, (*entries, *fc.reference, *fc.full_stick)))
    assert 0.0 < fc.trim_throttle < 1.0


@pytest.mark.parametrize("fc", READY)
def test_derivatives_are_there(fc: FlightCondition) -> None:
    seldom = {"CD_de", "Cy_p", "Cy_r", "Cy_da", "CL_alphadot", "CL_q", "CL_M", "CD_M", "Cm_M"}
    wanted = set(Coefficients._fields) - seldom if fc.nondimensional else {"X_u", "Z_w", "M_q", "Y_v", "L_p", "N_r"}
    assert fc.provenance.keys() > wanted


@pytest.mark.parametrize("fc", READY)
def test_positive_aileron_rolls_right(fc: FlightCondition) -> None:
    _, _, _, B_lat = fc.equations("full")
    assert B_lat[1][0] > 0.0


@pytest.mark.parametrize("fc", [p for p in READY if str(p.id).endswith("corrected")])
def test_signs_of_the_corrected_controls(fc: FlightCondition) -> None:
    A_lon, B_lon, A_lat, B_lat = fc.equations("full")
    assert (B_lon[1][0], B_lon[2][0], A_lon[1][1]) < (0.0, 0.0, 0.0)  # Z_de, M_de, Z_w
    assert B_lon[0][1] > 0.0  # X_dT
    assert B_lat[0][1] > 0.0 > B_lat[2][1]  # Y_dr, N_dr
    assert A_lat[1][1] < 0.0 < A_lat[2][0]  # L_p, N_beta
    assert A_lat[1][0] < 0.0  # L_beta


@pytest.mark.parametrize("fc", READY)
def test_full_stick_is_pleasant_and_within_the_limits(fc: FlightCondition) -> None:
    for held, low, high in zip(fc.full_stick, fc.limits.lower, fc.limits.upper, strict=True):
        assert low <= held <= high
    assert fc.full_stick.elevator < 0.0 < fc.full_stick.aileron
    assert fc.full_stick.rudder < 0.0
    _, _, A_lat, B_lat = fc.equations("full")
    assert 5.0 < math.degrees(-B_lat[1][0] / A_lat[1][1] * fc.full_stick.aileron) < 90.0


@pytest.mark.parametrize("fc", READY)
def test_every_assumption_has_a_reason(fc: FlightCondition) -> None:
    drag, engine_lag = not fc.nondimensional, fc.turbofan is None
    assert len(fc.assumed) == 2 * len(Surfaces._fields) + drag + engine_lag + len(UNLESS_SAID)
    for assumption in fc.assumed.values():
        assert assumption.keys() == {"value", "unit", "reason"}


def test_the_schema_knows_just_the_derivatives_of_the_plant() -> None:
    assert tuple(Derivatives.model_fields) == Coefficients._fields
