"""Every published number in `fdes.sources` against what FDES computes, at the tolerance its source allows."""

import copy
from collections.abc import Iterator
from typing import Any

import pytest

from fdes.aircraft import load
from fdes.analysis.verify import Check, checks
from fdes.errors import NoSuchPart
from fdes.sources import misprints, sources

PUBLISHED = sources()
FOUND = checks()


def all_checks() -> Iterator[object]:
    """One test per published number."""
    for check in FOUND:
        yield pytest.param(check, id=f"{check.item} {check.quantity}")


def items() -> Iterator[tuple[str, str, int]]:
    """Where each item stands: source, kind, number."""
    for name, source in PUBLISHED.items():
        for kind, found in source.items():
            yield from ((name, kind, k) for k in range(len(found)) if isinstance(found, list))


@pytest.mark.parametrize("check", list(all_checks()))
def test_published_number(check: Check) -> None:
    assert check.passed, f"{check.published} in {check.citation}, {check.where}; computed {check.computed:.6g}"


def test_every_item_of_every_source_is_checked() -> None:
    assert {check.item for check in FOUND} == {PUBLISHED[name][kind][k]["id"] for name, kind, k in items()}


def test_every_source_says_what_it_is() -> None:
    for name, source in PUBLISHED.items():
        assert len(source["citation"]) > 20, name


@pytest.mark.parametrize(("name", "kind", "k"), list(items()))
def test_one_wrong_number_in_any_item_is_found(name: str, kind: str, k: int) -> None:
    corrupted = copy.deepcopy({name: PUBLISHED[name]})
    item = corrupted[name][kind][k]
    if "published" in item:
        first = next(iter(item["published"].values()))
        key = next(iter(first))
        first[key] = [v * 1.2 for v in first[key]] if key == "eigenvalue" else first[key] * 1.2
    else:
        table = item.get("A") or item["rows"]
        table[0][{"atmosphere": 1, "execution_times": "total", "matrices": 0}[kind]] *= 1.2
    found = [check for check in checks(corrupted) if check.item == item["id"]]
    assert any(not check.passed for check in found) != all(check.verdict == "no check" for check in found)


def test_a_mode_that_is_missing_fails() -> None:
    item = copy.deepcopy(PUBLISHED["nelson_1998"]["modes"][0])
    item["published"] = {"no_such_mode": {"eigenvalue": [-1.0, 1.0]}}
    found = checks({"x": {"citation": "none", "modes": [item]}})
    assert not any(check.passed for check in found)


def figure(item: str, quantity: str) -> Check:
    (check,) = [c for c in FOUND if (c.item, c.quantity) == (item, quantity)]
    return check


def test_the_nt33a_has_the_five_modes_of_its_report() -> None:
    found = [check for check in FOUND if check.item == "NT33A_FROM_TABLE"]
    assert {check.quantity.split()[0] for check in found} == {"phugoid", "short_period", "roll", "spiral", "dutch_roll"}
    assert max(check.error for check in found) < 0.005


def test_the_dutch_roll_of_the_747_needs_its_own_mass_and_turned_inertias() -> None:
    turned = figure("B747_FC2_FROM_TABLE", "dutch_roll zeta")
    assert turned.computed == pytest.approx(0.107, abs=0.002)
    assert figure("B747_FC2_BODY_INERTIA", "dutch_roll zeta").computed < 0.07


def b747_from_table(**changes: Any) -> dict[str, Any]:
    """The one item that names a misprint, changed."""
    (item,) = [i for i in PUBLISHED["heffley_jewell_1972"]["modes"] if i["id"] == "B747_FC2_FROM_TABLE"]
    item = copy.deepcopy(item)
    item["published"] = {"short_period": item["published"]["short_period"] | changes}
    return {"x": {"citation": "none", "modes": [item]}}


def test_a_misprint_is_shown_with_its_evidence() -> None:
    _, frequency = checks(b747_from_table())
    assert (frequency.verdict, frequency.passed) == ("misprint", True)
    assert frequency.note.startswith("B747_CL_ALPHADOT: In dispute: NASA CR-2144 has -6.7")


def test_a_misprint_excuses_nothing_that_it_does_not_explain() -> None:
    _, frequency = checks(b747_from_table(omega_n=0.95))
    assert (frequency.verdict, frequency.passed) == ("failed", False)


def test_a_new_misprint_must_be_recorded_first() -> None:
    with pytest.raises(NoSuchPart, match=r"no accepted misprint named 'B747_CL_ALPHA'\. Did you mean"):
        checks(b747_from_table(misprint="B747_CL_ALPHA"))


@pytest.mark.parametrize("name", misprints())
def test_accepted_misprints_are_those_of_the_hangar(name: str) -> None:
    said = misprints()[name]
    aircraft = load(said["aircraft"])
    book, right = (
        aircraft.at(said["condition"], variant=v).provenance[said["number"]] for v in ("printed", "corrected")
    )
    assert book.value == pytest.approx(said["printed"])
    assert right.value == pytest.approx(said["instead"]) or right.corrected is None
    assert not right.unverified, "what is merely presumed is no misprint"
    assert len(said["evidence"]) > 20
