"""The assumed engine of a jet: thrust with density, held against published thrust and against its own condition."""

import math

import pytest

from fdes.aircraft import load
from fdes.analysis.jacobian import engine_held
from fdes.analysis.trim import TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.aero import Flow
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.propulsion import Engine, thrust
from fdes.units import FOOT

TROPOPAUSE = 11000.0  # m, geopotential
RATING = {("A-4D", "M0.8_35kft"): 7700.0, ("B747", "M0.90_40kft"): 174000.0, ("JetStar", "M0.80_40kft"): 12000.0}
POUND = 4.4482216152605  # N


def at(engine: Engine, h: float, V: float = 200.0) -> float:
    """Full thrust [N] along the thrust line."""
    air = standard_atmosphere(h)
    push = thrust(engine, Flow(V, V, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, air.rho, V / air.a, 0.5 * air.rho * V * V), 1.0)
    return math.hypot(push.X, push.Z)


def exponent(engine: Engine, low: float, high: float) -> float:
    rho = standard_atmosphere(low).rho / standard_atmosphere(high).rho
    return math.log(at(engine, low) / at(engine, high)) / math.log(rho)


@pytest.mark.parametrize("name", [("A-4D", "M0.4_SL"), *RATING, ("F-104A", "M1.8_55kft")], ids=" ".join)
def test_a_jet_thins_as_the_air_above_the_tropopause_and_by_less_below(name: tuple[str, str]) -> None:
    condition = load(name[0]).at(name[1])
    engine, ref = six_dof_of(condition).engine, condition.reference
    assert exponent(engine, 1000.0, 9000.0) == pytest.approx(0.7)
    assert exponent(engine, 12000.0, 18000.0) == pytest.approx(1.0)
    assert at(engine, ref.h, ref.V) == pytest.approx(ref.T_max, rel=1e-12)
    rho = standard_atmosphere(TROPOPAUSE * 6356766.0 / (6356766.0 - TROPOPAUSE)).rho
    assert engine.thin == pytest.approx(rho, rel=1e-4)


@pytest.mark.parametrize("name", RATING, ids=" ".join)
def test_at_sea_level_it_is_the_rating_that_the_file_begins_with(name: tuple[str, str]) -> None:
    assert at(six_dof_of(load(name[0]).at(name[1])).engine, 0.0) == pytest.approx(RATING[name] * POUND, rel=0.005)


def test_published_thrust_above_the_tropopause_is_nearer_to_the_density_than_to_its_power_of_07() -> None:
    """Of the F-16's engine, NASA TP-1538, military power, at all its Mach numbers."""
    tables = load("F-16").at().turbofan
    assert tables is not None
    engine = tables.engine()
    rho = standard_atmosphere(40000.0 * FOOT).rho / standard_atmosphere(50000.0 * FOOT).rho
    found = [math.log(row[4] / row[5]) / math.log(rho) for row in engine.military]
    assert min(found) > 1.0
    assert max(found) < 1.2
    below = standard_atmosphere(0.0).rho / standard_atmosphere(30000.0 * FOOT).rho
    assert [round(math.log(row[0] / row[3]) / math.log(below), 2) for row in engine.military] == [
        1.19, 1.17, 1.10, 1.02, 0.86, 0.66
    ]  # fmt: skip


def test_a_propeller_and_a_held_engine_know_no_tropopause() -> None:
    propeller = six_dof_of(load("NAVION").at()).engine
    assert exponent(propeller, 1000.0, 15000.0) == pytest.approx(1.0)
    condition = load("JetStar").at("M0.80_40kft")
    held = engine_held(trim(six_dof_of(condition), TrimSpec(condition.reference.V, condition.reference.h)))
    assert at(held, 0.0) == at(held, 15000.0)
