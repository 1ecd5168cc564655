"""A student with a gamepad, or with the mouse as stick: the aircraft obeys, rubbish is survived, unplugging centers."""

import json
from typing import Any

import pytest

from fdes.units import DEG

READY = "() => window.fdes && window.fdes.stats.frames > 5"
NAME = "Test Pad (Vendor: 1234)"
INJECT = """
window.pad = { id: %s, index: 0, connected: true, mapping: "standard", axes: [0, 0, 0, 0],
  buttons: Array.from({ length: 17 }, () => ({ value: 0, pressed: false })) };
navigator.getGamepads = () => [window.pad, null];
""" % json.dumps(NAME)  # noqa: UP031 - the script is full of braces


@pytest.fixture
def open_page(browser: Any, cockpit: str) -> Any:
    """Opens the Fly page after `script` has run in it. Any error in the page fails the test."""
    contexts: list[Any] = []
    errors: list[str] = []

    def opened(script: str = "") -> Any:
        context = browser.new_context(viewport={"width": 1280, "height": 720})
        contexts.append(context)
        context.add_init_script(script)
        page = context.new_page()
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(f"{cockpit}/?world=canvas2d&session=pad")
        page.wait_for_function(READY)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert errors == []


def drawn(page: Any) -> dict[str, Any]:
    """The values last drawn, SI and radians."""
    return dict(page.evaluate("() => structuredClone(window.fdes.drawn)"))


def axis(page: Any, number: int, value: float, seconds: float = 0.6) -> None:
    page.evaluate(f"() => window.pad.axes[{number}] = {value}")
    page.wait_for_timeout(1000 * seconds)


def remembering(mapping: Any) -> str:
    kept = json.dumps(json.dumps({NAME: mapping}))
    return f"localStorage.setItem('fdes.gamepads', {kept});" + INJECT


def test_right_stick_banks_right_and_the_heading_then_increases(open_page: Any) -> None:
    page = open_page(INJECT)
    axis(page, 0, 0.6)
    axis(page, 0, 0.0)
    banked = drawn(page)
    assert banked["phi"] > 3 * DEG
    page.wait_for_timeout(2000)
    assert drawn(page)["psi"] > banked["psi"]


def test_aft_stick_pitches_up_and_the_dead_zone_holds_zero(open_page: Any) -> None:
    page = open_page(INJECT)
    level = drawn(page)["theta"]
    axis(page, 1, 0.05)
    assert drawn(page)["stick_pitch"] == 0.0
    axis(page, 1, 0.8)
    assert drawn(page)["theta"] > level + 2 * DEG


def test_a_remapped_and_inverted_axis_obeys(open_page: Any) -> None:
    page = open_page(remembering({"roll": {"axis": 3, "invert": True, "center": 0.0}}))
    axis(page, 0, 1.0)
    assert drawn(page)["stick_roll"] == 0.0
    axis(page, 3, 1.0)
    assert drawn(page)["stick_roll"] == pytest.approx(-1.0)


@pytest.mark.parametrize(
    "rubbish",
    [
        7,
        {"roll": {"axis": "x"}, "deadZone": -4, "curve": None, "actions": {"freeze": "9"}},
        {"roll": None, "actions": {"freeze": 9000, "constructor": 5}},
        {"roll": {"axis": 0, "center": 0.95, "low": 0.99, "high": -7}, "actions": [5]},
    ],
)
def test_rubbish_in_the_store_leaves_the_usual_mapping(open_page: Any, rubbish: Any) -> None:
    page = open_page("localStorage.setItem('fdes.control', 'pedals');" + remembering(rubbish))
    page.evaluate("() => window.pad.buttons[5].value = 1")
    axis(page, 0, 1.0)
    assert drawn(page)["stick_roll"] == pytest.approx(1.0)


def test_the_button_that_wakes_a_pad_does_nothing_else(open_page: Any) -> None:
    page = open_page(INJECT + "window.asleep = window.pad; window.pad = null;")
    page.evaluate("() => { window.pad = window.asleep; window.pad.buttons[9].value = 1 }")
    page.get_by_text("Test Pad flies.").wait_for()
    page.wait_for_timeout(400)
    assert page.locator("#freeze-word").inner_text() == "Freeze"


def test_unplugging_centers_the_stick_and_says_so(open_page: Any) -> None:
    page = open_page(INJECT)
    axis(page, 0, 0.5)
    assert drawn(page)["stick_roll"] > 0.2
    page.evaluate("() => window.pad = null")
    page.get_by_text("Test Pad is unplugged. The stick is centered").wait_for()
    page.wait_for_timeout(300)
    assert drawn(page)["stick_roll"] == 0.0


