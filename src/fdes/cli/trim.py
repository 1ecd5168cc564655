"""`fdes trim`: the steady flight that is asked for, or what keeps the aircraft from it."""

from typing import TYPE_CHECKING, Annotated

import typer

from fdes.cli.options import AircraftName, AsJson, Changes, ConditionName, VariantName, chosen
from fdes.cli.output import note, number, print_json, screen, table
from fdes.units import DEG

if TYPE_CHECKING:
    from fdes.analysis.trim import TrimPoint


def trim(
    aircraft: AircraftName,
    wanted: Annotated[
        str, typer.Argument(metavar="TEXT", help="Such as 'V=170 kt h=5000 ft gamma=3 deg turn=3 deg/s beta=2 deg'.")
    ] = "",
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    changes: Changes = None,
    json: AsJson = False,
) -> None:
    """Trim the nonlinear plant in steady flight: straight, climbing, turning or sideslipping.

    What is not said is that of the flight condition: its speed and height, level, straight. `mach` may be given instead
    of V. Surfaces are from those of the condition.
    """
    from fdes.analysis.trim import TrimSpec, spec_of
    from fdes.analysis.trim import trim as found_by
    from fdes.flight.nonlinear import assumptions, six_dof_of

    ready = chosen(aircraft, condition, variant, changes)
    plant = six_dof_of(ready)
    default = TrimSpec(ready.reference.V, ready.reference.h)
    point = found_by(plant, spec_of(wanted, default) if wanted else default)
    said = assumptions(ready, plant)
    if json:
        print_json({
            "aircraft": ready.aircraft_id,
            "condition": ready.condition,
            "units": "SI",
            "asked": point.spec._asdict(),
            "alpha": point.alpha,
            "phi": point.phi,
            "theta": point.theta,
            "controls": point.surfaces._asdict(),
            "state": point.state._asdict(),
            "residual": point.residual,
            "iterations": point.iterations,
            "notes": said,
        })  # fmt: skip
        return
    _show(point, f"{ready.aircraft_name}, {ready.condition}")
    for sentence in said:
        note(sentence)


def _show(point: "TrimPoint", title: str) -> None:
    spec, surfaces = point.spec, point.surfaces
    screen().print(f"{title}: V = {spec.V:.4g} m/s, h = {spec.h:,.0f} m", style="bold")
    drawn = table("quantity", "value", "unit")
    for name, value, unit in (
        ("flight-path angle", spec.gamma / DEG, "deg"),
        ("turn rate", spec.turn / DEG, "deg/s"),
        ("sideslip", spec.beta / DEG, "deg"),
        ("angle of attack", point.alpha / DEG, "deg"),
        ("pitch", point.theta / DEG, "deg"),
        ("bank", point.phi / DEG, "deg"),
        ("elevator, from the condition's", surfaces.elevator / DEG, "deg"),
        ("aileron", surfaces.aileron / DEG, "deg"),
        ("rudder", surfaces.rudder / DEG, "deg"),
        ("throttle", surfaces.throttle, "of 1"),
    ):
        drawn.add_row(name, number(value), unit)
    screen().print(drawn)
    screen().print(
        f"{point.iterations} iterations; the largest acceleration that is left is {point.residual:.1g} m/s^2 or rad/s^2"
    )
