"""Every input shape: zero before it starts, never larger than its amplitude, and spoken to in words."""

from typing import Any

import pytest

from fdes.errors import NoSuchPart, SpecError
from fdes.flight import Excitation
from fdes.shelf import shelf

NAMES = shelf("inputs").names()
TIMES = [0.01 * k for k in range(8000)]


@pytest.fixture(params=NAMES)
def shape(request: pytest.FixtureRequest) -> Any:
    """The part; a time history is given as one that rises and falls within four seconds."""
    part = shelf("inputs").get(request.param)
    if not hasattr(part, "read"):
        return part

    def triangle(amplitude: float, at: float = 0.0) -> Any:
        return part((7.0, 9.0, 11.0), (0.0, amplitude, 0.0), at=at)

    return triangle


def test_zero_before_it_starts_and_bounded_by_its_amplitude(shape: Any) -> None:
    put = shape(amplitude=0.1, at=2.0)
    assert all(put(t) == 0.0 for t in TIMES if t < 2.0)
    values = [put(t) for t in TIMES]
    assert 0.09 < max(abs(v) for v in values) <= 0.1


STAY = ("step", "ramp", "one_minus_cosine")


@pytest.mark.parametrize("name", NAMES)
def test_an_input_that_lasts_ends_at_zero_but_for_those_that_stay(name: str) -> None:
    shape = shelf("inputs").get(name)
    if name in STAY:
        assert shape(0.1)(1e6) == 0.1
        return
    put = shape((0.0, 2.0, 4.0), (0.0, 0.1, 0.05), at=1.0) if name == "measured" else shape(0.1, at=1.0, lasting=4.0)
    assert put(5.001) == 0.0
    assert any(put(t) for t in TIMES)


def test_both_cosine_gusts_are_smooth_and_pass_their_middle() -> None:
    up, there_and_back = (
        shelf("inputs").get(f"one_minus_cosine{more}")(2.0, at=1.0, lasting=4.0) for more in ("", "_pulse")
    )
    assert [round(up(t), 12) for t in (1.0, 2.0, 3.0, 5.0, 9.0)] == [
        0.0,
        pytest.approx(0.292893, abs=1e-6),
        1.0,
        2.0,
        2.0,
    ]
    assert [round(there_and_back(t), 12) for t in (1.0, 2.0, 3.0, 4.0, 5.0, 9.0)] == [0.0, 1.0, 2.0, 1.0, 0.0, 0.0]


def test_equal_values_make_equal_inputs(shape: Any) -> None:
    assert shape(0.1, at=1.0) == shape(0.1, at=1.0)
    with pytest.raises(AttributeError):
        shape(0.1).amplitude = 2.0


def test_3211_has_the_lengths_it_is_named_for() -> None:
    put = shelf("inputs").get("three_two_one_one")(1.0, at=0.0, lasting=7.0)
    assert [put(0.5 + k) for k in range(8)] == [1.0, 1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 0.0]


def test_doublet_has_no_mean() -> None:
    put = shelf("inputs").get("doublet")(1.0, at=1.0, lasting=2.0)
    assert [put(t) for t in (0.99, 1.0, 1.99, 2.0, 2.99, 3.0)] == [0.0, 1.0, 1.0, -1.0, -1.0, 0.0]


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ("stp aileron 1deg", NoSuchPart, "There is no input named 'stp'. Did you mean 'step'?"),
        ("step ailerons 1deg", NoSuchPart, "There is no input channel named 'ailerons'. Did you mean 'aileron'?"),
        (
            "step aileron",
            SpecError,
            "The input 'step aileron' is incomplete. Write it like 'step aileron 15deg at 0s'.",
        ),
        ("step aileron 15kt", SpecError, "'15kt' is in kt, which is not a unit of this quantity. Use one of: rad, deg"),
        ("doublet elevator 5deg for -1s", SpecError, "it must last longer than 0 s"),
        ("step elevator 5deg at", SpecError, "does not say its value after 'at'"),
        ("step elevator 5deg for 2s", SpecError, "says 'for', which a step does not have. It knows: at."),
        ("step elevator 5deg at 0s for 2s", SpecError, "says 'for', which a step does not have. It knows: at."),
        ("doublet elevator 5deg 2s", SpecError, "says '2s', which a doublet does not have. It knows: at, for."),
        (
            "sine elevator 5deg perod 2s",
            SpecError,
            "says 'perod', which a sine does not have. It knows: at, period, for.",
        ),
        ("sine elevator 5deg period 0s", SpecError, "says period 0s; it must last longer than 0 s."),
        ("step elevator 5deg at 1s from 2s", SpecError, "says 'at' twice."),
        ("step elevator at 1s", SpecError, "does not say its value after 'elevator'."),
        ("step aileron 15", SpecError, "does not say the unit of 15. Write 15deg, or 15rad."),
        ("step aileron 15 at 0s", SpecError, "does not say the unit of 15. Write 15deg, or 15rad."),
        (
            "step aileron 15degs",
            SpecError,
            "The input 'step aileron 15degs' cannot be read. Unknown unit 'degs'. Did you",
        ),
        ("step aileron nan deg", SpecError, "cannot be read. 'nan deg' is not a number with a unit."),
        ("step aileron nan", SpecError, "cannot be read. 'nan' is not a number with a unit."),
        ("step aileron 1e400deg", SpecError, "cannot be read. '1e400deg' is not a finite number."),
        (
            "step aileron 1deg at 2m",
            SpecError,
            "'2m' is in m, which is not a unit of this quantity. Use one of: s, ms, min",
        ),
    ],
)
def test_says_what_is_wrong_with_an_input(text: str, error: type[Exception], words: str) -> None:
    with pytest.raises(error) as found:
        Excitation.parse([text])
    assert words in str(found.value)


@pytest.mark.parametrize(
    "text",
    [
        "step aileron 15deg at 0.5s",
        "Step Aileron 15 deg at 0.5 s",
        "step aileron +15deg FROM 500 ms",
        "step aileron 15deg at .5",
    ],
)
def test_one_input_can_be_said_in_several_ways(text: str) -> None:
    assert Excitation.parse([text]) == Excitation.parse(["step aileron 15deg at 0.5s"])


@pytest.mark.parametrize("kind", ["3-2-1-1", "3211", "three_two_one_one"])
def test_3211_goes_by_its_usual_name(kind: str) -> None:
    assert Excitation.parse([f"{kind} elevator 1deg for 7s"])(6.5).elevator < 0.0


@pytest.mark.parametrize(("at", "lasting"), [(0.1, 0.4), (0.7, 0.2), (0.3, 0.6), (1.1, 2.2), (2.3, 1.4)])
def test_halves_are_equal_though_decimals_are_not_exact(at: float, lasting: float) -> None:
    put = shelf("inputs").get("doublet")(1.0, at, lasting)
    assert sum(put(t) for t in TIMES) == 0.0
    put = shelf("inputs").get("three_two_one_one")(1.0, at, 3.5 * lasting)
    assert sum(put(t) for t in TIMES) == sum(abs(put(t)) for t in TIMES) / 7.0


def test_inputs_add_up() -> None:
    both = Excitation.parse(["step elevator 1deg at 1s; step elevator 2 deg at 2 s", "pulse rudder 1deg for 0.5s"])
    assert both(0.2).rudder == pytest.approx(0.0174533, rel=1e-5)
    assert both(2.5).elevator == pytest.approx(3 * 0.0174533, rel=1e-5)
