"""The command line: one file per command, all thin.

A command reads its words, asks the rooms below, and prints. A mistake of its user ends it with status 2 and the text of
the FdesError; anything else that is raised is a fault of FDES, and shows its traceback.
"""

import os
import sys
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from fdes import __version__
from fdes.cli.aircraft import app as aircraft
from fdes.cli.check import check
from fdes.cli.compare import compare
from fdes.cli.derivatives import derivatives
from fdes.cli.fly import fly
from fdes.cli.linearize import linearize
from fdes.cli.modes import modes
from fdes.cli.options import FLAG
from fdes.cli.output import complain, use_any_encoding
from fdes.cli.performance import performance
from fdes.cli.qualities import qualities
from fdes.cli.settings import NOT_A_SETTING, read_settings, settings, settings_file
from fdes.cli.shelves import shelves
from fdes.cli.simulate import simulate
from fdes.cli.trim import trim
from fdes.cli.verify import app as verify
from fdes.cli.whatif import whatif
from fdes.errors import FdesError

__all__ = ["app", "main"]

HELP_OPTIONS = {"help_option_names": ["-h", "--help"]}


class Commands(TyperGroup):
    """The commands, and what becomes of a mistake in any of them."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command, with the user's settings for what is not said."""
        try:
            ctx.default_map = read_settings(settings_file(), self._options())
            return super().invoke(ctx)
        except FdesError as mistake:
            complain(str(mistake))
            raise typer.Exit(2) from mistake

    def _options(self) -> dict[str, list[str]]:
        """What may be set: the options of each command, by the name in --help."""
        return {
            name: [p.name for p in command.params if p.name and p.name not in NOT_A_SETTING]
            for name, command in self.commands.items()
        }


app = typer.Typer(
    name="fdes",
    cls=Commands,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings=HELP_OPTIONS,
    epilog="Example: fdes fly A-4D",
)
app.command(epilog="Example: fdes fly NAVION --form nelson")(fly)
app.command(epilog="Example: fdes modes NAVION --form nelson --variant printed")(modes)
app.command(epilog="Example: fdes qualities A-4D --category A --plot levels.html")(qualities)
app.command(epilog="Example: fdes derivatives B747 --condition M0.90_40kft --json")(derivatives)
app.command(
    epilog='Example: fdes simulate A-4D --input "step aileron 15deg at 0s" --duration 6 --out run.csv',
)(simulate)
app.command(epilog='Example: fdes whatif flight.fdes --try "Cm_q*=0.5" --plot whatif.html')(whatif)
app.command(epilog="Example: fdes trim NAVION 'V=90 kt h=5000 ft turn=3 deg/s'")(trim)
app.command(epilog="Example: fdes performance NAVION --height '5000 ft'")(performance)
app.command(epilog="Example: fdes linearize A-4D 'mach=0.5 h=10000 ft'")(linearize)
app.command(epilog="Example: fdes compare A-4D -i 'doublet elevator 2deg for 2s'")(compare)
app.command(epilog="Example: fdes check A-4D")(check)
app.command(epilog="Example: fdes settings")(settings)
app.command(epilog="Example: fdes shelves --json")(shelves)
app.add_typer(aircraft, name="aircraft")
app.add_typer(verify, name="verify")


def _version(wanted: bool) -> None:
    if wanted:
        print(f"fdes {__version__}")
        raise typer.Exit


@app.callback()
def fdes(
    version: Annotated[
        bool,
        typer.Option("--version", metavar=FLAG, callback=_version, is_eager=True, help="Print the version and exit."),
    ] = False,
) -> None:
    """FDES, the flight dynamics engineering simulator: fly an aircraft, change a derivative, see what that does."""


def main() -> None:
    """Run the command that the program was called with, and exit with its status."""
    use_any_encoding()
    try:
        try:
            app(prog_name="fdes")
        finally:
            sys.stdout.flush()
    except KeyboardInterrupt:
        sys.exit(130)
    except BrokenPipeError:
        # Whoever read the output has enough. What is still waiting goes nowhere, or Python would complain at its end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
