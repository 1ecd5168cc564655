"""The tables of the F-16 against the check data that NASA publishes with them, inside its DAVE-ML files.

F16_aero.dml, Mod P, 2013, and F16_prop.dml, 2012, of NASA/TM-2015-218675: every static shot, with its own tolerance.
"""

import csv
from hashlib import sha256
from importlib.resources import files

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.table_derivatives import table_derivatives
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.aero import Flow
from fdes.physics.signals import Surfaces
from fdes.physics.terms import TermAero, body_coefficients, ends, term_loads, term_signals
from fdes.physics.turbofan import commanded_power, power_rate, turbofan_thrust
from fdes.units import DEG, FOOT, POUND_FORCE, SLUG

F16 = load("F-16").at("M0.53_10kft")
assert F16.tables is not None
assert F16.turbofan is not None
ENGINE = F16.turbofan.engine()
TABLES = F16.tables


def aero(cg: float) -> TermAero:
    return TABLES.aero(F16.reference.S, F16.reference.b, F16.reference.c, cg)


def shots(name: str) -> list[dict[str, str]]:
    text = (files("fdes.sources") / name).read_text("utf-8")
    return list(csv.DictReader(text.splitlines()))


AERO, THRUST = shots("f16_aero_checks.csv"), shots("f16_propulsion_checks.csv")


def flow_of(shot: dict[str, float]) -> tuple[Flow, Surfaces]:
    """Positive aileron rolls left in the source."""
    V = shot["vt_ft_s"] * FOOT
    rates = shot["p_rad_s"], shot["q_rad_s"], shot["r_rad_s"]
    flow = Flow(V, V, 0.0, 0.0, shot["alpha_deg"] * DEG, shot["beta_deg"] * DEG, *rates, 1.0, 0.3, 1.0)
    return flow, Surfaces(shot["el_deg"] * DEG, -shot["ail_deg"] * DEG, shot["rdr_deg"] * DEG)


@pytest.mark.parametrize("shot", AERO, ids=lambda s: s["shot"])
def test_aerodynamic_shots(shot: dict[str, str]) -> None:
    number = {name: float(text) for name, text in shot.items() if name != "shot"}
    model = aero(0.35)
    found = body_coefficients(model, term_signals(model, *flow_of(number)))
    for name, value in found._asdict().items():
        assert abs(value - number[name]) <= number["tolerance"], name


@pytest.mark.parametrize("shot", THRUST, ids=lambda s: s["shot"])
def test_thrust_shots(shot: dict[str, str]) -> None:
    number = {name: float(text) for name, text in shot.items() if name != "shot"}
    found = turbofan_thrust(ENGINE, number["mach"], number["altitude_ft"] * FOOT, number["power_pct"])
    assert abs(found.X / POUND_FORCE - number["thrust_lbf"]) <= number["tolerance"]
    assert found.Z == 0.0


def test_all_shots_are_there() -> None:
    """As many as the files have; those of F16_aero.dml make every table but the corners speak."""
    assert (len(AERO), len(THRUST)) == (16, 9)
    sizes = [(len(t.values), len(t.values[0])) for t in TABLES.tables.values()]
    assert len(sizes) == 18
    assert sizes.count((1, 12)) == 10
    assert sizes.count((5, 12)) == 2
    assert sizes.count((7, 12)) == 6


# Of every table in F16_aero.dml and F16_prop.dml, read there: SHA-256 of its values, as %g with commas between.
FINGERPRINTS = {
    "CX_0": "6422fba670c1",
    "CZ_0": "b9529825dd55",
    "Cm_0": "1ae8f6a0d76a",
    "Cl_0": "aa775929d7f1",
    "Cn_0": "c8586f741d80",
    "CX_q": "f919a8d8ee3d",
    "CY_r": "1c6e84248a0e",
    "CY_p": "a78561efc367",
    "CZ_q": "7f5171884731",
    "Cl_r": "8f19c721afc1",
    "Cl_p": "6645bc3b0831",
    "Cm_q": "7baf67731425",
    "Cn_r": "0df20e554937",
    "Cn_p": "122e06348972",
    "Cl_da": "b6619b1bde9a",
    "Cl_dr": "126f3a888b01",
    "Cn_da": "ce73d719dde5",
    "Cn_dr": "c73232f474a9",
    "idle": "6ca82cdc0575",
    "military": "0e97c556cfad",
    "maximum": "b51eb0c04d06",
}


