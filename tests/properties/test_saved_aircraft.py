"""Whatever is changed of whatever aircraft: the file that is saved flies the same to the last bit."""

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fdes.aircraft import FlightCondition, catalogue, edited
from fdes.aircraft.knobs import knobs
from fdes.aircraft.load import aircraft_of
from fdes.aircraft.save import as_toml, decimal, saved
from fdes.errors import AircraftFileError, FdesError, SpecError
from fdes.units import to_si

ALL = [a.at(c.id, v) for a in catalogue() for c in a.conditions for v in ("corrected", "printed")]
LISTED = [f"{c.aircraft_id} {c.condition} {c.variant}" for c in ALL]


def same(one: FlightCondition, other: FlightCondition) -> None:
    """Equal in all that the plant is made of."""
    table, again = one.aerodynamics, other.aerodynamics
    if one.nondimensional:
        assert again == table
    else:
        assert again.value == table.value  # type: ignore[union-attr]
    assert other.reference == one.reference
    assert other.limits == one.limits
    assert other.full_stick == one.full_stick
    assert other.trim_throttle == one.trim_throttle
    assert other.cg == one.cg


@pytest.mark.parametrize("condition", ALL, ids=LISTED)
def test_an_unchanged_aircraft_flies_the_same(condition: FlightCondition) -> None:
    same(condition, aircraft_of(as_toml(condition), "the file").at())


@settings(max_examples=150, deadline=None)
@given(data=st.data())
def test_a_changed_aircraft_flies_the_same(data: st.DataObject) -> None:
    base = data.draw(st.sampled_from(ALL))
    changed = base
    for _ in range(data.draw(st.integers(1, 4))):
        knob = data.draw(st.sampled_from(knobs(base)))
        where = data.draw(st.floats(0.0, 1.0))
        value = knob.low + where * (knob.high - knob.low)
        operator = "+=" if knob.name == "cg" and base.cg is None else "="
        try:
            changed = edited(changed, [f"{knob.name}{operator}{value!r} {knob.unit}"])
        except FdesError:
            continue  # no aircraft can have it
    try:
        text = as_toml(changed)
    except AircraftFileError:
        return  # a file may not say it
    except SpecError:
        if base.nondimensional:  # a table of dimensional ones in feet cannot say every number
            raise
        return
    same(changed, aircraft_of(text, "the file").at())


@given(value=st.floats(1e-3, 1e6), unit=st.sampled_from(["lb", "slug ft^2", "ft", "deg", "kt"]))
def test_a_decimal_is_exact_or_none(value: float, unit: str) -> None:
    found = decimal(value, unit)
    assert found is None or to_si(found, unit) == value


def test_the_file_says_what_was_printed_and_what_was_changed() -> None:
    base = next(c for c in ALL if c.aircraft_id == "A-4D")
    content: dict[str, Any] = saved(edited(base, ["Cm_q*=0.5", "m=8000 kg"]))
    assert [c["id"] for c in content["conditions"]] == [base.condition]
    (own,) = content["conditions"]
    Cm_q = own["derivatives"]["Cm_q"]
    assert (Cm_q["printed"], Cm_q["corrected"]) == (-3.6, -1.8)
    assert Cm_q["reason"] == "changed in flight"
    assert Cm_q["confidence"] == "high"
    assert own["notes"][-1] == "Changed from A-4D, in this order: Cm_q*=0.5; m=8000.0 kg."
    assert own["derivatives"]["Cm_alpha"] == base.document["conditions"][0]["derivatives"]["Cm_alpha"]
    assert content["id"] == "A-4D-changed"
