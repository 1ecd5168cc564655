"""Euler's method: the first that FDES had (Mansor and Perumal, eq. 2.3)."""

from fdes.physics.runge_kutta import Tableau

__all__ = ["euler"]

euler = Tableau(
    name="Euler",
    order=1,
    c=(0.0,),
    a=((),),
    b=(1.0,),
    reference="L. Euler, Institutionum calculi integralis, vol. 1, 1768, ch. VII",
)
