"""Two recordings laid over one another: marked, drawn, read at a time, and taken away as CSV."""

import csv
from pathlib import Path
from typing import Any

import pytest

from fdes.units import DEG

SIZE = {"width": 1280, "height": 720}


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with two recordings: a bank to the right, then one to the left."""
    context = browser.new_context(viewport=SIZE, bypass_csp=True)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{cockpit}/?world=canvas2d&session=overlay")
    page.wait_for_function("() => window.fdes && window.fdes.stats.frames > 5")
    page.keyboard.press("c")
    for key in ("ArrowRight", "ArrowLeft"):
        page.wait_for_function("() => window.fdes.link.has(2)")  # it is recording
        page.keyboard.down(key)
        page.wait_for_timeout(500)
        page.keyboard.up(key)
        page.wait_for_timeout(600)
        page.keyboard.press("c")
        page.wait_for_function("() => !window.fdes.link.has(2)")
        page.keyboard.press("r")
        page.wait_for_timeout(400)
        if key == "ArrowRight":
            page.keyboard.press("c")
    page.click("#tab-recordings")
    page.wait_for_selector(".recordings li >> nth=1")
    yield page
    context.close()
    assert errors == []


def reading(page: Any) -> list[list[float]]:
    """The figures of the table, one row for each flight."""
    rows = page.locator(".overlay-readings tbody tr").all()
    return [[float(cell.replace("\u2212", "-")) for cell in row.locator("td").all_inner_texts()] for row in rows]


def mark_and_open(page: Any) -> None:
    boxes = page.locator(".recordings input[type=checkbox]")
    boxes.nth(1).check()  # the older one: the bank to the right
    boxes.nth(0).check()
    page.click("text=Overlay the marked")
    page.wait_for_selector(".overlay-readings tbody tr >> nth=1")


def test_nothing_marked_cannot_be_overlaid(page: Any) -> None:
    assert page.is_disabled("text=Overlay the marked")


def test_two_flights_are_read_at_a_time_and_subtracted(page: Any, tmp_path: Path) -> None:
    mark_and_open(page)
    page.get_by_label("Signal 2", exact=True).select_option("phi")
    page.focus("#overlay canvas")
    page.wait_for_function("() => document.querySelector('.overlay-readings thead').textContent.includes('φ, deg')")
    for _ in range(100):
        page.keyboard.press("ArrowRight")
    at = float(page.locator(".overlay-readings thead th").first.inner_text().split()[1])
    (_, right), (_, left) = reading(page)
    assert right > 1.0 > -1.0 > left  # flown by hand in real time: how far it banked is not the same each time
    with page.expect_download() as taken:
        page.click("#overlay >> text=Download CSV")
    taken.value.save_as(tmp_path / "overlay.csv")
    with (tmp_path / "overlay.csv").open(newline="") as file:
        head, *rows = csv.reader(file)
    theta, phi = ["t [s", "theta [deg"], ["t [s", "phi [deg"]
    assert [title.split("]")[0] for title in head] == [*theta, *theta, *phi, *phi]
    nearest = min((row for row in rows if row[4]), key=lambda row: abs(float(row[4]) - at))
    assert float(nearest[5]) == pytest.approx(right, abs=1.0)
    page.get_by_label("Difference from the first flight").check()
    (_, none), (_, apart) = reading(page)
    assert none == 0.0
    assert apart == pytest.approx(left - right, abs=0.05)


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_dialog_is_accessible_and_drawn_in_the_colors_of_the_theme(page: Any, theme: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    mark_and_open(page)
    page.evaluate(f"() => fdes.theme.set('{theme}')")
    page.wait_for_timeout(300)
    assert Axe().run(page).response["violations"] == []
    corner = "() => [...document.querySelector('#overlay canvas').getContext('2d').getImageData(2, 2, 1, 1).data]"
    red, green, blue, _ = page.evaluate(corner)
    assert (red + green + blue > 600) is (theme == "light")


def test_a_fifth_recording_is_refused_with_the_reason(page: Any) -> None:
    page.evaluate(
        """async () => {
          const list = await (await fetch("/api/recordings")).json();
          const answer = fetch;
          const more = JSON.stringify([0, 1, 2, 3, 4].map((n) => ({ ...list[0], name: `${list[0].name}-${n}` })));
          window.fetch = (url) => (url === "/api/recordings" ? Promise.resolve(new Response(more)) : answer(url));
        }"""
    )
    page.click("#tab-modes")
    page.click("#tab-recordings")
    page.wait_for_selector(".recordings li >> nth=4")
    boxes = page.locator(".recordings input[type=checkbox]")
    for n in range(4):
        boxes.nth(n).check()
    boxes.nth(4).click()
    assert not boxes.nth(4).is_checked()
    page.get_by_text("4 are marked, and no more can be told apart. Unmark one first.").wait_for()
    boxes.nth(0).uncheck()
    boxes.nth(4).check()


def test_the_server_gives_the_numbers_of_the_recording(page: Any) -> None:
    name = page.evaluate("async () => (await (await fetch('/api/recordings')).json())[0].name")
    given = page.evaluate(f"async () => (await fetch('/api/recordings/{name}.json?columns=phi,q')).json()")
    assert set(given["values"]) == {"phi", "q"}
    assert len(given["t"]) == len(given["values"]["phi"]) > 30
    assert min(given["values"]["phi"]) < -3 * DEG
    assert {"name": "phi", "unit": "rad"}.items() <= next(c for c in given["columns"] if c["name"] == "phi").items()
