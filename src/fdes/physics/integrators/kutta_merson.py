"""Kutta-Merson: five stages, order four. Mansor and Perumal's "Runge-Kutta-Mason" method, eq. 2.13 and 2.14."""

from fdes.physics.runge_kutta import Tableau

__all__ = ["kutta_merson"]

kutta_merson = Tableau(
    name="Kutta-Merson",
    order=4,
    c=(0.0, 1 / 3, 1 / 3, 1 / 2, 1.0),
    a=(
        (),
        (1 / 3,),
        (1 / 6, 1 / 6),
        (1 / 8, 0.0, 3 / 8),
        (1 / 2, 0.0, -3 / 2, 2.0),
    ),
    b=(1 / 6, 0.0, 0.0, 2 / 3, 1 / 6),
    reference="R. H. Merson, An operational method for the study of integration processes, WRE Salisbury, 1957",
)
