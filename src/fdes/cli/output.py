"""What the command line prints: results on stdout; notes, progress and mistakes on stderr.

Rich is imported when something is drawn, so that `fdes --version` and `--json` never wait for it.
"""

import json
import sys
from contextlib import contextmanager, nullcontext
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import Console
    from rich.table import Table

    from fdes.aircraft import FlightCondition


Item = TypeVar("Item")


def screen() -> "Console":
    """Where results go: 80 columns, or as wide as the terminal is."""
    from rich.console import Console

    return Console(highlight=False, emoji=False, markup=False)


def aside() -> "Console":
    """Where goes what is not the result."""
    from rich.console import Console

    return Console(stderr=True, highlight=False, emoji=False, markup=False)


def print_json(data: Any) -> None:
    """Print for other programs."""
    print(json.dumps(data, indent=2, allow_nan=False))


def heading(ready: "FlightCondition", form: str) -> str:
    """What a table or a plot says first: what it is about."""
    changes = "".join(f", {change}" for change in ready.changes)
    return f"{ready.aircraft_name}, {ready.condition}: {ready.variant} values{changes}, form {form}"


def about(ready: "FlightCondition", form: str) -> dict[str, Any]:
    """What JSON says first: what it is about."""
    return {
        "aircraft": ready.aircraft_id,
        "condition": ready.condition,
        "form": form,
        "variant": ready.variant,
        "changes": [str(change) for change in ready.changes],
        "units": "SI",
    }


def track(items: "Sequence[Item]", what: str) -> "Iterator[Item]":
    """`items` one by one, with a bar on stderr that says how far `what` has come; on a terminal only."""
    from rich.progress import track as tracked

    console = aside()
    yield from tracked(items, what, console=console, transient=True, disable=not console.is_terminal)


@contextmanager
def working(what: str) -> "Iterator[None]":
    """Say on stderr that `what` is going on, for as long as it does; on a terminal only."""
    console = aside()
    with console.status(what) if console.is_terminal else nullcontext():
        yield


def complain(text: str) -> None:
    """Tell a mistake."""
    _aside("Error: ", "bold red", text)


def note(text: str) -> None:
    """Tell what whoever uses the result should know."""
    _aside("Note: ", "bold yellow", text)


def _aside(label: str, style: str, text: str) -> None:
    from rich.text import Text

    aside().print(Text.assemble((label, style), text), soft_wrap=True)


def table(*columns: str, title: str | None = None) -> "Table":
    """A table without frames. Its first column holds names and may be broken, the others hold numbers."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    drawn = Table(title=title, title_justify="left", title_style="bold", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for k, column in enumerate(columns):
        drawn.add_column(column, justify="right" if k else "left", no_wrap=k > 0)
    return drawn


def number(value: float | None, digits: int = 4) -> str:
    """A number as a table shows it: so many digits, or all of a large one's; nothing for None."""
    if value is None:
        return ""
    if value == 0.0:
        return "0"
    return f"{value:,.0f}" if 10.0**digits <= abs(value) < 1e7 else f"{value:#.{digits}g}".rstrip(".")


def use_any_encoding() -> None:
    """Let a terminal that cannot show a character show another in its place."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
