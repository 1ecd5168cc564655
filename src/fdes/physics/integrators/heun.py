"""Heun's method: the trapezoidal rule with an Euler predictor."""

from fdes.physics.runge_kutta import Tableau

__all__ = ["heun"]

heun = Tableau(
    name="Heun",
    order=2,
    c=(0.0, 1.0),
    a=((), (1.0,)),
    b=(1 / 2, 1 / 2),
    reference="K. Heun, Zeitschrift fuer Mathematik und Physik 45, 1900, 23-38",
)
