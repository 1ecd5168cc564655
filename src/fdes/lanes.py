"""Elementary functions without calls and branches, so that a compiler computes several aircraft at once.

A function of `fdes.elementary` is compiled as the function of the same name here. The C library's would be called for
one number at a time, and one such call makes a whole batch five times as slow. Each is within 4 units in the last
place of `math` over the ranges that its docstring names; tests/compiled holds them to it. As plain Python they are slow
and correct.

Reduction of arguments: J.-M. Muller, Elementary Functions, 3rd ed., Birkhauser 2016, ch. 11.
"""

import math
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.extending import intrinsic

LN2_HIGH, LN2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10  # ln 2 in two parts, fdlibm e_exp.c
PIO2_HIGH, PIO2_MIDDLE, PIO2_LOW = 1.57079632673412561417, 6.07710050630396597660e-11, 2.02226624879595063154e-21
TAN_PI_8 = 0.41421356237309503
EXPONENT, FRACTION = 52, 0xFFFFFFFFFFFFF  # bits of IEEE 754 binary64


@intrinsic(prefer_literal=True)
def scratch(typingctx: Any, count: Any) -> Any:
    """An array of so many floats, a literal number of them, on the stack: no other pointer leads there."""
    kind, size = types.Array(types.float64, 1, "C"), count.literal_value

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        data = cgutils.alloca_once(builder, ir.DoubleType(), size=size)
        array = context.make_array(kind)(context, builder)
        length, width = (context.get_constant(types.intp, n) for n in (size, 8))
        context.populate_array(array, data=data, shape=[length], strides=[width], itemsize=width, meminfo=None)
        return array._getvalue()  # noqa: SLF001  numba's own way to read it

    return kind(count), code


def where(test: Any, a: Any, b: Any) -> Any:
    """`a` where the test holds, else `b`. Both are computed."""
    return a if test else b


def largest(a: Any, b: Any) -> Any:
    """The larger of two numbers."""
    return a if a > b else b


def smallest(a: Any, b: Any) -> Any:
    """The smaller of two numbers."""
    return a if a < b else b


def sqrt(x: Any) -> Any:
    """The square root: one instruction."""
    return math.sqrt(x)


def exp(x: Any) -> Any:
    """e^x for |x| < 700: 2^k e^r with |r| < ln 2 / 2, and Taylor's polynomial for e^r."""
    k = math.floor(x * 1.4426950408889634 + 0.5)
    r = (x - k * LN2_HIGH) - k * LN2_LOW
    p = 1.0 / 6227020800.0
    p = p * r + 1.0 / 479001600.0
    p = p * r + 1.0 / 39916800.0
    p = p * r + 1.0 / 3628800.0
    p = p * r + 1.0 / 362880.0
    p = p * r + 1.0 / 40320.0
    p = p * r + 1.0 / 5040.0
    p = p * r + 1.0 / 720.0
    p = p * r + 1.0 / 120.0
    p = p * r + 1.0 / 24.0
    p = p * r + 1.0 / 6.0
    p = p * r + 0.5
    p = p * r * r + r + 1.0
    return p * np.int64((np.int64(k) + 1023) << EXPONENT).view(np.float64)


def log(x: Any) -> Any:
    """The natural logarithm of a normal positive number: x = m 2^k, and the series of 2 artanh((m - 1)/(m + 1))."""
    bits = np.float64(x).view(np.int64)
    k = np.float64((bits >> EXPONENT) - 1023)
    m = np.int64((bits & FRACTION) | (1023 << EXPONENT)).view(np.float64)
    big = m > 1.4142135623730951
    m = 0.5 * m if big else m
    k = k + 1.0 if big else k
    f = m - 1.0
    s = f / (m + 1.0)
    z = s * s
    p = 2.0 / 23.0
    p = p * z + 2.0 / 21.0
    p = p * z + 2.0 / 19.0
    p = p * z + 2.0 / 17.0
    p = p * z + 2.0 / 15.0
    p = p * z + 2.0 / 13.0
    p = p * z + 2.0 / 11.0
    p = p * z + 2.0 / 9.0
    p = p * z + 2.0 / 7.0
    p = p * z + 2.0 / 5.0
    p = p * z + 2.0 / 3.0
    # 2s + s z p = f - s (f - z p): the rounding of s does not spoil the leading term. fdlibm, e_log.c
    return k * LN2_HIGH - ((s * (f - z * p) - k * LN2_LOW) - f)


