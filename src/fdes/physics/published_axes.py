"""A and B from dimensional derivatives as a report prints them, in body or in stability axes.

The whole equations are written in the axes of the derivatives, then the state is turned into stability axes. That is a
similarity: the eigenvalues are those of the report's own equations.

Reference: D. McRuer, I. Ashkenas, D. Graham, Aircraft Dynamics and Automatic Control, 1973, eq. 4-44 to 4-49 and 6-5.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import cos, sin, tan
from fdes.physics.derivatives import Matrices, Matrix
from fdes.units import MeterPerSecond, MeterPerSecond2, Radian


class AxesDerivatives(NamedTuple):
    """Forces by the mass, moments by the moment of inertia; L and N primed, which is with the product of inertia.

    Ystar is Y / V: reports print the control derivatives of the side force so.
    """

    X_u: Annotated[float, "1/s"] = 0.0
    X_w: Annotated[float, "1/s"] = 0.0
    X_de: Annotated[float, "m/(s^2 rad)"] = 0.0
    Z_u: Annotated[float, "1/s"] = 0.0
    Z_w: Annotated[float, "1/s"] = 0.0
    Z_wdot: Annotated[float, "1"] = 0.0
    Z_q: Annotated[float, "m/(s rad)"] = 0.0
    Z_de: Annotated[float, "m/(s^2 rad)"] = 0.0
    M_u: Annotated[float, "rad/(m s)"] = 0.0
    M_w: Annotated[float, "rad/(m s)"] = 0.0
    M_wdot: Annotated[float, "rad/m"] = 0.0
    M_q: Annotated[float, "1/s"] = 0.0
    M_de: Annotated[float, "1/s^2"] = 0.0
    Y_v: Annotated[float, "1/s"] = 0.0
    Y_p: Annotated[float, "m/(s rad)"] = 0.0
    Y_r: Annotated[float, "m/(s rad)"] = 0.0
    Ystar_da: Annotated[float, "1/s"] = 0.0
    Ystar_dr: Annotated[float, "1/s"] = 0.0
    L_beta: Annotated[float, "1/s^2"] = 0.0
    L_p: Annotated[float, "1/s"] = 0.0
    L_r: Annotated[float, "1/s"] = 0.0
    L_da: Annotated[float, "1/s^2"] = 0.0
    L_dr: Annotated[float, "1/s^2"] = 0.0
    N_beta: Annotated[float, "1/s^2"] = 0.0
    N_p: Annotated[float, "1/s"] = 0.0
    N_r: Annotated[float, "1/s"] = 0.0
    N_da: Annotated[float, "1/s^2"] = 0.0
    N_dr: Annotated[float, "1/s^2"] = 0.0


def stability_axis_matrices(
    d: AxesDerivatives, V: MeterPerSecond, g: MeterPerSecond2, alpha: Radian, gamma: Radian, X_dT: MeterPerSecond2
) -> Matrices:
    """A and B in stability axes. `alpha` is the angle from the axes of `d` to the velocity: 0 in stability axes.

    The thrust acts along the velocity: X_dT is ours, no report has it.
    """
    U, W = V * cos(alpha), V * sin(alpha)
    theta = alpha + gamma
    z = 1.0 / (1.0 - d.Z_wdot)
    w = (d.Z_u * z, d.Z_w * z, (U + d.Z_q) * z, -g * sin(theta) * z)
    w_de = d.Z_de * z
    q = (d.M_u + d.M_wdot * w[0], d.M_w + d.M_wdot * w[1], d.M_q + d.M_wdot * w[2], d.M_wdot * w[3])
    A_lon: Matrix = ((d.X_u, d.X_w, -W, -g * cos(theta)), w, q, (0.0, 0.0, 1.0, 0.0))
    B_lon: Matrix = ((d.X_de,), (w_de,), (d.M_de + d.M_wdot * w_de,), (0.0,))
    A_lat: Matrix = (
        (d.Y_v, (W + d.Y_p) / V, (d.Y_r - U) / V, g * cos(theta) / V),
        (d.L_beta, d.L_p, d.L_r, 0.0),
        (d.N_beta, d.N_p, d.N_r, 0.0),
        (0.0, 1.0, tan(theta), 0.0),
    )
    B_lat: Matrix = ((d.Ystar_da, d.Ystar_dr), (d.L_da, d.L_dr), (d.N_da, d.N_dr), (0.0, 0.0))

    s, c = sin(alpha), cos(alpha)
    bank = cos(theta) / cos(gamma)  # a small bank about the velocity by one about the x axis
    lon: Matrix = ((c, s, 0.0, 0.0), (-s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    lon_back: Matrix = ((c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    lat: Matrix = ((1.0, 0.0, 0.0, 0.0), (0.0, c, s, 0.0), (0.0, -s, c, 0.0), (0.0, 0.0, 0.0, bank))
    lat_back: Matrix = ((1.0, 0.0, 0.0, 0.0), (0.0, c, -s, 0.0), (0.0, s, c, 0.0), (0.0, 0.0, 0.0, 1.0 / bank))
    turned = _product(lon, B_lon)
    return Matrices(
        A_lon=_product(_product(lon, A_lon), lon_back),
        B_lon=tuple((row[0], thrust) for row, thrust in zip(turned, (X_dT, 0.0, 0.0, 0.0), strict=True)),
        A_lat=_product(_product(lat, A_lat), lat_back),
        B_lat=_product(lat, B_lat),
    )


def _product(left: Matrix, right: Matrix) -> Matrix:
    columns = tuple(zip(*right, strict=True))
    return tuple(tuple(sum([a * b for a, b in zip(row, column, strict=True)]) for column in columns) for row in left)
