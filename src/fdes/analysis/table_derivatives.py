"""Nelson's nondimensional derivatives of an aircraft that is given by tables, in one steady flight.

They make its linear plant, its modes and its Levels, and stand in its file beside the tables: a test holds the two
together. They are slopes of the very text that flies, by complex step.

Reference: W. Squire, G. Trapp, SIAM Review 40 (1998) 110-112; R. C. Nelson, Flight Stability and Automatic Control, 2nd
ed., McGraw-Hill 1998, tables 3.5 and 5.1, for the definitions.
"""

from typing import Any

from fdes.elementary import cos, sin
from fdes.physics.aero import Flow
from fdes.physics.derivatives import Coefficients
from fdes.physics.signals import Surfaces
from fdes.physics.terms import TermAero, term_loads
from fdes.units import MeterPerSecond, Number, Radian

TINY = 1e-30  # a complex step: nothing is subtracted, so nothing is lost
STEPS = ("alpha", "beta", "p", "q", "r", "elevator", "aileron", "rudder", "mach")


def table_derivatives(
    aero: TermAero, V: MeterPerSecond, alpha: Radian, surfaces: Surfaces, mach: Number
) -> Coefficients:
    """The derivatives at `V`, `alpha` and those surfaces, straight and without sideslip, in stability axes of `alpha`.

    Moments are about the center of gravity. Tables know no alpha_dot, so its derivatives are 0.
    """

    def slopes(name: str) -> dict[str, float]:
        return {key: value.imag / TINY for key, value in _coefficients(aero, V, alpha, surfaces, mach, name).items()}

    steady = _coefficients(aero, V, alpha, surfaces, mach, "")
    by = {name: slopes(name) for name in STEPS}
    long, side = ("CL", "CD", "Cm"), ("Cy", "Cl", "Cn")
    found = {name: by["alpha"][name[:2]] for name in ("CL_alpha", "CD_alpha", "Cm_alpha")}
    found |= {"CL_q": by["q"]["CL"], "Cm_q": by["q"]["Cm"], "CL_alphadot": 0.0, "Cm_alphadot": 0.0}
    found |= {f"{c}_M": by["mach"][c] for c in long} | {f"{c}_de": by["elevator"][c] for c in long}
    found |= {f"{c}_{n}": by[n][c] for c in side for n in ("beta", "p", "r")}
    found |= {f"{c}_da": by["aileron"][c] for c in side} | {f"{c}_dr": by["rudder"][c] for c in side}
    return Coefficients(CL=steady["CL"].real, CD=steady["CD"].real, **found)


def _coefficients(
    aero: TermAero, V: float, alpha: float, surfaces: Surfaces, mach: float, stepped: str
) -> dict[str, Any]:
    """All six coefficients, one of `STEPS` having a step: of rates, the nondimensional ones in stability axes."""
    z = {name: complex(0.0, TINY if name == stepped else 0.0) for name in STEPS}
    ca, sa = cos(alpha), sin(alpha)
    p, r = 2.0 * V / aero.b * z["p"], 2.0 * V / aero.b * z["r"]
    rates: Any = (p * ca - r * sa, 2.0 * V / aero.c * z["q"], p * sa + r * ca)
    angle: Any = alpha + z["alpha"]
    flow = Flow._make([V, V * ca, 0.0, V * sa, angle, z["beta"], *rates, 1.0, mach + z["mach"], 1.0])
    moved = [s + z.get(name, 0.0) for name, s in surfaces._asdict().items()]
    loads: Any = term_loads(aero, flow, Surfaces._make(moved))
    S, Sb = aero.S, aero.S * aero.b
    c, s = cos(angle), sin(angle)
    return {
        "CL": (loads.X * s - loads.Z * c) / S,
        "CD": -(loads.X * c + loads.Z * s) / S,
        "Cm": loads.M / (S * aero.c),
        "Cy": loads.Y / S,
        "Cl": (loads.L * ca + loads.N * sa) / Sb,
        "Cn": (loads.N * ca - loads.L * sa) / Sb,
    }
