"""A flight that is asked for without a condition is flown as the one that it belongs to."""

import pytest

from fdes.aircraft import load
from fdes.analysis.nearest_condition import nearest_condition


@pytest.mark.parametrize(
    ("aircraft", "trim", "condition"),
    [
        ("F-16", "V=565.685 ft/s h=10013 ft", "M0.53_10kft"),
        ("F-16", "V=502 ft/s h=0 ft", "V502_SL"),
        ("F-16", "V=1300 ft/s h=0 ft", "V502_SL"),
        ("F-16", "V=600 ft/s", "V502_SL"),
        ("F-16_V502_SL", "h=0 ft", "V502_SL"),
        ("F-16_M0.53_10kft", "V=502 ft/s h=0 ft", None),
        ("F-104A", "V=300 kt h=30000 ft", None),
    ],
)
def test_which(aircraft: str, trim: str, condition: str | None) -> None:
    assert nearest_condition(load(aircraft), trim) == condition
