"""The classical fourth-order Runge-Kutta method."""

from fdes.physics.runge_kutta import Tableau

__all__ = ["rk4"]

rk4 = Tableau(
    name="Runge-Kutta 4",
    order=4,
    c=(0.0, 1 / 2, 1 / 2, 1.0),
    a=(
        (),
        (1 / 2,),
        (0.0, 1 / 2),
        (0.0, 0.0, 1.0),
    ),
    b=(1 / 6, 1 / 3, 1 / 3, 1 / 6),
    reference="W. Kutta, Zeitschrift fuer Mathematik und Physik 46, 1901, 435-453",
)
