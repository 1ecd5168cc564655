"""Dimensional derivatives: the transformation to stability axes changes no eigenvalue, and both kinds of file agree."""

import copy
import tomllib
from dataclasses import replace
from importlib.resources import files
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import FlightCondition, load, parse
from fdes.analysis import linear_model, modes
from fdes.analysis.approximations import approximate_modes, static_figures
from fdes.errors import AircraftFileError, SpecError
from fdes.flight import plant_of
from fdes.physics.published_axes import AxesDerivatives, stability_axis_matrices
from fdes.units import DEG, FOOT

HANGAR = files("fdes.aircraft") / "hangar"


def document(name: str) -> dict[str, Any]:
    return tomllib.loads((HANGAR / f"{name}.toml").read_text("utf-8"))


def by_name(condition: FlightCondition) -> dict[str, complex]:
    return {mode.name: mode.eigenvalue for mode in modes(condition)}


@pytest.mark.parametrize(("name", "k"), [("a7a", 0), ("b747cr2144", 0), ("b747cr2144", 4), ("nt33a", 1)])
def test_body_axis_equations_keep_their_eigenvalues(name: str, k: int) -> None:
    """Written out once more in body axes, in ft and s, by numpy: McRuer et al., eq. 4-44 to 4-49."""
    said = document(name)["conditions"][k]
    d = dict.fromkeys(("Z_wdot", "Z_q"), 0.0) | said["dimensional"]
    V, g, alpha = said["speed"]["printed"], said["gravity"]["printed"], said["trim_alpha"]["printed"] * DEG
    U, W, gx, gz = V * np.cos(alpha), V * np.sin(alpha), g * np.cos(alpha), g * np.sin(alpha)
    u = np.array([d["X_u"], d["X_w"], -W, -gx])
    w = np.array([d["Z_u"], d["Z_w"], U + d["Z_q"], -gz]) / (1.0 - d["Z_wdot"])
    q = np.array([d["M_u"], d["M_w"], d["M_q"], 0.0]) + d["M_wdot"] * w
    lon = np.array([u, w, q, [0.0, 0.0, 1.0, 0.0]])
    beta = [d["Y_v"], W / V, -U / V, gx / V]
    p, r = ([d[f"{n}_beta"], d[f"{n}_p"], d[f"{n}_r"], 0.0] for n in "LN")
    lat = np.array([beta, p, r, [0.0, 1.0, np.tan(alpha), 0.0]])
    model = linear_model(load(name).at(said["id"]))
    for written, ours in ((lon, model.longitudinal()), (lat, model.lateral())):
        expected, found = (np.sort_complex(np.linalg.eigvals(A)) for A in (written, ours.A))
        np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_in_stability_axes_bank_is_the_integral_of_the_roll_rate() -> None:
    A_lon, _, A_lat, _ = load("A-7A").at().equations("full")
    assert A_lat[3] == pytest.approx((0.0, 1.0, 0.0, 0.0), abs=1e-12)
    assert A_lat[0][1] == pytest.approx(0.0, abs=1e-12)  # no W0 p
    assert A_lat[0][2] == pytest.approx(-1.0)
    assert A_lon[0][2] == pytest.approx(0.0, abs=1e-9)  # no -W0 q


def test_a_climb_turns_gravity_too() -> None:
    """Without derivatives there is kinematics alone, and it is the same from any axes."""
    gamma = 0.2
    for straight, turned in zip(
        stability_axis_matrices(AxesDerivatives(), 50.0, 9.8, 0.0, gamma, 1.0),
        stability_axis_matrices(AxesDerivatives(), 50.0, 9.8, 0.3, gamma, 1.0),
        strict=True,
    ):
        np.testing.assert_allclose(turned, straight, atol=1e-12)


def test_coefficients_and_dimensional_derivatives_of_one_report_agree() -> None:
    table, dimensional = (by_name(load("NT-33A").at(c)) for c in ("FC1", "FC1_dimensional"))
    for name, value in table.items():
        assert dimensional[name] == pytest.approx(value, rel=0.03), name


def test_the_747_by_three_sources() -> None:
    """Etkin and Reid's cruise is flight condition 9 of the report; one is unprimed SI, the other primed feet."""
    etkin, report = by_name(load("B747_Etkin").at()), by_name(load("B747_CR2144_FC9").at())
    for name, value in etkin.items():
        assert report[name] == pytest.approx(value, rel=0.02), name


def test_controls_of_both_sources_agree() -> None:
    """Elevator, aileron and rudder from nondimensional control derivatives, against the report's dimensional ones."""
    (_, B, _, B_lat), (_, C, _, C_lat) = (load(n).at().equations("full") for n in ("B747_Etkin", "B747_CR2144_FC9"))
    assert B[2][0] == pytest.approx(C[2][0], rel=0.05)  # M_de
    assert B[1][0] == pytest.approx(C[1][0], rel=0.05)  # Z_de
    assert B_lat[1][0] == pytest.approx(C_lat[1][0], rel=0.05)  # L_da
    assert B_lat[2][1] == pytest.approx(C_lat[2][1], rel=0.05)  # N_dr


def test_the_plant_flies_the_same_matrices() -> None:
    condition = load("A-7A").at()
    assert plant_of(condition).matrices == condition.equations("full")


@pytest.mark.parametrize("form", ["paper", "nelson"])
def test_other_forms_do_not_apply(form: Any) -> None:
    with pytest.raises(SpecError, match=rf"Form '{form}' does not apply to A-7A FC1: .* Use form 'full'\."):
        modes(load("A-7A").at(), form)


@pytest.mark.parametrize("ask", [approximate_modes, static_figures])
def test_what_is_made_of_coefficients_does_not_apply(ask: Any) -> None:
    with pytest.raises(SpecError, match="A-7A FC1 has no nondimensional derivatives"):
        ask(load("A-7A").at())


