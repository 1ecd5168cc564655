"""The one door through which physics reaches elementary functions.

Today every plant flies on floats, so the door opens on `math`. A plant that must also run on complex numbers
(complex-step Jacobians), dimensioned numbers or lanes gets its forms here, and physics does not change a line.
"""

from math import atan2, cos, exp, pow, sin, sqrt, tan

__all__ = ["atan2", "cos", "exp", "pow", "sin", "sqrt", "tan"]
