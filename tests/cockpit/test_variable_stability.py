"""Variable stability as a student uses it: a derivative is edited in flight; poles, Levels and the response follow."""

from pathlib import Path
from typing import Any

import pytest
from axe_playwright_python.sync_playwright import Axe

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


COPY_MATRIX = """() => {
  getSelection().selectAllChildren(document.querySelector(".matrix"));
  const copy = new ClipboardEvent("copy", { clipboardData: new DataTransfer(), bubbles: true, cancelable: true });
  document.querySelector(".matrix").dispatchEvent(copy);
  return copy.clipboardData.getData("text/plain");
}"""


def level(page: Any, name: str) -> int:
    """The Level on the badge of a mode."""
    return int(page.locator(f'.level[data-mode="{name}"]').first.get_attribute("data-level"))


def pull(page: Any) -> float:
    """The highest pitch rate [rad/s] in answer to an elevator pulse, from trim; watched from before it begins."""
    return float(
        page.evaluate(
            """async () => {
              const { link } = window.fdes;
              await link.command("reset");
              await new Promise((done) => setTimeout(done, 300));
              let most = -1e9;
              const until = link.t + 3.5;
              const over = new Promise((done) =>
                link.on("frame", ({ values, index, t }) => {
                  if (t > until) done();
                  else most = Math.max(most, values[index.q]);
                }),
              );
              await link.command("input", { text: "pulse elevator -2deg for 0.6s" });
              await over;
              return most;
            }"""
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


def test_without_pitch_stiffness_the_mode_gets_another_name_and_its_level_falls(page: Any) -> None:
    levels = []
    for Cm_alpha in ("-0.38", "-0.1", "-0.03", "0"):
        if Cm_alpha != "-0.38":
            enter(page, "Cm_alpha", Cm_alpha)
        levels.append(told(page, "qualities")["charts"][1]["point"])
    caps = [point[1] for point in levels[:3]]
    assert caps == sorted(caps, reverse=True)
    names = {m["name"] for m in told(page, "modes")["modes"] if m["axis"] == "longitudinal"}
    assert "short_period" not in names
    assert level(page, "short_period") == 4


def test_a_slider_that_is_dragged_is_one_step_of_undo(page: Any) -> None:
    slider = page.locator('[data-knob="Cm_q"] input[type="range"]')
    slider.scroll_into_view_if_needed()
    box = slider.bounding_box()
    middle = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] / 2, middle)
    page.mouse.down()
    for k in range(12):
        page.mouse.move(box["x"] + box["width"] * (0.5 + 0.02 * k), middle)
        page.wait_for_timeout(70)
    page.mouse.up()
    page.wait_for_timeout(500)
    stability = told(page, "stability")
    assert len(stability["changes"]) == 1
    assert stability["undo"] == 1
    page.keyboard.down("ArrowDown")
    page.wait_for_function("() => window.fdes.drawn.stick_pitch > 0.05")  # the keys fly again, and move no slider
    page.keyboard.up("ArrowDown")
    assert told(page, "stability")["changes"] == stability["changes"]
    page.get_by_role("button", name="Undo").click()
    page.wait_for_function("() => window.fdes.link.latest.get('stability').changes.length === 0")
    assert page.locator(".knob.is-changed").count() == 0


# What is drawn of each frame, by its first letter. A command is sent before the second frame and answered before the
# fourth, where there is time between frames and where there is none; and one whose answer takes long.
RIGHT_OF_WAY = """async () => {
  const { RightOfWay } = await import("/page/right_of_way.js");
  const drawn = async (gap, count, answered) => {
    const link = { waiting: new Map(), commandId: 0 };
    const way = new RightOfWay(link);
    let shares = "";
    for (let k = 0; k < count; k++) {
      if (k === 1) link.waiting.set(++link.commandId, {});
      if (k === answered) link.waiting.clear();
      shares += way.next(performance.now())[0];
      if (gap) await new Promise((done) => setTimeout(done, gap));
    }
    return shares;
  };
  return [await drawn(30, 6, 3), await drawn(0, 6, 3), await drawn(30, 16, Infinity)];
}"""


