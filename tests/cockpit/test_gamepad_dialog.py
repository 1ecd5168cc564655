"""The set-up of a gamepad: what is assigned, calibrated and shaped holds at once, and is remembered for the device."""

from typing import Any

import pytest
from axe_playwright_python.sync_playwright import Axe

READY = "() => window.fdes && window.fdes.stats.frames > 5"
ROLL = "() => window.fdes.drawn.stick_roll"
FRAMES = """async () => {  // in which the page looks at the pad
  for (let i = 0; i < 3; i++) await new Promise((done) => requestAnimationFrame(done));
}"""
PADS = """
const made = (id, index, mapping, axes, buttons) => ({ id, index, connected: true, mapping, axes: Array(axes).fill(0),
  buttons: Array.from({ length: buttons }, () => ({ value: 0, pressed: false })) });
window.pad = made("Test Pad (Vendor: 1234)", 0, "standard", 4, 17);
window.stick = null;
navigator.getGamepads = () => [window.pad, window.stick];
"""
SECOND = "() => window.stick = { ...window.pad, id: 'Test Stick', index: 1, mapping: '', axes: [0.5, 0, 0, 0] }"


class Student:
    """Somebody with a pad in front of the page."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def open_dialog(self) -> None:
        self.page.locator("#control").click()
        self.page.get_by_role("menuitem", name="Set up the gamepad").click()
        self.page.get_by_role("dialog", name="Set up the gamepad").wait_for()

    def close_dialog(self) -> None:
        self.page.keyboard.press("Escape")
        self.page.wait_for_function("() => !document.querySelector('dialog[open]')")

    def reload(self) -> None:
        self.page.reload()
        self.page.wait_for_function(READY)

    def axis(self, number: int, value: float) -> None:
        self.page.evaluate(f"() => window.pad.axes[{number}] = {value}")
        self.page.evaluate(FRAMES)

    def button(self, number: int, value: float) -> None:
        self.page.evaluate(f"() => window.pad.buttons[{number}].value = {value}")
        self.page.evaluate(FRAMES)

    def press(self, name: str) -> None:
        self.page.get_by_role("button", name=name, exact=True).click()

    def sees(self, words: str) -> None:
        self.page.get_by_text(words, exact=True).first.wait_for()

    def row(self, control: str) -> str:
        return str(self.page.locator(f"[data-control={control}] small").inner_text())

    def figures(self, control: str) -> str:
        return str(self.page.locator(f"[data-control={control}] .figures").inner_text())

    def stick_rolls(self, expected: float) -> None:
        """The stick that the simulation has stands there, within a second or so."""
        self.page.wait_for_function(f"() => Math.abs(window.fdes.drawn.stick_roll - {expected}) < 2e-3")


@pytest.fixture
def student(browser: Any, cockpit: str) -> Any:
    """A student before the Fly page, with the injected pad. Any error in the page fails the test."""
    context = browser.new_context(viewport={"width": 1280, "height": 720})
    context.add_init_script(PADS)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{cockpit}/?world=canvas2d&session=pad-dialog")
    page.wait_for_function(READY)
    yield Student(page)
    context.close()
    assert errors == []


def test_the_axis_moved_furthest_is_assigned_with_its_sense_and_remembered(student: Student) -> None:
    student.open_dialog()
    student.press("Assign roll")
    student.sees("Move the stick fully right, or press the button that is to bank right.")
    student.page.evaluate("() => { window.pad.axes[1] = 0.6; window.pad.axes[3] = -1 }")
    student.sees("Axis 3 moves roll.")
    assert student.row("roll") == "Axis 3, inverted"
    assert student.figures("roll") == "right 100 % → 100 %"
    assert student.page.evaluate(ROLL) == 0.0  # it does not fly while it is set up
    student.close_dialog()
    student.stick_rolls(1.0)
    student.reload()
    student.axis(3, -1.0)
    student.stick_rolls(1.0)


def test_invert_and_escape_and_the_usual_mapping(student: Student) -> None:
    student.open_dialog()
    student.page.get_by_role("checkbox", name="Invert roll").check()
    student.axis(0, 1.0)
    assert student.figures("roll") == "left 100 % → 100 %"
    student.axis(0, 0.0)
    student.press("Assign pitch")
    student.page.keyboard.press("Escape")
    student.axis(2, 1.0)
    student.page.wait_for_timeout(500)
    assert (student.row("pitch"), student.row("roll")) == ("Axis 1", "Axis 0, inverted")
    student.press("Reset to usual mapping")
    student.sees("The usual mapping of such a device.")
    assert student.row("roll") == "Axis 0"
    student.reload()
    student.axis(0, 1.0)
    student.stick_rolls(1.0)


def test_a_pair_of_buttons_is_asked_for_one_after_the_other(student: Student) -> None:
    student.open_dialog()
    student.press("Assign roll")
    student.button(5, 1)
    student.sees("Button 5. Now the button that is to bank left.")
    student.button(5, 0)
    student.button(5, 1)  # the same again is not the other one
    student.button(5, 0)
    student.button(4, 1)
    student.sees("Buttons 5 and 4 move roll.")
    assert student.row("roll") == "Buttons 5 \N{MINUS SIGN} 4"
    assert student.figures("roll") == "left 100 % → 100 %"


def test_a_short_and_crooked_travel_is_measured(student: Student) -> None:
    student.axis(0, 0.1)
    student.open_dialog()
    student.press("Calibrate")
    student.press("Next")
    for value in (-0.7, 0.9, 0.1):
        student.axis(0, value)
    assert student.figures("roll") == "\N{MINUS SIGN}0.70 to 0.90"
    student.press("Done")
    student.sees("Measured: roll. Not moved far enough, and left as before: pitch.")
    for value, words in ((0.9, "right 100 % → 100 %"), (-0.7, "left 100 % → 100 %"), (0.1, "0 %")):
        student.axis(0, value)
        assert student.figures("roll") == words
    student.axis(0, -0.7)
    student.close_dialog()
    student.stick_rolls(-1.0)
    student.reload()
    student.axis(0, 0.9)
    student.stick_rolls(1.0)


def test_dead_zone_and_curve_shape_the_stick_and_are_drawn(student: Student) -> None:
    student.open_dialog()
    points = "() => document.querySelector('.shaping polyline').getAttribute('points')"
    before = student.page.evaluate(points)
    student.page.get_by_role("slider", name="Dead zone").fill("0.2")
    student.page.get_by_role("slider", name="Curve").fill("2")
    assert student.page.evaluate(points) != before
    student.axis(0, 0.6)
    assert student.figures("roll") == "right 60 % → 25 %"  # ((0.6 - 0.2) / 0.8)^2
    student.axis(0, 0.2)
    assert student.figures("roll") == "right 20 % → 0 %"
    student.axis(0, 0.6)
    student.close_dialog()
    student.stick_rolls(0.25)
    student.reload()
    student.axis(0, 0.6)
    student.stick_rolls(0.25)


def test_an_assigned_button_freezes_but_not_from_within_the_dialog(student: Student) -> None:
    student.open_dialog()
    assign = student.page.locator("[data-action-row=freeze] button").first
    assert assign.inner_text() == "Button 9"
    assign.click()
    student.button(2, 1)
    student.sees("Button 2: Freeze, resume.")
    assert assign.inner_text() == "Button 2"
    student.button(2, 0)
    student.button(2, 1)
    student.close_dialog()
    student.page.wait_for_timeout(400)
    assert student.page.locator("#freeze-word").inner_text() == "Freeze"  # it was down before the dialog closed
    student.button(2, 0)
    student.reload()
    student.button(9, 1)
    student.button(2, 1)
    student.page.get_by_role("button", name="Resume").wait_for()


def test_unplugged_while_it_is_set_up(student: Student) -> None:
    student.open_dialog()
    student.press("Assign yaw")
    student.page.evaluate("() => { window.away = window.pad; window.pad = null }")
    student.sees("Test Pad is unplugged. Plug it in again and press one of its buttons.")
    assert not student.page.get_by_role("button", name="Assign yaw").is_visible()
    student.page.evaluate("() => window.pad = window.away")
    student.page.get_by_role("button", name="Assign yaw", exact=True).wait_for()
    student.axis(2, 1.0)
    student.page.wait_for_timeout(500)
    assert student.row("yaw") == "Buttons 7 \N{MINUS SIGN} 6"  # what was under way ended when the device went


def test_of_two_devices_the_chosen_one_flies(student: Student) -> None:
    student.page.evaluate(SECOND)
    student.open_dialog()
    student.page.get_by_role("combobox", name="Device").select_option(label="1: Test Stick")
    student.page.wait_for_timeout(200)
    assert student.row("throttle") == "Axis 3, inverted"  # as joysticks have it
    student.close_dialog()
    student.page.wait_for_function("() => window.fdes.drawn.stick_roll > 0.3")
    student.reload()
    student.page.evaluate(SECOND)
    student.page.wait_for_function("() => window.fdes.drawn.stick_roll > 0.3")


def test_the_throttle_is_held_while_the_lever_is_set_up(student: Student) -> None:
    student.page.evaluate("() => { window.pad.mapping = ''; window.pad.id = 'Lever'; window.pad.axes[3] = -0.5 }")
    throttle = "() => Math.abs(window.fdes.drawn.stick_throttle - %s) < 1e-3"
    student.page.wait_for_function(throttle % 0.75)
    student.open_dialog()
    student.axis(3, 1.0)
    student.page.wait_for_timeout(300)
    assert student.figures("throttle") == "0 %"
    assert student.page.evaluate(throttle % 0.75)
    student.close_dialog()
    student.page.wait_for_function(throttle % 0.0)


@pytest.mark.parametrize("theme", ["dark", "light"])
@pytest.mark.parametrize("is_there", [True, False])
def test_accessible_and_whole_at_the_smallest_size(student: Student, theme: str, is_there: bool) -> None:
    student.page.evaluate(f"() => fdes.theme.set('{theme}')")
    if not is_there:
        student.page.evaluate("() => window.pad = null")
    student.page.keyboard.press("?")
    student.press("Set up the gamepad…")
    if is_there:
        student.page.locator("[data-action-row=record] button").first.click()
        student.press("Assign throttle")
    else:
        student.page.get_by_text("press one of its buttons").first.wait_for()
    student.page.wait_for_timeout(300)
    assert Axe().run(student.page).response["violations"] == []
    body = "() => { const b = document.querySelector('#gamepad .dialog-body'); return b.scrollHeight - b.clientHeight }"
    assert student.page.evaluate(body) <= 0
