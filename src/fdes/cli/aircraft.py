"""`fdes aircraft`: what can be flown, and where every number of it is from."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from fdes.cli.options import AircraftName, AsJson, Changes, ConditionName, VariantName, chosen
from fdes.cli.output import number, print_json, screen, table
from fdes.errors import SpecError
from fdes.units import DEG

if TYPE_CHECKING:
    from rich.table import Table

    from fdes.aircraft import Aircraft, FlightCondition
    from fdes.analysis.trim_alpha import DutchRollAt


class ListOrShow(TyperGroup):
    """Without a word all aircraft are listed; a word that is no command is an aircraft to show."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Put in the command that was left out."""
        named = any(not word.startswith("-") for word in args)
        if not {*args[:1]} & {*self.commands, *ctx.help_option_names}:
            args = ["show" if named else "list", *args]
        return super().parse_args(ctx, args)


app = typer.Typer(cls=ListOrShow, help="List the aircraft, or show one.", epilog="Example: fdes aircraft A-4D")


@app.command("list", epilog="Example: fdes aircraft list --json")
def list_all(json: AsJson = False) -> None:
    """All aircraft, their flight conditions, and the work that their numbers are from."""
    from fdes.aircraft import catalogue

    if json:
        print_json([_picture(a) for a in catalogue()])
        return
    from rich.table import Table
    from rich.text import Text

    drawn = Table.grid(padding=(0, 2))
    for a in catalogue():
        drawn.add_row(Text(a.id, "bold"), a.name)
        for c in a.conditions:
            drawn.add_row("", f"{c.id:<16}{c.name}")
        drawn.add_row("", Text(a.source, "dim"))
        drawn.add_row()
    show = screen()
    show.print(drawn)
    show.print("Any of them: fdes fly NAVION, fdes modes NAVION, fdes aircraft NAVION")


@app.command(epilog="Example: fdes aircraft show NAVION --condition M0.158_SL")
def show(
    aircraft: AircraftName,
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    json: AsJson = False,
) -> None:
    """Every number of an aircraft: as printed, corrected and why, how sure; and what is only assumed."""
    from fdes.aircraft import load
    from fdes.analysis.trim_alpha import dutch_roll_by_trim_alpha

    found = load(aircraft)
    ready = found.at(condition, variant)
    if json:
        depends = {"dutch_roll_by_trim_alpha": [at._asdict() for at in dutch_roll_by_trim_alpha(ready)]}
        print_json(_picture(found) | _numbers(ready) | depends | {"sources": dict(found.sources)})
        return
    page = screen()
    page.print(f"{found.name} ({found.id})", style="bold")
    page.print(found.summary)
    page.print(f"Also called {', '.join(found.aliases)}\n" if found.aliases else "")
    page.print(_named([(f"{c.id}{' <' * (c.id == ready.condition)}", c.name) for c in found.conditions]))
    page.print(_number_table(ready))
    if by_alpha := dutch_roll_by_trim_alpha(ready):
        page.print(_dutch_roll_table(by_alpha))
    assumed = [(name, f"{a['value']:,.10g} {a['unit']}: {a['reason']}") for name, a in ready.assumed.items()]
    for title, rows in (
        ("Corrections", _corrections(ready)),
        ("ASSUMED: no source gives these", assumed),
        ("Notes", _notes(ready)),
        ("Sources", [*found.sources.items()]),
    ):
        if rows:
            page.print(title, style="bold")
            page.print(_named(rows))


