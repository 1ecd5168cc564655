"""Every file of the hangar keeps what its readers rely on."""

import math
import tomllib
from importlib.resources import files
from typing import Any

import pytest

from fdes.aircraft import Aircraft, FlightCondition, catalogue, load
from fdes.aircraft.load import fold
from fdes.aircraft.schema import Derivatives
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
    assert cited | {"NELSON"} == set(aircraft.sources)
    assert aircraft.source == aircraft.sources["NELSON"]
    assert aircraft.summary.endswith(".")


@pytest.mark.parametrize("fc", READY)
def test_numbers_are_finite_and_fly(fc: FlightCondition) -> None:
    assert all(map(math.isfinite, (*fc.coefficients, *fc.reference, *fc.full_stick)))
    assert 0.0 < fc.trim_throttle < 1.0
    assert fc.provenance.keys() > set(Coefficients._fields) - {"CD_de", "Cy_p", "Cy_r", "Cy_da"}


@pytest.mark.parametrize("fc", READY)
def test_positive_aileron_rolls_right(fc: FlightCondition) -> None:
    assert fc.coefficients.Cl_da > 0.0


@pytest.mark.parametrize("fc", [p for p in READY if str(p.id).endswith("corrected")])
def test_signs_of_the_corrected_controls(fc: FlightCondition) -> None:
    k = fc.coefficients
    assert k.CL_de > 0.0 > k.Cm_de
    assert k.Cy_dr > 0.0 > k.Cn_dr
    assert k.Cl_dr > 0.0
    assert k.Cl_p < 0.0 < k.Cn_beta
    assert k.Cl_beta < 0.0


@pytest.mark.parametrize("fc", READY)
def test_full_stick_is_pleasant_and_within_the_limits(fc: FlightCondition) -> None:
    for held, low, high in zip(fc.full_stick, fc.limits.lower, fc.limits.upper, strict=True):
        assert low <= held <= high
    assert fc.full_stick.elevator < 0.0 < fc.full_stick.aileron
    assert fc.full_stick.rudder < 0.0
    roll_rate = -fc.coefficients.Cl_da / fc.coefficients.Cl_p * 2.0 * fc.reference.V / fc.reference.b
    assert 7.0 < math.degrees(roll_rate * fc.full_stick.aileron) < 90.0


@pytest.mark.parametrize("fc", READY)
def test_every_assumption_has_a_reason(fc: FlightCondition) -> None:
    assert len(fc.assumed) == 2 * len(Surfaces._fields)
    for assumption in fc.assumed.values():
        assert assumption.keys() == {"value", "unit", "reason"}


def test_the_schema_knows_just_the_derivatives_of_the_plant() -> None:
    assert tuple(Derivatives.model_fields) == Coefficients._fields
