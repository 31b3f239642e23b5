"""Several numbers side by side in the vector registers of the processor, for kernels that solve many bearings.

A kernel written with ``Lanes`` reads as one for a single bearing; every operation does all lanes at once, and in
place of a branch stands ``where``. Arrays hold the lanes along their last axis: ``get`` and ``put`` move all lanes
of one place. LLVM cuts the vectors to what the processor has. (Loops over the last axis, left to the compiler,
were not: it cannot tell that the arrays are distinct.)
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import extending, types
from numba.extending import models

__all__ = ["LANES", "any_of", "get", "lent", "maximum", "minimum", "put", "where"]

# their published types know only what Python calls
intrinsic: Callable[[Callable[..., Any]], Any] = extending.intrinsic
overload: Callable[[Any], Callable[[Callable[..., Any]], Any]] = extending.overload
register_model: Callable[[Any], Callable[[type], type]] = extending.register_model

LANES = 4
"""Bearings side by side."""

INDEX = ir.IntType(32)
NUMBERS, BITS = ir.VectorType(ir.DoubleType(), LANES), ir.VectorType(ir.IntType(1), LANES)
FAST = ("contract", "reassoc")


class Lanes(types.Type):
    """A number of every lane."""

    def __init__(self) -> None:
        super().__init__(name=f"Lanes({LANES})")


class Mask(types.Type):
    """A truth of every lane."""

    def __init__(self) -> None:
        super().__init__(name=f"Mask({LANES})")


class Table(types.Type):
    """An array with the lanes along its last axis, on loan: its owner lives longer, no references are counted."""

    def __init__(self, axes: int) -> None:
        super().__init__(name=f"Table({axes})")
        self.axes = axes


lanes, mask = Lanes(), Mask()


@register_model(Lanes)
class LanesModel(models.PrimitiveModel):
    """A vector of doubles."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, NUMBERS)


