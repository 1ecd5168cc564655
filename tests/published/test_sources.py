"""Every published number in `fdes.sources` against what FDES computes, at the tolerance its source allows."""

import copy
from collections.abc import Iterator

import pytest

from fdes.analysis.verify import Check, checks
from fdes.sources import sources

PUBLISHED = sources()


def all_checks() -> Iterator[object]:
    """One test per published number."""
    for check in checks():
        yield pytest.param(check, id=f"{check.item} {check.quantity}")


@pytest.mark.parametrize("check", list(all_checks()))
def test_published_number(check: Check) -> None:
    assert check.passed, f"{check.published} in {check.citation}, {check.where}; computed {check.computed:.6g}"


def test_every_item_of_every_source_is_checked() -> None:
    items = {
        i["id"] for source in PUBLISHED.values() for kind in source.values() if isinstance(kind, list) for i in kind
    }
    assert {check.item for check in checks()} == items


def test_every_source_says_what_it_is() -> None:
    for name, source in PUBLISHED.items():
        assert len(source["citation"]) > 20, name


@pytest.mark.parametrize("name", PUBLISHED)
def test_one_wrong_number_in_any_source_is_found(name: str) -> None:
    corrupted = copy.deepcopy({name: PUBLISHED[name]})
    for kind, items in corrupted[name].items():
        for item in items if isinstance(items, list) else []:
            if "published" in item:
                first = next(iter(item["published"].values()))
                key = next(iter(first))
                first[key] = [v * 1.2 for v in first[key]] if key == "eigenvalue" else first[key] * 1.2
            else:
                table = item.get("A") or item["rows"]
                key = {"atmosphere": 1, "execution_times": "total", "matrices": 0}[kind]
                table[0][key] *= 1.2
    assert any(not check.passed for check in checks(corrupted))


def test_a_mode_that_is_missing_fails() -> None:
    item = copy.deepcopy(PUBLISHED["nelson_1998"]["modes"][0])
    item["published"] = {"no_such_mode": {"eigenvalue": [-1.0, 1.0]}}
    found = checks({"x": {"citation": "none", "modes": [item]}})
    assert not any(check.passed for check in found)
