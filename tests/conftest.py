"""What every test may use: folders of its own, a running cockpit, a browser; and the rule that CI leaves nothing out.

The browser is the Chromium of this computer: the one FDES_CHROMIUM names, or the first that is found. Without one the
tests that need it are deselected, and the last lines say so; where the environment says CI=true they fail instead, and
so does any test that skips itself.
"""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import hypothesis
import pytest

IN_CI = os.environ.get("CI", "").casefold() == "true"
NO_BROWSER = (
    "The cockpit's browser tests need Chromium, and none was found. "
    "Install it (Debian: sudo apt install chromium) or name it in FDES_CHROMIUM."
)
LEFT_OUT = pytest.StashKey[int]()
COCKPIT = "cockpit"  # the folder of tests that fly in real time
ON_PATH = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
USUAL_PLACES = (
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
)
BROWSER_OPTIONS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
STARTS_WITHIN = 30.0  # s
ENDS_WITHIN = 10.0  # s
TOUR_TAKEN = "try { localStorage.setItem('fdes.tour', 'done'); } catch {}"

# How long one example takes depends on what else the computer does; that is not what a property says.
hypothesis.settings.register_profile("fdes", deadline=None)
hypothesis.settings.load_profile("fdes")


class Cockpit(NamedTuple):
    """A cockpit that listens, its data folder, and its process."""

    url: str
    data: Path
    process: "subprocess.Popen[str]"


def find_chromium() -> str | None:
    """The path of this computer's Chromium. FDES_CHROMIUM, where it is set, is the only candidate."""
    named = os.environ.get("FDES_CHROMIUM")
    if named:
        return shutil.which(named)
    on_path = (shutil.which(name) for name in ON_PATH)
    return next((path for path in (*on_path, *map(shutil.which, USUAL_PLACES)) if path), None)


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[Any]) -> Iterator[None]:
    """Mark the cockpit's tests before -m looks at marks; then leave out what cannot run here.

    Browser tests come last of all, after the rest of the cockpit's: quick evidence first, and Playwright leaves an
    event loop running in the thread that it was started in, where `asyncio.run` of another test would fail.
    """
    for item in items:
        if item.path.parent.name == COCKPIT:
            item.add_marker("cockpit")
        if "browser" in item.fixturenames:
            item.add_marker("cockpit_browser")
    items.sort(key=lambda item: (item.path.parent.name == COCKPIT, "browser" in item.fixturenames))
    yield
    if IN_CI or find_chromium():
        return
    left_out = [item for item in items if item.get_closest_marker("cockpit_browser")]
    items[:] = [item for item in items if item not in left_out]
    config.hook.pytest_deselected(items=left_out)
    config.stash[LEFT_OUT] = len(left_out)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """On several processes (-n) the cockpit's tests come last and one by one: they fly in real time.

    This is the scheduler that `--dist loadgroup` would be; with pytest 9.2 pytest-xdist 3.8 finds no group (its issue
    1386), so that the folder is the group here.
    """
    from xdist.scheduler import LoadScopeScheduling  # whoever does not distribute needs no xdist

    class OneCockpit(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return COCKPIT if COCKPIT in Path(nodeid.partition("::")[0]).parts else nodeid

    config.option.loadscopereorder = False
    return OneCockpit(config, log)


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    """Say once what was left out, and what to do about it. Workers of xdist count for themselves."""
    distributed = config.getoption("numprocesses", None)
    if find_chromium() is None and (IN_CI or distributed or config.stash.get(LEFT_OUT, 0)):
        terminalreporter.write_line(NO_BROWSER, yellow=True)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[None]:
    """In CI a test that skips itself has failed."""
    return _failed_if_skipped_in_ci((yield), item.nodeid)


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Iterator[None]:
    """In CI a file that skips itself has failed."""
    return _failed_if_skipped_in_ci((yield), collector.nodeid)


def _failed_if_skipped_in_ci(report: Any, name: str) -> Any:
    if IN_CI and report.skipped and not hasattr(report, "wasxfail"):
        report.outcome, report.longrepr = "failed", f"{name} skipped itself; with CI=true every test runs."
    return report


@pytest.fixture(autouse=True)
def _data_of_its_own(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """No test writes to, or reads from, the recordings and settings of whoever runs it."""
    monkeypatch.setenv("FDES_DATA", str(tmp_path / "fdes-data"))
    monkeypatch.setenv("FDES_SETTINGS", str(tmp_path / "no-settings.toml"))


@pytest.fixture(scope="session")
def fdes_command() -> str:
    """The path of the installed console script."""
    command = shutil.which("fdes", path=str(Path(sys.executable).parent))
    assert command, "The command fdes is not beside this Python. Install the package first, as README.md says."
    return command


@pytest.fixture
def serve(fdes_command: str, tmp_path: Path) -> Iterator[Callable[..., Cockpit]]:
    """Starts cockpits: ``serve(*options, data=folder)``. Each must end with status 0 when it is asked to end."""
    started: list[Cockpit] = []

    def start(*options: str, data: Path = tmp_path / "data") -> Cockpit:
        command = [fdes_command, "fly", "--no-browser", "--port", "0", "--json", "--data", str(data), *options]
        with (tmp_path / "cockpit-stderr.txt").open("a") as stderr:
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=stderr, text=True)
        started.append(Cockpit(_url_of(process, tmp_path / "cockpit-stderr.txt"), data, process))
        return started[-1]

    yield start
    statuses = [_ended(cockpit.process) for cockpit in started if cockpit.process.poll() is None]
    if sys.platform != "win32":
        assert statuses == [0] * len(statuses), (tmp_path / "cockpit-stderr.txt").read_text()


def _url_of(process: "subprocess.Popen[str]", stderr: Path) -> str:
    """The address that the cockpit prints as soon as it listens."""
    assert process.stdout
    too_late = threading.Timer(STARTS_WITHIN, process.kill)
    too_late.start()
    line = process.stdout.readline()
    too_late.cancel()
    if not line:
        process.kill()
        pytest.fail(f"The cockpit did not start; status {process.wait()}.\n{stderr.read_text()}")
    return str(json.loads(line)["url"])


def _ended(process: "subprocess.Popen[str]") -> int:
    """The exit status after SIGTERM."""
    process.send_signal(signal.SIGTERM)
    try:
        process.communicate(timeout=ENDS_WITHIN)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
    return process.returncode


@pytest.fixture
def cockpit(serve: Callable[..., Cockpit]) -> str:
    """The address of a cockpit that runs for this test."""
    return serve().url


class Browser:
    """Chromium as somebody has it who knows the first-flight tour: it is over, but for contexts with `tour=True`."""

    def __init__(self, chromium: Any) -> None:
        self._chromium = chromium

    def new_context(self, *, tour: bool = False, **options: Any) -> Any:
        """A context of Playwright."""
        context = self._chromium.new_context(**options)
        if not tour:
            context.add_init_script(TOUR_TAKEN)
        return context

    def new_page(self, **options: Any) -> Any:
        """A page in a context of its own, which ends with the session."""
        return self.new_context(**options).new_page()


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Headless Chromium, one for the whole session; a test opens its own context or page."""
    path = find_chromium()
    if path is None:
        pytest.fail(NO_BROWSER)
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=BROWSER_OPTIONS)
        yield Browser(chromium)
        chromium.close()
