"""Variable stability as a student uses it: a derivative is edited in flight; poles, Levels and the response follow."""

from typing import Any

import pytest

SIZE = {"width": 1280, "height": 720}
READY = "() => window.fdes && window.fdes.stats.frames > 5"


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with the tab open. Any error in the page fails the test."""
    context = browser.new_context(viewport=SIZE)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=stability")
    page.wait_for_function(READY)
    page.get_by_role("tab", name="Variable stability").click()
    page.wait_for_selector(".knob")
    yield page
    context.close()
    assert errors == []


def told(page: Any, kind: str) -> dict[str, Any]:
    """The newest message of that kind."""
    return dict(page.evaluate("kind => window.fdes.link.latest.get(kind)", kind))


def enter(page: Any, name: str, text: str) -> None:
    """Type a value into the entry of a number, and wait for the aircraft that has it."""
    before = told(page, "stability")["changes"]
    entry = page.locator(f"#knob-{name}")
    entry.fill(text)
    entry.press("Enter")
    page.wait_for_function(
        "before => JSON.stringify(window.fdes.link.latest.get('stability').changes) !== before",
        arg=page.evaluate("changes => JSON.stringify(changes)", before),
    )


def mode(page: Any, name: str) -> dict[str, Any] | None:
    return next((m for m in told(page, "modes")["modes"] if m["name"] == name), None)


def level(page: Any, name: str) -> int:
    """The Level on the badge of a mode."""
    return int(page.locator(f'.level[data-mode="{name}"]').first.get_attribute("data-level"))


def pull(page: Any) -> float:
    """The highest pitch rate [rad/s] in answer to an elevator pulse, from trim."""
    page.evaluate(
        """async () => {
          const { link } = window.fdes;
          await link.command("reset");
          await new Promise((done) => setTimeout(done, 300));
          await link.command("input", { text: "pulse elevator -2deg for 0.6s" });
        }"""
    )
    return float(
        page.evaluate(
            """() => new Promise((done) => {
              let most = -1e9;
              const until = window.fdes.link.t + 2.5;
              const look = ({ values, index, t }) => {
                most = Math.max(most, values[index.q]);
                if (t > until) done(most);
              };
              window.fdes.link.on("frame", look);
            })"""
        )
    )


def test_less_pitch_damping_goes_through_the_levels_and_undo_brings_all_back(page: Any) -> None:
    printed = told(page, "modes")["modes"]
    assert mode(page, "short_period")["zeta"] == pytest.approx(0.357, abs=0.002)  # type: ignore[index]
    assert level(page, "short_period") == 1
    quick = pull(page)

    enter(page, "Cm_q", "-1.8")
    assert mode(page, "short_period")["zeta"] == pytest.approx(0.28, abs=0.005)  # type: ignore[index]
    assert level(page, "short_period") == 2
    enter(page, "Cm_q", "0")
    assert mode(page, "short_period")["zeta"] == pytest.approx(0.195, abs=0.005)  # type: ignore[index]
    assert level(page, "short_period") == 3
    slack = pull(page)
    assert slack > 1.05 * quick

    page.keyboard.press("Control+z")
    page.wait_for_function("() => window.fdes.link.latest.get('stability').changes[0] === 'Cm_q=-1.8'")
    page.keyboard.press("Control+z")
    page.wait_for_function("() => window.fdes.link.latest.get('stability').changes.length === 0")
    assert told(page, "modes")["modes"] == printed
    assert pull(page) == pytest.approx(quick, rel=1e-3)  # a screen sees every second frame

    page.get_by_role("tab", name="Modes").click()
    dots = page.locator("#s-plane .s-trail.s-longitudinal").first.get_attribute("d")
    assert dots.count("M") > 4  # the poles have left a trail
