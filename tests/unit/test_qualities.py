"""Flying qualities of aircraft: edited ones, split and merged modes, what improves them, and how long it takes."""

import json
import math
import subprocess
import sys
import time
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.aircraft.edit import edited
from fdes.aircraft.role import STRICTEST, Role, role_of
from fdes.analysis import linear_model, modes
from fdes.analysis.closed_loop import close, with_actuators
from fdes.analysis.design import law_for
from fdes.analysis.drawing import to_plotly
from fdes.analysis.improvement import Adjustable, adjustables, gains, improvements, unreachable
from fdes.analysis.measured import Measured, measure, n_alpha, phi_beta
from fdes.analysis.qualities import assess, charts, judge
from fdes.analysis.quality_charts import as_drawing, spaced
from fdes.analysis.verdict import WORSE, Verdict
from fdes.control import Law, LinearModel
from fdes.errors import NoSuchPart, SpecError
from fdes.physics.actuators import Actuator, Actuators

A4D = load("A-4D").at("M0.4_SL")
IV_A = Role("IV", "A", None, "as in the acceptance test")
SHORT_PERIOD = "mil_f_8785c_short_period"


def short_period(*changes: str) -> Verdict:
    (only,) = assess(edited(A4D, changes), IV_A, criteria=[SHORT_PERIOD])
    return only


@pytest.mark.parametrize(("factor", "zeta", "level"), [(1.0, 0.36, 1), (0.5, 0.28, 2), (0.0, 0.195, 3)])
def test_pitch_damping_takes_the_short_period_through_the_levels(factor: float, zeta: float, level: int) -> None:
    found = short_period(f"Cm_q*={factor}")
    assert found.level == level
    assert found.value == pytest.approx(zeta, abs=0.005)
    assert found.reason.startswith("Damping governs")


def test_pitch_stiffness_takes_cap_through_the_levels_and_the_mode_changes_its_name() -> None:
    caps, levels = [], []
    for k in range(41):
        found = short_period(f"Cm_alpha*={1.0 - k / 40}")
        (cap,) = (part for part in found.parts if part.requirement.startswith("CAP"))
        caps.append(cap.value or 0.0)
        levels.append(cap.level)
    assert caps == sorted(caps, reverse=True)
    assert [level for k, level in enumerate(levels) if level != levels[k - 1] or k == 0] == [1, 2, 4]
    named = [mode.name for mode in modes(edited(A4D, ["Cm_alpha=0"]))]
    assert "short_period" not in named
    assert "short_period_fast" in named
    assert "split into two real roots" in short_period("Cm_alpha=0").reason


def test_a_short_period_with_an_unstable_root_is_worse_than_level_3() -> None:
    model = _with_roots((-2.0, 0.5), (-0.01 + 0.1j, -0.01 - 0.1j))
    named = {mode.name for mode in modes(model)}
    assert {"short_period_fast", "short_period_slow"} <= named
    (found,) = assess(model, IV_A, criteria=[SHORT_PERIOD])
    assert found.level == 4
    assert found.value is not None
    assert found.value < 0.0
    assert found.unit == "1/(g s^2)"
    assert "two real roots, -2 and 0.5 1/s. That of 0.5 grows: it doubles in 1.39 s" in found.reason
    assert "omega_sp^2 = -1 (rad/s)^2, the product of its roots" in found.reason
    assert "omega_sp -" not in found.reason
    (phugoid,) = assess(model, IV_A, criteria=["mil_f_8785c_phugoid"])
    assert phugoid.value == pytest.approx(math.log(2.0) / 0.5)
    assert phugoid.level == 4


def _with_roots(fast: tuple[complex, complex], slow: tuple[complex, complex]) -> LinearModel:
    """The A-4D with a short period and a phugoid that have these roots and nothing to do with each other."""
    model = linear_model(A4D)
    A = model.A.copy()
    A[:4, :4] = 0.0
    index = {name: k for k, name in enumerate(model.states)}

    def put(first: str, second: str, roots: tuple[complex, complex]) -> None:
        total, product = sum(roots).real, (roots[0] * roots[1]).real
        A[index[first], index[second]] = 1.0
        A[index[second], index[first]] = -product
        A[index[second], index[second]] = total

    put("w", "q", fast)
    put("u", "theta", slow)
    return LinearModel(A, model.B, model.states, model.inputs, model.units, model.point)


