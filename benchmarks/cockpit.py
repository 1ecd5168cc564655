"""The cockpit's figures, measured in a real browser: start-up, first frame, latency, frame rate, page weight.

    python benchmarks/cockpit.py [--seconds 20] [--size 1280x720]

Each figure stands beside the demand that it must meet. Headless Chromium, without a GPU, with the 2-D world.
"""

import argparse
import gzip
import json
import subprocess
import sys
import time
import urllib.request
from pathlib import Path
from statistics import quantiles
from tempfile import TemporaryDirectory
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from conftest import BROWSER_OPTIONS, NO_BROWSER, find_chromium  # the tests know where the browser is

# 120 edits, 15 a second as from a slider: from the command to the frame in which poles and badges have been painted.
EDIT = """async () => {
  const { link } = window.fdes;
  let drawn = () => {};
  link.on("qualities", () => requestAnimationFrame(() => setTimeout(() => drawn(performance.now()))));
  await new Promise((done) => setTimeout(done, 500));
  const times = [];
  for (let k = 0; k < 120; k++) {
    const start = performance.now();
    const end = new Promise((done) => (drawn = done));
    link.command("edit", { changes: [`Cm_q=${-3.6 + 0.03 * (k + 1)}`], dragging: true });
    times.push((await end) - start);
    await new Promise((done) => setTimeout(done, 66 - times.at(-1)));
  }
  return times;
}"""


def main() -> None:
    """Start a cockpit, fly it, print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=20.0, help="how long to fly")
    parser.add_argument("--size", default="1280x720", help="size of the page, WIDTHxHEIGHT")
    options = parser.parse_args()
    width, height = map(int, options.size.split("x"))
    if find_chromium() is None:
        raise SystemExit(NO_BROWSER)
    with TemporaryDirectory() as data:
        began = time.perf_counter()
        command = [str(Path(sys.executable).with_name("fdes")), "fly", "--no-browser", "--port", "0", "--json"]
        server = subprocess.Popen([*command, "--data", data], stdout=subprocess.PIPE, text=True)
        assert server.stdout is not None
        url = json.loads(server.stdout.readline())["url"]
        listening = time.perf_counter() - began
        try:
            figures = measure(url, width, height, options.seconds)
        finally:
            server.terminate()
            server.wait()
    rows = [("fdes fly to listening", f"{listening:.2f} s", "1 s"), *figures]
    for name, value, demand in rows:
        print(f"{name:<44} {value:>20}   demand {demand}")


def measure(url: str, width: int, height: int, seconds: float) -> list[tuple[str, str, str]]:
    """Fly with a moving stick and read what the page has counted."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=BROWSER_OPTIONS)
        page = browser.new_page(viewport={"width": width, "height": height})
        asked: list[str] = []
        page.on("request", lambda request: asked.append(request.url))
        page.goto(f"{url}/?world=canvas2d&tour=off&session=bench")
        page.wait_for_function("() => window.fdes && window.fdes.stats.frames > 0")
        first = page.evaluate("() => window.fdes.stats.firstFrameAt")
        page.wait_for_timeout(2000)
        page.evaluate("() => { const s = window.fdes.stats; s.latencies.length = 0; s.from = s.frames; }")
        start = time.perf_counter()
        for k in range(int(seconds)):
            key = ("ArrowRight", "ArrowLeft", "ArrowDown", "ArrowUp")[k % 4]
            page.keyboard.down(key)
            page.wait_for_timeout(300)
            page.keyboard.up(key)
            page.wait_for_timeout(700)
        flown = time.perf_counter() - start
        stats: dict[str, Any] = page.evaluate(
            "() => { const s = window.fdes.stats; return { latencies: s.latencies, frames: s.frames - s.from }; }"
        )
        before = json.loads(urllib.request.urlopen(f"{url}/api/stats").read())
        edits = quantiles(page.evaluate(EDIT), n=100)
        after = json.loads(urllib.request.urlopen(f"{url}/api/stats?seconds=8").read())
        browser.close()
    server = before
    page_files = {u for u in asked if u.startswith(url) and "/api/" not in u}
    weight = sum(len(gzip.compress(urllib.request.urlopen(u).read())) for u in page_files)
    cuts = quantiles(stats["latencies"], n=100)
    outside = sum(not u.startswith((url, url.replace("http", "ws"), "data:")) for u in asked)
    return [
        ("navigation to first frame drawn", f"{first / 1000:.2f} s", "1 s"),
        ("page weight, gzip; requests outside", f"{weight / 1000:.1f} kB; {outside}", "100 kB; 0"),
        ("stick sampled to drawn, p50 / p99", f"{cuts[49]:.1f} / {cuts[98]:.1f} ms", "20 / 40 ms"),
        (f"frames per second, {width}x{height}, 2-D world", f"{stats['frames'] / flown:.1f}", ">= 55"),
        ("simulation loop lateness p99, 1 pilot", f"{server['lateness_ms']['p99']:.2f} ms", "1 ms"),
        ("edit to new poles and Levels drawn, p50 / p95", f"{edits[49]:.1f} / {edits[94]:.1f} ms", "50 ms (p95)"),
        (
            "loop lateness p99 and ticks lost while editing",
            f"{after['lateness_ms']['p99']:.2f} ms; {after['slips'] - before['slips']}",
            "5 ms; 0",
        ),
    ]


if __name__ == "__main__":
    main()
