"""`fdes linearize`: A, B, C and D of the nonlinear plant about a trimmed flight, and the modes of A."""

from typing import Annotated

import typer

from fdes.cli.law import show_law
from fdes.cli.options import (
    FLAG,
    Across,
    AircraftName,
    AsJson,
    Changes,
    ConditionName,
    LawText,
    VariantName,
    chosen,
    designed_law,
)
from fdes.cli.output import note, number, print_json, screen, table
from fdes.cli.scenario import loading_of

DUST = 1e-12  # what rounding leaves of a zero


def linearize(
    aircraft: AircraftName,
    wanted: Annotated[
        str, typer.Argument(metavar="TEXT", help="The trim, such as 'V=170 kt h=5000 ft gamma=3 deg'.")
    ] = "",
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    changes: Changes = None,
    across: Across = None,
    thrust_held: Annotated[
        bool,
        typer.Option("--thrust-held", metavar=FLAG, help="Thrust does not change with speed, as in the linear plant."),
    ] = False,
    law: LawText = None,
    json: AsJson = False,
) -> None:
    """Linearize the nonlinear plant where it is trimmed: the derivative that flies, differentiated by complex step.

    States are along the stability axes of the trim, surfaces in rad. C and D, to the outputs along body axes, are in
    the JSON. With a law, its continuous `linear()` closes the loop: inputs are what is added to its command, and the
    stick. It feels rates along body axes, as in flight; on the linear plant they are along the stability axes.
    """
    from fdes.analysis import modes
    from fdes.analysis.jacobian import linearized
    from fdes.analysis.trim import TrimSpec, spec_of, trim
    from fdes.flight.nonlinear import assumptions, six_dof_of
    from fdes.flight.table_ends import beyond_tables

    ready = chosen(aircraft, loading_of(aircraft, condition, wanted), variant, changes, across)
    default = TrimSpec(ready.reference.V, ready.reference.h)
    plant = six_dof_of(ready)
    point = trim(plant, spec_of(wanted, default) if wanted else default)
    model = linearized(point, thrust_held=thrust_held)
    designed = None if law is None else designed_law(law, ready, "full")
    if designed is not None:
        from fdes.analysis.closed_loop import close

        model = close(model, designed.law)
    outputs = point.outputs()._asdict()
    said = assumptions(ready, plant) + beyond_tables(point.plant, {name: [value] for name, value in outputs.items()})
    if json:
        print_json({
            "aircraft": ready.aircraft_id,
            "condition": ready.condition,
            "point": model.point,
            "states": model.states,
            "inputs": model.inputs,
            "outputs": model.outputs,
            "units": model.units,
            **{name: getattr(model, name).tolist() for name in "ABCD"},
            **({} if designed is None else {"law": designed.as_dict()}),
            "notes": said,
        })  # fmt: skip
        return
    spec = point.spec
    title = f"{ready.aircraft_name}, {ready.condition}: V = {spec.V:.4g} m/s, h = {spec.h:,.0f} m"
    screen().print(f"{title}; SI and radians", style="bold")
    if designed is not None:
        show_law(designed)
    for part in (model.longitudinal(), model.lateral()) if designed is None else ():
        drawn = table("d/dt", *part.states, *part.inputs)
        for name, row, gains in zip(part.states, part.A, part.B, strict=True):
            drawn.add_row(name, *(number(v if abs(v) > DUST else 0.0, 4) for v in (*row, *gains)))
        screen().print(drawn)
    drawn = table("mode", "eigenvalue [1/s]", "zeta", "omega_n [rad/s]")
    for mode in modes(model):
        s = mode.eigenvalue
        value = f"{s.real:.4g} ± {abs(s.imag):.4g}j" if s.imag else f"{s.real:.4g}"
        drawn.add_row(mode.name.replace("_", " "), value, number(-s.real / abs(s), 3), number(abs(s), 4))
    screen().print(drawn)
    for sentence in said:
        note(sentence)