def test_numbers_are_kept_as_printed_and_used_in_si() -> None:
    condition = load("B747_CR2144").at("FC2")
    moment = condition.provenance["M_u"]
    assert (moment.printed, moment.unit, moment.si_unit) == (0.000181, "1/(ft s)", "1/(m s)")
    assert moment.value == pytest.approx(0.000181 / FOOT)
    assert (condition.reference.m, load("B747_CR2144").at("FC3").reference.m) == pytest.approx((255840.6, 288773.2))


def test_unknown_geometry_is_said_and_not_needed() -> None:
    condition = load("A-7A").at()
    assert "Not given, and not needed: S, b, c, Ix, Iy, Iz, Ixz." in condition.notes
    assert condition.reference.S == 0.0


def test_a_condition_may_be_named_with_its_aircraft() -> None:
    assert load("B747_CR2144_FC9").at().condition == "FC9"
    assert load("b747 cr2144 fc9").id == "B747_CR2144"
    assert load("B747_CR2144").at().condition == "FC1"


def test_trim_alpha_turns_body_axes_only() -> None:
    """Etkin's derivatives are in stability axes: an angle of attack would change nothing but what is displayed."""
    changed = document("b747etkin")
    changed["conditions"][0]["trim_alpha"] = {"printed": 4.6, "unit": "deg"}
    assert parse(changed, "x").at().equations("full") == load("B747_Etkin").at().equations("full")
    changed = document("a7a")
    changed["conditions"][0]["trim_alpha"]["printed"] = 5.0
    assert parse(changed, "x").at().equations("full") != load("A-7A").at().equations("full")


def _edit(**changes: Any) -> dict[str, Any]:
    changed = document("a7a")
    table = changed["conditions"][0]["dimensional"]
    for name, value in changes.items():
        if value is None:
            del table[name]
        else:
            table[name] = value
    return changed


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (_edit(axes="wind"), "dimensional.axes of condition 'FC1' is 'wind'; it must be 'body' or 'stability'."),
        (_edit(lateral=None), "dimensional.lateral of condition 'FC1' is missing."),
        (_edit(M_qq=-1.0), "dimensional.M_qq of condition 'FC1' is not a known key. Did you mean 'M_q'?"),
        (_edit(L_beta=None), "dimensional of condition 'FC1' needs L_beta or L_v, one of the two."),
        (_edit(L_v=-0.04), "dimensional of condition 'FC1' needs L_beta or L_v, one of the two."),
        (_edit(M_de=None, N_dr=None), "lacks M_de, N_dr: give them, or nondimensional ones under controls."),
        (_edit(M_q={"printed": -0.466, "unit": "1/s"}), "M_q of condition 'FC1' has a unit of its own, '1/s'"),
        (_edit(lateral="unprimed"), "mass.Ix is missing, and condition 'FC1' needs it."),
        (_edit(L_da=-5.34), "L_da is -5.34 1/s^2 by the file's aileron_sense, but positive aileron must roll right."),
    ],
)
def test_mistakes_in_the_table_are_explained(changed: dict[str, Any], said: str) -> None:
    with pytest.raises(AircraftFileError) as mistake:
        parse(changed, "a7a.toml")
    assert said in str(mistake.value)


@pytest.mark.parametrize("kinds", ["neither", "both"])
def test_a_condition_has_one_kind_of_derivatives(kinds: str) -> None:
    changed = document("nt33a")
    first, second = changed["conditions"]
    if kinds == "neither":
        del first["derivatives"]
    else:
        first["dimensional"] = copy.deepcopy(second["dimensional"])
    with pytest.raises(AircraftFileError, match=rf"condition 'FC1' has {kinds} of \[conditions.derivatives\]"):
        parse(changed, "x")


def test_body_axes_need_the_trim_angle_of_attack() -> None:
    changed = document("a7a")
    del changed["conditions"][0]["trim_alpha"]
    with pytest.raises(AircraftFileError, match="condition 'FC1' lacks trim_alpha: without it, derivatives in body"):
        parse(changed, "x")
    assert any("shown as if it were zero" in note for note in load("B747_Etkin").at().notes)


def test_a_lost_assumption_or_geometry_is_missed() -> None:
    changed = document("a7a")
    del changed["conditions"][0]["assumed"]["drag"]
    with pytest.raises(AircraftFileError, match="lacks 'drag', and condition 'FC1' does not give its own"):
        parse(changed, "x")
    changed = document("b747etkin")
    del changed["geometry"]
    with pytest.raises(AircraftFileError, match=r"geometry\.S is missing, and condition 'M0\.8_40kft' needs it"):
        parse(changed, "x")


def test_unprimed_derivatives_are_primed_by_the_inertias() -> None:
    condition = load("B747_Etkin").at()
    ref = condition.reference
    L_p, N_p = -1.076e7, -1.33e6
    p_dot, r_dot = np.linalg.solve([[ref.Ix, -ref.Ixz], [-ref.Ixz, ref.Iz]], [L_p, N_p])
    _, _, A_lat, _ = condition.equations("full")
    assert (A_lat[1][1], A_lat[2][1]) == pytest.approx((p_dot, r_dot))


def test_no_check_rule_of_coefficients_stumbles_over_them() -> None:
    from fdes.aircraft.check import findings

    condition = load("A-7A").at()
    assert findings(condition) == []
    wrong = replace(
        condition, provenance={**condition.provenance, "N_beta": replace(condition.provenance["N_beta"], value=-1.28)}
    )
    (finding,) = findings(wrong)
    assert (finding.rule, finding.what) == ("sign_Cn_beta", "N_beta is -1.28 1/s^2; it must be greater than 0.")