def pow(x: Any, y: Any) -> Any:  # noqa: A001  its name in every textbook
    """x^y for x > 0; its relative error grows as |y log x|, and is held to 4 units where that is less than 2."""
    return exp(y * log(x))


def sin(x: Any) -> Any:
    """The sine of an angle [rad], |x| < 1e5."""
    k = math.floor(x * 0.6366197723675814 + 0.5)
    return _of_quadrant(np.int64(k), _reduced(x, k))


def cos(x: Any) -> Any:
    """The cosine of an angle [rad], |x| < 1e5."""
    k = math.floor(x * 0.6366197723675814 + 0.5)
    return _of_quadrant(np.int64(k) + 1, _reduced(x, k))


def tan(x: Any) -> Any:
    """The tangent of an angle [rad], |x| < 1e5."""
    return sin(x) / cos(x)


def _reduced(x: Any, k: Any) -> Any:
    """x - k pi/2, pi/2 being in three parts. Cody and Waite."""
    return ((x - k * PIO2_HIGH) - k * PIO2_MIDDLE) - k * PIO2_LOW


def _of_quadrant(n: Any, r: Any) -> Any:
    """sin(r + n pi/2) for |r| <= pi/4, by Taylor's polynomials."""
    z = r * r
    s = 1.0 / 355687428096000.0
    s = s * z - 1.0 / 1307674368000.0
    s = s * z + 1.0 / 6227020800.0
    s = s * z - 1.0 / 39916800.0
    s = s * z + 1.0 / 362880.0
    s = s * z - 1.0 / 5040.0
    s = s * z + 1.0 / 120.0
    s = s * z - 1.0 / 6.0
    c = -1.0 / 6402373705728000.0
    c = c * z + 1.0 / 20922789888000.0
    c = c * z - 1.0 / 87178291200.0
    c = c * z + 1.0 / 479001600.0
    c = c * z - 1.0 / 3628800.0
    c = c * z + 1.0 / 40320.0
    c = c * z - 1.0 / 720.0
    c = c * z + 1.0 / 24.0
    half = 0.5 * z
    one_less = 1.0 - half
    cosine = one_less + ((1.0 - one_less - half) + z * z * c)  # what the first subtraction rounds off is put back
    value = cosine if n & 1 else r + r * z * s
    return -value if n & 2 else value


def atan2(y: Any, x: Any) -> Any:
    """The angle [rad] of the point (x, y), from -pi to pi; 0 at the origin. S. L. Moshier, Cephes, atan.c (P and Q)."""
    ax, ay = abs(x), abs(y)
    steep = ay > ax
    low = ax if steep else ay
    high = ay if steep else ax
    far = low > TAN_PI_8 * high
    above = low - high if far else low
    below = low + high if far else high
    t = above / (below if below > 0.0 else 1.0)
    z = t * t
    P = -8.750608600031904122785e-1
    P = P * z - 1.615753718733365076637e1
    P = P * z - 7.500855792314704667340e1
    P = P * z - 1.228866684490136173410e2
    P = P * z - 6.485021904942025371773e1
    Q = z + 2.485846490142306297962e1
    Q = Q * z + 1.650270098316988542046e2
    Q = Q * z + 4.328810604912902668951e2
    Q = Q * z + 4.853903996359136964868e2
    Q = Q * z + 1.945506571482613964425e2
    angle = t + t * (z * P / Q)
    angle = 0.78539816339744830962 + (angle + 3.061616997868383e-17) if far else angle
    angle = 1.57079632679489661923 - (angle - 6.123233995736766e-17) if steep else angle
    angle = math.pi - angle if x < 0.0 else angle
    return -angle if y < 0.0 else angle
