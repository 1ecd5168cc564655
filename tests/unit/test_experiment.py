"""Experiments and aircraft files from outside reopen what flew; no name in them leads to a file or to code."""

import json
from pathlib import Path
from typing import Any

import pytest

from fdes.aircraft import load
from fdes.aircraft.role import role_of
from fdes.cockpit.craft import make_craft
from fdes.cockpit.excite import held as held_by_hand
from fdes.cockpit.experiment import experiment_of, opened
from fdes.cockpit.fleet import Fleet
from fdes.cockpit.flight_control import Control
from fdes.errors import FdesError

FLEET = Fleet(load("A-4D"), None, "corrected", "full", "rk4")
PLAIN: dict[str, Any] = {"format": "fdes experiment 1", "aircraft": "A-4D", "condition": "M0.4_SL", "step": 0.02}


def experiment(**said: Any) -> str:
    return json.dumps(PLAIN | said)


def test_an_experiment_reopens_what_flew() -> None:
    base = load("NAVION").at()
    control = Control("yaw_damper gain=0.5", actuators=True)
    role = role_of(base.document, base.condition).but("II-L", "A")
    craft = make_craft(base, "nelson", "heun", 0.02, ["Cm_q*=0.5", "cg+=0.02"], role, control)
    held = {"elevator": 0.0349, "throttle": 0.1, "gust_w": -2.0}
    said = json.loads(json.dumps(experiment_of(craft, FLEET, ["step aileron 1deg"], held)))
    assert "document" not in said
    again, opened_again = opened(json.dumps(said), FLEET)
    assert again.header() == craft.header()
    assert again.modes == craft.modes
    assert str(again.role) == str(craft.role)
    assert opened_again.inputs == ["step aileron 1deg"]
    assert dict(map(held_by_hand, opened_again.held)) == held


def test_all_laws_at_once_fit_into_an_experiment() -> None:
    control = Control(
        "yaw_damper; roll_rate_damper; spiral_stabilization; roll_angle; pitch_rate_damper; pitch_rate_pi"
    )
    craft = make_craft(load("A-4D").at(), control=control)
    again, _ = opened(json.dumps(experiment_of(craft, FLEET, [])), FLEET)
    assert again.fit.control.law == craft.fit.control.law


def test_an_aircraft_that_the_server_does_not_offer_comes_along() -> None:
    craft = FLEET.first
    other = FLEET.opened(Path("tests/unit/mine.toml").read_text(encoding="utf-8"), craft)
    said = experiment_of(other, FLEET, [])
    assert said["document"] == other.base.document
    again, _ = opened(json.dumps(said), FLEET)
    assert again.header() == other.header()


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"aircraft": "tests/unit/mine.toml"}, "no aircraft"),
        ({"aircraft": "/etc/passwd"}, "no aircraft"),
        ({"aircraft": "../mine.toml"}, "no aircraft"),
        ({"condition": "../M0.4_SL"}, "no flight condition"),
        ({"law": "./law.py"}, "no law"),
        ({"law": "fdes.control.laws.direct"}, "no law"),
        ({"law": "__import__('os').system('true')"}, "law"),
        ({"form": "/elsewhere/form.py"}, "no form"),
        ({"integrator": "../rk4.py"}, "no integrator"),
        ({"inputs": ["measured elevator from /etc/passwd"]}, "input"),
        ({"held": ["elevator 2deg; rudder 1deg"]}, "is incomplete"),
        ({"held": ["elevatr 2deg"]}, "Did you mean 'elevator'"),
        ({"changes": ["Cm_q=__import__('os')"]}, "cannot be read"),
        ({"changes": ["/etc/passwd"]}, "not understood"),
        ({"changes": ["x=1"] * 100}, "changes"),
        ({"code": "print(1)"}, "code"),
        ({"step": "0.02"}, "step"),
        ({"step": 1e9}, "cannot be flown"),
        ({"format": "fdes experiment 2"}, "format"),
        ({"variant": "pickle"}, "variant"),
        ({"document": {"format": 1}}, "cannot be used"),
        ({"document": "/etc/passwd"}, "document"),
    ],
)
def test_what_could_name_code_or_a_file_is_refused(said: dict[str, Any], words: str) -> None:
    with pytest.raises(FdesError, match=words):
        opened(experiment(**said), FLEET)


@pytest.mark.parametrize("wrong", ["", "{", "[" * 50000, "7", "null", '{"format": NaN}'])
def test_what_is_no_experiment_is_refused(wrong: str) -> None:
    with pytest.raises(FdesError, match="cannot be used"):
        opened(wrong, FLEET)


@pytest.mark.parametrize("wrong", ["", "format = 1", "x = [" * 3000, "not toml", 'source = "/etc/passwd"'])
def test_what_is_no_aircraft_file_is_refused(wrong: str) -> None:
    with pytest.raises(FdesError, match="cannot be used"):
        FLEET.opened(wrong, FLEET.first)
