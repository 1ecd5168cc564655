"""A flight of the nonlinear plant under the names and in the units of NASA's check cases.

The names are those of the columns that NASA/TM-2015-218675 publishes, made after ANSI/AIAA S-119-2011.
"""

import numpy as np
from numpy.typing import NDArray

from fdes.flight.recording import Recording
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.attitude import rotation, turned, turned_back
from fdes.physics.earth import Earth, geodetic, place
from fdes.physics.plant import State
from fdes.units import DEG, FOOT, KNOT, POUND_FORCE, SLUG, Kelvin

Column = NDArray[np.float64]


def s119_columns(earth: Earth, flight: Recording, warmer: Kelvin = 0.0) -> dict[str, Column]:
    """The columns by name, in US units; over a flat Earth without latitude and longitude.

    warmer: the day than the standard.
    """
    states = [State(*row) for row in np.column_stack([flight[f"state_{name}"] for name in State._fields]).tolist()]
    velocity = np.array([_velocity(earth, x) for x in states]) / FOOT
    columns = {"time": flight["t"], "altitudeMsl_ft": flight["h"] / FOOT}
    if not earth.g:
        found = np.array([geodetic(earth, x.x, x.y, x.z)[:2] for x in states]) / DEG
        columns |= {"longitude_deg": found[:, 1], "latitude_deg": found[:, 0]}
    air = np.array([standard_atmosphere(h, warmer) for h in flight["h"].tolist()])
    return columns | {
        "feVelocity_ft_s_X": velocity[:, 0],
        "feVelocity_ft_s_Y": velocity[:, 1],
        "feVelocity_ft_s_Z": velocity[:, 2],
        "eulerAngle_deg_Yaw": flight["psi"] / DEG,
        "eulerAngle_deg_Pitch": flight["theta"] / DEG,
        "eulerAngle_deg_Roll": flight["phi"] / DEG,
        "bodyAngularRateWrtEi_deg_s_Roll": flight["p"] / DEG,
        "bodyAngularRateWrtEi_deg_s_Pitch": flight["q"] / DEG,
        "bodyAngularRateWrtEi_deg_s_Yaw": flight["r"] / DEG,
        "ambientTemperature_dgR": air[:, 0] * 1.8,
        "ambientPressure_lbf_ft2": air[:, 1] * FOOT**2 / POUND_FORCE,
        "airDensity_slug_ft3": air[:, 2] * FOOT**3 / SLUG,
        "speedOfSound_ft_s": air[:, 3] / FOOT,
        "mach": flight["mach"],
        "dynamicPressure_lbf_ft2": flight["qbar"] * FOOT**2 / POUND_FORCE,
        "trueAirspeed_nmi_h": flight["V"] / KNOT,
    }


def _velocity(earth: Earth, x: State) -> tuple[float, float, float]:
    """Over the Earth, along local north, east, down [m/s]."""
    over = turned(rotation(x.e0, x.e1, x.e2, x.e3), x.u, x.v, x.w)
    return turned_back(place(earth, x.x, x.y, x.z).local, *over)
