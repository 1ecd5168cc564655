"""What is said of a law, of a vehicle or of a time in a scenario that cannot be flown."""

import tomllib

import pytest

from fdes.errors import SpecError
from fdes.flight.scenario import SHIPPED, fly_scenario, scenario_of

TRIMMED = tomllib.loads((SHIPPED / "nesc_11_f16_trim.toml").read_text("utf-8")) | {"duration": "0.2 s"}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            {"law": "pitch_rate_pi gain=0.5"},
            r"integral_gain of pitch_rate_pi is not said, and in a scenario nothing is designed\. Say its gains\.",
        ),
        (
            {"law": "yaw_damper gain=0.5 zeta=0.4"},
            r"zeta of yaw_damper is a wish, and in a scenario nothing is designed",
        ),
        ({"vehicle": {"aircraft": "F-16", "condition": 16}}, r"vehicle\.condition is 16; it must be a text, in quotes"),
        (
            {"vehicle": {"aircraft": "A-4D"}, "law": {"name": "f16_autopilot"}},
            r"The gains of f16_autopilot are those of the F-16: fly that, or another law\.",
        ),
        ({"step": "0 s"}, r'step is 0 s; it must be more than zero, such as "0\.01 s"'),
        ({"row": "-1 s"}, r"row is -1 s; it must be more than zero"),
    ],
)
def test_refusals(change: dict, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        scenario_of(TRIMMED | change)


@pytest.mark.parametrize("law", ["direct", "pitch_rate_damper gain=0.3; sensors delay=50ms"])
def test_laws_that_have_no_gain_of_their_own_fly(law: str) -> None:
    assert len(fly_scenario(scenario_of(TRIMMED | {"law": law})).data) == 3
