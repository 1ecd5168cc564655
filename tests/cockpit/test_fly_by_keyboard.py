"""A student at the keyboard: the aircraft goes where the stick says, the page shows it, and the flight is kept."""

import csv
import io
import math
import signal
import time
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from fdes.flight import list_recordings, open_recording
from fdes.units import DEG

SIZE = {"width": 1280, "height": 720}
READY = "() => window.fdes && window.fdes.stats.frames > 5"


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page, drawn, with the 2-D world: a test browser has no GPU. Any error in the page fails the test."""
    context = browser.new_context(viewport=SIZE)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=test")
    page.wait_for_function(READY)
    yield page
    context.close()
    assert errors == []


def drawn(page: Any) -> dict[str, Any]:
    """The values last drawn, SI and radians."""
    return dict(page.evaluate("() => structuredClone(window.fdes.drawn)"))


def hold(page: Any, key: str, seconds: float) -> None:
    page.keyboard.down(key)
    page.wait_for_timeout(1000.0 * seconds)
    page.keyboard.up(key)


def test_right_stick_banks_right_and_the_heading_then_increases(page: Any) -> None:
    hold(page, "ArrowRight", 0.5)
    page.wait_for_timeout(300)
    banked = drawn(page)
    assert banked["phi"] > 3 * DEG
    page.wait_for_timeout(2500)
    turned = drawn(page)
    assert turned["psi"] > banked["psi"] > -1 * DEG
    assert turned["east"] > 0.0


def test_left_stick_banks_left(page: Any) -> None:
    hold(page, "KeyA", 0.5)
    page.wait_for_timeout(300)
    assert drawn(page)["phi"] < -3 * DEG


def test_aft_stick_pitches_up_and_forward_down(page: Any) -> None:
    level = drawn(page)["theta"]
    hold(page, "ArrowDown", 0.6)
    assert drawn(page)["theta"] > level + 2 * DEG
    assert drawn(page)["n_z"] > 1.1
    page.keyboard.press("r")
    page.wait_for_timeout(600)
    hold(page, "ArrowUp", 0.6)
    assert drawn(page)["theta"] < level - 2 * DEG


def test_right_pedal_yaws_right_and_throttle_speeds_up(page: Any) -> None:
    hold(page, "KeyX", 0.5)
    assert drawn(page)["r"] > 0.0
    page.keyboard.press("r")
    page.wait_for_timeout(500)
    slow = drawn(page)["V"]
    hold(page, "PageUp", 2.5)
    page.wait_for_timeout(1500)
    assert drawn(page)["V"] > slow + 0.5


def test_the_stick_centers_itself(page: Any) -> None:
    hold(page, "ArrowRight", 0.6)
    assert drawn(page)["stick_roll"] > 0.5
    page.wait_for_timeout(900)
    assert drawn(page)["stick_roll"] == pytest.approx(0.0, abs=0.01)


def test_hud_and_world_agree_on_the_horizon(page: Any) -> None:
    hold(page, "ArrowRight", 0.4)
    hold(page, "ArrowDown", 0.3)
    page.keyboard.press("f")
    page.wait_for_timeout(300)
    seen = drawn(page)
    assert abs(seen["phi"]) > 3 * DEG
    hud, world = seen["hudHorizon"], seen["worldHorizon"]
    assert hud["y"] == pytest.approx(world["y"], abs=1.0)
    assert hud["tilt"] == pytest.approx(world["tilt"], abs=0.1 * DEG)


def test_freeze_stops_time_and_step_advances_one_frame(page: Any) -> None:
    page.keyboard.press("f")
    page.wait_for_timeout(300)
    t = page.evaluate("() => window.fdes.link.t")
    page.wait_for_timeout(500)
    assert page.evaluate("() => window.fdes.link.t") == t
    page.keyboard.press(".")
    page.wait_for_timeout(300)
    assert page.evaluate("() => window.fdes.link.t") == pytest.approx(t + 1 / 120, abs=1e-6)
    page.keyboard.press("f")
    page.wait_for_timeout(500)
    assert page.evaluate("() => window.fdes.link.t") > t + 0.2


def test_reset_returns_to_undisturbed_flight(page: Any) -> None:
    start = drawn(page)
    hold(page, "ArrowRight", 0.5)
    page.keyboard.press("r")
    page.wait_for_timeout(700)
    back = drawn(page)
    for name in ("phi", "theta", "psi", "alpha"):
        assert back[name] == pytest.approx(start[name], abs=0.2 * DEG)


def test_the_flight_is_on_disk_after_a_kill_but_for_its_last_second(
    browser: Any, serve: Callable[..., Any], tmp_path: Path
) -> None:
    served = serve(data=tmp_path / "kept")
    page = browser.new_page()
    page.goto(f"{served.url}/?world=canvas2d&session=killed")
    page.wait_for_function(READY)
    hold(page, "ArrowRight", 0.3)
    page.wait_for_timeout(2500)
    flown = page.evaluate("() => window.fdes.link.t")
    served.process.send_signal(signal.SIGKILL)
    served.process.wait()
    page.close()
    (kept,) = list_recordings(tmp_path / "kept" / "recordings")
    recording = open_recording(kept.path)
    assert not recording.complete
    assert recording["t"][-1] > flown - 1.2
    assert recording["phi"].max() > 3 * DEG
    assert recording["stick_roll"].max() > 0.3


def test_a_recording_downloads_as_csv_and_replays(page: Any, cockpit: str) -> None:
    hold(page, "ArrowRight", 0.4)
    page.wait_for_timeout(1200)
    reached = drawn(page)["phi"]
    page.get_by_role("tab", name="Recordings").click()
    page.locator(".recordings li").first.get_by_text("being recorded").wait_for()
    page.keyboard.press("c")
    page.wait_for_selector(".recordings li:first-child:not(:has-text('being recorded'))")
    with page.expect_download() as download:
        page.get_by_role("link", name="CSV").first.click()
    rows = list(csv.DictReader(io.StringIO(Path(download.value.path()).read_text(encoding="utf-8"))))
    assert max(float(row["phi [rad]"]) for row in rows) >= reached - 1 * DEG
    assert float(rows[1]["t [s]"]) - float(rows[0]["t [s]"]) == pytest.approx(1 / 120)
    page.get_by_role("button", name="Replay").first.click()
    page.wait_for_function("() => (window.fdes.link.flags & 4) !== 0")
    page.wait_for_function(f"() => window.fdes.drawn.phi > {0.5 * reached}")
    page.get_by_role("button", name="End replay").click()
    page.wait_for_function("() => (window.fdes.link.flags & 4) === 0")


def test_inputs_disturbances_and_a_step_that_is_too_long(page: Any) -> None:
    page.get_by_role("tab", name="Inputs").click()
    page.get_by_role("button", name="Elevator doublet").click()
    page.wait_for_function("() => Math.abs(window.fdes.drawn.elevator) > 0.03")
    page.wait_for_function("() => window.fdes.drawn.t > 0.2 && window.fdes.drawn.elevator === 0")
    page.get_by_role("button", name="β + 5°").click()
    page.wait_for_function("() => window.fdes.drawn.beta > 0.05")
    page.get_by_role("tab", name="Equations").click()
    page.locator("#inputs-equations select").nth(2).select_option("euler")
    page.locator("#inputs-equations select").nth(3).select_option("0.1 s")
    page.get_by_role("button", name="Fly from trim with these").click()
    page.get_by_text("euler is stable up to 0.0580 s here (dutch roll). This step is beyond it").wait_for()
    page.get_by_role("tab", name="Ready-made").click()
    page.get_by_role("button", name="β + 5°").click()
    page.wait_for_function("() => Math.abs(window.fdes.drawn.p) > 1.0", timeout=60_000)


def test_another_aircraft_is_flown_from_the_picker(page: Any) -> None:
    speed = drawn(page)["V"]
    page.get_by_role("button", name="A-4D").first.click()
    page.get_by_role("dialog").get_by_text("NAVION").first.wait_for()
    page.evaluate("() => window.fdes.link.command('aircraft', { aircraft: 'NAVION' })")
    page.wait_for_function(f"() => window.fdes.drawn.V < {0.6 * speed}")
    assert drawn(page)["V"] == pytest.approx(176 * 0.3048, abs=1.0)


def test_the_page_asks_nobody_but_its_server_and_weighs_little(browser: Any, cockpit: str) -> None:
    page = browser.new_page()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(f"{cockpit}/?world=canvas2d")
    page.wait_for_function(READY)
    page.close()
    ours = [url for url in asked if url.startswith((cockpit, "data:", cockpit.replace("http", "ws"), "blob:"))]
    assert asked == ours
    weight = 0
    for url in {u for u in asked if u.startswith(cockpit) and "/api/" not in u}:
        request = urllib.request.Request(url, headers={"Accept-Encoding": "gzip"})
        with urllib.request.urlopen(request) as answer:
            weight += len(answer.read())
    assert weight < 100_000


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_no_accessibility_violations(browser: Any, cockpit: str, theme: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    page = browser.new_page(viewport=SIZE, bypass_csp=True)
    page.goto(f"{cockpit}/?world=canvas2d&theme={theme}")
    page.wait_for_function(READY)
    for tab in page.get_by_role("tab").all():
        tab.click()
        time.sleep(0.1)
        found = Axe().run(page).response["violations"]
        assert [(v["id"], [n["target"] for n in v["nodes"]]) for v in found] == []
    page.close()


def test_the_page_fits_usual_windows(page: Any) -> None:
    for width in (1024, 1200, 1280, 1366, 1440, 1536, 1600, 1680, 1920):
        page.set_viewport_size({"width": width, "height": 680})
        rows, wider, cut = page.evaluate(
            """() => {
              const tabs = [...document.querySelectorAll("#tabs [role=tab]")].map((tab) => tab.offsetTop);
              const over = ({ scrollWidth, clientWidth }) => scrollWidth - clientWidth;
              const condition = document.querySelector("#aircraft-condition");
              return [new Set(tabs).size, over(document.body), over(condition)];
            }"""
        )
        assert (width, rows, wider, cut) == (width, 1, 0, 0)


def test_values_on_the_page_are_finite(page: Any) -> None:
    numbers = [v for v in drawn(page).values() if isinstance(v, (int, float))]
    assert len(numbers) > 30
    assert all(math.isfinite(v) for v in numbers)
