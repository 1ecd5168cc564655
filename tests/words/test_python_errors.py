"""What a mistake in Python is answered: the first things that somebody types who has not read the guide."""

import re
from collections.abc import Callable
from typing import Any

import pytest

import fdes
from fdes.analysis.linearize import linear_model
from fdes.errors import FdesError
from fdes.flight import plant_of
from fdes.flight.nonlinear import six_dof_of

ASKED: dict[str, Callable[[Any], Any]] = {
    "modes": fdes.modes,
    "assess": fdes.assess,
    "linear_model": linear_model,
    "plant_of": plant_of,
    "six_dof_of": six_dof_of,
    "edited": lambda of: fdes.edited(of, ["Cm_q=0"]),
    "simulate": lambda of: fdes.simulate(of, clock=fdes.Clock(0.01, duration=1.0)),
}


@pytest.mark.parametrize("ask", ASKED.values(), ids=ASKED)
@pytest.mark.parametrize(
    ("of", "words"),
    [
        (
            fdes.load("A-4D"),
            "in no flight condition yet. It has M0.4_SL, M0.8_35kft: take one with .at('M0.4_SL'), or the first",
        ),
        (
            "A-4D",
            "aircraft in a flight condition is needed, and this is the text 'A-4D'. Load one: fdes.load('A-4D')",
        ),
        (fdes.load("A-4D").conditions[0], "and this is of type Condition. Load one: fdes.load('A-4D').at('M0.4_SL')."),
    ],
    ids=["aircraft", "name", "condition"],
)
def test_what_is_no_flight_condition(ask: Callable[[Any], Any], of: Any, words: str) -> None:
    with pytest.raises(FdesError, match=re.escape(words)):
        ask(of)


@pytest.mark.parametrize("ask", [fdes.modes, linear_model, plant_of, fdes.assess], ids=lambda ask: ask.__name__)
def test_a_form_that_there_is_not(ask: Callable[..., Any]) -> None:
    with pytest.raises(FdesError, match=r"no form of the linear equations named 'ful'\. Did you mean 'full'\?"):
        ask(fdes.load("A-4D").at(), form="ful")


def test_a_path_is_no_recording() -> None:
    with pytest.raises(FdesError, match=r"A recording is needed, and this is 'flight\.fdes'\. Open one"):
        fdes.what_if("flight.fdes")


def test_one_text_is_as_good_as_a_list_of_one() -> None:
    a4d = fdes.load("A-4D").at()
    assert fdes.edited(a4d, "Cm_q*=0.5") == fdes.edited(a4d, ["Cm_q*=0.5"])
    clock = fdes.Clock(0.02, duration=1.0)
    alone = fdes.simulate(a4d, "step elevator 1deg", clock=clock, initial="beta=5deg")
    listed = fdes.simulate(a4d, ["step elevator 1deg"], clock=clock, initial=["beta=5deg"])
    assert (alone.data == listed.data).all()
    assert alone.header["inputs"] == ["step elevator 1deg"]
