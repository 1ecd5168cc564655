"""What a change that cannot be made is answered."""

import re

import pytest

from fdes.aircraft import edited, load
from fdes.errors import FdesError


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("Cm_alpa=-0.3", "There is no number of the A-4D named 'Cm_alpa'. Did you mean 'Cm_alpha'?"),
        ("Cm_alpha", "The change 'Cm_alpha' is not understood. Write it like Cm_alpha=-0.3, Cn_r*=2 or 'm+=500 kg'."),
        ("Cm_alpha=much", "The change 'Cm_alpha=much' cannot be read. 'much' is not a number."),
        ("Cm_alpha=nan", "The change 'Cm_alpha=nan' cannot be read. 'nan' is not a number."),
        ("Cm_q=1e999", "'1e999' is not a finite number."),
        ("m=8000", "The change 'm=8000' has no unit: m is in kg. Write it like 'm=8000 kg'."),
        ("m=8000 ft", "'8000 ft' is in ft, which is not a unit of this quantity. Use one of: kg, lb, slug."),
        ("m=-8000 kg", "m would be -8000 kg; it must be greater than zero."),
        ("cg=3", "cg would be 3; it can be from -1 to 2."),
        ("h=90 km", "h would be 90000 m; it can be from -500 to 30000."),
        ("Ixz=60000 kg m^2", "no body has such inertias. Ixz squared must be less than Ix times Iz."),
        ("T_max=100 N", "level flight needs 8,224 N of thrust (CD = 0.03); there is none below 0 N and none above"),
        ("CD=-0.1", "level flight needs -27,412 N of thrust"),
    ],
)
def test_change_that_cannot_be_made(change: str, words: str) -> None:
    with pytest.raises(FdesError, match=re.escape(words)):
        edited(load("A-4D").at(), [change])


def test_mass_of_dimensional_derivatives() -> None:
    with pytest.raises(
        FdesError, match="its source gives dimensional derivatives, which hold for its own mass and speed"
    ):
        edited(load("B747_CR2144").at(), ["m*=1.1"])


def test_weight_without_lift() -> None:
    with pytest.raises(FdesError, match="no angle of attack carries the weight: change CL_alpha first"):
        edited(load("A-4D").at(), ["CL_alpha=0", "m*=1.1"])


def test_place_of_an_unknown_center_of_gravity() -> None:
    with pytest.raises(FdesError, match=re.escape("Shift it instead, as in cg+=0.05 (mean chords, aft).")):
        edited(load("NT-33A").at(), ["cg=0.3"])
