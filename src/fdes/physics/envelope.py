"""The envelope of the nonlinear plant: in it, every aircraft's equations are sure to give numbers. Beyond it a flight
has departed, and is ended with the name of the state that left.

It is far wider than what the aerodynamics of any aircraft are known for; that is announced elsewhere (`table_ends`).
"""

from typing import Any

from fdes.errors import Departed
from fdes.physics.atmosphere import BOTTOM, TOP
from fdes.units import Meter, MeterPerSecond, RadianPerSecond

MARGIN: Meter = 100.0  # to the ends of the atmosphere: no step goes as far
LOWEST, HIGHEST = BOTTOM + MARGIN, TOP - MARGIN  # m above mean sea level
FASTEST: MeterPerSecond = 3000.0  # each of u, v, w: some ten times the speed of sound
QUICKEST: RadianPerSecond = 100.0  # each of p, q, r: sixteen turns a second
POWER = 1000.0  # %, either way: ten times that of any engine
BOUNDS = {
    **dict.fromkeys(("u", "v", "w"), (FASTEST, "m/s")),
    **dict.fromkeys(("p", "q", "r"), (QUICKEST, "rad/s")),
    "power": (POWER, "%"),
}


def must_be_inside(x: Any, h: Meter) -> None:
    """Raises Departed where the state `x`, at height `h` above mean sea level, is not in the envelope."""
    if not LOWEST < h < HIGHEST:
        raise Departed(
            f"The flight departed: its height reached {h:,.0f} m, and the atmosphere that its plant knows reaches "
            f"from {LOWEST:,.0f} m to {HIGHEST:,.0f} m above mean sea level. End the flight before."
        )
    for name, (bound, unit) in BOUNDS.items():
        value = getattr(x, name)
        if not -bound < value < bound:
            raise Departed(
                f"The flight departed: {name} reached {value:.4g} {unit}, and its plant is sure of numbers up to "
                f"{bound:g} {unit}. Either the aircraft is unstable here, or the integrator is with this time step: "
                "try a smaller one."
            )


def lost_within(x: Any, dt: float) -> Departed:
    """What ended a flight that was in state `x` when a step of `dt` [s] led to where there are no numbers."""
    name = max(BOUNDS, key=lambda name: abs(getattr(x, name)) / BOUNDS[name][0])
    return Departed(
        f"The flight departed: within one step of {dt:g} s it left what its plant can compute, {name} having been "
        f"{getattr(x, name):.4g} {BOUNDS[name][1]}. Try a smaller time step."
    )
