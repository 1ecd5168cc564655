"""What-if as a student uses it: a recording flown again with changes; differences, charts, and a ghost in the world."""

from typing import Any

import pytest
from axe_playwright_python.sync_playwright import Axe

SIZE = {"width": 1280, "height": 720}
READY = "() => window.fdes && window.fdes.stats.frames > 5"
SLOW = 60_000  # ms: another process starts, and a computer may be busy


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with a recording of two seconds, its Recordings tab open. Any error in the page fails the test."""
    context = browser.new_context(viewport=SIZE)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=what_if")
    page.wait_for_function(READY)
    page.evaluate(
        """async () => {
          const { link } = window.fdes;
          const name = await link.command("record", { value: true });
          await link.command("input", { text: "doublet rudder 5deg for 1s" });
          await new Promise((done) => setTimeout(done, 2000));
          await link.command("record", { value: false });
          window.recorded = name.recording;
        }"""
    )
    page.get_by_role("tab", name="Recordings").click()
    page.get_by_text("What if…").first.click()
    page.wait_for_selector(".what-if-helpers select")
    yield page
    context.close()
    assert errors == []


def fly_again(page: Any, *variations: str) -> None:
    for number, text in enumerate(variations):
        if number:
            page.get_by_role("button", name="One more").click()
        page.locator(".what-if-rows input").nth(number).fill(text)
    page.locator("#fly-again").click()
    page.wait_for_selector(".what-if-results table", timeout=SLOW)


def test_unchanged_it_is_the_same_and_changed_it_is_not(page: Any) -> None:
    fly_again(page, "", "Cn_r*=0; law=roll_rate_damper")
    rows = page.locator(".what-if-results tbody tr")
    said = [[cell.inner_text() for cell in row.locator("th, td").all()] for row in rows.all()]
    assert said[-1][1] == "same in every bit"
    assert {row[1] for row in said[:-1]} == {"0"}
    assert "0" not in {row[2] for row in said[:-1]}
    assert page.locator("#what-if .problem").count() == 0
    assert Axe().run(page).response["violations"] == []
    page.get_by_role("button", name="Overlay in charts").click()
    page.wait_for_selector("#overlay[open] .overlay-readings tbody tr:nth-child(3)")


def test_a_variant_flies_beside_the_replay_as_a_ghost(page: Any) -> None:
    fly_again(page, "Cn_beta*=0.3")
    page.get_by_role("button", name="Ghost").click()
    page.wait_for_function("() => window.fdes.link.latest.get('status').replay !== null")
    page.wait_for_function("() => window.fdes.cockpit.beside && window.fdes.cockpit.view === 'chase'")
    page.wait_for_function(
        """() => {
          const { cockpit, link } = window.fdes;
          return link.t > 1 && Math.abs(cockpit.beside.psi - cockpit.drawn.psi) > 1e-3;
        }"""
    )
    page.evaluate("() => window.fdes.link.command('freeze', { value: true })")
    page.get_by_role("button", name="Tower").click()  # from behind, the picture comes to rest slowly
    page.wait_for_timeout(500)
    assert page.evaluate(PIXELS_OF_THE_GHOST) > 200
    page.get_by_role("button", name="End replay").click()
    page.wait_for_function("() => window.fdes.cockpit.beside === null")


# How many pixels of a standing picture change when the ghost is taken away and nothing else is.
PIXELS_OF_THE_GHOST = """async () => {
  const { cockpit } = window.fdes;
  const canvas = document.querySelector("#hud");
  const picture = async () => {
    for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
    return canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  };
  const differing = (one, other) => one.reduce((count, value, i) => count + (value !== other[i]), 0);
  const [before, again] = [await picture(), await picture()];
  const ghost = cockpit.beside;
  cockpit.beside = null;
  const without = await picture();
  cockpit.beside = ghost;
  return differing(before, again) ? -1 : differing(before, without);
}"""


def test_what_cannot_be_flown_is_said(page: Any) -> None:
    page.locator(".what-if-rows input").fill("law=./mine.py")
    page.locator("#fly-again").click()
    page.wait_for_selector(".what-if-state.problem", timeout=SLOW)
    assert "There is no law named './mine.py'." in page.locator(".what-if-state").inner_text()
    refused = page.evaluate(
        """() => window.fdes.link.command("what_if", { recording: "../recordings", variations: [""] })
          .then(() => "flown", (error) => error.message)"""
    )
    assert refused == "There is no recording named '../recordings'."
