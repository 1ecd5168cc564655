"""What crosses the border of a plant: surfaces and air going in, outputs coming out.

The fields of `Outputs` are the signal catalogue. Their names, units, long names and order serve the recorder, the
wire to the cockpit and the documentation; nobody else keeps a list.

Signs are written once, in docs/symbols.md: body axes forward-right-down, positive elevator trailing edge down
(pitches down), positive aileron rolls right, positive rudder trailing edge left (yaws left).
"""

from typing import Annotated, NamedTuple, get_type_hints

from fdes.units import Meter, MeterPerSecond, Number, Pascal, Radian, RadianPerSecond, RadianPerSecond2


class Surfaces(NamedTuple):
    """What a control law commands. For the linear plant surfaces are measured from trim; throttle is absolute."""

    elevator: Radian = 0.0
    aileron: Radian = 0.0
    rudder: Radian = 0.0
    throttle: Number = 0.0


class Air(NamedTuple):
    """How the air moves: the steady wind it blows with, and the gust on top, in body axes, at the cg."""

    wind_north: MeterPerSecond = 0.0
    wind_east: MeterPerSecond = 0.0
    wind_down: MeterPerSecond = 0.0
    gust_u: MeterPerSecond = 0.0
    gust_v: MeterPerSecond = 0.0
    gust_w: MeterPerSecond = 0.0


class Outputs(NamedTuple):
    """All that a pilot, a law, an instrument or a criterion may ask of one instant. SI and radians."""

    V: Annotated[MeterPerSecond, "true airspeed"]
    mach: Annotated[Number, "Mach number"]
    cas: Annotated[MeterPerSecond, "calibrated airspeed"]
    eas: Annotated[MeterPerSecond, "equivalent airspeed"]
    qbar: Annotated[Pascal, "dynamic pressure"]
    alpha: Annotated[Radian, "angle of attack"]
    beta: Annotated[Radian, "angle of sideslip"]
    gamma: Annotated[Radian, "flight-path angle"]
    chi: Annotated[Radian, "course over the ground"]
    phi: Annotated[Radian, "bank angle"]
    theta: Annotated[Radian, "pitch attitude"]
    psi: Annotated[Radian, "heading"]
    p: Annotated[RadianPerSecond, "roll rate"]
    q: Annotated[RadianPerSecond, "pitch rate"]
    r: Annotated[RadianPerSecond, "yaw rate"]
    p_dot: Annotated[RadianPerSecond2, "roll acceleration"]
    q_dot: Annotated[RadianPerSecond2, "pitch acceleration"]
    r_dot: Annotated[RadianPerSecond2, "yaw acceleration"]
    psi_dot: Annotated[RadianPerSecond, "turn rate"]
    n_x: Annotated[Number, "load factor, forward"]
    n_y: Annotated[Number, "load factor, right"]
    n_z: Annotated[Number, "load factor, normal (up)"]
    h: Annotated[Meter, "height above mean sea level"]
    h_dot: Annotated[MeterPerSecond, "climb rate"]
    north: Annotated[Meter, "distance north"]
    east: Annotated[Meter, "distance east"]
    ground_speed: Annotated[MeterPerSecond, "speed over the ground"]
    elevator: Annotated[Radian, "elevator, from trim"]
    aileron: Annotated[Radian, "aileron"]
    rudder: Annotated[Radian, "rudder"]
    throttle: Annotated[Number, "throttle"]
    excursion: Annotated[Radian, "largest angle from the reference flight condition"]


class Channel(NamedTuple):
    """One named signal: what tables, recordings and the wire say of it."""

    name: str
    unit: str
    long_name: str


def channels(record: type, prefix: str = "") -> tuple[Channel, ...]:
    """The fields of a named tuple whose annotations carry a unit, and perhaps a long name, as channels."""
    found = []
    for name, hint in get_type_hints(record, include_extras=True).items():
        unit, *words = hint.__metadata__
        label = f"{prefix}{name}"
        found.append(Channel(label, unit, words[-1] if words else label.replace("_", " ")))
    return tuple(found)
