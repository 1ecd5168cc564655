"""A new aircraft from nothing: the form in the page, and the server that checks it as it is filled in."""

import json
from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import httpx
import pytest
from axe_playwright_python.sync_playwright import Axe

from fdes.aircraft import load
from fdes.aircraft.load import aircraft_of
from fdes.aircraft.role import role_of
from fdes.aircraft.save import as_toml
from fdes.analysis import linear_model, modes
from fdes.cockpit.draft import LARGEST, reviewed
from fdes.errors import SpecError

READY = "() => window.fdes && window.fdes.stats.frames > 5"
GOOD = ".new-aircraft .verdict.is-good"
DOUBTED = ".new-aircraft .verdict.is-doubted"


@pytest.fixture
def navion() -> dict[str, Any]:
    return deepcopy(dict(load("NAVION").document))


def review(content: Any) -> dict[str, Any]:
    return reviewed(json.dumps(content).encode())


def test_a_whole_aircraft_has_no_errors_and_a_file_that_flies_the_same(navion: dict[str, Any]) -> None:
    said = review(navion)
    assert (said["errors"], said["findings"], said["file"]["name"]) == ([], [], "NAVION.toml")
    assert aircraft_of(said["file"]["text"], "the file").at().coefficients == load("NAVION").at().coefficients


def test_mistakes_and_gaps_are_told_by_field(navion: dict[str, Any]) -> None:
    del navion["mass"]["Ix"], navion["assumed"]["aileron_limit"]
    navion["geometry"]["S"] = {"printed": "wide", "unit": "ft^2"}
    navion["conditions"][0]["derivatives"]["Cl_p"] = {"printed": -0.41, "unit": "ft"}
    said = review(navion)
    told = {error["field"]: error["what"] for error in said["errors"]}
    assert told == {
        "geometry.S": "is 'wide'; it must be a number.",
        "conditions.0.derivatives.Cl_p": "is in 'ft', which does not fit here: use one of '1/rad', '1/deg'.",
        "mass.Ix": "is missing.",
        "assumed.aileron_limit": "is missing.",
    }
    assert said["file"] is None


def test_a_wrong_sign_is_found_with_its_meaning_its_advice_and_its_field(navion: dict[str, Any]) -> None:
    navion["conditions"][0]["derivatives"]["Cm_alpha"] = 0.683
    (found,) = review(navion)["findings"]
    assert found["what"] == "Cm_alpha is 0.683 1/rad; it must be less than 0."
    assert found["meaning"].startswith("Unstable in pitch")
    assert found["fields"] == ["conditions.0.derivatives.Cm_alpha"]
    assert found["advice"]


def test_a_speed_alone_makes_the_mach_number(navion: dict[str, Any]) -> None:
    del navion["conditions"][0]["mach"]
    flown = aircraft_of(review(navion)["file"]["text"], "the file").at().reference
    assert flown.mach == pytest.approx(176 / 1116.45, rel=1e-4)


@pytest.mark.parametrize("body", [b"", b"not JSON", b"[]", b'"A-4D"', b"\xff", b"[" * 50_000, b" " * (LARGEST + 1)])
def test_rubbish_is_refused(body: bytes) -> None:
    with pytest.raises(SpecError, match="The aircraft"):
        reviewed(body)


@pytest.mark.parametrize(
    "content",
    [
        {},
        {"mass": 1, "conditions": 3},
        {"conditions": [1, {"speed": 5, "altitude": None}]},
        {"conditions": {}},
        {"format": 1, "terms": "os.system", "sources": {"a": 1}},
    ],
)
def test_what_is_no_aircraft_makes_errors_and_no_file(content: Any) -> None:
    said = review(content)
    assert said["errors"]
    assert said["file"] is None


def test_a_name_is_never_a_path(navion: dict[str, Any]) -> None:
    assert review(navion | {"id": "../../etc/passwd"})["file"]["name"] == "etc-passwd.toml"


@pytest.fixture
def http(serve: Any) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=serve().url) as client:
        yield client


def test_the_server_reviews_offers_and_refuses(http: httpx.Client, navion: dict[str, Any]) -> None:
    offered = http.get("/api/new-aircraft").json()
    assert offered["units"]["m^2"]["ft^2"] == pytest.approx(0.09290304)
    assert ("NAVION", "M0.158_SL") in [(each["aircraft"], each["condition"]) for each in offered["start_from"]]
    assert http.get("/api/new-aircraft/from/NAVION").json() == json.loads(json.dumps(navion))
    assert http.get("/api/new-aircraft/from/..%2F..%2Fmine.toml").status_code in {400, 404}
    assert http.post("/api/new-aircraft", json=navion).json()["errors"] == []
    flown = http.post("/api/new-aircraft/from", content=as_toml(load("NAVION").at()).encode()).json()
    assert flown["geometry"]["S"]["printed"] == 184
    assert http.post("/api/new-aircraft/from", content=b"\xff").status_code == 400
    assert http.post("/api/new-aircraft", content=b"rubbish").status_code == 400
    assert http.post("/api/new-aircraft", content=b" " * (LARGEST + 1)).status_code == 413
    assert http.post("/api/new-aircraft", json=navion, headers={"origin": "http://evil.example"}).status_code == 403


