"""Control laws as a student uses them: a damper engaged in flight, its gain by hand, actuators, the diagram."""

from typing import Any

import pytest
from axe_playwright_python.sync_playwright import Axe

from fdes.aircraft import load
from fdes.analysis.design import law_for
from fdes.analysis.margins import margins

SIZE = {"width": 1280, "height": 720}
READY = "() => window.fdes && window.fdes.stats.frames > 5"
YAW = "[data-law=yaw_damper]"
ENGAGED = "() => window.fdes.link.latest.get('control').text !== 'direct'"
DIRECT = "() => window.fdes.link.latest.get('control').text === 'direct'"


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with the tab open. Any error in the page fails the test."""
    context = browser.new_context(viewport=SIZE)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=control")
    page.wait_for_function(READY)
    page.get_by_role("tab", name="Flight control").click()
    page.wait_for_selector(YAW)
    yield page
    context.close()
    assert errors == []


def told(page: Any, kind: str) -> dict[str, Any]:
    """The newest message of that kind."""
    return dict(page.evaluate("kind => window.fdes.link.latest.get(kind)", kind))


def engage(page: Any, law: str) -> None:
    """Tick a law, and wait until it flies."""
    page.locator(f"[data-law={law}] input[type=checkbox]").check()
    page.wait_for_function("law => window.fdes.link.latest.get('control').text.includes(law)", arg=law)


def dutch_roll(page: Any) -> float:
    """The damping ratio that the table of modes shows."""
    return float(page.locator('#modes-table tr[data-mode="dutch_roll"] td').nth(1).text_content())


def sway_after_a_kick(page: Any) -> float:
    """The greatest sideslip [rad] from two to five seconds after a kick of the rudder, from trim."""
    return float(
        page.evaluate(
            """async () => {
              const { link } = window.fdes;
              await link.command("reset");
              await new Promise((done) => setTimeout(done, 300));
              await link.command("input", { text: "pulse rudder 5deg for 0.5s" });
              return new Promise((done) => {
                let most = 0;
                const begin = link.t;
                link.on("frame", ({ values, index, t }) => {
                  if (t > begin + 2) most = Math.max(most, Math.abs(values[index.beta]));
                  if (t > begin + 5) done(most);
                });
              });
            }"""
        )
    )


def test_the_bare_yaw_damper_damps_the_dutch_roll_that_is_shown_and_flown(page: Any) -> None:
    bare, sways = dutch_roll(page), sway_after_a_kick(page)
    engage(page, "yaw_damper")
    assert dutch_roll(page) >= 1.5 * bare
    assert sway_after_a_kick(page) < 0.5 * sways
    shown = page.locator(f"{YAW} .law-figures").inner_text().split()
    assert shown[shown.index("wanted") + 1] == "0.400"
    assert shown[shown.index("flown") + 1] == "0.402"
    page.get_by_role("tab", name="Modes").click()
    assert page.locator("#s-plane .s-bare path").count() > 4
    assert "◇ bare aircraft" in page.locator("#s-plane").text_content()
    page.keyboard.press("l")
    page.wait_for_function(DIRECT)
    assert dutch_roll(page) == bare
    assert page.locator("#s-plane .s-bare path").count() == 0
    page.keyboard.press("l")
    page.wait_for_function(ENGAGED)


def test_a_recording_says_with_what_it_began(page: Any) -> None:
    engage(page, "yaw_damper")
    changes = ["Cm_q*=0.5", "Cn_r*=0.5", "Cl_p*=0.5", "Cn_p*=0.5", "Cl_r*=0.5"]
    page.evaluate("changes => window.fdes.link.command('edit', { changes })", changes)
    page.evaluate("() => window.fdes.link.command('record', { value: true })")
    page.get_by_role("tab", name="Recordings").click()
    page.locator(".recordings li").first.get_by_text(f"{', '.join(changes[:4])} and 1 more · yaw damper").wait_for()
    page.evaluate("() => window.fdes.link.command('record', { value: false })")


def test_an_edit_of_the_aircraft_keeps_the_gains(page: Any) -> None:
    engage(page, "yaw_damper")
    before = told(page, "control")
    page.evaluate("() => window.fdes.link.command('edit', { changes: ['Cn_r*=3'] })")
    page.wait_for_function("() => window.fdes.link.latest.get('stability').changes.length === 1")
    after = told(page, "control")
    assert after["text"] == before["text"]
    assert after["achieved"][0]["wanted"] == before["achieved"][0]["wanted"] == 0.4
    assert after["achieved"][0]["flown"] > before["achieved"][0]["flown"]


def test_gains_by_hand_wishes_and_one_out_of_reach(page: Any) -> None:
    engage(page, "yaw_damper")
    gain = page.get_by_label("Yaw damper: gain, rad/(rad/s)", exact=True)
    gain.fill("0.1")
    gain.press("Enter")
    page.wait_for_function("() => window.fdes.link.latest.get('control').gains.yaw_damper?.gain === 0.1")
    assert told(page, "control")["achieved"][0]["wanted"] is None
    page.get_by_label("Yaw damper: gain, slider").fill("0.2")
    page.wait_for_function("() => window.fdes.link.latest.get('control').gains.yaw_damper?.gain === 0.2")
    engage(page, "roll_rate_damper")
    assert told(page, "control")["gains"]["yaw_damper"]["gain"] == 0.2
    wish = page.get_by_label("Roll-rate damper: time constant")
    wish.fill("0.001")
    wish.press("Enter")
    page.wait_for_selector(".law-notes p")
    assert "out of reach" in page.locator(".law-notes").inner_text()
    wish.fill("nonsense")
    wish.press("Enter")
    page.wait_for_function("() => document.querySelector('#panel-control .problem').textContent.includes('nonsense')")


def test_the_stick_is_flown_by_keys_after_a_law_was_ticked(page: Any) -> None:
    engage(page, "pitch_rate_pi")
    assert page.evaluate("() => document.activeElement.type") == "checkbox"
    assert page.locator("[data-law=pitch_rate_pi] .law-figures").is_visible()
    page.keyboard.down("ArrowRight")
    page.wait_for_function("() => window.fdes.drawn.stick_roll > 0.1")
    page.keyboard.up("ArrowRight")


def test_the_diagram_shows_signals_and_surfaces_at_their_limits(page: Any) -> None:
    engage(page, "yaw_damper")
    page.locator("#actuators").check()
    page.wait_for_function("() => window.fdes.link.latest.get('control').actuators.on")
    page.get_by_role("tab", name="Block diagram").click()
    page.evaluate("() => window.fdes.link.command('input', { text: 'sine rudder 15deg period 0.6s for 20s' })")
    page.wait_for_function(
        "() => document.querySelector('.diagram-state').textContent.includes('rudder at its rate limit')"
    )
    page.wait_for_function("() => /r .?[1-9]/.test(document.querySelector('.diagram').textContent)")
    page.evaluate("() => window.fdes.link.command('input', { text: 'step rudder 60deg' })")
    page.wait_for_function("() => document.querySelector('.diagram-state').textContent.includes('rudder at its stop')")
    assert page.locator(".diagram .is-limited").count() >= 1
    page.get_by_role("tab", name="Modes").click()
    assert page.get_by_text("δe actuator").count() == 1


def test_margins_follow_the_law_and_the_aircraft(page: Any) -> None:
    page.get_by_role("tab", name="Margins").click()
    page.get_by_text("engage a law, and its margins stand here").wait_for()
    page.evaluate("() => window.fdes.link.command('law', { text: 'yaw_damper gain=0.5', sampled: false })")
    alone = page.locator(".margins tbody tr", has_text="law alone").locator("td")
    alone.first.wait_for()
    expected = margins(load("A-4D").at(), law_for("yaw_damper gain=0.5", load("A-4D").at()).law)[0].as_dict()
    assert page.locator(".margins caption").inner_text() == "Loop broken at the rudder"
    assert float(alone.nth(1).inner_text()) == pytest.approx(expected["gain_margin_db"], rel=6e-3)
    assert float(alone.nth(5).inner_text()) == pytest.approx(1e3 * expected["delay_margin_s"], rel=6e-3)
    assert page.locator(".margins .is-growing").count() == 0
    before = alone.nth(5).inner_text()
    page.evaluate("() => window.fdes.link.command('edit', { changes: ['Cn_beta=0.1'] })")
    page.wait_for_function(
        "before => document.querySelector('.margins tbody td:last-child').textContent !== before", arg=before
    )
    page.evaluate(
        "() => window.fdes.link.command('law', { text: 'yaw_damper gain=20; sensors delay=50ms', sampled: false })"
    )
    page.locator(".margins .is-growing", has_text="+ frames, grows").wait_for()
    assert page.evaluate(
        "(({ scrollWidth: a, clientWidth: b }) => a <= b + 1)(document.querySelector('#laws-margins'))"
    )


def test_what_a_loop_brings_to_a_sum_is_shown_with_the_sign_beside_it(page: Any) -> None:
    """Commanded aileron: gain times roll rate, taken away at the minus and not once more."""
    page.evaluate("() => window.fdes.link.command('law', { text: 'roll_rate_damper gain=0.5', sampled: false })")
    page.get_by_role("tab", name="Block diagram").click()
    page.evaluate("() => window.fdes.link.command('input', { text: 'step aileron 2deg' })")
    page.wait_for_function(
        """() => {
          const words = [...document.querySelectorAll(".diagram .d-value")].map((word) => word.textContent);
          const p = words.map((word) => /^p ([\\d.]+)/.exec(word)?.[1]).find(Boolean);
          const [brought, more] = document.querySelectorAll(".diagram .d-value.d-end:not(.d-quiet)");
          return p > 1 && !more && Math.abs(parseFloat(brought.textContent) - 0.5 * p) < 0.02;
        }"""
    )


def enter(page: Any, label: str, value: str) -> None:
    field = page.get_by_label(label, exact=True)
    field.fill(value)
    field.press("Enter")


def test_sensors_are_entered_in_seconds_or_frames_and_drawn_with_what_they_say(page: Any) -> None:
    enter(page, "Sensor lag", "0.05")
    assert "lag and delay come with the first" in page.locator("#panel-control .problem").inner_text()
    engage(page, "yaw_damper")
    page.wait_for_function("() => window.fdes.link.latest.get('control').gains.sensors?.lag === 0.05")
    page.get_by_label("Unit of the sensor delay").select_option("frames")
    enter(page, "Sensor delay", "30")
    page.wait_for_function(
        "() => Math.abs(window.fdes.link.latest.get('control').gains.sensors.delay - 30 / 120) < 1e-12"
    )
    page.get_by_label("Unit of the sensor delay").select_option("s")
    assert page.get_by_label("Sensor delay", exact=True).input_value() == "0.25"
    enter(page, "Sensor delay", "a while")
    page.wait_for_function("() => document.querySelector('#panel-control .problem').textContent.includes('a while')")
    assert told(page, "control")["gains"]["sensors"] == {"lag": 0.05, "delay": 0.25}
    page.get_by_role("tab", name="Block diagram").click()
    drawn = page.locator(".diagram").text_content()
    assert "lag 50 ms" in drawn
    assert "delay 250 ms" in drawn
    behind = page.evaluate(
        """async () => {
          const { link } = window.fdes;
          await link.command("input", { text: "ramp rudder 5deg for 4s" });
          const { Sensed } = await import("/page/sensed.js");
          const sensed = new Sensed(["r"], { lag: 0.1, delay: 0.2 });
          let said;
          for (let k = 0; k <= 240; k++) said = sensed.of({ t: k / 60, r: 0.5 * (k / 60), p: 7 });
          return { said, truth: 0.5 * 4 };
        }"""
    )
    assert behind["said"]["r"] == pytest.approx(behind["truth"] - 0.5 * 0.3, abs=0.5 / 60)
    assert behind["said"]["p"] == 7
    page.keyboard.press("l")
    page.wait_for_function(DIRECT)
    page.keyboard.press("l")
    page.wait_for_function("() => window.fdes.link.latest.get('control').gains.sensors?.delay === 0.25")


def test_it_is_accessible_and_nothing_is_cut_off(page: Any) -> None:
    for theme in ("dark", "light"):
        page.evaluate("theme => (document.documentElement.dataset.theme = theme)", theme)
        engage(page, "yaw_damper")
        assert Axe().run(page).response["violations"] == []
        page.get_by_role("tab", name="Margins").click()
        page.locator(".margins").wait_for()
        assert Axe().run(page).response["violations"] == []
        page.get_by_role("tab", name="Block diagram").click()
        assert Axe().run(page).response["violations"] == []
        assert page.evaluate(
            """() => {
              const panel = document.querySelector("#panel-control");
              return panel.scrollWidth <= panel.clientWidth + 1;
            }"""
        )
        page.get_by_role("tab", name="Laws").click()
        enter(page, "Sensor lag", "0.02")


def test_a_path_is_no_law(page: Any) -> None:
    said = page.evaluate(
        """() => window.fdes.link.command("law", { text: "./mine.py" }).then(() => "flown", (error) => error.message)"""
    )
    assert said.startswith("There is no law named './mine.py'.")