def test_a_phugoid_that_has_merged_is_judged_as_the_third_oscillation() -> None:
    merged = edited(A4D, ["Cm_alpha=0.02"])
    named = {mode.name for mode in modes(merged)}
    assert "third_oscillatory" in named
    first, second, *_ = assess(merged, IV_A)
    assert first.level == WORSE
    assert "merged with the phugoid; at constant speed its roots are -2.12 and -0.221 1/s. Frequency" in first.reason
    assert "third oscillation, which is judged here" in second.reason


def test_a_short_period_that_merges_is_not_lost_between_two_that_are_judged() -> None:
    """Stiffness goes from too little over none to less than none: nowhere is the aircraft without a verdict."""
    caps = []
    for Cm_alpha in (-0.05, 0.0, 0.01, 0.02, 0.03, 0.05):
        short_period, *_ = assess(edited(A4D, [f"Cm_alpha={Cm_alpha}"]), IV_A)
        assert short_period.level == WORSE or Cm_alpha < 0.0
        caps.append(float(short_period.value or 0.0))
    assert caps == sorted(caps, reverse=True)
    neutral, *_ = assess(edited(A4D, ["Cm_q=0", "Cm_alpha=0"]), IV_A)
    assert (neutral.level, neutral.value) == (WORSE, pytest.approx(0.0, abs=1e-9))
    assert "CAP is 0.00 1/(g s^2), from omega_sp^2 = 0 (rad/s)^2" in neutral.reason


def test_with_an_actuator_a_merged_short_period_is_missing_and_told() -> None:
    bare = linear_model(edited(A4D, ["Cm_alpha=0.02"]))
    moved = with_actuators(bare, Actuators(*(Actuator(bandwidth=20.0) for _ in Actuators._fields)))
    short_period, *_ = assess(moved, IV_A)
    assert short_period.level is None
    assert "third oscillatory" in short_period.reason


@pytest.mark.parametrize(
    ("Cn_beta", "level", "said"),
    [
        (0.01, 2, "Dutch roll and spiral have merged in one oscillation, which is judged here. Damping governs"),
        (-0.01, WORSE, "zeta_dr is -0.383"),
        (-0.05, WORSE, "Half of the dutch roll has merged with the roll, the other half, 0.97 1/s, grows"),
    ],
)
def test_a_dutch_roll_that_has_merged_is_judged_all_the_same(Cn_beta: float, level: int, said: str) -> None:
    verdicts = {v.mode: v for v in assess(edited(A4D, [f"Cn_beta={Cn_beta}"]), IV_A)}
    assert verdicts["dutch_roll"].level == level
    assert said in verdicts["dutch_roll"].reason


def test_what_a_mode_has_become_part_of_is_told_with_its_growth() -> None:
    verdicts = {v.mode: v for v in assess(edited(A4D, ["Cn_beta=0"]), IV_A)}
    assert verdicts["roll"].reason.endswith("part of another mode (roll dutch roll).")
    assert verdicts["spiral"].reason.endswith("(spiral dutch roll, unstable: it doubles in 6.13 s).")
    assert verdicts["roll_spiral"].reason == "Roll and spiral do not form a mode together."


def test_overdamped_modes_keep_their_frequency_and_damping() -> None:
    split = measure(_with_roots((-2.0, -0.5), (-0.3, -0.1)))
    assert split.omega_sp == pytest.approx(1.0)
    assert split.zeta_sp == pytest.approx(1.25)
    assert split.zeta_ph == pytest.approx(0.4 / (2.0 * math.sqrt(0.03)))


def test_n_alpha_is_that_of_a_steady_pull_up() -> None:
    """Solved again as a balance of lift and pitching moment: two equations, the elevator unknown."""
    model = linear_model(A4D)
    A, B = model.A[1:3, 1:3], model.B[1:3, 0]
    V, g = model.point["V"], model.point["g"]
    w = 1.0
    q, _ = np.linalg.solve(np.column_stack([A[:, 1], B]), -A[:, 0] * w)
    assert n_alpha(model) == pytest.approx((V * q / g) / (w / V))
    approximate = A4D.coefficients.CL_alpha / A4D.coefficients.CL
    assert n_alpha(model) == pytest.approx(approximate, rel=0.15)


@pytest.mark.parametrize("state", ["w", "q"])
def test_feedback_to_the_elevator_leaves_n_alpha(state: str) -> None:
    model = linear_model(A4D)
    gain = np.zeros((4, 8))
    gain[0, model.states.index(state)] = 0.7 if state == "q" else 0.002
    closed = LinearModel(model.A + model.B @ gain, model.B, model.states, model.inputs, model.units, model.point)
    assert n_alpha(closed) == pytest.approx(n_alpha(model), rel=1e-12)
    assert measure(closed).zeta_sp != pytest.approx(measure(model).zeta_sp, rel=0.01)