@pytest.fixture
def page(browser: Any, cockpit: str) -> Any:
    """The Fly page with the form open. Any error in the page fails the test."""
    context = browser.new_context(viewport={"width": 1280, "height": 720}, accept_downloads=True)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{cockpit}/?world=canvas2d&session=new-aircraft")
    page.wait_for_function(READY)
    page.click("#choose-aircraft")
    page.get_by_role("button", name="New aircraft…").click()
    page.wait_for_selector("dialog.new-aircraft[open]")
    yield page
    context.close()
    assert errors == []


def fill_in(page: Any, content: dict[str, Any]) -> None:
    """Enter the numbers of an aircraft file, each in the unit of its source."""
    page.get_by_label("Positive aileron").select_option(content["aileron_sense"])
    page.get_by_label("Engine").select_option(content["engine"])
    condition = content["conditions"][0]
    parts = {
        "geometry": content["geometry"],
        "mass": content["mass"],
        "conditions-0-derivatives": condition["derivatives"],
        "conditions-0": {
            name: condition[name] for name in ("mach", "altitude", "speed", "density", "gravity", "trim_alpha")
        },
    }
    for part, numbers in parts.items():
        for name, said in numbers.items():
            if name == "source":
                continue
            given = said if isinstance(said, dict) else {"printed": said}
            page.fill(f"#new-{part}-{name}", str(given.get("corrected", given["printed"])))
            if "unit" in given:
                page.get_by_label(f"Unit of {name}", exact=True).select_option(given["unit"])


def test_what_flies_now_fills_the_form_with_its_changes(page: Any) -> None:
    page.evaluate("() => window.fdes.link.command('edit', { changes: ['Cm_q*=0.5'] })")
    page.get_by_label("Start from").select_option("flown")
    page.wait_for_selector(GOOD)
    assert float(page.input_value("#new-conditions-0-derivatives-Cm_q")) == pytest.approx(-1.8)
    assert page.input_value("#new-assumed-max_thrust") != ""
    page.evaluate("() => window.fdes.link.command('aircraft', { aircraft: 'A-7A' })")
    page.get_by_label("Start from").select_option("")
    page.wait_for_selector(".new-aircraft .verdict.is-open")
    page.get_by_label("Start from").select_option("flown")
    page.get_by_text("It has dimensional derivatives or tables, which this form does not ask.").wait_for()


def test_class_category_and_phase_go_into_the_file_with_their_reason(page: Any) -> None:
    page.get_by_label("Start from").select_option("flown")
    page.wait_for_selector(GOOD)
    page.locator(".new-aircraft").get_by_role("combobox", name="Class", exact=True).select_option("II-C")
    page.locator(".new-aircraft").get_by_role("combobox", name="Category", exact=True).select_option("C")
    page.locator(".new-aircraft").get_by_role("combobox", name="Flight Phase").select_option("PA")
    with page.expect_response(lambda response: "a carrier" in (response.request.post_data or "")) as reviewed:
        page.get_by_label("Reason", exact=True).fill("a carrier trainer")
    file = reviewed.value.json()["file"]
    role = role_of(aircraft_of(file["text"], "the file").document, "as entered")
    assert (role.airplane_class, role.category, role.phase) == ("II-C", "C", "PA")
    assert role.reason == "a carrier trainer"


def test_the_navion_is_entered_by_hand_checked_mended_and_flown(
    page: Any, navion: dict[str, Any], tmp_path: Any
) -> None:
    assert "It cannot fly yet." in page.wait_for_selector(".new-aircraft .verdict.is-open").inner_text()
    assert page.get_by_role("button", name="Fly it").is_disabled()
    fill_in(page, navion)
    page.wait_for_selector(GOOD)
    stiffness = page.locator("#new-conditions-0-derivatives-Cm_alpha")
    stiffness.fill("0.683")
    page.wait_for_selector(DOUBTED)
    assert "Cm_alpha is 0.683 1/rad; it must be less than 0." in page.inner_text(".review-list")
    assert stiffness.get_attribute("data-marked") is not None
    results = Axe().run(page)
    assert results.violations_count == 0, results.generate_report()
    stiffness.fill("-0.683")
    page.wait_for_selector(GOOD)
    assert page.inner_text(".review-list") == ""
    assert stiffness.get_attribute("data-marked") is None
    with page.expect_download() as saving:
        page.get_by_role("button", name="Save (.toml)").click()
    saving.value.save_as(tmp_path / "mine.toml")
    page.get_by_role("button", name="Fly it").click()
    page.wait_for_function("() => window.fdes.link.latest.get('aircraft').id === 'my-aircraft'")
    page.wait_for_selector("dialog.new-aircraft", state="hidden")
    wanted = next(m for m in modes(linear_model(load("NAVION").at())) if m.name == "short_period")
    assert load(tmp_path / "mine.toml").at().coefficients == load("NAVION").at().coefficients
    page.wait_for_function("() => Math.abs(window.fdes.link.latest.get('aircraft').mass_kg - 1247.4) < 1")
    told = page.evaluate("() => window.fdes.link.latest.get('modes').modes")
    flown = next(m for m in told if m["name"] == "short_period")
    assert flown["zeta"] == pytest.approx(wanted.zeta, rel=1e-9)
    assert flown["omega_n"] == pytest.approx(wanted.omega_n, rel=1e-9)
