"""Dual numbers for compiled code: a value, and its slopes along many directions in vector registers.

Physics that is compiled with them as its numbers gives, beside each result, the exact derivative by every direction at
once: forward-mode differentiation. Values are computed once, as scalars, so tables are looked up and branches taken as
in the plain text; slopes are packed additions and multiplications, whatever the compiler makes of loops.

Like a complex number, a dual one has `real` and mixes with floats. A function of `fdes.elementary` is compiled as its
namesake here: by the chain rule. numba is imported with this module, so only `fdes.kernel` imports it, when asked.

Reference: A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, sec. 3.2, vector mode.
"""

import math
import operator
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typeconv.castgraph import Conversion
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic as _intrinsic
from numba.extending import lower_builtin, lower_cast, make_attribute_wrapper, models, register_model

from fdes.solver_text import OCTET

intrinsic: Any = _intrinsic  # its functions are called without the first argument, which a type checker cannot see
VECTOR = ir.VectorType(ir.DoubleType(), OCTET)  # a register of AVX-512, two of AVX2


class OctetType(types.Type):
    """Eight slopes."""

    def __init__(self) -> None:
        super().__init__("Octet")


class DualType(types.Type):
    """A value with eight slopes in each of `octets` vectors."""

    def __init__(self, octets: int) -> None:
        self.octets = octets
        super().__init__(f"Dual({octets})")

    def unify(self, typingctx: Any, other: Any) -> Any:
        """What a variable is that may be either: a dual number, for a float is one without slopes."""
        return self if isinstance(other, types.Float | types.Integer) else None

    def can_convert_from(self, typingctx: Any, other: Any) -> Any:
        """A float is a dual number without slopes."""
        return Conversion.safe if isinstance(other, types.Float | types.Integer) else None


octet = OctetType()


@register_model(OctetType)
class OctetModel(models.PrimitiveModel):
    """In the machine: a vector."""

    def __init__(self, dmm: Any, fe_type: Any) -> None:
        super().__init__(dmm, fe_type, VECTOR)


@register_model(DualType)
class DualModel(models.StructModel):
    """In the machine: a number, and the vectors."""

    def __init__(self, dmm: Any, fe_type: Any) -> None:
        slopes = [(f"slopes{k}", octet) for k in range(fe_type.octets)]
        super().__init__(dmm, fe_type, [("real", types.float64), *slopes])


make_attribute_wrapper(DualType, "real", "real")


class Parts:
    """A dual number taken apart while code is written for it; a float has no slopes."""

    def __init__(self, context: Any, builder: Any, type_: Any, value: Any) -> None:
        if isinstance(type_, DualType):
            whole = cgutils.create_struct_proxy(type_)(context, builder, value=value)
            self.real = whole.real
            self.slopes = [getattr(whole, f"slopes{k}") for k in range(type_.octets)]
        else:
            self.real = context.cast(builder, value, type_, types.float64)
            self.slopes = []


def _joined(context: Any, builder: Any, type_: DualType, real: Any, slopes: list[Any]) -> Any:
    whole = cgutils.create_struct_proxy(type_)(context, builder)
    whole.real = real
    for k, vector in enumerate(slopes):
        setattr(whole, f"slopes{k}", vector)
    return whole._getvalue()  # noqa: SLF001  numba's own way to read it


def _each(builder: Any, number: Any) -> Any:
    """A vector, all eight of which are that number."""
    one = builder.insert_element(ir.Constant(VECTOR, ir.Undefined), number, ir.Constant(ir.IntType(32), 0))
    zeros = ir.Constant(ir.VectorType(ir.IntType(32), OCTET), [0] * OCTET)
    return builder.shuffle_vector(one, ir.Constant(VECTOR, ir.Undefined), zeros)


def _sum(builder: Any, a: Parts, b: Parts) -> tuple[Any, list[Any]]:
    slopes = [builder.fadd(p, q) for p, q in zip(a.slopes, b.slopes, strict=False)] or a.slopes or b.slopes
    return builder.fadd(a.real, b.real), slopes


def _difference(builder: Any, a: Parts, b: Parts) -> tuple[Any, list[Any]]:
    slopes = [builder.fsub(p, q) for p, q in zip(a.slopes, b.slopes, strict=False)] or a.slopes
    return builder.fsub(a.real, b.real), slopes or [builder.fneg(q) for q in b.slopes]


def _product(builder: Any, a: Parts, b: Parts) -> tuple[Any, list[Any]]:
    """a db + b da."""
    of_a = [builder.fmul(_each(builder, b.real), p) for p in a.slopes]
    of_b = [builder.fmul(_each(builder, a.real), q) for q in b.slopes]
    slopes = [builder.fadd(p, q) for p, q in zip(of_a, of_b, strict=False)] or of_a or of_b
    return builder.fmul(a.real, b.real), slopes


def _quotient(builder: Any, a: Parts, b: Parts) -> tuple[Any, list[Any]]:
    """(da - a/b db) / b."""
    value = builder.fdiv(a.real, b.real)
    per = _each(builder, builder.fdiv(ir.Constant(ir.DoubleType(), 1.0), b.real))
    of_b = [builder.fmul(_each(builder, value), q) for q in b.slopes]
    above = [builder.fsub(p, q) for p, q in zip(a.slopes, of_b, strict=False)] or a.slopes
    return value, [builder.fmul(v, per) for v in above or [builder.fneg(q) for q in of_b]]


