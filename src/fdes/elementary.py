"""The one door through which physics reaches elementary functions, in two forms: floats, and whole columns of them.

A plant flies on floats. Where a flight is known in advance, its equations run over NumPy arrays, one number per frame,
with the same text. Physics never branches on a value that may be an array: it asks `largest`, or for `each` number.
"""

import math
from collections.abc import Callable, Iterable
from operator import mul
from typing import Any

__all__ = ["atan2", "cos", "dot", "each", "exp", "largest", "pow", "sin", "sqrt", "tan"]

exp, tan = math.exp, math.tan
pow = math.pow  # noqa: A001  its name in every textbook


def sqrt(x: Any) -> Any:
    """The square root."""
    return math.sqrt(x) if isinstance(x, float) else _numpy().sqrt(x)


def sin(x: Any) -> Any:
    """The sine of an angle [rad]."""
    return math.sin(x) if isinstance(x, float) else _numpy().sin(x)


def cos(x: Any) -> Any:
    """The cosine of an angle [rad]."""
    return math.cos(x) if isinstance(x, float) else _numpy().cos(x)


def atan2(y: Any, x: Any) -> Any:
    """The angle [rad] of the point (x, y), from -pi to pi."""
    return math.atan2(y, x) if isinstance(y, float) else _numpy().arctan2(y, x)


def largest(*values: Any) -> Any:
    """The largest of some values, frame by frame."""
    return max(values) if isinstance(values[0], float) else _numpy().maximum.reduce(values)


def dot(a: Iterable[float], b: Iterable[float]) -> float:
    """The sum of products of two rows of equal length."""
    total: float = sum(map(mul, a, b))
    return total


def each(f: Callable[[float], float], x: Any) -> Any:
    """`f` of each number: for what has branches or iterates, and so takes one number at a time."""
    return f(x) if isinstance(x, float) else _numpy().array([f(v) for v in x.tolist()])


def _numpy() -> Any:
    import numpy as np

    return np
