"""`fdes qualities`: Levels of flying qualities, of an aircraft or of numbers that are known from elsewhere."""

import math
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fdes.cli.law import show_notes
from fdes.cli.options import (
    AsJson,
    Changes,
    ConditionName,
    FormName,
    LawText,
    OnActuators,
    PlotFile,
    Sampled,
    VariantName,
    chosen,
    designed_law,
    form_of_equations,
    frame_of,
)
from fdes.cli.output import about, heading, number, print_json, screen, table
from fdes.errors import SpecError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from rich.table import Table

    from fdes.aircraft import FlightCondition
    from fdes.aircraft.role import Role
    from fdes.analysis.improvement import Improvement
    from fdes.analysis.measured import Measured
    from fdes.analysis.verdict import Verdict
    from fdes.control import Law, LinearModel

LARGEST_SHOWN = 9.995  # of a margin: beyond, it only says that the limit is far away
FIELDS = "What is measured"  # the panel of --help

Aircraft = Annotated[
    str | None,
    typer.Argument(metavar="[AIRCRAFT]", help="A name or the path of a TOML file; none to judge numbers of your own."),
]
ClassName = Annotated[
    str | None, typer.Option("--class", metavar="I|II-L|II-C|III|IV", help="The Class; else the aircraft's, or IV.")
]
CategoryName = Annotated[
    str | None, typer.Option(metavar="A|B|C", help="The Flight Phase Category; else the aircraft's, or A.")
]
PhaseName = Annotated[str | None, typer.Option(metavar="CODE", help="The Flight Phase, such as CO, GA, CR or PA.")]
CriterionName = Annotated[
    str | None, typer.Option(metavar="NAME", help="One criterion; `fdes shelves` has their names. Else all.")
]


def _measured(flag: str, metavar: str, help_: str) -> Any:
    return typer.Option(flag, metavar=metavar, help=help_, rich_help_panel=FIELDS)


