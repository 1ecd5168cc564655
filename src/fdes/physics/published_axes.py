"""A and B from dimensional derivatives as a report prints them, in body or in stability axes.

State, forces and moments are turned from the axes of the derivatives to stability axes. That is a similarity: the
eigenvalues are those of the report's own equations, in which rotation and gravity have components along both axes.

Reference: D. McRuer, I. Ashkenas, D. Graham, Aircraft Dynamics and Automatic Control, 1973, eq. 4-44 to 4-49 and 6-5.
"""

from typing import Annotated, NamedTuple

from fdes.elementary import cos, sin, tan
from fdes.physics.derivatives import Matrices
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
    s, c = sin(alpha), cos(alpha)

    def turned(first: float, second: float) -> tuple[float, float]:
        """The x and z components of a vector, or derivatives with respect to them, along the stability axes."""
        return c * first + s * second, c * second - s * first

    # Columns u, w, q, theta, elevator: the aerodynamics turned; gravity and rotation as stability axes have them.
    X = (*turned(d.X_u, d.X_w), 0.0, 0.0, d.X_de)
    Z = (*turned(d.Z_u, d.Z_w), d.Z_q, 0.0, d.Z_de)
    M = (*turned(d.M_u, d.M_w), d.M_q, 0.0, d.M_de)
    free = ((0.0, 0.0), (0.0, 0.0), (0.0, V), (-g * cos(gamma), -g * sin(gamma)), (0.0, 0.0))
    forces = [turned(x, z) for x, z in zip(X, Z, strict=True)]
    along, down = zip(*[(x + a, z + b) for (x, z), (a, b) in zip(forces, free, strict=True)], strict=True)
    # Z_wdot and M_wdot go with the acceleration along the z axis of the derivatives.
    w_dot = [(s * x + c * z) / (1.0 - d.Z_wdot) for x, z in zip(along, down, strict=True)]
    u = [x + s * d.Z_wdot * a for x, a in zip(along, w_dot, strict=True)]
    w = [z + c * d.Z_wdot * a for z, a in zip(down, w_dot, strict=True)]
    q = [m + d.M_wdot * a for m, a in zip(M, w_dot, strict=True)]

    # Columns p, r, then those of one derivative alone.
    side_p, side_r = turned(d.Y_p / V, d.Y_r / V)
    (L_p, N_p), (L_r, N_r) = (turned(*by) for by in zip(turned(d.L_p, d.L_r), turned(d.N_p, d.N_r), strict=True))
    L_beta, N_beta = turned(d.L_beta, d.N_beta)
    L_da, N_da = turned(d.L_da, d.N_da)
    L_dr, N_dr = turned(d.L_dr, d.N_dr)
    return Matrices(
        A_lon=(tuple(u[:4]), tuple(w[:4]), tuple(q[:4]), (0.0, 0.0, 1.0, 0.0)),
        B_lon=((u[4], X_dT), (w[4], 0.0), (q[4], 0.0), (0.0, 0.0)),
        A_lat=(
            (d.Y_v, side_p, side_r - 1.0, g * cos(gamma) / V),
            (L_beta, L_p, L_r, 0.0),
            (N_beta, N_p, N_r, 0.0),
            (0.0, 1.0, tan(gamma), 0.0),
        ),
        B_lat=((d.Ystar_da, d.Ystar_dr), (L_da, L_dr), (N_da, N_dr), (0.0, 0.0)),
    )