@pytest.mark.parametrize("actuated", [False, True])
def test_a_sampled_model_and_one_with_actuators_are_measured_as_well(actuated: bool) -> None:
    """At 120 frames a second sampling moves no verdict; half a frame and the actuator's lag are the delay."""
    bare = linear_model(A4D)
    plant = (
        with_actuators(bare, Actuators(*(Actuator(bandwidth=20.0) for _ in Actuators._fields))) if actuated else bare
    )
    sampled = plant.held(1.0 / 120.0)
    here, there = measure(bare), measure(sampled)
    for name in ("omega_sp", "zeta_sp", "zeta_ph", "omega_dr", "zeta_dr", "phi_beta", "tau_roll", "t2_spiral"):
        assert getattr(there, name) == pytest.approx(getattr(here, name), rel=1e-6), name
    assert n_alpha(sampled) == pytest.approx(n_alpha(bare), rel=0.02)
    assert n_alpha(plant) == pytest.approx(n_alpha(bare), rel=1e-12)
    assert measure(sampled, airframe=bare).n_alpha == n_alpha(bare)
    assert here.delay is None
    assert there.delay == pytest.approx(1.0 / 240.0 + (0.05 if actuated else 0.0), rel=1e-6)
    assert measure(plant).delay == (pytest.approx(0.05) if actuated else None)


def test_without_an_elevator_n_alpha_is_the_lift_slope() -> None:
    model = linear_model(A4D).part(("u", "w", "q", "theta"), ("throttle",))
    assert n_alpha(model) == pytest.approx(-model.A[1, 1] * model.point["V"] / model.point["g"])


def test_phi_over_beta_is_that_of_the_eigenvector() -> None:
    """From the first equation of motion alone: beta_dot = A beta, with p = s phi and r eliminated by the third."""
    model = linear_model(A4D)
    s = next(mode.eigenvalue for mode in modes(model) if mode.name == "dutch_roll")
    A = model.lateral().A
    # Rows of p and phi with beta = 1: unknowns p, r, phi.
    M = np.array([A[k, 1:] - s * np.eye(4)[k, 1:] for k in (0, 1, 3)])
    _, _, phi = np.linalg.solve(M, -np.array([A[0, 0] - s, A[1, 0], 0.0]))
    assert phi_beta(model, s) == pytest.approx(abs(phi))


def test_a_verdict_in_words_and_in_json() -> None:
    found = short_period()
    assert str(found).startswith("short period: Level 1, margin +2%. Damping governs: zeta_sp is 0.357: Level 1.")
    assert str(found).endswith("[MIL-F-8785C, paragraph 3.2.2.1.2, table IV, page 13]")
    assert json.loads(json.dumps(found.as_dict()))["level"] == 1


def test_assessing_is_quick_enough_for_a_live_edit() -> None:
    model = linear_model(A4D)
    assess(model, IV_A)
    times = []
    for _ in range(20):
        start = time.process_time()
        assess(model, IV_A)
        times.append(time.process_time() - start)
    assert sorted(times)[10] < 0.005


def test_what_the_cockpit_imports_stays_light() -> None:
    code = "import sys; from fdes.analysis.qualities import chosen; import fdes.analysis.improvement; chosen(); "
    run = subprocess.run(
        [sys.executable, "-c", code + "print(*sys.modules)"], capture_output=True, text=True, check=True
    )
    assert not {"scipy", "xarray", "matplotlib", "plotly", "numba"} & set(run.stdout.split())


def test_an_unknown_criterion_is_named() -> None:
    with pytest.raises(NoSuchPart, match=r"no criterion named .* Did you mean 'mil_f_8785c_roll_mode'\?"):
        assess(A4D, criteria=["mil_f_8785c_rol_mode"])