def qualities(
    aircraft: Aircraft = None,
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    form: FormName = "full",
    changes: Changes = None,
    law: LawText = None,
    actuators: OnActuators = False,
    sampled: Sampled = None,
    flying_class: ClassName = None,
    category: CategoryName = None,
    phase: PhaseName = None,
    criterion: CriterionName = None,
    omega_sp: Annotated[float | None, _measured("--omega-sp", "RAD/S", "Short period: natural frequency.")] = None,
    zeta_sp: Annotated[float | None, _measured("--zeta-sp", "RATIO", "Short period: damping ratio.")] = None,
    n_alpha: Annotated[float | None, _measured("--n-alpha", "G/RAD", "Load factor per angle of attack.")] = None,
    zeta_ph: Annotated[float | None, _measured("--zeta-ph", "RATIO", "Phugoid: damping ratio.")] = None,
    t2_ph: Annotated[float | None, _measured("--t2-ph", "S", "Phugoid: time to double, where it grows.")] = None,
    t2_speed: Annotated[float | None, _measured("--t2-speed", "S", "Airspeed that diverges: time to double.")] = None,
    omega_dr: Annotated[float | None, _measured("--omega-dr", "RAD/S", "Dutch roll: natural frequency.")] = None,
    zeta_dr: Annotated[float | None, _measured("--zeta-dr", "RATIO", "Dutch roll: damping ratio.")] = None,
    phi_beta: Annotated[float | None, _measured("--phi-beta", "RATIO", "Dutch roll: bank per sideslip.")] = None,
    tau_roll: Annotated[float | None, _measured("--tau-roll", "S", "Roll mode: time constant.")] = None,
    t2_spiral: Annotated[
        float | None, _measured("--t2-spiral", "S", "Spiral: time to double; negative: to half.")
    ] = None,
    damping_rs: Annotated[
        float | None, _measured("--damping-rs", "RAD/S", "Coupled roll-spiral: zeta times omega.")
    ] = None,
    delay: Annotated[float | None, _measured("--delay", "S", "Delay from stick to response.")] = None,
    plot: PlotFile = None,
    json: AsJson = False,
) -> None:
    """Levels of flying qualities by MIL-F-8785C, their margins, and what to change to reach the next Level.

    Name an aircraft, or one criterion with what it reads. What is left out limits the verdict, which says so. With
    --law the closed loop is judged, and its gains are among what may be changed: continuous, without actuators and
    with no delay between stick and surface, unless --sampled or --actuators asks for them.
    """
    from fdes.cli.plot import target_of

    wanted, target = form_of_equations(form), target_of(plot)
    given = {
        "omega_sp": omega_sp,
        "zeta_sp": zeta_sp,
        "n_alpha": n_alpha,
        "zeta_ph": zeta_ph,
        "t2_ph": t2_ph,
        "t2_speed": t2_speed,
        "omega_dr": omega_dr,
        "zeta_dr": zeta_dr,
        "phi_beta": phi_beta,
        "tau_roll": tau_roll,
        "t2_spiral": t2_spiral,
        "damping_rs": damping_rs,
        "delay": delay,
    }
    known = {name: value for name, value in given.items() if value is not None}
    _check(known)
    if aircraft is None:
        if changes or law or actuators or sampled is not None:
            raise SpecError("--set, --law, --actuators and --sampled need an aircraft: name one.")
        _judge_numbers(known, criterion, (flying_class, category, phase), target, json)
        return
    if set(known) - {"delay"}:
        raise SpecError(
            f"{_flags(known)} cannot be given with {aircraft}, of which it is computed. Leave out one of the two."
        )
    from fdes.aircraft.role import role_of
    from fdes.analysis import linear_model
    from fdes.analysis.closed_loop import close
    from fdes.analysis.improvement import adjustables, gains, improvements, unreachable
    from fdes.analysis.measured import measure
    from fdes.analysis.qualities import judge
    from fdes.flight.actuated import actuators_of

    ready = chosen(aircraft, condition, variant, changes)
    role = role_of(ready.document, ready.condition).but(flying_class, category, phase)
    dt = frame_of(sampled)
    designed = designed_law(law or "direct", ready, wanted, dt, actuators=actuators) if law or actuators or dt else None
    on = actuators_of(ready) if actuators else None

    def loop(changed: "FlightCondition", other: "Law | None" = None) -> "LinearModel":
        if designed is None:
            return linear_model(changed, wanted)
        return close(changed, other or designed.law, dt, on, wanted)

    measured = measure(loop(ready), delay, airframe=linear_model(ready, wanted))
    verdicts = judge(measured, role, _names(criterion))
    title = heading(ready, form) + (f", law {designed.text}" if designed and law else "")
    _draw(measured, role, _names(criterion), target, title)
    better: list[Improvement] = []
    hopeless = []
    for verdict in verdicts:
        candidates = adjustables(ready, verdict.mode, loop)
        if designed:
            candidates += gains(designed, lambda other: loop(ready, other))
        found = improvements(verdict, candidates, role, delay)
        better += found
        if not found:
            hopeless += [f"{_words(verdict.mode)}: {said}" for said in [unreachable(verdict, candidates)] if said]
    if json:
        extra = {"law": designed.as_dict()} if designed else {}
        changes_found = {"improvements": [i.as_dict() for i in better]}
        print_json(_as_json(role, verdicts) | about(ready, form) | changes_found | extra)
        return
    _show(title, role, verdicts)
    _show_improvements(better, hopeless)
    _show_written(target)
    show_notes(designed)


def _check(known: dict[str, float]) -> None:
    """Numbers that no airplane can have are refused here. Damping ratios may be negative."""
    positive = {"n_alpha", "omega_sp", "omega_dr", "tau_roll", "t2_ph", "t2_speed"}
    not_negative = {"phi_beta", "delay"}
    for name, value in known.items():
        if not math.isfinite(value) and not (name == "t2_spiral" and math.isinf(value)):
            raise SpecError(f"{_flag(name)} is {value}; it must be a finite number.")
        if name in positive and value <= 0.0:
            raise SpecError(f"{_flag(name)} is {value:g}; it must be greater than zero.")
        if name in not_negative and value < 0.0:
            raise SpecError(f"{_flag(name)} is {value:g}; it must not be negative.")