class DualOperation(AbstractTemplate):
    """The type of an operation in which a dual number takes part, with itself or with a float."""

    def generic(self, args: Any, kws: Any) -> Any:
        """A dual number, if one of them is."""
        duals = [a for a in args if isinstance(a, DualType)]
        others = [a for a in args if not isinstance(a, DualType | types.Float | types.Integer)]
        return signature(duals[0], *args) if duals and not others else None


def _offer(operation: Any, rule: Any) -> None:
    """Teach numba that operation on dual numbers, in place or not."""
    name = {operator.add: "iadd", operator.sub: "isub", operator.mul: "imul", operator.truediv: "itruediv"}[operation]

    def lowered(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        a, b = (Parts(context, builder, t, v) for t, v in zip(sig.args, args, strict=True))
        return _joined(context, builder, sig.return_type, *rule(builder, a, b))

    for key in (operation, getattr(operator, name)):
        infer_global(key)(type(f"Dual_{key.__name__}", (DualOperation,), {"key": key}))
        for pair in ((DualType, DualType), (DualType, types.Number), (types.Number, DualType)):
            lower_builtin(key, *pair)(lowered)


for _operation, _rule in (
    (operator.add, _sum),
    (operator.sub, _difference),
    (operator.mul, _product),
    (operator.truediv, _quotient),
):
    _offer(_operation, _rule)


@infer_global(operator.neg)
class DualNegative(DualOperation):
    """-x."""

    key = operator.neg


@lower_builtin(operator.neg, DualType)
def _negative(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    a = Parts(context, builder, sig.args[0], args[0])
    return _joined(context, builder, sig.return_type, builder.fneg(a.real), [builder.fneg(p) for p in a.slopes])


@lower_cast(types.Float, DualType)
@lower_cast(types.Integer, DualType)
def _without_slopes(context: Any, builder: Any, fromty: Any, toty: Any, value: Any) -> Any:
    real = context.cast(builder, value, fromty, types.float64)
    return _joined(context, builder, toty, real, [ir.Constant(VECTOR, [0.0] * OCTET)] * toty.octets)


@intrinsic(prefer_literal=True)
def seed(typingctx: Any, value: Any, direction: Any, octets: Any) -> Any:
    """A dual number whose slope is 1 along one direction, and 0 along others. The latter two are literal integers."""
    chosen, made = direction.literal_value, DualType(octets.literal_value)

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        ones = [[float(OCTET * k + i == chosen) for i in range(OCTET)] for k in range(made.octets)]
        return _joined(context, builder, made, args[0], [ir.Constant(VECTOR, row) for row in ones])

    return made(types.float64, direction, octets), code


@intrinsic
def chain(typingctx: Any, value: Any, slope: Any, x: Any) -> Any:
    """f(x), of its value and its slope at x: the chain rule. The value itself where x is a float."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        if not isinstance(x, DualType):
            return args[0]
        slopes = Parts(context, builder, x, args[2]).slopes
        return _joined(context, builder, x, args[0], [builder.fmul(_each(builder, args[1]), p) for p in slopes])

    return (x if isinstance(x, DualType) else types.float64)(types.float64, types.float64, x), code


@intrinsic
def store(typingctx: Any, slopes: Any, first: Any, x: Any) -> Any:
    """Write the slopes of `x` into that array from the element `first` on: eight for each octet; none of a float."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        data = context.make_array(slopes)(context, builder, args[0]).data
        for k, vector in enumerate(Parts(context, builder, x, args[2]).slopes):
            at = builder.gep(data, [builder.add(args[1], ir.Constant(args[1].type, OCTET * k))])
            builder.store(vector, builder.bitcast(at, VECTOR.as_pointer()), align=8)
        return context.get_dummy_value()

    return types.void(slopes, types.intp, x), code


def where(test: Any, a: Any, b: Any) -> Any:
    """`a` where the test holds, else `b`."""
    return a if test else b


def largest(a: Any, b: Any) -> Any:
    """The larger of two numbers."""
    return a if a.real > b.real else b


def sqrt(x: Any) -> Any:
    """The square root."""
    root = math.sqrt(x.real)
    return chain(root, 0.5 / root, x)


def exp(x: Any) -> Any:
    """e^x."""
    value = math.exp(x.real)
    return chain(value, value, x)


def log(x: Any) -> Any:
    """The natural logarithm."""
    return chain(math.log(x.real), 1.0 / x.real, x)


def pow(x: Any, y: float) -> Any:  # noqa: A001  its name in every textbook
    """x^y for x > 0."""
    value = math.pow(x.real, y)
    return chain(value, y * value / x.real, x)


def sin(x: Any) -> Any:
    """The sine of an angle [rad]."""
    return chain(math.sin(x.real), math.cos(x.real), x)


def cos(x: Any) -> Any:
    """The cosine of an angle [rad]."""
    return chain(math.cos(x.real), -math.sin(x.real), x)


def tan(x: Any) -> Any:
    """The tangent of an angle [rad]."""
    value = math.tan(x.real)
    return chain(value, 1.0 + value * value, x)


def atan2(y: Any, x: Any) -> Any:
    """The angle [rad] of the point (x, y), from -pi to pi."""
    per = 1.0 / (x.real * x.real + y.real * y.real)
    return chain(math.atan2(y.real, x.real), 1.0, (x.real * per) * y - (y.real * per) * x)
