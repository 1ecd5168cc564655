"""`fdes modes`: the natural modes of an aircraft, Nelson's approximations to them, and the static figures."""

from typing import TYPE_CHECKING

from fdes.cli.law import show_law, show_margins
from fdes.cli.options import (
    AircraftName,
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

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from rich.table import Table

    from fdes.aircraft import FlightCondition
    from fdes.analysis import Mode
    from fdes.analysis.approximations import Compared, StaticFigures
    from fdes.physics.derivatives import Form

DIGITS = 3  # of what follows from an eigenvalue


def modes(
    aircraft: AircraftName,
    condition: ConditionName = None,
    form: FormName = "full",
    variant: VariantName = "corrected",
    changes: Changes = None,
    law: LawText = None,
    sampled: Sampled = None,
    actuators: OnActuators = False,
    plot: PlotFile = None,
    json: AsJson = False,
) -> None:
    """Natural modes with damping and times, Nelson's approximations to them, static margin, n/alpha and roll rate.

    The form full is the default: over all published modes its mean error is the smallest, 0.8 % against 2.8 % (nelson)
    and 5.7 % (paper). Compare with Nelson's book in nelson. With --law they are those of the closed loop: continuous
    and without actuators, unless --sampled or --actuators asks for them; and the margins of gain, phase and delay are
    shown, the loop broken at each surface.
    """
    from fdes.analysis import modes as modes_of
    from fdes.analysis.approximations import WITHOUT_COEFFICIENTS, compare, mode_report, static_figures
    from fdes.cli.plot import save_plot, target_of

    wanted, target = form_of_equations(form), target_of(plot)
    ready = chosen(aircraft, condition, variant, changes)
    title = heading(ready, form)
    if law is not None or sampled is not None or actuators:
        _closed(ready, wanted, law or "direct", sampled, actuators, title, target, json)
        return
    found = modes_of(ready, wanted)
    if target is not None:
        from fdes.analysis.plots import s_plane

        save_plot(s_plane(found, title), target)
    if json:
        print_json(about(ready, form) | mode_report(ready, wanted, found))
        return
    show = screen()
    show.print(f"{title}\n")
    for axis in ("longitudinal", "lateral"):
        show.print(_table(axis.capitalize(), [mode for mode in found if mode.axis == axis]))
    if ready.nondimensional:
        compared = compare(ready, wanted, found)
        show.print(_comparison(compared))
        for alone in (c for c in compared if c.exact is None):
            show.print(f"{_words(alone.approximation.name)}: no exact mode to compare with: {alone.alone}.")
        show.print("Static margin, pull-up and roll\n", style="bold")
        show.print(_static(static_figures(ready, ready.cg), ready.cg))
    else:
        show.print(WITHOUT_COEFFICIENTS)
    if target is not None:
        show.print(f"{plot} is written.", soft_wrap=True)


def _closed(
    ready: "FlightCondition",
    form: "Form",
    text: str,
    sampled: float | None,
    actuators: bool,
    title: str,
    target: "Path | None",
    json: bool,
) -> None:
    """The modes of the closed loop, and what the law is."""
    from fdes.analysis import modes as modes_of
    from fdes.analysis.closed_loop import close
    from fdes.analysis.margins import costs
    from fdes.flight.actuated import actuators_of

    dt = frame_of(sampled)
    designed = designed_law(text, ready, form, dt, actuators=actuators)
    on = actuators_of(ready) if actuators else None
    found = modes_of(close(ready, designed.law, dt, on, form))
    left = costs(ready, designed.law, dt, on, form)
    if target is not None:
        from fdes.analysis.plots import s_plane
        from fdes.cli.plot import save_plot

        save_plot(s_plane(found, title), target)
    if json:
        loop = {
            "law": designed.as_dict(),
            "sampled": sampled,
            "actuators": on and {name: one._asdict() for name, one in on._asdict().items()},
            "margins": [{"with": step} | m.as_dict() for step, margins in left.items() for m in margins],
        }
        print_json(about(ready, form) | loop | {"modes": [mode.as_dict() for mode in found]})
        return
    screen().print(f"{title}\n")
    show_law(designed)
    how = "continuous" if sampled is None else f"sampled at {sampled:g} Hz"
    screen().print(f"\nThe closed loop, {how}, {'with' if actuators else 'without'} actuators\n")
    for axis in ("longitudinal", "lateral"):
        screen().print(_table(axis.capitalize(), [mode for mode in found if mode.axis == axis]))
    show_margins(left)


def _table(title: str, found: "Sequence[Mode]") -> "Table":
    grows = any(mode.time_to_double is not None for mode in found)
    drawn = table(
        "mode",
        "eigenvalue\n[rad/s]",
        "omega_n\n[rad/s]",
        "zeta\n",
        "tau\n[s]",
        "to half,\nx2 [s]" if grows else "to half\n[s]",
        "period\n[s]",
        "cycles\nto half",
        title=title,
    )
    drawn.padding = 0  # eight columns in 80 characters
    for mode in found:
        drawn.add_row(
            _words(mode.name),
            _eigenvalue(mode.eigenvalue),
            number(mode.omega_n, DIGITS),
            number(mode.zeta, DIGITS),
            number(mode.time_constant, DIGITS),
            _with_doubling(mode.time_to_half, mode.time_to_double),
            number(mode.period, DIGITS),
            _with_doubling(mode.cycles_to_half, mode.cycles_to_double),
            style=None if mode.time_to_double is None else "red",
        )
    return drawn


def _comparison(compared: "Sequence[Compared]") -> "Table":
    drawn = table(
        "mode",
        "approximation\n[rad/s]",
        "omega_n\n[rad/s]",
        "off by\n",
        "zeta\n",
        "off by\n",
        title="Nelson's approximations, and how far they are off the exact modes above",
    )
    for one in compared:
        a = one.approximation
        drawn.add_row(
            _words(a.name),
            _eigenvalue(a.eigenvalue),
            number(a.omega_n, DIGITS),
            _percent(one.omega_n_error),
            number(a.zeta, DIGITS),
            _percent(one.zeta_error),
        )
    return drawn


def _static(figures: "StaticFigures", cg: float | None) -> str:
    """One figure a line."""
    lines = [f"static margin     {100.0 * figures.static_margin:6.1f} %  of the mean chord"]
    lines += [f"maneuver margin   {100.0 * figures.maneuver_margin:6.1f} %  of the mean chord"]
    if cg is not None and figures.neutral_point is not None and figures.maneuver_point is not None:
        lines += [f"neutral point     {100.0 * figures.neutral_point:6.1f} %  center of gravity at {100.0 * cg:.1f} %"]
        lines += [f"maneuver point    {100.0 * figures.maneuver_point:6.1f} %"]
    n, of_lift = number(figures.n_alpha, DIGITS), number(figures.n_alpha_lift, DIGITS)
    lines += [f"n/alpha           {n:>6} g/rad in a steady pull-up; {of_lift} by q S CL_alpha / W"]
    if figures.roll_rate is not None:
        rate = number(figures.roll_rate, DIGITS)
        lines += [f"steady roll rate  {rate:>6} deg/s per degree of aileron, rolling alone"]
    return "\n".join([" " + line for line in lines])


def _words(name: str) -> str:
    return name.replace("_", " ")


def _eigenvalue(value: complex) -> str:
    return f"{number(value.real)} ± {number(value.imag)}i" if value.imag else number(value.real)


def _with_doubling(to_half: float | None, to_double: float | None) -> str:
    """The one that there is; a doubling says so."""
    return number(to_half, DIGITS) if to_double is None else f"{number(to_double, DIGITS)} x2"


def _percent(error: float | None) -> str:
    """A signed error."""
    if error is None:
        return ""
    percent = 100.0 * error
    return f"{percent:+,.0f} %" if abs(percent) >= 10.0 else f"{percent:+.1f} %"
