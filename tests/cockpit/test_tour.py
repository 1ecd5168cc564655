"""The first-flight tour: flown to its end by its own keys, skipped, left, remembered, taken again."""

import urllib.request
from collections.abc import Iterator
from typing import Any

import pytest

SIZES = [{"width": 1280, "height": 720}, {"width": 1920, "height": 1080}]
READY = "() => window.fdes && window.fdes.stats.frames > 5"
CARD = ".tour"
STEPS = 7
FORBID_STORAGE = """
Object.defineProperty(window, "localStorage", { get() { throw new DOMException("forbidden", "SecurityError"); } });
"""
KEYS = {"→": "ArrowRight", "←": "ArrowLeft", "↓": "ArrowDown", "X": "KeyX", "F": "KeyF", "R": "KeyR", "L": "KeyL"}


@pytest.fixture
def visit(browser: Any, cockpit: str) -> Iterator[Any]:
    """Opens the Fly page as on a first visit: `visit(query, script, **context)`. Errors in the page fail it."""
    contexts: list[Any] = []
    errors: list[str] = []

    def opened(query: str = "", script: str = "", **options: Any) -> Any:
        context = browser.new_context(tour=True, **{"viewport": SIZES[0], **options})
        contexts.append(context)
        if script:
            context.add_init_script(script)
        page = context.new_page()
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.goto(f"{cockpit}/?world=canvas2d&session=tour{query}")
        page.wait_for_function(READY)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert errors == []


def drawn(page: Any, name: str) -> float:
    """One value last drawn, SI and radians."""
    return float(page.evaluate(f"() => window.fdes.drawn.{name}"))


def wait_for_step(page: Any, number: int) -> None:
    page.locator(CARD).get_by_text(f"step {number} of {STEPS}").wait_for(state="attached", timeout=20_000)


def keys_of(page: Any) -> list[str]:
    """The keys that the step shown names, in their order."""
    return [KEYS[name] for name in page.locator(".tour-does kbd").all_text_contents()]


def hold(page: Any, key: str, milliseconds: float = 300) -> None:
    page.keyboard.down(key)
    page.wait_for_timeout(milliseconds)
    page.keyboard.up(key)


def hold_until(page: Any, key: str, condition: str) -> None:
    page.keyboard.down(key)
    page.wait_for_function(f"() => {{ const s = window.fdes.drawn; return {condition}; }}")
    page.keyboard.up(key)


def level_the_wings(page: Any, left: str, right: str) -> None:
    """As a student does it: taps of the one key or the other until the step is done."""
    for _ in range(30):
        if page.locator(f"{CARD}.is-done").count():
            return
        coming = drawn(page, "phi") + 0.6 * drawn(page, "p")
        if abs(coming) > 0.06:
            hold(page, left if coming > 0 else right, min(500.0, 700 * abs(coming)))
        page.wait_for_timeout(400)


def press_in_turn(page: Any, *keys: str) -> None:
    for key in keys:
        page.wait_for_timeout(300)
        page.keyboard.press(key)


def fly_step(page: Any, number: int) -> None:
    """Does step `number` with the keys that its sentence names."""
    wait_for_step(page, number)
    keys = keys_of(page)
    match number:
        case 1:
            hold_until(page, keys[0], "s.phi > 0.28")
        case 2:
            before = drawn(page, "psi")
            page.wait_for_timeout(800)
            assert drawn(page, "psi") > before
            level_the_wings(page, *keys)
        case 3:
            hold_until(page, keys[0], "s.stick_pitch > 0.2")
        case 4:
            press_in_turn(page, *keys)
        case 5:
            page.locator("#tab-stability").click()
            entry = page.locator("#knob-Cm_q")
            entry.fill("0")
            entry.press("Enter")
            page.wait_for_function("() => window.fdes.link.latest.get('stability').changes.length > 0")
            hold_until(page, keys[0], "s.stick_pitch > 0.2")
        case 6:
            press_in_turn(page, keys[0])
            page.wait_for_timeout(500)
            hold_until(page, keys[1], "s.stick_yaw > 0.3")
        case _:
            press_in_turn(page, keys[0])
            page.wait_for_function("() => window.fdes.link.latest.get('control').achieved.length > 0")
            hold_until(page, keys[1], "s.stick_yaw > 0.3")


def test_the_whole_tour_is_flown_by_the_keys_that_it_names(visit: Any) -> None:
    page = visit()
    for number in range(1, STEPS + 1):
        fly_step(page, number)
        page.locator(f"{CARD}.is-done").wait_for(timeout=10_000)
        if number in (5, STEPS):
            assert "its ζ was" in page.locator(".tour-notice").inner_text()
    page.get_by_text("That was the tour").wait_for(timeout=10_000)
    assert page.evaluate("() => document.activeElement === document.body")
    page.get_by_role("button", name="Close").click()
    assert page.locator(CARD).count() == 0
    page.reload()
    page.wait_for_function(READY)
    page.wait_for_timeout(1500)
    assert page.locator(CARD).count() == 0


