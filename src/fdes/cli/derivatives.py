"""`fdes derivatives`: dimensional derivatives, and the matrices A and B that are made of them."""

import json as json_text
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fdes.cli.options import (
    AircraftName,
    AsJson,
    Changes,
    ConditionName,
    FormName,
    VariantName,
    chosen,
    form_of_equations,
)
from fdes.cli.output import about, heading, number, print_json, screen, table
from fdes.errors import SpecError

if TYPE_CHECKING:
    from rich.table import Table

    from fdes.control import LinearModel
    from fdes.physics.derivatives import Dimensional

MATRIX_FILES = (".tex", ".mat", ".json")
ASSUMED = "*"  # marks what rests on a number that no source gives


def derivatives(
    aircraft: AircraftName,
    condition: ConditionName = None,
    form: FormName = "full",
    variant: VariantName = "corrected",
    changes: Changes = None,
    matrices: Annotated[
        str | None, typer.Option("--matrices", metavar="FILE", help="Write A and B: .tex, .mat or .json.")
    ] = None,
    json: AsJson = False,
) -> None:
    """Dimensional derivatives, A and B, in SI."""
    from fdes.analysis import linear_model
    from fdes.cli.plot import target_of
    from fdes.physics.derivatives import dimensional

    wanted, target = form_of_equations(form), target_of(matrices, MATRIX_FILES)
    ready = chosen(aircraft, condition, variant, changes)
    model = linear_model(ready, wanted)
    named = dimensional(ready.coefficients, ready.reference, wanted) if ready.nondimensional else None
    if target is not None:
        _write(target, model, about(ready, form))
    if json:
        print_json(
            about(ready, form)
            | {
                "longitudinal": _as_lists(model.longitudinal()),
                "lateral": _as_lists(model.lateral()),
                "dimensional": named
                and {name: {"value": value, "unit": unit} for name, (value, unit) in _with_units(named).items()},
            }
        )
        return
    show = screen()
    show.print(f"{heading(ready, form)}, SI\n")
    if named:
        show.print(_dimensional_table(named))
    else:
        show.print(
            "The source gives dimensional derivatives: fdes aircraft show has them as printed. "
            "A and B made of them, in stability axes:\n"
        )
    show.print(_matrix_table("Longitudinal: rows are rates of change", model.longitudinal()))
    show.print(_matrix_table("Lateral: rows are rates of change", model.lateral()))
    thrust = ready.assumed["max_thrust"]
    show.print(f"{ASSUMED} rests on an ASSUMED thrust of {thrust['value']:,g} {thrust['unit']}: {thrust['reason']}")
    if target is not None:
        show.print(f"{matrices} is written.", soft_wrap=True)


def _write(path: Path, model: "LinearModel", said: dict[str, Any]) -> None:
    """Both sets in the format of the suffix. Raises SpecError where the disk does not take it."""
    from fdes.control.matrix_files import latex, save_mat

    parts = {"longitudinal": model.longitudinal(), "lateral": model.lateral()}
    try:
        if path.suffix == ".mat":
            save_mat(path, **parts)
        elif path.suffix == ".json":
            content = said | {name: _as_lists(part) for name, part in parts.items()}
            path.write_text(json_text.dumps(content, indent=2) + "\n", encoding="utf-8")
        else:
            title = "% {aircraft} {condition}, {variant} values, form {form}, SI. \\usepackage{{amsmath}}".format(
                **said
            )
            sets = [f"\n% {name}\n\\[\n{latex(part)}\n\\]\n" for name, part in parts.items()]
            path.write_text(f"{title}\n{''.join(sets)}", encoding="utf-8")
    except OSError as trouble:
        raise SpecError(f"{path} cannot be written: {trouble.strerror or trouble}.") from trouble


def _as_lists(part: "LinearModel") -> dict[str, Any]:
    return {"states": list(part.states), "inputs": list(part.inputs), "A": part.A.tolist(), "B": part.B.tolist()}


def _with_units(named: "Dimensional") -> dict[str, tuple[float, str]]:
    """Each derivative with its unit."""
    from fdes.physics.signals import channels

    return {c.name: (value, c.unit) for c, value in zip(channels(type(named)), named, strict=True)}


def _dimensional_table(named: "Dimensional") -> "Table":
    """Longitudinal derivatives beside the lateral ones."""
    drawn = table("longitudinal", "", "unit", "  lateral", "", "unit", title="Dimensional derivatives")
    for k in (2, 3, 5):
        drawn.columns[k].justify = "left"
    cells = [
        (name + ASSUMED * (name == "X_dT"), number(value), unit) for name, (value, unit) in _with_units(named).items()
    ]
    first = next(k for k, name in enumerate(named._fields) if name.startswith("Y"))
    left, right = cells[:first], cells[first:]
    for (name, value, unit), (other, its_value, its_unit) in zip(left, [*right, *[("", "", "")] * 2], strict=False):
        drawn.add_row(name, value, unit, f"  {other}", its_value, its_unit)
    return drawn


def _matrix_table(title: str, part: "LinearModel") -> "Table":
    """A and B side by side."""
    heads = [f"{name}{ASSUMED * (name == 'throttle')}\n[{part.units[name]}]" for name in (*part.states, *part.inputs)]
    drawn = table("", *heads, title=title)
    for name, a, b in zip(part.states, part.A, part.B, strict=True):
        drawn.add_row(f"{name}_dot", *map(number, a), *map(number, b))
    return drawn
