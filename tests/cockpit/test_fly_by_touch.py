"""A student with a tablet: fingers fly by the stick, throttle and rudder of the screen, and let go they center."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest

from fdes.units import DEG

TABLET = {"width": 1024, "height": 768}
READY = "() => window.fdes && window.fdes.stats.frames > 5"
LARGE_ENOUGH = 44  # px: a fingertip


class Tablet(NamedTuple):
    """A page on a touch screen, and the way to touch it."""

    page: Any
    devtools: Any

    def touch(self, kind: str, *points: tuple[float, float]) -> None:
        """touchStart, touchMove or touchEnd, with the fingers that are then on the glass."""
        fingers = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(points)]
        self.devtools.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})

    def middle(self, control: str) -> tuple[float, float]:
        box = self.page.locator(f".touch-{control}").bounding_box()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def value(self, name: str) -> float:
        return float(self.page.evaluate(f"() => window.fdes.drawn.{name}"))

    def wait_until(self, condition: str) -> None:
        self.page.wait_for_function(f"() => {{ const s = window.fdes.drawn; return {condition}; }}")


@pytest.fixture
def tablet(browser: Any, cockpit: str) -> Iterator[Tablet]:
    """The Fly page on a tablet that lies on its side. Any error in the page fails the test."""
    context = browser.new_context(viewport=TABLET, has_touch=True, is_mobile=True, bypass_csp=True)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=touch")
    page.wait_for_function(READY)
    page.locator(".touch-pad").wait_for()
    yield Tablet(page, context.new_cdp_session(page))
    context.close()
    assert errors == []


def test_a_finger_to_the_right_banks_right_heading_increases_and_release_centers(tablet: Tablet) -> None:
    x, y = tablet.middle("pad")
    tablet.touch("touchStart", (x, y))
    tablet.touch("touchMove", (x + 40, y))
    tablet.wait_until("s.stick_roll > 0.5 && s.phi > 0.1")
    assert tablet.value("stick_pitch") == pytest.approx(0.0, abs=0.05)
    tablet.touch("touchEnd")
    tablet.wait_until("s.stick_roll === 0")
    heading = tablet.value("psi")
    tablet.page.wait_for_timeout(1500)
    assert tablet.value("phi") > 3 * DEG
    assert tablet.value("psi") > heading


def test_a_finger_towards_the_pilot_pitches_up(tablet: Tablet) -> None:
    level = tablet.value("theta")
    x, y = tablet.middle("pad")
    tablet.touch("touchStart", (x, y + 30))
    tablet.wait_until(f"s.stick_pitch > 0.3 && s.theta > {level + 2 * DEG}")
    tablet.touch("touchEnd")
    tablet.wait_until("s.stick_pitch === 0")


def test_stick_and_throttle_move_together_and_the_lever_stays(tablet: Tablet) -> None:
    stick, lever = tablet.middle("pad"), tablet.middle("throttle")
    before = tablet.value("stick_throttle")
    tablet.touch("touchStart", stick, lever)
    tablet.page.wait_for_timeout(200)
    assert tablet.value("stick_throttle") == pytest.approx(before, abs=0.01)
    tablet.touch("touchMove", (stick[0] - 40, stick[1]), (lever[0], lever[1] - 20))
    tablet.wait_until(f"s.stick_roll < -0.5 && s.stick_throttle > {before + 0.2}")
    tablet.touch("touchEnd")
    tablet.wait_until("s.stick_roll === 0")
    assert tablet.value("stick_throttle") > before + 0.2


def test_the_rudder_yaws_right_and_centers(tablet: Tablet) -> None:
    x, y = tablet.middle("rudder")
    tablet.touch("touchStart", (x + 35, y))
    tablet.wait_until("s.stick_yaw > 0.5 && s.r > 0.02")
    tablet.touch("touchEnd")
    tablet.wait_until("s.stick_yaw === 0")


def test_the_chooser_takes_the_touch_stick_away_and_brings_it_back(tablet: Tablet) -> None:
    tablet.page.locator("#control").tap()
    assert tablet.page.get_by_role("menuitemradio", name="Touch").get_attribute("aria-checked") == "true"
    tablet.page.get_by_role("menuitemradio", name="Keyboard").tap()
    tablet.page.locator(".touch-pad").wait_for(state="hidden")
    tablet.page.reload()
    tablet.page.wait_for_function(READY)
    assert not tablet.page.locator(".touch-pad").is_visible()
    tablet.page.locator("#control").tap()
    tablet.page.get_by_role("menuitemradio", name="Touch").tap()
    tablet.page.locator(".touch-pad").wait_for()


def test_a_mouse_alone_shows_no_touch_stick(browser: Any, cockpit: str) -> None:
    page = browser.new_page()
    page.goto(f"{cockpit}/?world=canvas2d&session=mouse")
    page.wait_for_function(READY)
    assert page.locator(".touch-pad").count() == 0
    page.close()


def test_the_page_is_usable_on_a_tablet(tablet: Tablet) -> None:
    page = tablet.page
    assert page.evaluate("() => document.documentElement.scrollWidth") <= TABLET["width"]
    for words in ("Freeze", "Reset"):
        box = page.get_by_role("button", name=words, exact=True).bounding_box()
        assert min(box["width"], box["height"]) >= LARGE_ENOUGH
        assert box["x"] + box["width"] <= TABLET["width"]
    view = page.locator(".view").bounding_box()
    boxes = [page.locator(f".touch-{name}").bounding_box() for name in ("throttle", "rudder", "pad")]
    for box in boxes:
        assert box["x"] >= view["x"]
        assert box["x"] + box["width"] <= view["x"] + view["width"]
        assert box["y"] + box["height"] <= view["y"] + view["height"]
    assert page.locator(".touch-pad").evaluate("(e) => getComputedStyle(e).touchAction") == "none"
    assert page.locator(".view").evaluate("(e) => getComputedStyle(e).touchAction") == "auto"
    page.get_by_role("button", name="Freeze", exact=True).tap()
    page.wait_for_function("() => (window.fdes.link.flags & 1) !== 0")


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_no_accessibility_violations_with_the_touch_stick(tablet: Tablet, theme: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    tablet.page.evaluate(f"() => window.fdes.theme.set('{theme}')")
    found = Axe().run(tablet.page).response["violations"]
    assert [(v["id"], [n["target"] for n in v["nodes"]]) for v in found] == []
