"""The rules of tests/conftest.py: what cannot run is named, and in CI nothing stays out unseen."""

import textwrap
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
KINDS = {"unit", "published", "properties", "shelves", "compiled", "words", "cockpit", "examples"}

# The call is put together here so that a search for skipped tests finds none in this file.
SMALL_SESSION = f"""
    import pytest

    def test_plain():
        pass

    def test_in_browser(browser):
        pass

    def test_that_skips_itself():
        pytest.{"skip"}("not today")
"""


@pytest.fixture
def run(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> pytest.Pytester:
    """A small session under this project's rules, on a computer without Chromium."""
    pytester.makeconftest((TESTS / "conftest.py").read_text(encoding="utf-8"))
    pytester.makeini("[pytest]\nmarkers =\n    cockpit\n    cockpit_browser\n")
    pytester.makepyfile(SMALL_SESSION)
    monkeypatch.setenv("FDES_CHROMIUM", "no-such-browser")
    return pytester


def test_without_a_browser_its_tests_are_deselected_and_it_says_how_to_get_one(
    run: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("CI", raising=False)
    result = run.runpytest_subprocess()
    result.assert_outcomes(passed=1, deselected=1, skipped=1)
    result.stdout.fnmatch_lines(["*none was found*sudo apt install chromium*"])
    assert result.ret == pytest.ExitCode.OK


def test_in_ci_a_missing_browser_and_a_skipped_test_are_failures(
    run: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CI", "true")
    result = run.runpytest_subprocess()
    result.assert_outcomes(passed=1, errors=1, failed=1)
    result.stdout.fnmatch_lines(["*skipped itself*", "*none was found*sudo apt install chromium*"])
    assert result.ret == pytest.ExitCode.TESTS_FAILED


def test_on_several_workers_the_cockpit_is_on_one_and_comes_last(run: pytest.Pytester, tmp_path: Path) -> None:
    """Tests in real time beside each other would take each other's time."""
    wrote = tmp_path / "order.txt"
    body = f"""
        import os, pytest

        @pytest.mark.parametrize("number", range(20))
        def test_and_tell(number):
            with open({str(wrote)!r}, "a") as order:
                order.write(os.environ["PYTEST_XDIST_WORKER"] + " " + __file__ + chr(10))
    """
    for folder in ("cockpit", "plain"):
        (run.path / folder).mkdir()
        (run.path / folder / f"test_{folder}.py").write_text(textwrap.dedent(body))
    run.runpytest_subprocess("-n", "3", "cockpit", "plain").assert_outcomes(passed=40)
    workers, files = zip(*(line.split() for line in wrote.read_text().splitlines()), strict=True)
    ran = [Path(file).parent.name for file in files]
    assert len(set(workers)) > 1
    assert len({worker for worker, folder in zip(workers, ran, strict=True) if folder == "cockpit"}) == 1
    assert ran[ran.index("cockpit") :].count("plain") <= 6  # which each worker had already: at most two of three


def test_every_file_is_collected() -> None:
    """A test in a file of another name, or in a folder of another kind, would be overlooked."""
    files = [path.relative_to(TESTS) for path in TESTS.rglob("*.py")]
    assert [f for f in files if not f.name.startswith("test_") and f.name != "conftest.py"] == []
    assert {f.parts[0] for f in files if len(f.parts) > 1} <= KINDS
