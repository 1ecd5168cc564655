"""`fdes trim`: the steady flight that is asked for, or what keeps the aircraft from it."""

from typing import TYPE_CHECKING, Annotated, Any

import typer

from fdes.cli.options import Across, AircraftName, AsJson, Changes, ConditionName, PlotFile, VariantName, chosen
from fdes.cli.output import note, number, print_json, screen, table, working
from fdes.cli.scenario import loading_of
from fdes.errors import SpecError
from fdes.units import DEG, parse

if TYPE_CHECKING:
    from fdes.analysis.trim import TrimPoint, TrimSpec
    from fdes.analysis.trim_map import TrimLine
    from fdes.physics.plant import SixDof


def trim(
    aircraft: AircraftName,
    wanted: Annotated[
        str,
        typer.Argument(metavar="TEXT", help="Such as 'V=170 kt h=5000 ft gamma=3 deg', or 'CAS=250 kt bank=45 deg'."),
    ] = "",
    condition: ConditionName = None,
    variant: VariantName = "corrected",
    changes: Changes = None,
    across: Across = None,
    heights: Annotated[
        str | None,
        typer.Option(metavar="TEXT", help="All speeds that can be flown at these, such as '0 ft, 10000 ft, 6 km'."),
    ] = None,
    plot: PlotFile = None,
    json: AsJson = False,
) -> None:
    """Trim the nonlinear plant in steady flight: straight, climbing, turning, pulling up or sideslipping.

    What is not said is that of the flight condition: its speed and height, level, straight, without sideslip. Speed: V
    (true), CAS, EAS, M, or alpha. Path: gamma, climb ('climb=1000 ft/min'), or throttle, from which it follows. Turn:
    turn, as a rate or as a load factor ('turn=2 g', to the left '-2 g'), or bank. Pull-up or push-over: n, the load
    factor, or q. Sideslip: beta, or n_y=0 for none of the side force; 'bank=5 deg turn=0' is a straight one. Surfaces
    are from those of the condition.
    """
    from fdes.analysis.trim import TrimSpec, spec_of, stalled
    from fdes.analysis.trim import trim as found_by
    from fdes.flight.nonlinear import assumptions, six_dof_of
    from fdes.flight.table_ends import beyond_tables

    ready = chosen(aircraft, loading_of(aircraft, condition, wanted), variant, changes, across)
    plant = six_dof_of(ready)
    default = TrimSpec(ready.reference.V, ready.reference.h)
    spec, said = spec_of(wanted, default) if wanted else default, assumptions(ready, plant)
    if heights is not None or plot is not None:
        _map(plant, spec, heights, plot, f"{ready.aircraft_name}, {ready.condition}", json)
        return
    point = found_by(plant, spec)
    said += stalled(point)
    said += beyond_tables(point.plant, {name: [value] for name, value in point.outputs()._asdict().items()})
    if json:
        print_json({
            "aircraft": ready.aircraft_id,
            "condition": ready.condition,
            "units": "SI",
            "asked": point.asked.asked(),
            "flight": point.spec.flight(),
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


def _map(plant: "SixDof", spec: "TrimSpec", heights: str | None, plot: str | None, title: str, json: bool) -> None:
    """Every speed that can be flown, at each height."""
    from fdes.analysis.trim_map import drawn, trim_map
    from fdes.cli.plot import save_plot, target_of

    if spec.alpha is not None:
        raise SpecError("A map is over all speeds, and an angle of attack fixes one: leave alpha out of the trim.")
    target = target_of(plot)
    wanted = [spec.h] if heights is None else [parse(h.strip(), "m") for h in heights.split(",")]
    with working("Trimming"):
        lines = trim_map(plant, spec, wanted)
    if not lines:
        raise SpecError(f"At none of these heights can it be flown at any speed near {spec.V:.4g} m/s. Try lower ones.")
    if target is not None:
        save_plot(drawn(lines, title), target)
    if json:
        print_json({"lines": [_line_as_json(line) for line in lines], "units": "SI"})
        return
    screen().print(f"{title}: speeds that can be flown, true airspeed in m/s", style="bold")
    rows = table("height [m]", "slowest", "least power", "best excess [m/s]", "at", "fastest")
    for line in lines:
        V, excess = line.speeds, line.excess_power()
        power = [speed * T for speed, T in zip(V, line.required, strict=True)]
        best = excess.index(max(excess))
        figures = (V[0], V[power.index(min(power))], excess[best], V[best], V[-1])
        rows.add_row(f"{line.h:,.0f}", *(number(f, 4) for f in figures))
    screen().print(rows)
    for line in lines:
        screen().print(f"At {line.h:,.0f} m, slower: {line.slow_end or 'not looked for'}.", soft_wrap=True)
        screen().print(f"At {line.h:,.0f} m, faster: {line.fast_end or 'not looked for'}.", soft_wrap=True)
    if plot is not None:
        screen().print(f"{plot} is written.", soft_wrap=True)


def _line_as_json(line: "TrimLine") -> dict[str, Any]:
    return {
        "h": line.h,
        "V": line.speeds,
        "alpha": [p.alpha for p in line.points],
        **{name: [getattr(p.surfaces, name) for p in line.points] for name in ("elevator", "throttle")},
        "thrust_required": line.required,
        "thrust_available": line.available,
        "excess_power": line.excess_power(),
        "slow_end": line.slow_end,
        "fast_end": line.fast_end,
    }


def _show(point: "TrimPoint", title: str) -> None:
    from fdes.physics.aero import derivative_loads

    spec, surfaces, y = point.spec, point.surfaces, point.outputs()
    elevator = "elevator, from the condition's" if point.plant.aerodynamics is derivative_loads else "elevator"
    screen().print(f"{title}: V = {spec.V:.4g} m/s, h = {spec.h:,.0f} m", style="bold")
    drawn = table("quantity", "value", "unit")
    for name, value, unit in (
        ("flight-path angle", spec.gamma / DEG, "deg"),
        ("turn rate", spec.turn / DEG, "deg/s"),
        ("pitch rate", y.q / DEG, "deg/s"),
        ("load factor n_z", y.n_z, "g"),
        ("sideslip", spec.beta / DEG, "deg"),
        ("angle of attack", point.alpha / DEG, "deg"),
        ("pitch", point.theta / DEG, "deg"),
        ("bank", point.phi / DEG, "deg"),
        (elevator, surfaces.elevator / DEG, "deg"),
        ("aileron", surfaces.aileron / DEG, "deg"),
        ("rudder", surfaces.rudder / DEG, "deg"),
        ("throttle", surfaces.throttle, "of 1"),
    ):
        drawn.add_row(name, number(value), unit)
    screen().print(drawn)
    screen().print(
        f"{point.iterations} iterations; the largest acceleration that is left is {point.residual:.1g} m/s^2 or rad/s^2"
    )