@pytest.mark.parametrize(
    ("changes", "name", "wanted"),
    [(["Cm_q*=0.5"], "Cm_q", -3.44), (["Cm_q=0"], "Cm_q", -1.18), (["Cm_alpha*=0.05"], "Cm_alpha", None)],
)
def test_an_improvement_is_the_nearest_and_reaches_what_it_says(
    changes: list[str], name: str, wanted: float | None
) -> None:
    slack = edited(A4D, changes)
    verdict = assess(slack, IV_A, criteria=[SHORT_PERIOD])[0]
    found = {i.name: i for i in improvements(verdict, adjustables(slack, "short_period"), IV_A)}
    best = found[name]
    assert wanted is None or best.wanted == pytest.approx(wanted, abs=0.01)
    assert verdict.level is not None
    assert best.level < verdict.level

    def level(value: float) -> Any:
        return assess(edited(slack, [f"{name}={value}"]), IV_A, criteria=[SHORT_PERIOD])[0].level

    assert level(best.wanted) == best.level
    assert level(best.value + 0.98 * (best.wanted - best.value)) == verdict.level
    assert f"reaches Level {best.level}" in str(best)
    json.dumps(best.as_dict(), allow_nan=False)


def test_the_sensitivity_is_the_slope() -> None:
    slack = edited(A4D, ["Cm_q*=0.5"])
    verdict = assess(slack, IV_A, criteria=[SHORT_PERIOD])[0]
    found = next(i for i in improvements(verdict, adjustables(slack, "short_period"), IV_A) if i.name == "Cm_q")
    (more,) = assess(edited(slack, ["Cm_q*=1.001"]), IV_A, criteria=[SHORT_PERIOD])
    assert verdict.value is not None
    assert more.value is not None
    assert found.sensitivity == pytest.approx((more.value / verdict.value - 1.0) / 0.001, rel=1e-2)


def test_a_gain_is_a_candidate_like_a_derivative() -> None:
    model = linear_model(edited(A4D, ["Cm_q=0"]))

    def closed(gain: float) -> LinearModel:
        feedback = np.zeros((4, 8))
        feedback[0, model.states.index("q")] = gain
        return LinearModel(model.A + model.B @ feedback, model.B, model.states, model.inputs, model.units, model.point)

    verdict = assess(model, IV_A, criteria=[SHORT_PERIOD])[0]
    gain = Adjustable("gain", "s", 0.0, 0.0, 2.0, closed)
    (found,) = improvements(verdict, [gain], IV_A)
    assert found.level == 2
    assert found.sensitivity is None
    assert assess(closed(found.wanted), IV_A, criteria=[SHORT_PERIOD])[0].level == 2


def test_the_gain_of_a_law_is_a_candidate() -> None:
    """The yaw damper of the A-4D at half the gain that Level 1 takes; only its own gain is turned, not the other's."""
    designed = law_for("pitch_rate_damper gain=0.1; yaw_damper gain=0.05", A4D)

    def model(law: Law) -> LinearModel:
        return close(A4D, law)

    loop = model(designed.law)
    verdict = next(v for v in assess(loop, IV_A, airframe=linear_model(A4D)) if v.mode == "dutch_roll")
    assert verdict.level == 2
    candidates = gains(designed, model)
    assert {c.name for c in candidates} == {"pitch_rate_damper gain", "yaw_damper gain"}
    (found,) = improvements(verdict, candidates, IV_A)
    assert (found.name, found.level) == ("yaw_damper gain", 1)
    again = close(A4D, law_for(f"pitch_rate_damper gain=0.1; yaw_damper gain={found.wanted}", A4D).law)
    assert next(v.level for v in assess(again, IV_A) if v.mode == "dutch_roll") == 1


def test_nothing_is_promised_that_cannot_be_had() -> None:
    fc = load("A-4D").at("M0.8_35kft")
    verdict = next(v for v in assess(fc, IV_A) if v.mode == "dutch_roll")
    candidates = adjustables(fc, "dutch_roll")
    assert improvements(verdict, candidates, IV_A) == []
    assert unreachable(verdict, candidates).startswith("None of Cy_beta, Cl_beta, Cn_beta, Cn_p, Cn_r alone reaches")
    roll = next(v for v in assess(A4D, IV_A) if v.mode == "roll")
    assert (roll.level, improvements(roll, adjustables(A4D, "roll"), IV_A)) == (1, [])
    assert unreachable(roll, []) == ""


def test_what_an_improvement_costs_is_said() -> None:
    fc = load("F-104A").at("M1.8_55kft")
    verdict = assess(fc, IV_A)[0]
    costly = [i for i in improvements(verdict, adjustables(fc, "short_period"), IV_A) if i.costs]
    assert costly
    assert "falls to Level" in str(costly[0])


def test_an_aircraft_with_dimensional_derivatives_is_improved_by_those() -> None:
    fc = load("B747_Etkin").at()
    role = role_of(fc.document, fc.condition)
    verdict = next(v for v in assess(fc) if v.mode == "dutch_roll")
    assert verdict.level == 3
    names = {i.name for i in improvements(verdict, adjustables(fc, "dutch_roll"), role)}
    assert "N_r" in names


