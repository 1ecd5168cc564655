"""The tab Inputs: every shape is seen before it is put in, a measured file is read by the browser, values are held."""

from pathlib import Path
from typing import Any

import pytest

from fdes.units import DEG

SHAPES = ["step", "pulse", "3-2-1-1", "ramp", "sine", "sweep", "multisine", "1-cosine", "1-cosine-pulse"]


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{cockpit}/?world=canvas2d&session=inputs")
    page.wait_for_function("() => window.fdes && window.fdes.stats.frames > 5")
    page.get_by_role("tab", name="Inputs").click()
    yield page
    page.close()
    assert errors == []


def test_every_shape_blows_as_a_gust_and_is_seen_beforehand(page: Any) -> None:
    page.get_by_role("tab", name="Test input").click()
    panel = page.locator("#inputs-test-input")
    panel.get_by_label("Moves").select_option("alpha_g")
    for shape in SHAPES:
        page.evaluate("() => window.fdes.link.command('reset')")
        page.wait_for_function("() => Math.abs(window.fdes.drawn.q_dot) < 1e-6")
        panel.get_by_label("Shape").select_option(shape)
        page.wait_for_function("() => document.querySelector('.preview-curve').points.length === 400")
        panel.get_by_role("button", name="Put in").click()
        page.wait_for_function("() => Math.abs(window.fdes.drawn.q_dot) > 1e-3")
        assert panel.locator(".problem").inner_text() == ""
        assert page.evaluate(
            "() => { const p = document.getElementById('panel-inputs'); return p.scrollWidth <= p.clientWidth; }"
        )


def test_a_measured_file_is_read_here_and_its_numbers_are_flown(page: Any, tmp_path: Path) -> None:
    path = tmp_path / "run.csv"
    path.write_text("t [s],elevator [deg],raw\n10,0,1\n11,2,1\n40,2,1\n", encoding="utf-8")
    page.get_by_role("tab", name="Test input").click()
    panel = page.locator("#inputs-test-input")
    panel.get_by_label("Shape").select_option("measured")
    panel.locator("input[type=file]").set_input_files(path)
    panel.get_by_role("button", name="Put in").click()
    page.wait_for_function(f"() => Math.abs(window.fdes.drawn.elevator - {2 * DEG}) < 1e-6")
    panel.locator("select").nth(3).select_option("raw")
    page.get_by_text("The header of raw in run.csv has no unit. Write it like: raw [deg]").wait_for()


def test_a_value_is_held_until_it_is_let_go(page: Any) -> None:
    page.get_by_role("tab", name="Hold").click()
    entry = page.get_by_label("Hold aileron δa (+ rolls right), deg")
    entry.fill("1.25")
    page.wait_for_timeout(1300)  # a status came meanwhile, and did not touch what was being typed
    entry.press("Enter")
    page.wait_for_function(f"() => Math.abs(window.fdes.drawn.aileron - {1.25 * DEG}) < 1e-6")
    page.get_by_role("button", name="Let go of all").click()
    page.wait_for_function("() => window.fdes.drawn.aileron === 0")
