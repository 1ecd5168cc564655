"""`fdes check`: what in an aircraft file cannot be, or hardly, and what that means in flight; what a law must be."""

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from fdes.cli.options import AsJson
from fdes.cli.output import print_json, screen

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.table import Table

    from fdes.aircraft import Aircraft, Finding

STYLES = {"error": "bold red", "warning": "bold yellow", "waived": "dim"}


def check(
    aircraft: Annotated[
        str | None,
        typer.Argument(
            metavar="AIRCRAFT|LAW.py",
            help="A name or the path of a TOML file; or of a law in Python, which is run. Else the whole hangar.",
        ),
    ] = None,
    json: AsJson = False,
) -> None:
    """Look for mistakes in an aircraft: signs, sizes, units, inertias. Exits with 1 unless all is clean or waived.

    A law of your own is tried in flight: pure, finite, the same after a reset, linear() the Jacobian of step.
    """
    if aircraft is not None and aircraft.endswith(".py"):
        _check_law(aircraft, json=json)
        return
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


def _check_law(path: str, *, json: bool) -> None:
    """What does not hold of the law in that file."""
    from fdes.analysis.law_check import RULES, law_findings
    from fdes.cli.options import law_in

    part = law_in(path)
    found = law_findings(part)
    if json:
        print_json({"law": part.__name__, "findings": [asdict(finding) for finding in found], "rules": len(RULES)})
    else:
        page = screen()
        page.print(f"{part.__name__}{'' if found else ': clean'}", style="bold")
        for finding in found:
            page.print(_grid("error", STYLES["error"], finding.rule, (finding.what, f"To do: {finding.advice}")))
        page.print(f"{len(RULES)} rules: {_count(len(found), 'error')}")
    if found:
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
    kind = _kind(finding)
    said = (
        finding.what,
        f"In flight: {finding.meaning}",
        f"Reason: {finding.waived}" if finding.waived else f"To do: {finding.advice}",
    )
    return _grid(kind, STYLES[kind], finding.rule, said, "dim" if finding.waived else "")


def _grid(kind: str, style: str, rule: str, said: "Sequence[str]", ink: str = "") -> "Table":
    from rich.table import Table
    from rich.text import Text

    drawn = Table.grid(padding=(0, 2, 0, 0))
    drawn.add_column(width=9)
    drawn.add_column()
    drawn.add_row(Text(f"  {kind}", style), Text(rule, ink))
    for sentence in said:
        drawn.add_row("", Text(sentence, ink))
    return drawn
