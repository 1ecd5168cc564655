"""The nonlinear aircraft in the page: chosen by a key, looped and rolled by the keyboard."""

from typing import Any

import pytest

READY = "() => window.fdes && window.fdes.stats.frames > 5"


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with the 2-D world. Any error in the page fails the test."""
    context = browser.new_context(viewport={"width": 1280, "height": 720}, bypass_csp=True)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=nonlinear")
    page.wait_for_function(READY)
    yield page
    context.close()
    assert errors == []


def test_roll_inverted_by_the_keyboard(page: Any) -> None:
    """The linear aircraft offers the nonlinear one, which flies on from there, upside down."""
    page.keyboard.down("ArrowRight")
    page.wait_for_function("() => fdes.cockpit.words().small.includes('N NONLINEAR')")
    page.keyboard.press("n")
    page.wait_for_function("() => fdes.cockpit.aircraft.plant === 'nonlinear'")
    assert page.locator("#method-words").inner_text().endswith("· nonlinear")
    assert page.locator("#static-figures").inner_text().endswith("· all of the linearized aircraft")
    page.wait_for_function("() => Math.abs(fdes.drawn.phi) > 2.6")
    page.keyboard.up("ArrowRight")
    assert page.evaluate("() => fdes.cockpit.words().small") == ""
    assert page.evaluate("() => Object.values(fdes.drawn).every((v) => typeof v !== 'number' || Number.isFinite(v))")


def test_the_form_switches_too_and_the_lever_goes_to_trim(page: Any) -> None:
    page.get_by_role("tab", name="Inputs").click()
    page.get_by_role("tab", name="Equations").click()
    page.locator("#inputs-equations select").nth(0).select_option("nonlinear")
    page.wait_for_function("() => fdes.cockpit.aircraft.plant === 'nonlinear'")
    trim = page.evaluate("() => fdes.cockpit.aircraft.trim_throttle")
    page.wait_for_function(f"() => Math.abs(fdes.drawn.throttle - {trim}) < 1e-6")
    page.locator("#inputs-equations select").nth(2).select_option("exact")
    page.get_by_role("button", name="Fly from trim with these").click()
    page.wait_for_function("() => document.getElementById('toast').textContent.includes('exact hold')")