@app.command(epilog="Example: fdes aircraft save A-4D slack.toml --set Cm_q*=0.5")
def save(
    aircraft: AircraftName,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The file to write, NAME.toml.")],
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    changes: Changes = None,
) -> None:
    """Write a flight condition with its changes as an aircraft file that flies the same, printed values kept."""
    from fdes.aircraft.save import as_toml

    text = as_toml(chosen(aircraft, condition, variant, changes))
    if file.suffix != ".toml":
        raise SpecError(f"{file} does not end in .toml, by which an aircraft file is known. Name it {file.stem}.toml.")
    try:
        file.write_text(text, encoding="utf-8")
    except OSError as trouble:
        raise SpecError(f"{file} cannot be written: {trouble.strerror or trouble}.") from trouble
    screen().print(f"{file} is written. Fly it: fdes fly ./{file.name}", soft_wrap=True)


def _picture(aircraft: "Aircraft") -> dict[str, Any]:
    """What an aircraft is, for other programs. Altitudes in m."""
    return {
        "id": aircraft.id,
        "name": aircraft.name,
        "summary": aircraft.summary,
        "aliases": list(aircraft.aliases),
        "conditions": [asdict(c) for c in aircraft.conditions],
        "source": aircraft.source,
    }


def _numbers(ready: "FlightCondition") -> dict[str, Any]:
    """All numbers of a flight condition and where they are from."""
    return {
        "condition": ready.condition,
        "variant": ready.variant,
        "numbers": {name: asdict(p) for name, p in ready.provenance.items()},
        "assumed": {name: dict(a) for name, a in ready.assumed.items()},
        "notes": list(ready.notes),
    }


def _number_table(ready: "FlightCondition") -> "Table":
    """Numbers in the units of their source. What this variant does not use is dim."""
    from rich.text import Text

    drawn = table(
        "number",
        "printed",
        "corrected",
        "unit",
        "confidence",
        "SI",
        "",
        title=f"\n{ready.condition}, {ready.variant} values",
    )
    for k in (3, 4, 6):
        drawn.columns[k].justify = "left"
    corrected = ready.variant == "corrected"
    for name, p in ready.provenance.items():
        mended = p.corrected is not None
        printed = Text(f"{p.printed:,.10g}", "dim" if mended and corrected else "")
        by = Text("" if p.corrected is None else f"{p.corrected:,.10g}", "bold" if corrected else "dim")
        drawn.add_row(name, printed, by, _shown(p.unit), p.confidence or "", number(p.value), _shown(p.si_unit))
    return drawn


def _dutch_roll_table(by_alpha: "list[DutchRollAt]") -> "Table":
    """What hangs on a trim angle of attack that no source gives, or only a doubtful one."""
    title = "The trim angle of attack is not well known, and the Dutch roll depends on it"
    drawn = table("alpha [deg]", "zeta", "omega_n [rad/s]", "", title=title)
    for at in by_alpha:
        drawn.add_row(
            f"{at.alpha / DEG:.3g}",
            number(at.zeta, 3),
            number(at.omega_n, 3),
            "< used" if at.used else "",
            style="red" if at.zeta < 0.0 else None,
        )
    return drawn


def _shown(unit: str) -> str:
    return "" if unit == "1" else unit


def _corrections(ready: "FlightCondition") -> list[tuple[str, str]]:
    """Which numbers are corrected, and why; one reason may be that of several."""
    why: dict[str, list[str]] = {}
    for name, p in ready.provenance.items():
        if p.corrected is not None:
            reason = f"{str(p.reason).rstrip('.')}.{' Presumed: no source has it.' if p.unverified else ''}"
            why.setdefault(reason, []).append(name)
    return [(", ".join(names), reason) for reason, names in why.items()]


def _notes(ready: "FlightCondition") -> list[tuple[str, str]]:
    """What is to be known of the condition, then of single numbers."""
    return [*(("", text) for text in ready.notes), *((n, p.note) for n, p in ready.provenance.items() if p.note)]


def _named(rows: list[tuple[str, str]]) -> "Table":
    """Names, and what is to be said of them."""
    from rich.table import Table

    drawn = Table.grid(padding=(0, 2))
    drawn.add_column(no_wrap=True)
    for name, said in rows:
        drawn.add_row(name, said)
    drawn.add_row()
    return drawn