@register_model(Mask)
class MaskModel(models.PrimitiveModel):
    """A vector of bits."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, BITS)


@register_model(Table)
class TableModel(models.StructModel):
    """Where the numbers stand, and how many along each axis but the last."""

    def __init__(self, manager: Any, kind: Any) -> None:
        sizes = types.UniTuple(types.intp, kind.axes)
        super().__init__(manager, kind, [("data", types.CPointer(types.float64)), ("sizes", sizes)])


@intrinsic
def lent(typing: Any, array: Any) -> Any:
    """An array as a table, to be used only while a caller holds the array.

    An array that is handed to a function in a loop counts its references with two locked additions, which took a
    sixth of the time of a film.
    """

    def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        own = context.make_array(array)(context, builder, value=arguments[0])
        table = ir.Constant(context.get_value_type(signature.return_type), ir.Undefined)
        table = builder.insert_value(table, own.data, 0)
        for axis in range(array.ndim - 1):
            table = builder.insert_value(table, builder.extract_value(own.shape, axis), [1, axis])
        return table

    return Table(array.ndim - 1)(array), write


def spread(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    """A number of all lanes from lanes or from one number that all share."""
    if isinstance(kind, Lanes):
        return value
    number = context.cast(builder, value, kind, types.float64)
    one = builder.insert_element(ir.Constant(NUMBERS, ir.Undefined), number, INDEX(0))
    order = ir.Constant(ir.VectorType(INDEX, LANES), [0] * LANES)
    return builder.shuffle_vector(one, ir.Constant(NUMBERS, ir.Undefined), order)


def both(first: Any, second: Any) -> bool:
    """Whether an operation on these is one on lanes."""
    return (isinstance(first, Lanes) and isinstance(second, (Lanes, types.Number))) or (
        isinstance(second, Lanes) and isinstance(first, types.Number)
    )


def arithmetic(sign: Any, name: str) -> None:
    """Teach the compiler one operation on lanes."""

    @intrinsic
    def on_lanes(typing: Any, first: Any, second: Any) -> Any:
        def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            a, b = (spread(context, builder, *one) for one in zip(signature.args, arguments, strict=True))
            return getattr(builder, name)(a, b, flags=FAST)

        return lanes(first, second), write

    @overload(sign)
    def of(first, second):
        if both(first, second):
            return lambda first, second: on_lanes(first, second)
        return None


def comparison(sign: Any, symbol: str) -> None:
    """Teach the compiler one comparison of lanes."""

    @intrinsic
    def on_lanes(typing: Any, first: Any, second: Any) -> Any:
        def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            a, b = (spread(context, builder, *one) for one in zip(signature.args, arguments, strict=True))
            return builder.fcmp_ordered(symbol, a, b)

        return mask(first, second), write

    @overload(sign)
    def of(first, second):
        if both(first, second):
            return lambda first, second: on_lanes(first, second)
        return None


def logic(sign: Any, name: str) -> None:
    """Teach the compiler to join truths."""

    @intrinsic
    def on_lanes(typing: Any, first: Any, second: Any) -> Any:
        def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return getattr(builder, name)(*arguments)

        return mask(first, second), write

    @overload(sign)
    def of(first, second):
        if isinstance(first, Mask) and isinstance(second, Mask):
            return lambda first, second: on_lanes(first, second)
        return None


for sign, name in (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
):
    arithmetic(sign, name)
for sign, name in ((operator.lt, "<"), (operator.gt, ">"), (operator.le, "<="), (operator.ge, ">=")):
    comparison(sign, name)
for sign, name in ((operator.and_, "and_"), (operator.or_, "or_")):
    logic(sign, name)


@intrinsic
def _negative(typing: Any, value: Any) -> Any:
    def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.fneg(arguments[0])

    return lanes(value), write


@overload(operator.neg)
def _negative_of(value):
    if isinstance(value, Lanes):
        return lambda value: _negative(value)
    return None


@intrinsic
def where(typing: Any, truth: Any, first: Any, second: Any) -> Any:
    """The first number of lanes where the mask is true, the second elsewhere."""

    def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        a = spread(context, builder, signature.args[1], arguments[1])
        b = spread(context, builder, signature.args[2], arguments[2])
        return builder.select(arguments[0], a, b)

    return lanes(truth, first, second), write


def extreme(symbol: str) -> Any:
    """The smaller or the larger of two; the second where one is not a number."""

    @intrinsic
    def of(typing: Any, first: Any, second: Any) -> Any:
        def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            a, b = (spread(context, builder, *one) for one in zip(signature.args, arguments, strict=True))
            return builder.select(builder.fcmp_ordered(symbol, a, b), a, b)

        return lanes(first, second), write

    return of


minimum, maximum = extreme("<"), extreme(">")


@intrinsic
def any_of(typing: Any, truth: Any) -> Any:
    """Whether the mask is true in any lane."""

    def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        bits = builder.bitcast(arguments[0], ir.IntType(LANES))
        return builder.icmp_unsigned("!=", bits, ir.IntType(LANES)(0))

    return types.boolean(truth), write


def place(context: Any, builder: Any, kinds: Any, array: Any, indices: Any) -> Any:
    """Address of the lanes at a tuple of indices in an array with the lanes along its last axis."""
    if isinstance(kinds[0], Table):
        data, sizes = builder.extract_value(array, 0), builder.extract_value(array, 1)
    else:
        own = context.make_array(kinds[0])(context, builder, value=array)
        data, sizes = own.data, own.shape
    index = ir.Constant(context.get_value_type(types.intp), 0)
    for axis, kind in enumerate(kinds[1]):
        size = builder.extract_value(sizes, axis)
        along = context.cast(builder, builder.extract_value(indices, axis), kind, types.intp)
        index = builder.add(builder.mul(index, size), along)
    index = builder.mul(index, ir.Constant(index.type, LANES))
    return builder.bitcast(builder.gep(data, [index], inbounds=True), NUMBERS.as_pointer())


@intrinsic
def get(typing: Any, array: Any, indices: Any) -> Any:
    """All lanes at one place of an array; indices is a tuple, the last axis of the array not counted."""

    def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.load(place(context, builder, signature.args, *arguments), align=8)

    return lanes(array, indices), write


@intrinsic
def put(typing: Any, array: Any, indices: Any, value: Any) -> Any:
    """Set all lanes at one place of an array, to lanes or to one number."""

    def write(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        number = spread(context, builder, signature.args[2], arguments[2])
        builder.store(number, place(context, builder, signature.args, *arguments[:2]), align=8)
        return context.get_dummy_value()

    return types.void(array, indices, value), write
