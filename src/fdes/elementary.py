"""The one door through which physics reaches elementary functions: of floats, complex numbers, and columns of floats.

A plant flies on floats. Where a flight is known in advance, its equations run over NumPy arrays, one number per frame,
with the same text; and they run on complex numbers, whose imaginary part then is a derivative. Physics never branches
on a value that may be one of these: it asks `largest`, `where`, or for `each` number. Compiled, its functions are those
of `fdes.lanes`.
"""

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from operator import mul
from typing import Any, cast

__all__ = ["atan2", "combined", "cos", "dot", "each", "exp", "largest", "log", "pow", "sin", "sqrt", "tan", "where"]


def sqrt(x: Any) -> Any:
    """The square root."""
    if isinstance(x, float):
        return math.sqrt(x)
    return cmath.sqrt(x) if isinstance(x, complex) else _numpy().sqrt(x)


def exp(x: Any) -> Any:
    """e^x."""
    if isinstance(x, float):
        return math.exp(x)
    return cmath.exp(x) if isinstance(x, complex) else _numpy().exp(x)


def log(x: Any) -> Any:
    """The natural logarithm."""
    if isinstance(x, float):
        return math.log(x)
    return cmath.log(x) if isinstance(x, complex) else _numpy().log(x)


def pow(x: Any, y: float) -> Any:  # noqa: A001  its name in every textbook
    """x^y."""
    return math.pow(x, y) if isinstance(x, float) else x**y


def sin(x: Any) -> Any:
    """The sine of an angle [rad]."""
    if isinstance(x, float):
        return math.sin(x)
    return cmath.sin(x) if isinstance(x, complex) else _numpy().sin(x)


def cos(x: Any) -> Any:
    """The cosine of an angle [rad]."""
    if isinstance(x, float):
        return math.cos(x)
    return cmath.cos(x) if isinstance(x, complex) else _numpy().cos(x)


def tan(x: Any) -> Any:
    """The tangent of an angle [rad]."""
    if isinstance(x, float):
        return math.tan(x)
    return cmath.tan(x) if isinstance(x, complex) else _numpy().tan(x)


def atan2(y: Any, x: Any) -> Any:
    """The angle [rad] of the point (x, y), from -pi to pi. Of complex numbers, as far as first derivatives go."""
    if isinstance(y, float) and isinstance(x, float):
        return math.atan2(y, x)
    if isinstance(y, complex) or isinstance(x, complex):
        a, b = y.real, x.real
        return complex(math.atan2(a, b), (y.imag * b - x.imag * a) / (a * a + b * b))
    return _numpy().arctan2(y, x)


def where(test: Any, a: Any, b: Any) -> Any:
    """`a` where the test holds, else `b`. Both are computed; test the real part of what may be complex."""
    return (a if test else b) if isinstance(test, bool) else _numpy().where(test, a, b)


def largest(*values: Any) -> Any:
    """The largest of some values, frame by frame."""
    return max(values) if isinstance(values[0], float) else _numpy().maximum.reduce(values)


def dot(a: Iterable[float], b: Iterable[float]) -> float:
    """The sum of products of two rows of equal length."""
    total: float = sum(map(mul, a, b))
    return total


def combined(y: tuple[float, ...], terms: Sequence[tuple[float, tuple[float, ...]]]) -> tuple[float, ...]:
    """y + sum(factor * row) over the `terms`, whose rows are as long as `y`, added in their order."""
    return _written_out(len(y), len(terms))(y, terms) if terms else y


@cache
def _written_out(length: int, terms: int) -> Callable[..., tuple[float, ...]]:
    """That sum for rows of `length` and so many `terms`, without a loop, which takes three times as long.

    Its text is made of numbers alone, as the constructors of named tuples are.
    """
    number, of = range(length), range(terms)
    elements = "".join(f"y{i}, " for i in number)
    rows = "".join(f"(f{k}, ({''.join(f'r{k}_{i}, ' for i in number)})), " for k in of)
    sums = "".join(f"y{i}{''.join(f' + f{k} * r{k}_{i}' for k in of)}, " for i in number)
    made: dict[str, Any] = {}
    exec(f"def combined(y, terms):\n    {elements} = y\n    {rows} = terms\n    return {sums}", made)  # noqa: S102
    return cast("Callable[..., tuple[float, ...]]", made["combined"])


def each(f: Callable[[float], float], x: Any) -> Any:
    """`f` of each number: for what has branches or iterates, and so takes one number at a time."""
    return f(x) if isinstance(x, float) else _numpy().array([f(v) for v in x.tolist()])


def _numpy() -> Any:
    import numpy as np

    return np
