"""Air data against closed forms and each other."""

import pytest

from fdes.errors import SpecError
from fdes.physics.airdata import calibrated_airspeed, equivalent_airspeed, impact_pressure
from fdes.physics.atmosphere import A0, P0, standard_atmosphere
from fdes.units import FOOT, KNOT


@pytest.mark.parametrize("mach", [0.05, 0.4, 0.9, 1.0, 1.3, 2.0])
def test_at_sea_level_calibrated_is_true_airspeed(mach: float) -> None:
    assert calibrated_airspeed(impact_pressure(mach, P0)) == pytest.approx(mach * A0, rel=1e-6)


def test_pitot_equation_is_continuous_at_mach_one() -> None:
    assert impact_pressure(1.0 + 1e-9, P0) == pytest.approx(impact_pressure(1.0, P0), rel=1e-6)


def test_mach_08_at_35000_ft_reads_272_knots() -> None:
    """The usual chart value: M 0.80 at FL350 is 272 KCAS."""
    air = standard_atmosphere(35000 * FOOT)
    assert calibrated_airspeed(impact_pressure(0.8, air.p)) / KNOT == pytest.approx(272.0, abs=1.0)
    assert equivalent_airspeed(0.8 * air.a, air.rho) / KNOT == pytest.approx(256.8, abs=1.0)


def test_says_how_far_the_atmosphere_reaches() -> None:
    with pytest.raises(SpecError, match="86,000 m; height 90,000 m is outside"):
        standard_atmosphere(90e3)