def test_answers_have_the_right_of_way_but_the_picture_never_stands_still(page: Any) -> None:
    roomy, crowded, slow = page.evaluate(RIGHT_OF_WAY)
    assert roomy == "ewwwee"  # everything; the view alone until the answer is shown; everything
    assert crowded == "ennnee"  # or nothing
    assert "wwww" not in slow
    assert slow.endswith("eeee")  # an answer that takes long is not waited for


def test_what_cannot_be_is_said_and_changes_nothing(page: Any) -> None:
    page.get_by_role("tab", name="Mass, speed").click()
    entry = page.locator("#knob-m")
    entry.fill("-5")
    entry.press("Enter")
    page.wait_for_function(
        "() => document.querySelector('#panel-stability > .problem').textContent.includes('greater')"
    )
    assert told(page, "stability")["changes"] == []


def test_the_value_of_the_file_typed_again_is_no_change(page: Any) -> None:
    as_in_file = page.locator("#knob-Cm_q").input_value()
    enter(page, "Cm_q", "-1.8")
    entry = page.locator("#knob-Cm_q")
    entry.fill(as_in_file)
    entry.press("Enter")
    page.wait_for_function("() => window.fdes.link.latest.get('stability').changes.length === 0")


def test_a_link_that_holds_nothing_says_so_and_flies_all_the_same(page: Any, cockpit: str) -> None:
    other = page.context.new_page()
    other.goto(f"{cockpit}/?world=canvas2d&session=broken#experiment=%25%25")
    other.get_by_text("The link holds no experiment that can be read").wait_for()
    other.wait_for_function("() => window.fdes.stats.frames > 5")


def test_the_saved_file_and_the_link_fly_the_same(page: Any, cockpit: str, tmp_path: Path) -> None:
    enter(page, "Cm_q", "-1.8")
    page.get_by_role("tab", name="Mass, speed").click()
    enter(page, "cg", "0.27")
    edited = told(page, "modes")["modes"]
    page.get_by_role("button", name="Files…").click()
    with page.expect_download() as kept:
        page.get_by_role("button", name="Aircraft as flown").click()
    path = tmp_path / kept.value.suggested_filename
    kept.value.save_as(path)
    page.wait_for_function("() => document.querySelector('#experiment-link').value.includes('#experiment=')")
    link = page.locator("#experiment-link").input_value()

    page.get_by_label("Open an aircraft").set_input_files(path)
    page.wait_for_function("() => window.fdes.link.latest.get('aircraft').id === 'A-4D-changed'")
    page.wait_for_function("() => window.fdes.link.latest.get('stability').changes.length === 0")
    assert told(page, "modes")["modes"] == edited

    other = page.context.new_page()
    other.goto(link.replace("/#", "/?world=canvas2d&session=shared#"))
    other.wait_for_function("() => window.fdes?.link.latest.get('stability')?.changes.length === 2")
    assert told(other, "modes")["modes"] == edited
    assert "#experiment" not in other.url


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_tab_and_the_verdict_are_accessible(page: Any, theme: str) -> None:
    page.evaluate(
        "theme => { if (document.documentElement.dataset.theme !== theme) window.fdes.theme.toggle(); }", theme
    )
    enter(page, "Cm_q", "0")
    assert Axe().run(page).response["violations"] == []
    page.get_by_role("tab", name="Calculated").click()
    page.wait_for_selector(".matrix")
    assert Axe().run(page).response["violations"] == []
    copied = page.evaluate(COPY_MATRIX)
    assert "\u2212" in page.locator(".matrix").first.inner_text()
    assert "\u2212" not in copied
    assert "-" in copied
    page.get_by_role("tab", name="Modes").click()
    page.locator('.level[data-mode="short_period"]').click()
    page.get_by_role("button", name="What to change").click()
    page.wait_for_selector(".advice li")
    assert "ζsp is " in page.locator(".quality-body").inner_text()
    assert "zeta" not in page.locator(".quality-card").inner_text()
    assert Axe().run(page).response["violations"] == []
