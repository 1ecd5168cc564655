"""`fdes modes`: the natural modes of an aircraft."""

from typing import TYPE_CHECKING

from fdes.cli.options import AircraftName, AsJson, ConditionName, FormName, VariantName, form_of_equations
from fdes.cli.output import about, number, print_json, screen, table

if TYPE_CHECKING:
    from rich.table import Table

    from fdes.analysis import Mode

DIGITS = 3  # of what follows from an eigenvalue


def modes(
    aircraft: AircraftName,
    condition: ConditionName = None,
    form: FormName = "full",
    variant: VariantName = "corrected",
    json: AsJson = False,
) -> None:
    """Natural modes: eigenvalues, damping, and times to half or to double."""
    from fdes.aircraft import load
    from fdes.analysis import modes as modes_of

    wanted = form_of_equations(form)
    ready = load(aircraft).at(condition, variant)
    found = modes_of(ready, wanted)
    if json:
        print_json(about(ready, form) | {"modes": [mode.as_dict() for mode in found]})
        return
    show = screen()
    show.print(f"{ready.aircraft_name}, {ready.condition}: {ready.variant} values, form {form}\n")
    for axis in ("longitudinal", "lateral"):
        show.print(_table(axis.capitalize(), [mode for mode in found if mode.axis == axis]))


def _table(title: str, found: "list[Mode]") -> "Table":
    drawn = table(
        "mode",
        "eigenvalue\n[rad/s]",
        "omega_n\n[rad/s]",
        "zeta\n",
        "tau\n[s]",
        "to half,\ndouble [s]",
        "period\n[s]",
        title=title,
    )
    for mode in found:
        drawn.add_row(
            mode.name.replace("_", " "),
            _eigenvalue(mode.eigenvalue),
            number(mode.omega_n, DIGITS),
            number(mode.zeta, DIGITS),
            number(mode.time_constant, DIGITS),
            _half_or_double(mode),
            number(mode.period, DIGITS),
            style=None if mode.time_to_double is None else "red",
        )
    return drawn


def _eigenvalue(value: complex) -> str:
    return f"{number(value.real)} ± {number(value.imag)}i" if value.imag else number(value.real)


def _half_or_double(mode: "Mode") -> str:
    if mode.time_to_double is not None:
        return f"{number(mode.time_to_double, DIGITS)} double"
    return "" if mode.time_to_half is None else f"{number(mode.time_to_half, DIGITS)} half"
