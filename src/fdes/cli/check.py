"""`fdes check`: what in an aircraft file cannot be, or hardly, and what that means in flight."""

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from fdes.cli.options import AsJson
from fdes.cli.output import print_json, screen

if TYPE_CHECKING:
    from rich.table import Table

    from fdes.aircraft import Aircraft, Finding

STYLES = {"error": "bold red", "warning": "bold yellow", "waived": "dim"}


def check(
    aircraft: Annotated[
        str | None,
        typer.Argument(metavar="AIRCRAFT", help="A name, or the path of a TOML file; else the whole hangar."),
    ] = None,
    json: AsJson = False,
) -> None:
    """Look for mistakes in an aircraft: signs, sizes, units, inertias. Exits with 1 unless all is clean or waived."""
    from fdes.aircraft import catalogue, load
    from fdes.aircraft import check as findings_of
    from fdes.aircraft.check import RULES

    checked = catalogue() if aircraft is None else [load(aircraft)]
    found = [(a, finding) for a in checked for finding in findings_of(a)]
    counted = {kind: sum(_kind(finding) == kind for _, finding in found) for kind in STYLES}
    conditions = sum(len(a.conditions) for a in checked)
    if json:
        print_json(
            {
                "findings": [{"aircraft": a.id, **asdict(finding)} for a, finding in found],
                "rules": len(RULES),
                "conditions": conditions,
                "errors": counted["error"],
                "warnings": counted["warning"],
                "waived": counted["waived"],
            }
        )
    else:
        for a in checked:
            _show(a, [finding for of, finding in found if of is a])
        errors, warnings = (_count(counted[kind], kind) for kind in ("error", "warning"))
        places = _count(conditions, "condition")
        screen().print(f"{len(RULES)} rules, {places}: {errors}, {warnings}, {counted['waived']} waived")
    if counted["error"] or counted["warning"]:
        raise typer.Exit(1)


def _kind(finding: "Finding") -> str:
    return "waived" if finding.waived else finding.severity


def _count(number: int, word: str) -> str:
    return f"{number} {word}{'' if number == 1 else 's'}"


def _show(aircraft: "Aircraft", found: "list[Finding]") -> None:
    """One paragraph per condition, headed by its name; those without findings in one line."""
    page = screen()
    for condition in (*aircraft.conditions, None):
        here = [f for f in found if f.condition == (condition and condition.id)]
        if condition:
            page.print(f"{aircraft.id} {condition.id}{'' if here else ': clean'}", style="bold")
        elif here:
            page.print(f"{aircraft.id}, whole file", style="bold")
        for finding in here:
            page.print(_drawn(finding))
        if here or condition:
            page.print()


def _drawn(finding: "Finding") -> "Table":
    from rich.table import Table
    from rich.text import Text

    kind = _kind(finding)
    dim = "dim" if finding.waived else ""
    drawn = Table.grid(padding=(0, 2, 0, 0))
    drawn.add_column(width=9)
    drawn.add_column()
    drawn.add_row(Text(f"  {kind}", STYLES[kind]), Text(finding.rule, dim))
    for label, said in (
        ("", finding.what),
        ("In flight: ", finding.meaning),
        ("Reason: " if finding.waived else "To do: ", finding.waived or finding.advice),
    ):
        drawn.add_row("", Text(label + said, dim))
    return drawn