def test_no_step_is_done_by_waiting_or_by_another_stick(visit: Any) -> None:
    page = visit()
    wait_for_step(page, 1)
    hold(page, "ArrowLeft", 600)
    hold(page, "ArrowDown", 300)
    page.wait_for_timeout(1500)
    assert page.locator(f"{CARD}.is-done").count() == 0
    wait_for_step(page, 1)


def test_every_step_can_be_skipped_and_the_keys_stay_with_the_stick(visit: Any) -> None:
    page = visit()
    for number in range(1, STEPS + 1):
        wait_for_step(page, number)
        page.get_by_role("button", name="Skip step").click()
    page.get_by_text("That was the tour").wait_for()
    hold(page, "ArrowRight", 400)
    assert drawn(page, "stick_roll") > 0.1


def test_the_tour_that_was_ended_is_over_after_a_reload_and_comes_back_from_help(visit: Any) -> None:
    page = visit()
    wait_for_step(page, 1)
    page.get_by_role("button", name="End tour").click()
    assert page.locator(CARD).count() == 0
    page.reload()
    page.wait_for_function(READY)
    page.wait_for_timeout(1500)
    assert page.locator(CARD).count() == 0
    page.keyboard.press("?")
    page.get_by_role("button", name="Take the first-flight tour").click()
    wait_for_step(page, 1)
    fly_step(page, 1)
    wait_for_step(page, 2)


def test_forbidden_storage_breaks_nothing(visit: Any) -> None:
    page = visit(script=FORBID_STORAGE)
    wait_for_step(page, 1)
    page.get_by_role("button", name="End tour").click()
    assert page.locator(CARD).count() == 0
    hold(page, "ArrowRight", 400)
    assert drawn(page, "stick_roll") > 0.1


def test_a_kiosk_an_observer_and_a_replay_have_no_tour(visit: Any) -> None:
    page = visit("&tour=off")
    observer = visit()
    assert observer.get_by_text("Only watching.").is_visible()
    page.wait_for_timeout(1500)
    assert page.locator(CARD).count() == observer.locator(CARD).count() == 0
    observer.evaluate("() => document.dispatchEvent(new Event('take-tour'))")
    observer.get_by_text("The tour is flown").wait_for()
    assert observer.locator(CARD).count() == 0


def test_who_flies_on_has_left_the_tour(visit: Any) -> None:
    page = visit()
    wait_for_step(page, 1)
    for _ in range(9):  # the step asks for a bank to the right
        hold(page, "ArrowDown", 1000)
        hold(page, "ArrowUp", 1000)
    page.get_by_text("The tour is over: you fly by yourself").wait_for()
    assert page.locator(CARD).count() == 0
    assert page.evaluate("() => localStorage.getItem('fdes.tour')") == "done"


def test_another_aircraft_ends_the_tour(visit: Any) -> None:
    page = visit()
    wait_for_step(page, 1)
    page.evaluate("() => window.fdes.link.command('aircraft', { aircraft: 'NAVION' })")
    page.get_by_text("The tour is over").wait_for()


@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size['width']}")
def test_the_card_hides_neither_stick_indicator_nor_the_bank_scale(visit: Any, size: Any) -> None:
    page = visit(viewport=size)
    for number in range(1, STEPS + 1):
        wait_for_step(page, number)
        card = page.locator(CARD).bounding_box()
        stick = page.locator("#stick").bounding_box()
        view = page.locator(".view").bounding_box()
        assert card["x"] >= stick["x"] + stick["width"]
        assert card["x"] + card["width"] <= view["x"] + view["width"]
        assert card["y"] + card["height"] <= view["y"] + view["height"]
        assert card["y"] >= view["y"] + bank_scale_ends(view)
        page.get_by_role("button", name="Skip step").click()


def bank_scale_ends(view: dict[str, float]) -> float:
    """How far under the top of the view the bank scale ends, px: as camera.js, hud.js and hud_scales.js place it."""
    width, height = view["width"], view["height"]
    k = min(1.4, max(0.72, height / 620))
    return 0.44 * height + min(0.225 * width, 0.4 * height) + 12 * k


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_no_accessibility_violations_with_the_tour(visit: Any, theme: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    page = visit(f"&theme={theme}", bypass_csp=True)
    for number in range(1, STEPS + 1):
        wait_for_step(page, number)
        found = Axe().run(page).response["violations"]
        assert [(v["id"], [n["target"] for n in v["nodes"]]) for v in found] == []
        page.get_by_role("button", name="Skip step").click()


def test_a_first_visit_with_its_tour_weighs_less_than_100_kB(browser: Any, cockpit: str) -> None:
    context = browser.new_context(tour=True)
    page = context.new_page()
    asked: set[str] = set()
    page.on("request", lambda request: asked.add(request.url))
    page.goto(f"{cockpit}/?world=canvas2d")
    page.locator(CARD).wait_for()
    page.wait_for_timeout(300)
    context.close()
    files = {url for url in asked if url.startswith(cockpit) and "/api/" not in url}
    assert any(url.endswith("tour_steps.js") for url in files)
    weight = 0
    for url in files:
        with urllib.request.urlopen(urllib.request.Request(url, headers={"Accept-Encoding": "gzip"})) as answer:
            weight += len(answer.read())
    assert weight < 100_000
