"""`fdes fly`: the cockpit in a browser."""

from pathlib import Path
from typing import Annotated

import typer

from fdes.cli.options import FLAG, Across, AircraftName, ConditionName, FormName, IntegratorName, Spool, VariantName
from fdes.errors import SpecError


def fly(
    aircraft: AircraftName = "A-4D",
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    form: FormName = "full",
    integrator: IntegratorName = "rk4",
    plant: Annotated[
        str, typer.Option(metavar="linear|nonlinear", help="Small perturbations, or six degrees of freedom.")
    ] = "linear",
    across: Across = None,
    spool: Spool = False,
    host: Annotated[str, typer.Option(metavar="ADDRESS", help="Where to listen; 0.0.0.0 lets the network in.")] = (
        "127.0.0.1"
    ),
    port: Annotated[
        int | None,
        typer.Option(
            min=0, max=65535, metavar="NUMBER", help="0 takes any free one; so does the usual one being in use."
        ),
    ] = None,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", metavar=FLAG, help="Open the cockpit in a browser.")
    ] = True,
    data: Annotated[
        Path | None,
        typer.Option(metavar="FOLDER", help="Where recordings are kept; else FDES_DATA says, or the platform."),
    ] = None,
    record: Annotated[bool, typer.Option("--record/--no-record", metavar=FLAG, help="Record every flight.")] = True,
    verbose: Annotated[
        bool, typer.Option("--verbose", metavar=FLAG, help="Show on stderr what the server does; a log is kept anyway.")
    ] = False,
    json: Annotated[
        bool, typer.Option("--json", metavar=FLAG, help='Print one JSON line, {"url": ...}, when it listens.')
    ] = False,
) -> None:
    """Fly an aircraft in the browser. Ends with Ctrl+C."""
    from fdes.cli.log import logged
    from fdes.cockpit import serve
    from fdes.flight.storage import data_folder

    with logged(data_folder(data), verbose=verbose):
        serve(
            host=host,
            port=_usual_or_free(host) if port is None else port,
            data=data,
            open_browser=browser,
            json_line=json,
            aircraft=aircraft,
            condition=condition,
            variant=variant,
            form=form,
            integrator=integrator,
            plant=plant,
            across=across,
            spool=spool,
            record=record,
        )


def _usual_or_free(host: str) -> int:
    """The port that cockpits usually have, or 0 for any free one when it cannot be had."""
    from fdes.cockpit.serve import PORT, listening

    try:
        with listening(host, PORT):
            return PORT
    except SpecError:
        return 0
