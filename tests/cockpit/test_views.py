"""From outside: chase and tower draw the aircraft as it flies, surfaces and all; and the choice of instruments."""

from typing import Any

import pytest

SIZE = {"width": 1280, "height": 720}
READY = "() => window.fdes && window.fdes.stats.frames > 5"
STATE = "{ north, east, h, phi, theta, psi, elevator: 0, aileron: 0, rudder: 0 }"


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with the 2-D world. Any error in the page fails the test."""
    context = browser.new_context(viewport=SIZE, bypass_csp=True)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=views")
    page.wait_for_function(READY)
    yield page
    context.close()
    assert errors == []


def look(page: Any, view: str) -> None:
    page.get_by_role("button", name=view, exact=True).click()
    page.wait_for_function(f"() => fdes.cockpit.view === '{view.lower()}' && fdes.cockpit.outside.painter.cam")
    page.wait_for_timeout(200)


def landmarks(page: Any) -> dict[str, list[float]]:
    """Where parts of the aircraft stand on the screen [px], right and down."""
    return dict(page.evaluate("() => fdes.cockpit.outside.painter.landmarks()"))


def orange(page: Any) -> int:
    """How many pixels have the color of the control surfaces."""
    return int(
        page.evaluate(
            """() => {
              const canvas = document.getElementById("hud");
              const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
              let found = 0;
              for (let i = 0; i < data.length; i += 4)
                if (data[i] > 110 && data[i + 1] < 0.6 * data[i] && data[i + 2] < 0.3 * data[i]) found++;
              return found;
            }"""
        )
    )


def test_the_key_goes_around_the_views(page: Any) -> None:
    seen = []
    for wanted in ("chase", "tower", "cockpit"):
        page.keyboard.press("v")
        page.wait_for_function(f"() => fdes.cockpit.view === '{wanted}'")
        page.wait_for_timeout(300)
        seen.append(orange(page))
    chase, tower, cockpit = seen
    assert chase > 200
    assert tower > 20
    assert cockpit == 0


def test_a_second_press_while_the_first_view_is_fetched_counts(page: Any) -> None:
    page.keyboard.press("v")
    page.keyboard.press("v")
    page.wait_for_function("() => fdes.cockpit.view === 'tower'")
    page.wait_for_timeout(300)
    assert page.get_by_role("button", name="Tower", exact=True).get_attribute("aria-pressed") == "true"


def test_the_tower_keeps_the_aircraft_in_sight_and_zooms(page: Any) -> None:
    look(page, "Tower")
    at = landmarks(page)
    canvas = page.locator("#hud").bounding_box()
    assert abs(at["middle"][0] - canvas["width"] / 2) < 2
    assert abs(at["right tip"][0] - at["left tip"][0]) > 0.1 * canvas["width"]
    page.get_by_text("from the tower").wait_for()


def test_right_stick_lowers_the_right_wing_and_raises_the_right_aileron(page: Any) -> None:
    look(page, "Chase")
    level = landmarks(page)
    assert level["right tip"][0] > level["left tip"][0]  # seen from behind
    assert level["right tip"][1] == pytest.approx(level["left tip"][1], abs=1.0)
    page.keyboard.down("ArrowRight")
    page.wait_for_function("() => fdes.drawn.aileron > 0.07 && fdes.drawn.phi > 0.05")
    rolling = landmarks(page)
    page.keyboard.up("ArrowRight")
    assert rolling["right tip"][1] > rolling["left tip"][1] + 5.0  # down is positive on a screen
    assert rolling["right aileron"][1] < rolling["right aileron at rest"][1] - 2.0
    assert rolling["left aileron"][1] > rolling["left aileron at rest"][1] + 2.0


def test_pulling_raises_the_elevator_and_the_right_pedal_turns_the_rudder_right(page: Any) -> None:
    look(page, "Chase")
    page.keyboard.down("ArrowDown")
    page.wait_for_function("() => fdes.drawn.elevator < -0.03")
    pulled = landmarks(page)
    page.keyboard.up("ArrowDown")
    assert pulled["elevator"][1] < pulled["elevator at rest"][1] - 0.5
    page.keyboard.down("x")
    page.wait_for_function("() => fdes.drawn.rudder < -0.05")
    kicked = landmarks(page)
    page.keyboard.up("x")
    assert kicked["rudder"][0] > kicked["rudder at rest"][0] + 1.0


def test_a_ghost_flies_beside_the_aircraft(page: Any) -> None:
    page.keyboard.press("f")
    look(page, "Chase")
    alone = orange(page)
    beside = STATE.replace("east", "east: east + 12")
    page.evaluate(
        f"() => {{ const {{ north, east, h, phi, theta, psi }} = fdes.drawn; return fdes.cockpit.ghost({beside}); }}"
    )
    painted = """() => {
      const canvas = document.getElementById("hud");
      const middle = fdes.cockpit.outside.painter.landmarks()["right tip"];
      const { data } = canvas.getContext("2d").getImageData(middle[0] + 20, middle[1] - 60, 200, 120);
      return data.filter((value, i) => i % 4 === 3 && value > 90 && value < 200).length;
    }"""
    page.wait_for_timeout(300)
    assert page.evaluate(painted) > 300
    page.evaluate("() => fdes.cockpit.ghost(null)")
    page.wait_for_timeout(300)
    assert page.evaluate(painted) == 0
    assert orange(page) == pytest.approx(alone, rel=0.02)


def test_a_frozen_chart_goes_back_and_returns_with_the_flight(page: Any) -> None:
    page.keyboard.press("f")
    page.wait_for_function("() => fdes.link.has(1)")
    page.evaluate(
        """() => {
          const { chart } = fdes;
          const from = fdes.link.t;
          const row = chart.values.slice(0, chart.channels.length);
          chart.clear();
          for (let k = -1800; k <= 0; k++) chart.record(from + k / 60, row);
        }"""
    )
    past = page.get_by_label("Show an earlier part of the flight")
    past.wait_for()
    shown = """() => {
      const { chart } = fdes;
      return chart.times[chart.row(chart.since(chart.times[chart.row(-1)] - chart.past))];
    }"""
    latest = page.evaluate(shown)
    past.focus()
    page.keyboard.press("Home")
    page.wait_for_function("() => fdes.chart.past > 5")
    assert page.evaluate(shown) == pytest.approx(latest - page.evaluate("() => fdes.chart.past"), abs=0.05)
    page.keyboard.press("r")  # a slider takes the keys that move it, and no letter
    page.keyboard.press("f")
    past.wait_for(state="hidden")
    assert page.evaluate("() => fdes.chart.past") == 0


def test_a_heading_through_north_breaks_its_line(page: Any) -> None:
    """Turning right through 180 deg, the heading goes on at -180 deg: no line is drawn across the lane between them."""
    page.keyboard.press("f")
    page.wait_for_function("() => fdes.link.has(1)")
    lines = page.evaluate(
        """() => {
          const { chart } = fdes;
          const row = chart.values.slice(0, chart.channels.length);
          const [psi, theta] = [chart.index.psi, chart.index.theta];
          const from = fdes.link.t;
          chart.setLanes([["psi"], ["theta"]]);
          chart.clear();
          for (let k = -900; k <= 0; k++) {
            row[psi] = Math.atan2(Math.sin(0.3 * k / 60 + 5), Math.cos(0.3 * k / 60 + 5));
            row[theta] = k < -300 ? 0.7 : -0.7;
            chart.record(from + k / 60, row);
          }
          const drawn = [];
          const { prototype } = CanvasRenderingContext2D;
          const { moveTo, lineTo, beginPath } = prototype;
          let last = null;
          prototype.beginPath = function () { drawn.push({ longest: 0, parts: 0 }); beginPath.call(this); };
          prototype.moveTo = function (x, y) { drawn.at(-1).parts++; last = y; moveTo.call(this, x, y); };
          prototype.lineTo = function (x, y) {
            drawn.at(-1).longest = Math.max(drawn.at(-1).longest, Math.abs(y - last));
            last = y;
            lineTo.call(this, x, y);
          };
          const series = chart.drawSeries;
          const kept = [];
          chart.drawSeries = (...all) => { series.apply(chart, all); kept.push(drawn.at(-1)); };
          chart.draw({ series: ["red"] }, 1);
          Object.assign(prototype, { moveTo, lineTo, beginPath });
          delete chart.drawSeries;
          return kept;
        }"""
    )
    heading, pitch = lines
    assert heading["parts"] == 2
    assert heading["longest"] < 5.0
    assert pitch["parts"] == 1
    assert pitch["longest"] > 20.0


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_chosen_instruments_are_shown_and_remembered(browser: Any, cockpit: str, theme: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    context = browser.new_context(viewport=SIZE, bypass_csp=True)
    page = context.new_page()
    page.goto(f"{cockpit}/?world=canvas2d&theme={theme}")
    page.wait_for_function(READY)
    view = page.locator("#hud")
    small = view.bounding_box()["height"]
    page.keyboard.press("i")
    page.get_by_label("None").check()
    page.wait_for_function("() => fdes.panel.names.length === 0")
    assert view.bounding_box()["height"] > small + 100
    page.get_by_label("Airspeed, altimeter, heading").check()
    page.wait_for_function("() => fdes.panel.names.join() === 'airspeed,altimeter,heading'")
    page.get_by_label("g meter").check()
    page.wait_for_function("() => fdes.panel.names.join() === 'airspeed,altimeter,heading,g_meter'")
    assert Axe().run(page).response["violations"] == []
    page.reload()
    page.wait_for_function(READY)
    assert page.evaluate("() => fdes.panel.names") == ["airspeed", "altimeter", "heading", "g_meter"]
    context.close()
