"""Dormand and Prince's fifth-order method, at a fixed step and without its error estimate."""

from fdes.physics.runge_kutta import Tableau

__all__ = ["dopri5"]

dopri5 = Tableau(
    name="Dormand-Prince 5",
    order=5,
    c=(0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0),
    a=(
        (),
        (1 / 5,),
        (3 / 40, 9 / 40),
        (44 / 45, -56 / 15, 32 / 9),
        (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
        (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    ),
    b=(35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
    reference="J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6, 1980, 19-26, table 2",
)