def test_every_number_of_every_table_is_the_published_one() -> None:
    """The shots above visit some cells only."""
    engine = F16.turbofan
    assert engine is not None
    grids = {name: t.values for name, t in TABLES.tables.items()}
    grids |= {name: getattr(engine, name) for name in ("idle", "military", "maximum")}
    found = {name: ",".join(f"{v + 0.0:g}" for row in rows for v in row) for name, rows in grids.items()}
    assert {name: sha256(text.encode()).hexdigest()[:12] for name, text in found.items()} == FINGERPRINTS


def test_rotor() -> None:
    """Stevens, Lewis and Johnson, appendix A: 160 slug ft^2/s."""
    assert six_dof_of(F16).inertia.Hx == pytest.approx(160.0 * SLUG * FOOT**2, rel=1e-12)


def test_inertia() -> None:
    """F16_inertia.dml: 637.1595 slug, moments of inertia in slug ft^2."""
    ref = F16.reference
    assert ref.m == pytest.approx(637.1595 * SLUG, rel=1e-12)
    found = [v / (SLUG * FOOT**2) for v in (ref.Ix, ref.Iy, ref.Iz, ref.Ixz)]
    assert found == pytest.approx([9496.0, 55814.0, 63100.0, 982.0], rel=1e-12)


def test_moments_move_with_the_center_of_gravity() -> None:
    """F16_inertia.dml: the center of gravity is (35 - cg) % of the chord before the reference; moments by r x F."""
    flow, held = flow_of({name: float(text) for name, text in AERO[-1].items() if name != "shot"})
    there, here = term_loads(aero(0.35), flow, held), term_loads(aero(0.25), flow, held)
    arm = 0.1 * 11.32 * FOOT
    assert here[:4] == there[:4]
    moved = [here.M - there.M, here.N - there.N]
    assert moved == pytest.approx([arm * there.Z, -arm * there.Y], rel=1e-12)


def test_throttle_and_lag_are_those_of_stevens() -> None:
    """Stevens, Lewis and Johnson, appendix A, TGEAR, PDOT, RTAU; the two lines of TGEAR miss one another by 0.0012."""
    for throttle in (0.0, 0.1385, 0.5, 0.77, 0.9, 1.0):
        printed = 64.94 * throttle if throttle <= 0.77 else 217.38 * throttle - 117.38
        assert commanded_power(ENGINE, throttle) == pytest.approx(printed, abs=0.0012)
    rates = {(90.0, 78.262): -58.69, (60.0, 30.0): -100.0, (20.0, 30.0): 10.0, (0.0, 100.0): 6.0, (10.0, 47.5): 20.625}
    rates[49.0, 80.0] = 11.0
    for (power, commanded), rate in rates.items():
        assert power_rate(ENGINE.lag, power, commanded) == pytest.approx(rate, abs=1e-9)


@pytest.mark.parametrize("condition", ["V502_SL", "M0.53_10kft"])
def test_the_derivatives_in_the_file_are_those_of_its_tables(condition: str) -> None:
    """At the elevator that holds level flight there, to the six digits that are written down."""
    fc = load("F-16").at(condition)
    ref = fc.reference
    assert fc.cg is not None
    model = aero(fc.cg)
    elevator = {"V502_SL": -0.7587798673871624, "M0.53_10kft": -3.2411867447303426}[condition] * DEG
    found = table_derivatives(model, ref.V, ref.alpha, Surfaces(elevator), ref.mach)
    np.testing.assert_allclose(found, fc.coefficients, rtol=2e-5, atol=1e-7)


def test_beyond_its_ends_a_table_is_held() -> None:
    shot = {name: float(text) for name, text in AERO[0].items() if name != "shot"}
    model = aero(0.35)
    inside, held = flow_of(shot)
    edge = term_loads(model, inside._replace(alpha=45.0 * DEG), held)
    assert term_loads(model, inside._replace(alpha=50.0 * DEG), held) == edge
    assert edge != term_loads(model, inside._replace(alpha=44.0 * DEG), held)


def test_where_tables_end() -> None:
    found = {name: (low / DEG, high / DEG) for name, (low, high) in ends(aero(0.35)).items()}
    assert found == {
        "alpha": pytest.approx((-10.0, 45.0)),
        "beta": pytest.approx((-30.0, 30.0)),
        "elevator": pytest.approx((-24.0, 24.0)),
    }
