"""Reading quantities with units, and what is said when they cannot be read."""

import math

import pytest

from fdes.errors import SpecError
from fdes.units import G0, POUND_FORCE, SLUG, parse, to_si


@pytest.mark.parametrize(
    ("text", "si", "value"),
    [
        ("15deg", "rad", math.radians(15.0)),
        ("-1.5e1 deg", "rad", -math.radians(15.0)),
        ("170 kt", "m/s", 170.0 * 1852.0 / 3600.0),
        ("2 s", "s", 2.0),
        ("0.5", "rad", 0.5),
        (".5 ft/s", "m/s", 0.1524),
    ],
)
def test_reads_a_quantity(text: str, si: str, value: float) -> None:
    assert parse(text, si) == pytest.approx(value, rel=1e-14)


def test_slug_and_pound_follow_from_their_definitions() -> None:
    assert pytest.approx(14.593903, rel=1e-7) == SLUG
    assert pytest.approx(4.4482216152605, rel=1e-14) == POUND_FORCE
    assert to_si(32.174048556430446, "ft/s^2") == pytest.approx(G0)


@pytest.mark.parametrize(
    ("text", "si", "words"),
    [
        ("fifteen", "rad", "'fifteen' is not a number with a unit. Write it like '15 deg'"),
        ("15 kt", "rad", "'15 kt' is in kt, which is not a unit of this quantity. Use one of: rad, deg"),
        ("15 degs", "rad", "Unknown unit 'degs'. Did you mean 'deg'?"),
        ("1e999 deg", "rad", "not a finite number"),
        ("nan", "rad", "'nan' is not a number with a unit"),
        ("NaN", "1", "'NaN' is not a number."),
        ("50%", "1", "Unknown unit '%'. It has none."),
    ],
)
def test_says_what_is_wrong(text: str, si: str, words: str) -> None:
    with pytest.raises(SpecError) as error:
        parse(text, si)
    assert words in str(error.value)