def test_the_role_is_the_files_then_the_defaults() -> None:
    assert role_of(A4D.document, "M0.4_SL").airplane_class == "IV"
    approach = role_of(load("B747").document, "M0.25_SL")
    assert (approach.airplane_class, approach.category, approach.phase) == ("III", "C", "PA")
    cruise = role_of(load("B747").document, "M0.90_40kft")
    assert (cruise.airplane_class, cruise.category, cruise.phase) == ("III", "B", "CR")
    assert role_of({}, "any") == STRICTEST
    assert str(approach) == "Class III, Category C, Flight Phase PA (power approach)"


def test_a_role_can_be_changed() -> None:
    role = role_of(load("B747").document, "M0.90_40kft")
    assert role.but(phase="pa").category == "C"
    assert role.but(category="A").phase is None
    assert role.but(category="b").phase == "CR"
    assert role.but("ii").airplane_class == "II-L"
    assert role.but("IV-C").airplane_class == "IV"
    assert "III as asked for" in role.but("III").reason
    with pytest.raises(
        SpecError, match=r"Flight Phase CO \(air-to-air combat\) belongs to Category A, not to Category C"
    ):
        role.but(category="C", phase="CO")


@pytest.mark.parametrize("word", [{"airplane_class": "V"}, {"category": "D"}, {"phase": "XX"}])
def test_an_unknown_word_of_the_specification_is_refused(word: dict[str, str]) -> None:
    with pytest.raises(NoSuchPart, match="of MIL-F-8785C named"):
        STRICTEST.but(**word)


@pytest.mark.parametrize("category", ["A", "B", "C"])
def test_the_boundaries_of_the_charts_are_where_the_level_changes(category: str) -> None:
    """Each line of constant CAP is stepped across; the verdict must change there."""
    role = Role("III", "A", None, "").but(category=category)
    figure, plane = charts(Measured(omega_sp=2.0, n_alpha=10.0, zeta_sp=0.7), role, [SHORT_PERIOD])

    def level(omega: float, n: float) -> Any:
        return assess_numbers(Measured(omega_sp=omega, n_alpha=n, zeta_sp=0.7), role)

    for line in figure.boundaries:
        for n, omega in zip(line.x[2:], line.y[2:], strict=True):
            outside, inside = level(omega * 0.999, n), level(omega * 1.001, n)
            if line.label.endswith("upper"):
                outside, inside = inside, outside
            assert inside <= line.level < outside, (line.label, n, omega)
    assert figure.point == (10.0, 2.0)
    assert plane.point == (0.7, pytest.approx(0.4))


def assess_numbers(measured: Measured, role: Role) -> Any:
    return judge(measured, role, [SHORT_PERIOD])[0].level


def test_charts_become_drawings() -> None:
    drawing = as_drawing(charts(measure(linear_model(A4D)), IV_A), "A-4D")
    assert [panel.title.splitlines()[0] for panel in drawing.panels] == [
        "Short-period frequency",
        "Short-period damping and CAP",
        "Dutch roll",
    ]
    assert drawing.panels[0].x_log
    figure = to_plotly(drawing)
    (note, *_) = (a for a in figure.layout.annotations if a.text == "Level 1")
    assert (10.0**note.x, 10.0**note.y) == pytest.approx(charts(measure(linear_model(A4D)), IV_A)[0].point)
    with pytest.raises(SpecError, match="has a chart"):
        as_drawing([], "nothing")


def test_spaced_keeps_its_ends() -> None:
    found = spaced(1.0, 100.0, 5)
    assert found[0] == 1.0
    assert found[-1] == 100.0
    assert found[2] == pytest.approx(10.0)


@pytest.mark.parametrize("name", ["u", "w"])
def test_numbers_are_those_of_the_model_not_of_the_file(name: str) -> None:
    """A model of its own gets its own verdicts: the role alone comes from outside."""
    model = linear_model(A4D)
    A = model.A.copy()
    A[model.states.index(name), model.states.index(name)] *= 1.5
    changed = LinearModel(A, model.B, model.states, model.inputs, model.units, model.point)
    before, after = measure(model), measure(changed)
    assert (before.zeta_sp, before.zeta_ph) != (after.zeta_sp, after.zeta_ph)


def test_delay_is_judged_where_it_is_known() -> None:
    (verdict,) = assess(A4D, IV_A, delay=0.15, criteria=["mil_f_8785c_response_delay"])
    assert verdict.level == 2