def _judge_numbers(
    known: dict[str, Any],
    criterion: str | None,
    asked: tuple[str | None, str | None, str | None],
    target: "Path | None",
    json: bool,
) -> None:
    """Numbers without an aircraft: one criterion, or all that read what is given."""
    from fdes.aircraft.role import STRICTEST
    from fdes.analysis.measured import Measured
    from fdes.analysis.qualities import chosen as criteria
    from fdes.analysis.qualities import judge

    parts = criteria(_names(criterion))
    unread = set(known) - {name for part in parts for name in part.reads}
    if unread:
        reads = _flags({name for part in parts for name in part.reads})
        raise SpecError(f"{parts[0].name} does not read {_flags(unread)}. It reads: {reads}.")
    if not known:
        reads = _flags(parts[0].reads) if criterion else "as in: --criterion mil_f_8785c_short_period --zeta-sp 0.7"
        raise SpecError(f"There is nothing to judge: name an aircraft, or give what a criterion reads: {reads}.")
    role = STRICTEST.but(*asked)
    measured = Measured(**known)
    names = [part.name for part in parts if set(part.reads) & set(known)]
    verdicts = judge(measured, role, names)
    _draw(measured, role, names, target, "Numbers given by hand")
    if json:
        print_json(_as_json(role, verdicts))
        return
    _show("Numbers given by hand", role, verdicts)
    _show_written(target)


def _names(criterion: str | None) -> list[str] | None:
    return None if criterion is None else [criterion]


def _as_json(role: "Role", verdicts: "Sequence[Verdict]") -> dict[str, Any]:
    return {
        "verdicts": [verdict.as_dict() for verdict in verdicts],
        "class": role.airplane_class,
        "category": role.category,
        "phase": role.phase,
        "chosen": role.reason,
    }


def _draw(measured: "Measured", role: "Role", names: "Sequence[str] | None", target: "Path | None", title: str) -> None:
    if target is None:
        return
    from fdes.analysis.qualities import charts
    from fdes.analysis.quality_charts import as_drawing
    from fdes.cli.plot import save_plot

    save_plot(as_drawing(charts(measured, role, names), f"{title}: {role}"), target)


def _show(title: str, role: "Role", verdicts: "Sequence[Verdict]") -> None:
    show = screen()
    show.print(title)
    show.print(f"{role}: {role.reason}\n")
    show.print(_table(verdicts))
    for verdict in verdicts:
        show.print(f"{_words(verdict.mode)}: {verdict.reason}\n  {verdict.requirement}.\n  {verdict.reference}\n")


def _table(verdicts: "Sequence[Verdict]") -> "Table":
    from fdes.analysis.verdict import level_name

    drawn = table("mode", "governing value", "unit", "Level", "margin")
    for column in (2, 3):
        drawn.columns[column].justify = "left"
    for verdict in verdicts:
        style = {1: None, 2: "yellow", None: "dim"}.get(verdict.level, "red")
        drawn.add_row(
            _words(verdict.mode),
            number(verdict.value, 3),
            verdict.unit if verdict.value is not None else "",
            level_name(verdict.level).removeprefix("Level "),
            _margin(verdict.margin),
            style=style,
        )
    return drawn


def _margin(margin: float | None) -> str:
    if margin is None:
        return ""
    return "> +999 %" if margin > LARGEST_SHOWN else "< -999 %" if margin < -LARGEST_SHOWN else f"{100 * margin:+.0f} %"


def _show_improvements(found: "Sequence[Improvement]", hopeless: "Sequence[str]") -> None:
    show = screen()
    if found or hopeless:
        show.print("What one change would do", style="bold")
    for improvement in found:
        show.print(f"  {_words(improvement.mode)}: {improvement}")
    for sentence in hopeless:
        show.print(f"  {sentence}")


def _show_written(target: "Path | None") -> None:
    if target is not None:
        screen().print(f"{target} is written.", soft_wrap=True)


def _words(mode: str) -> str:
    return mode.replace("_", " ")


def _flag(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def _flags(names: Any) -> str:
    return ", ".join(sorted(map(_flag, names)))