def test_the_mouse_is_a_stick_until_escape(open_page: Any) -> None:
    page = open_page()
    box = page.locator(".view").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x + 120, y)
    page.wait_for_timeout(300)
    assert drawn(page)["stick_roll"] == 0.0
    page.keyboard.press("m")
    page.mouse.move(x + 100, y + 60)
    page.wait_for_timeout(600)
    flown = drawn(page)
    assert flown["phi"] > 3 * DEG
    assert flown["stick_pitch"] > 0.1
    page.keyboard.press("Escape")
    page.wait_for_timeout(400)
    assert drawn(page)["stick_roll"] == 0.0


def test_the_chooser_hands_the_stick_over_and_back(open_page: Any) -> None:
    page = open_page(INJECT)
    page.evaluate("() => window.pad.axes[0] = 0.7")
    page.wait_for_function("() => window.fdes.drawn.stick_roll > 0.3")
    page.locator("#control").click()
    page.get_by_role("menuitemradio", name="Keyboard").click()
    page.wait_for_function("() => window.fdes.drawn.stick_roll === 0")
    page.locator("#control").focus()
    page.keyboard.press("Enter")
    page.keyboard.press("End")
    page.keyboard.press("ArrowUp")  # the last item sets the gamepad up
    page.wait_for_timeout(300)
    assert drawn(page)["stick_pitch"] == 0.0
    page.keyboard.press("Enter")
    page.wait_for_function("() => window.fdes.drawn.stick_roll > 0.3")
    page.get_by_text("Test Pad", exact=True).wait_for()


def test_without_a_gamepad_the_chooser_says_what_to_do(open_page: Any) -> None:
    page = open_page()
    page.locator("#control").click()
    page.get_by_role("menuitemradio", name="Gamepad").click()
    page.get_by_text("Plug one in and press one of its buttons").wait_for()


def test_a_calibrated_axis_reaches_both_stops(open_page: Any) -> None:
    roll = {"axis": 0, "center": 0.1, "low": -0.7, "high": 0.9}
    page = open_page(remembering({"roll": roll, "deadZone": 0, "curve": 1}))
    for read, meant in ((0.9, 1.0), (-0.7, -1.0), (0.5, 0.5), (-0.3, -0.5), (0.1, 0.0)):
        axis(page, 0, read, 0.4)
        assert drawn(page)["stick_roll"] == pytest.approx(meant, abs=1e-3)


def test_start_freezes_once_for_each_press_and_not_in_a_dialog(open_page: Any) -> None:
    page = open_page(INJECT)
    press = "(value) => window.pad.buttons[9].value = value"
    page.evaluate(press, 1)
    page.get_by_role("button", name="Resume").wait_for()
    page.wait_for_timeout(500)
    page.get_by_role("button", name="Resume").wait_for()
    page.evaluate(press, 0)
    page.wait_for_timeout(200)
    page.keyboard.press("?")
    page.locator("dialog#help[open]").wait_for()  # it is fetched first
    page.evaluate(press, 1)
    page.wait_for_timeout(400)
    page.keyboard.press("Escape")
    page.wait_for_timeout(400)
    page.get_by_role("button", name="Resume").wait_for()
    page.evaluate(press, 0)
    page.wait_for_timeout(200)
    page.evaluate(press, 1)
    page.get_by_role("button", name="Freeze").wait_for()


def test_the_chosen_control_is_remembered(open_page: Any) -> None:
    page = open_page(INJECT)
    page.locator("#control").click()
    page.get_by_role("menuitemradio", name="Keyboard").click()
    page.reload()
    page.wait_for_function(READY)
    page.get_by_text("Test Pad is plugged in. To fly with it, choose Gamepad").wait_for()
    axis(page, 0, 1.0)
    assert drawn(page)["stick_roll"] == 0.0
    page.keyboard.press("m")
    page.reload()
    page.wait_for_function(READY)
    page.locator("#control", has_text="Mouse stick").wait_for()
    page.keyboard.press("m")
    page.locator("#control", has_text="Keyboard").wait_for()
    page.locator("#control").click()
    page.get_by_role("menuitemradio", name="Gamepad").click()
    page.reload()
    page.wait_for_function(READY)
    axis(page, 0, 1.0)
    assert drawn(page)["stick_roll"] == pytest.approx(1.0)
