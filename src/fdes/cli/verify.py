"""`fdes verify`: published numbers beside computed ones."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fdes.cli.options import AsJson
from fdes.cli.output import number, print_json, screen, table, working
from fdes.errors import SpecError

if TYPE_CHECKING:
    from fdes.analysis.verify import Check

VERDICTS = {"ok": "ok", "misprint": "misprint", "failed": "FAILED", "no check": "not held"}
STYLES = {"failed": "red", "misprint": "yellow", "no check": "dim"}
NOTED = ("misprint", "no check")

app = typer.Typer(no_args_is_help=True, help="Hold what FDES computes against what is published.")


@app.command(epilog="Example: fdes verify textbooks")
def textbooks(
    sources: Annotated[
        Path | None, typer.Option("--sources", metavar="FOLDER", help="Your own source files; else those of FDES.")
    ] = None,
    json: AsJson = False,
) -> None:
    """Every number of every source, with the error achieved. Exits with 1 if one is out of its tolerance.

    A number that misses because of an accepted misprint is shown as such. What cannot be compared is shown, not held.
    """
    from fdes.analysis.verify import checks
    from fdes.sources import sources as published

    if sources is not None and not sources.is_dir():
        raise SpecError(f"{sources} is no folder. Name a folder of source files such as those in fdes/sources.")
    found = checks(published(sources))
    if not found:
        raise SpecError(f"There is nothing to verify in {sources}: no source file there holds a published number.")
    _report(found, json=json)


@app.command(epilog="Example: fdes verify f16")
def f16(json: AsJson = False) -> None:
    """The F-16 against the book's trims, state derivative and linear model. Exits with 1 if one is out of its digits.

    What the tables of the book make is held. Where those of the aircraft file make something else, that is shown.
    """
    from fdes.analysis.f16_checks import f16_checks

    with working("Trimming the F-16"):
        found = f16_checks()
    _report(found, json=json)


def _report(found: "list[Check]", *, json: bool) -> None:
    ok, misprints, failed, shown = (
        sum(check.verdict == verdict for check in found) for verdict in ("ok", "misprint", "failed", "no check")
    )
    if json:
        counts = {"passed": ok, "misprints": misprints, "failed": failed, "shown": shown}
        print_json({"checks": [_as_json(check) for check in found], **counts})
    else:
        _show(found)
        if shown:
            screen().print(f"{shown} more numbers are shown with the reason why they are not held.")
        excused = f"{misprints} accepted misprint{'s' * (misprints != 1)}, " if misprints else ""
        screen().print(f"{len(found) - shown} checks: {ok} passed, {excused}{failed} failed")
    if failed:
        raise typer.Exit(1)


def _as_json(check: "Check") -> dict[str, str | float | bool | None]:
    finite = check.computed == check.computed  # a mode that was not found is not a number, which JSON cannot say
    return {
        "item": check.item,
        "quantity": check.quantity,
        "published": check.published,
        "computed": check.computed if finite else None,
        "error": check.error if finite else None,
        "tolerance": check.tolerance,
        "verdict": check.verdict,
        "passed": check.passed if check.tolerance is not None else None,
        "note": check.note,
        "citation": check.citation,
        "where": check.where,
    }


def _show(found: "list[Check]") -> None:
    """One table per item, headed by where its numbers stand."""
    for item in dict.fromkeys(check.item for check in found):
        of_item = [check for check in found if check.item == item]
        screen().print(f"\n[{item}] {of_item[0].citation}, {of_item[0].where}", style="bold")
        drawn = table("quantity", "published", "computed", "error", "allowed", "")
        for check in of_item:
            percent = check.published != 0.0
            allowed = f"{100.0 * (check.tolerance or 0.0):.2g} %" if percent else f"{check.floor:.2g}"
            drawn.add_row(
                check.quantity,
                number(check.published),
                number(check.computed, 5),
                f"{100.0 * check.error:.2g} %" if percent else f"{check.error:.2g}",
                "" if check.tolerance is None else allowed,
                VERDICTS[check.verdict],
                style=STYLES.get(check.verdict),
            )
        screen().print(drawn)
        for verdict, note in dict.fromkeys((c.verdict, c.note) for c in of_item if c.verdict in NOTED):
            screen().print(f"{VERDICTS[verdict]}: {note}", style=STYLES[verdict])


@app.command(epilog="Example: fdes verify paper --out paper.html")
def paper(
    out: Annotated[
        str, typer.Option("--out", "-o", metavar="FILE.html", help="Where the report is written.")
    ] = "fdes-verify-paper.html",
) -> None:
    """The figures and tables of the UTM-FDES paper, flown again. Exits with 1 if one comes out otherwise."""
    from fdes.analysis import report
    from fdes.analysis.paper import execution_times, paper_figures, table_claims
    from fdes.sources import sources

    target = Path(out)
    if target.suffix != ".html" or not target.parent.is_dir():
        raise SpecError(f"{out} cannot be written: name a file that ends in .html in a folder that exists.")
    with working("Flying the paper's figures"):
        figures, tables, taken = paper_figures(), table_claims(), execution_times()
    claims = [claim for figure in figures for claim in figure.claims] + tables
    times = [(r["integrator"].replace("_", "-"), f"{r['step']:g}", f"{r['total']:g}", f"{r['now']:.3f}") for r in taken]
    target.write_text(
        report.page(
            "The UTM-FDES paper, flown again",
            [
                report.paragraph(f"{sources()['mansor_perumal']['citation']}."),
                report.paragraph(
                    "Assumed, for the paper does not say: the A-4D at Mach 0.4, sea level, derivatives as printed, the "
                    "paper's equations 2.1 and 2.2, and steps of 0.2618 rad. Dashed: the matrix exponential."
                ),
                *[report.figure_part(figure) for figure in figures],
                report.heading("Tables 5.1 and 5.2: execution time for 100 s of simulation, then and now"),
                report.plain_table(["integrator", "step [s]", "then [s]", "now [s]"], times),
                report.claims_table(tables),
            ],
        ),
        encoding="utf-8",
    )
    show = screen()
    for claim in claims:
        verdict = "ok    " if claim.passed else "FAILED"
        show.print(f"{verdict} {claim.says}: {claim.found}", style=None if claim.passed else "red")
    failed = sum(not claim.passed for claim in claims)
    show.print(f"\n{out} is written. {len(claims)} checks: {len(claims) - failed} passed, {failed} failed")
    if failed:
        raise typer.Exit(1)


@app.command(epilog="Example: fdes verify nesc --out nesc.html")
def nesc(
    data: Annotated[
        Path | None,
        typer.Option(metavar="FOLDER", help="The published curves, unpacked; else points of them that come with FDES."),
    ] = None,
    out: Annotated[
        str | None, typer.Option("--out", "-o", metavar="FILE.html", help="A report with plots of the differences.")
    ] = None,
    json: AsJson = False,
) -> None:
    """NASA's six-degree-of-freedom check cases, flown by the nonlinear plant. Exits with 1 if one comes out otherwise.

    Where a body has drag, it is flown with the density of the simulation it is compared with; `as flown` is without.
    """
    from fdes.analysis.check_cases import check_cases

    target = None if out is None else Path(out)
    if target is not None and (target.suffix != ".html" or not target.parent.is_dir()):
        raise SpecError(f"{out} cannot be written: name a file that ends in .html in a folder that exists.")
    with working("Flying NASA's check cases"):
        found = check_cases(data)
    failed = sum(not c.passed for c in found)
    if target is not None:
        from fdes.analysis.check_cases_report import check_cases_page

        target.write_text(check_cases_page(found), encoding="utf-8")
    if json:
        names = ("scenario", "simulation", "column", "raw", "error", "excess", "tolerance", "note", "passed")
        print_json({"comparisons": [{n: getattr(c, n) for n in names} for c in found], "failed": failed})
    else:
        for scenario in dict.fromkeys(c.scenario for c in found):
            of_case = [c for c in found if c.scenario == scenario]
            screen().print(f"\n[{scenario}] {of_case[0].title}", style="bold", markup=False)
            drawn = table("simulation", "column", "as flown", "error", "allowed", "")
            for c in of_case:
                verdict = VERDICTS["no check" if c.note else "ok" if c.passed else "failed"]
                allowed = "" if c.note else f"{c.tolerance:.0e}"
                style = STYLES.get("no check" if c.note else "ok" if c.passed else "failed")
                drawn.add_row(c.simulation, c.column, f"{c.raw:.1e}", f"{c.error:.1e}", allowed, verdict, style=style)
            screen().print(drawn)
            for note in dict.fromkeys(f"{c.simulation} {c.note}." for c in of_case if c.note):
                screen().print(f"not held: {note}", style="dim")
        held = sum(not c.note for c in found)
        if out is not None:
            screen().print(f"\n{out} is written.", soft_wrap=True)
        screen().print(f"\n{held} comparisons: {held - failed} passed, {failed} failed")
    if failed:
        raise typer.Exit(1)


@app.command(epilog="Example: fdes verify sixdof")
def sixdof(json: AsJson = False) -> None:
    """What must hold of six degrees of freedom without anyone's data. Exits with 1 if something does not.

    Conservation, symmetry, order of the integrator, gravity, trim, and that linear meets nonlinear.
    """
    from fdes.analysis.six_dof_checks import six_dof_properties

    found = list(six_dof_properties())
    failed = sum(not p.passed for p in found)
    if json:
        rows = [{"says": p.says, "found": p.found, "allowed": p.allowed, "passed": p.passed} for p in found]
        print_json({"properties": rows, "failed": failed})
    else:
        for p in found:
            verdict = "ok    " if p.passed else "FAILED"
            bound = f"at least {p.allowed:g}" if p.least else f"at most {p.allowed:g}"
            screen().print(
                f"{verdict} {p.says}: {p.found:.2g}, {bound}", style=None if p.passed else "red", soft_wrap=True
            )
        screen().print(f"\n{len(found)} properties: {len(found) - failed} hold, {failed} do not")
    if failed:
        raise typer.Exit(1)
