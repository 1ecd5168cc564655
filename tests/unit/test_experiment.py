"""Experiments and aircraft files from outside reopen what flew; no name in them leads to a file or to code."""

import json
from pathlib import Path
from typing import Any

import pytest

from fdes.aircraft import load
from fdes.aircraft.load import aircraft_of
from fdes.aircraft.role import role_of
from fdes.aircraft.save import as_toml
from fdes.cockpit.cabin import Cabin
from fdes.cockpit.commands import ClearInputs, PutIn, Reset
from fdes.cockpit.craft import make_craft
from fdes.cockpit.excite import held as held_by_hand
from fdes.cockpit.experiment import MOST, experiment_of, opened
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
    said = json.loads(
        json.dumps(experiment_of(craft, FLEET, [(0.0, "step aileron 1deg"), (2.5, "doublet rudder 1deg for 1s")], held))
    )
    assert "document" not in said
    again, opened_again = opened(json.dumps(said), FLEET)
    assert again.header() == craft.header()
    assert again.modes == craft.modes
    assert str(again.role) == str(craft.role)
    assert opened_again.put_in()[:2] == [PutIn("step aileron 1deg"), PutIn("doublet rudder 1deg for 1s", 2.5)]
    assert dict(map(held_by_hand, opened_again.held)) == held


def test_all_laws_at_once_fit_into_an_experiment() -> None:
    control = Control(
        "yaw_damper; roll_rate_damper; spiral_stabilization; roll_angle; pitch_rate_damper; pitch_rate_pi"
    )
    craft = make_craft(load("A-4D").at(), control=control)
    again, _ = opened(json.dumps(experiment_of(craft, FLEET, [])), FLEET)
    assert again.fit.control == craft.fit.control


def test_plant_actuators_and_sensors_come_along() -> None:
    control = Control("yaw_damper zeta=0.5; sensors lag=20ms delay=50ms", actuators=True, sampled=True)
    craft = make_craft(load("A-4D").at(), integrator="rk4", control=control, plant="nonlinear")
    said = json.loads(json.dumps(experiment_of(craft, FLEET, [])))
    assert said["wanted"] == {"yaw_damper": 0.5}
    again, _ = opened(json.dumps(said), FLEET)
    assert again.header() == craft.header()
    assert again.control == craft.control
    assert again.fit.control.sampled


def test_interpolation_across_mach_and_a_lagging_engine_come_along() -> None:
    craft = make_craft(load("A-4D").at(across="mach", spool=True), changes=["Cm_q*=0.5"], plant="nonlinear")
    said = json.loads(json.dumps(experiment_of(craft, FLEET, [])))
    assert (said["across"], said["spool"]) == ("mach", True)
    again, _ = opened(json.dumps(said), FLEET)
    assert again.header() == craft.header()
    assert again.setup.plant == craft.setup.plant
    assert not {"across", "spool"} & experiment_of(make_craft(load("A-4D").at()), FLEET, []).keys()


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"across": "os.system"}, "no quantity to interpolate across named 'os.system'"),
        ({"aircraft": "F-16", "condition": "V502_SL", "spool": True}, "lag of its own"),
        ({"aircraft": "NAVION", "condition": "M0.158_SL", "across": "mach"}, "no other condition"),
    ],
)
def test_what_cannot_be_interpolated_or_lag_is_refused(said: dict[str, Any], words: str) -> None:
    with pytest.raises(FdesError, match=words):
        opened(experiment(**said), FLEET)


def test_another_condition_of_what_flies_is_interpolated_too_as_far_as_it_can_be() -> None:
    fleet = Fleet(load("JetStar"), "M0.80_40kft", "corrected", "full", "rk4", "nonlinear", spool=True)
    assert fleet.craft("JetStar", None, "corrected", fleet.first).base.spool
    between = Fleet(load("A-4D"), None, "corrected", "full", "rk4", "nonlinear", across="mach", spool=True)
    other = fleet.craft("A-4D", "M0.8_35kft", "corrected", between.first).base
    assert (other.condition, other.across[0].condition, other.spool) == ("M0.8_35kft", "M0.4_SL", True)
    elsewhere = fleet.craft("NAVION", None, "corrected", between.first).base
    assert not elsewhere.across
    assert not elsewhere.spool


def test_a_file_says_that_its_engine_lagged_and_is_not_made_of_several_conditions() -> None:
    with pytest.raises(FdesError, match=r"between M0\.4_SL, M0.8_35kft; a saved file holds one condition alone"):
        as_toml(load("A-4D").at(across="mach"))
    lagging = load("A-4D").at(spool=True)
    assert any("Flown with --spool" in note for note in aircraft_of(as_toml(lagging), "the file").at().notes)


class Flown:
    """As much of a session as a cabin asks."""

    t = 0.0


def test_a_cabin_keeps_all_inputs_of_a_flight_and_when_each_was_put_in() -> None:
    flown: Any = Flown()
    cabin = Cabin(flown, FLEET.first)
    for flown.t, text in ((10.0, "doublet elevator 1deg"), (12.5, "step aileron 1deg")):
        cabin.remember(PutIn(text))
    assert cabin.given() == [(0.0, "doublet elevator 1deg"), (2.5, "step aileron 1deg")]
    cabin.remember(Reset())
    assert len(cabin.given()) == 2, "they can still be shared"
    cabin.remember(PutIn("pulse rudder 1deg", 0.5))
    assert cabin.given() == [(0.0, "pulse rudder 1deg")]
    for _ in range(100):
        cabin.remember(PutIn("step aileron 1deg"))
    assert len(cabin.given()) == MOST
    cabin.remember(ClearInputs())
    assert cabin.given() == []


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
        ({"inputs": ["__import__('os').system('true')"]}, "input"),
        ({"inputs": ["step elevator open('x')"]}, "input"),
        ({"inputs": ["step elevator 1deg"], "after": ["1"]}, "after"),
        ({"inputs": ["step elevator 1deg"], "after": [-1.0]}, "from 0 s to 3600 s"),
        ({"inputs": ["step elevator 1deg"], "after": [1.0, 2.0]}, "1 inputs and 2 times"),
        ({"wanted": {"yaw_damper": "open('x')"}}, "wanted"),
        ({"wanted": ["./law.py"]}, "wanted"),
        ({"law": "yaw_damper; sensors lag=open('x')"}, "cannot be read"),
        ({"law": "yaw_damper; sensors file=/etc/passwd"}, "sensors"),
        ({"plant": "./plant.py"}, "no plant"),
        ({"plant": "fdes.physics.plant"}, "no plant"),
        ({"actuators": "./actuators.py"}, "actuators"),
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


def test_inputs_more_than_an_hour_apart_do_not_keep_an_experiment_from_opening() -> None:
    flown: Any = Flown()
    cabin = Cabin(flown, FLEET.first)
    for flown.t, text in ((0.0, "step rudder 1deg"), (3000.0, "step elevator 1deg"), (4000.0, "step aileron 1deg")):
        cabin.remember(PutIn(text))
    assert cabin.given() == [(0.0, "step elevator 1deg"), (1000.0, "step aileron 1deg")]
    opened(json.dumps(experiment_of(FLEET.first, FLEET, cabin.given())), FLEET)
