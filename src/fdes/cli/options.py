"""What several commands ask for, declared once."""

from typing import TYPE_CHECKING, Annotated, Any

import typer

from fdes.errors import NoSuchPart, SpecError

if TYPE_CHECKING:
    from fdes.aircraft import FlightCondition
    from fdes.analysis.designed import Designed
    from fdes.physics.derivatives import Form

FLAG = ""  # a switch takes no value; Typer would show one

AircraftName = Annotated[
    str, typer.Argument(metavar="AIRCRAFT", help="A name, as `fdes aircraft` lists them, or the path of a TOML file.")
]
ConditionName = Annotated[
    str | None, typer.Option("--condition", "-c", metavar="ID", help="The flight condition; else the aircraft's first.")
]
VariantName = Annotated[
    str, typer.Option(metavar="corrected|printed", help="Mend what is known to be misprinted, or take it as printed.")
]
FormName = Annotated[
    str,
    typer.Option(
        metavar="paper|nelson|full",
        help="The linear equations: Mansor and Perumal's, Nelson's, or with nothing neglected.",
    ),
]
IntegratorName = Annotated[str, typer.Option(metavar="NAME", help="exact, rk4, dopri5, kutta_merson, heun or euler.")]
PlotFile = Annotated[
    str | None,
    typer.Option("--plot", metavar="FILE", help="Draw it too: .png, .svg, or .html to zoom and point at."),
]
Changes = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="CHANGE",
        help="Change a number: 'Cm_alpha=-0.3', 'Cn_r*=2', 'cg+=0.05', 'm=9000 kg'. Repeatable.",
    ),
]
Across = Annotated[
    str | None,
    typer.Option("--across", metavar="mach", help="Interpolate the nonlinear plant between the aircraft's conditions."),
]
Spool = Annotated[
    bool,
    typer.Option("--spool", metavar=FLAG, help="Let the nonlinear plant's engine follow the throttle with its lag."),
]
LawText = Annotated[
    str | None,
    typer.Option(
        "--law",
        metavar="TEXT",
        help="A control law: 'yaw_damper gain=0.5', 'yaw_damper zeta=0.4', bare to have it designed, several with ';', "
        "or the path of a Python file of your own.",
    ),
]
OnActuators = Annotated[
    bool, typer.Option("--actuators", metavar=FLAG, help="Move the surfaces by the actuators that are assumed.")
]
Sampled = Annotated[
    float | None,
    typer.Option(metavar="HZ", help="From frame to frame, as it is flown, this many a second; laws designed in z."),
]

AsJson = Annotated[bool, typer.Option("--json", metavar=FLAG, help="Print JSON, for other programs.")]


def chosen(
    aircraft: str,
    condition: str | None,
    variant: str,
    changes: list[str] | None,
    across: str | None = None,
    *,
    spool: bool = False,
) -> "FlightCondition":
    """The aircraft in its flight condition, with what `--set` changes, `--across` and `--spool`. Raises FdesError."""
    from fdes.aircraft import edited, load

    return edited(load(aircraft).at(condition, variant, across=across, spool=spool), changes or ())


def designed_law(
    text: str,
    ready: "FlightCondition",
    form: "Form",
    dt: float | None = None,
    frame: float | None = None,
    *,
    actuators: bool = False,
) -> "Designed":
    """The law that was said; a path runs a file, which only whoever sits at the computer may ask for. Raises FdesError.

    dt [s]: designed in z at that step; frame [s]: flown at that. actuators: with those that are assumed.
    """
    from fdes.analysis.design import law_for
    from fdes.control.own_law import own_laws
    from fdes.flight.actuated import actuators_of

    said, own = own_laws(text)
    return law_for(said, ready, form, dt, frame, own, actuators_of(ready) if actuators else None)


def law_in(path: str) -> Any:
    """The law in a Python file, which is run. Raises SpecError."""
    from pathlib import Path

    from fdes.control.own_law import law_from_file

    return law_from_file(Path(path))


def frame_of(sampled: float | None) -> float | None:
    """The length of a frame [s] of so many a second; None is continuous. Raises SpecError."""
    if sampled is not None and not 0.0 < sampled < float("inf"):
        raise SpecError(f"A loop cannot be sampled {sampled:g} times a second: write --sampled 120, or the like.")
    return None if sampled is None else 1.0 / sampled


def form_of_equations(form: str) -> "Form":
    """The form by that name. Raises NoSuchPart with the nearest name."""
    from fdes.physics.derivatives import FORMS

    for known in FORMS:
        if form == known:
            return known
    raise NoSuchPart("form of the linear equations", form, FORMS)
