"""NASA's check cases: the errors that are demanded, on the points that travel with FDES."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from fdes.analysis.check_cases import Comparison, check_case, check_cases
from fdes.errors import SpecError
from fdes.flight.scenario import Scenario, fly_scenario, load_scenario, scenario_names

FOUND = check_cases()


@pytest.mark.parametrize("c", FOUND, ids=lambda c: f"{c.scenario} {c.simulation} {c.column}")
def test_check_case(c: Comparison) -> None:
    assert c.passed, f"{c.error:.2e}, allowed {c.tolerance:.0e}"


def test_every_scenario_is_compared() -> None:
    assert {c.scenario for c in FOUND} == set(scenario_names())
    assert all(len(c.t) == 6 for c in FOUND)


def test_a_wrong_constant_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another GM, by one part in ten million: that of the workbook, which does not belong to the curves."""

    def wrong(name: str) -> Scenario:
        found = load_scenario(name)
        earth = found.plant.earth._replace(GM=1.407644311e16 * 0.3048**3)
        return replace(found, plant=found.plant._replace(earth=earth))

    monkeypatch.setattr("fdes.analysis.check_cases.load_scenario", wrong)
    assert not any(c.passed for c in check_case("nesc_01_dropped_sphere"))


def test_a_folder_without_curves_is_said(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match=r"sim_04\.csv is not there\. Name the folder that holds Atmos_01"):
        check_cases(tmp_path)


def test_the_damped_brick_against_equations_of_another_form() -> None:
    """Principal axes, no translation but free fall, rates relative to the Earth: solved by SciPy to 1e-12."""
    scenario = load_scenario("nesc_03_tumbling_brick_damped")
    flight = fly_scenario(scenario)
    body, aero, omega = scenario.plant.inertia, scenario.plant.aero, scenario.plant.earth.Omega
    t, V, rho = flight["t"], flight["V"], 2.0 * flight["qbar"] / np.maximum(flight["V"], 1e-9) ** 2
    rho[0] = 2.0 * rho[1] - rho[2]

    def euler(time: float, s: np.ndarray) -> np.ndarray:
        e0, e1, e2, e3, p, q, r = s
        speed, density = np.interp(time, t, V), np.interp(time, t, rho)
        # The Earth's axis, which is north here, where latitude and longitude stay next to zero, in body axes.
        north = np.array([e0**2 + e1**2 - e2**2 - e3**2, 2.0 * (e1 * e2 - e0 * e3), 2.0 * (e1 * e3 + e0 * e2)])
        a, b, c = np.array([p, q, r]) - omega * north
        k = 0.25 * density * max(speed, 0.1524) * aero.S
        L, M, N = k * aero.b**2 * aero.Cl_p * a, k * aero.c**2 * aero.Cm_q * b, k * aero.b**2 * aero.Cn_r * c
        return np.array([
            0.5 * (-e1 * a - e2 * b - e3 * c),
            0.5 * (e0 * a + e2 * c - e3 * b),
            0.5 * (e0 * b - e1 * c + e3 * a),
            0.5 * (e0 * c + e1 * b - e2 * a),
            (L + (body.Iy - body.Iz) * q * r) / body.Ix,
            (M + (body.Iz - body.Ix) * p * r) / body.Iy,
            (N + (body.Ix - body.Iy) * p * q) / body.Iz,
        ])  # fmt: skip

    start = [1.0, 0.0, 0.0, 0.0, *np.radians([10.0, 20.0, 30.0])]
    end = solve_ivp(euler, (0.0, 30.0), start, method="DOP853", rtol=1e-11, atol=1e-13, max_step=0.1).y[:, -1]
    # The air data of the flight are interpolated over 0.1 s, which is worth some 1e-5 rad/s.
    assert flight["p"][-1] == pytest.approx(end[4], abs=1e-6)
    assert flight["theta"][-1] == pytest.approx(math.asin(2.0 * (end[0] * end[2] - end[1] * end[3])), abs=2e-5)
