"""Every criterion, ours and yours alike, judges every aircraft of the hangar and has an answer to everything."""

import itertools
import json
import math
from dataclasses import asdict, fields
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import FlightCondition, catalogue
from fdes.aircraft.role import CATEGORIES, CLASSES, STRICTEST, Role, role_of
from fdes.analysis import linear_model
from fdes.analysis.measured import Measured, measure
from fdes.analysis.qualities import assess, charts, chosen
from fdes.analysis.verdict import Criterion, Verdict
from fdes.control import LinearModel
from fdes.shelf import shelf

NAMES = shelf("criteria").names()
READY = [
    pytest.param(a.at(c.id, variant=v), id=f"{a.id} {c.id} {v}")
    for a in catalogue()
    for c in a.conditions
    for v in ("corrected", "printed")
]
ROLES = [Role(k, c, None, "all of them") for k in CLASSES for c in CATEGORIES]
KEYS = ["criterion", "mode", "level", "margin", "value", "unit", "requirement", "reference", "reason"]


@pytest.fixture(params=NAMES)
def criterion(request: pytest.FixtureRequest) -> Criterion:
    part: Criterion = shelf("criteria").get(request.param)
    return part


def is_valid(verdict: Verdict) -> bool:
    told = json.loads(json.dumps(verdict.as_dict(), allow_nan=False))
    assert list(told) == KEYS
    assert told["level"] in {1, 2, 3, 4, None}
    assert (told["level"] is None) == (told["margin"] is None) == (told["value"] is None)
    if verdict.margin is not None and verdict.level is not None:
        assert verdict.margin >= 0.0 if verdict.level < 4 else verdict.margin <= 0.0
    assert all(told[key] for key in ("criterion", "mode", "unit", "requirement", "reference", "reason"))
    assert told["reason"].endswith((".", "?"))
    assert all(is_valid(part) for part in verdict.parts)
    return True


def test_the_part_is_named_as_its_file(criterion: Criterion) -> None:
    assert shelf("criteria").get(criterion.name) is criterion
    assert set(criterion.reads) < {f.name for f in fields(Measured)}


@pytest.mark.parametrize("fc", READY)
def test_judges_every_aircraft_in_every_role(criterion: Criterion, fc: FlightCondition) -> None:
    measured = measure(linear_model(fc), delay=0.12)
    for role in ROLES:
        verdict = criterion.evaluate(measured, role)
        assert verdict.criterion == criterion.name
        assert is_valid(verdict)
        assert criterion.evaluate(measured, role) == verdict  # pure
        for chart in criterion.charts(measured, role):
            json.dumps(chart.as_dict(), allow_nan=False)


def test_has_an_answer_to_whatever_is_known_or_not(criterion: Criterion) -> None:
    values: dict[str, tuple[float | None, ...]] = dict.fromkeys(criterion.reads, (None, -3.0, 0.0, 1e-09, 0.7, 40.0))
    for each in itertools.product(*values.values()):
        for role in ROLES:
            known: dict[str, Any] = dict(zip(values, each, strict=True))
            assert is_valid(criterion.evaluate(Measured(**known), role)), known
            for chart in criterion.charts(Measured(**known), role):
                assert all(map(math.isfinite, itertools.chain(*(line.x + line.y for line in chart.boundaries))))


def test_says_what_is_missing(criterion: Criterion) -> None:
    verdict = criterion.evaluate(Measured(), STRICTEST)
    assert verdict.level is None
    assert any(name in verdict.reason for name in criterion.reads)


@pytest.mark.parametrize("seed", range(40))
def test_any_model_gets_verdicts(seed: int) -> None:
    """Even one that merges, splits and diverges: each root somewhere at random."""
    random = np.random.default_rng(seed)
    fc = READY[seed % len(READY)].values[0]
    assert isinstance(fc, FlightCondition)
    model = linear_model(fc)
    wild = LinearModel(
        model.A * random.normal(0.3, 1.0, model.A.shape),
        model.B,
        model.states,
        model.inputs,
        model.units,
        model.point,
    )
    for verdict in assess(wild, role_of(fc.document, fc.condition)):
        assert is_valid(verdict)
    for chart in charts(measure(wild), STRICTEST):
        json.dumps(chart.as_dict(), allow_nan=False)


def test_all_are_asked_unless_some_are_named() -> None:
    assert sorted(c.name for c in chosen()) == NAMES
    assert [c.mode for c in chosen()][:4] == ["short_period", "phugoid", "roll", "dutch_roll"]


@pytest.mark.parametrize("fc", READY)
def test_the_hangar_says_what_its_aircraft_are_for(fc: FlightCondition) -> None:
    role = role_of(fc.document, fc.condition)
    assert role != STRICTEST
    assert role.reason
    assert asdict(role)["airplane_class"] in CLASSES
