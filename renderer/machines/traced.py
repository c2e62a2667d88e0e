"""Traced values: the shader and its kernels run on them once, and every operator emits LLVM's instruction for a vector.

Neither fast-math nor contraction is allowed, so that the bits are NumPy's. Only operations with a literal 0 or 1 are
left out: 0·x, x + 0, 1·x, x/1. For a finite x that changes at most the sign of a zero.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache, partialmethod
from itertools import count
from types import SimpleNamespace
from typing import Any

import llvmlite.ir as ir

from renderer.machines.forms import Step, Variables, flat, of_form

FLOAT, BIT, BYTE, WHOLE = ir.DoubleType(), ir.IntType(1), ir.IntType(8), ir.IntType(64)


@cache
def constant(vector: ir.VectorType, digits: str) -> ir.Constant:
    """Return the vector of one float64 everywhere, given by its hexadecimal digits: −0 is not 0."""
    return ir.Constant(vector, float.fromhex(digits))


class _Traced:
    """A value of every pixel of a group, as a vector of LLVM's."""

    def __init__(self, machine: "Tracer", vector: ir.Value, literal: float | None = None):
        self.machine, self.vector, self.literal = machine, vector, literal

    def _emit(self, instruction, *operands):
        """Return the result of an instruction on operands of this kind."""
        vectors = [self.machine.value(operand).vector for operand in operands]
        return type(self)(self.machine, getattr(self.machine.builder, instruction)(*vectors))


class Mask(_Traced):
    """A condition of every pixel of a group."""

    def __and__(self, other):
        return self._emit("and_", self, other)

    def __or__(self, other):
        return self._emit("or_", self, other)

    def __invert__(self):
        return self._emit("not_", self)


def _comparison(operator):
    """Return the method by which two Values are compared: a Mask."""

    def compared(self, other):
        machine = self.machine
        compare = machine.builder.fcmp_unordered if operator == "!=" else machine.builder.fcmp_ordered
        return Mask(machine, compare(operator, self.vector, machine.value(other).vector))

    return compared


class Value(_Traced):
    """A float64 of every pixel of a group; `literal` is its number where it is one."""

    def __add__(self, other):
        other = self.machine.value(other)
        if self.literal == 0.0:
            return other
        return self if other.literal == 0.0 else self._emit("fadd", self, other)

    def __sub__(self, other):
        return self if self.machine.value(other).literal == 0.0 else self._emit("fsub", self, other)

    def __rsub__(self, other):
        return self.machine.value(other) - self

    def __mul__(self, other):
        other = self.machine.value(other)
        for one, two in ((self, other), (other, self)):
            if one.literal == 0.0:
                return one
            if one.literal == 1.0:
                return two
        return self._emit("fmul", self, other)

    def __truediv__(self, other):
        return self if self.machine.value(other).literal == 1.0 else self._emit("fdiv", self, other)

    def __rtruediv__(self, other):
        return self._emit("fdiv", other, self)

    def __neg__(self):
        return self._emit("fneg", self)

    def __abs__(self):
        return self.machine.call("fabs", self)

    __radd__, __rmul__ = __add__, __mul__
    __lt__ = _comparison("<")
    __le__ = _comparison("<=")
    __gt__ = _comparison(">")
    __ge__ = _comparison(">=")
    __eq__ = _comparison("==")
    __ne__ = _comparison("!=")
    __hash__ = None  # type: ignore[assignment]


class Variable:
    """A variable: memory that LLVM turns into registers."""

    def __init__(self, machine: "Tracer", value: Value | float):
        self.machine, self.place = machine, machine.reserve(machine.vector)
        self.set(value)

    @property
    def value(self) -> Value:
        """The present value."""
        return Value(self.machine, self.machine.builder.load(self.place))

    def set(self, value: Value | float, mask: Mask | None = None) -> None:
        """Put a value in its place, where the mask holds."""
        value = self.machine.value(value) if mask is None else self.machine.where(mask, value, self.value)
        self.machine.builder.store(value.vector, self.place)


class Tracer:
    """A machine whose values are traced: it emits a function that `lanes` pixels at a time go through.

    The function's one parameter is the address of an array of int64, its arguments: addresses of arrays, and numbers.
    arguments: those that have names, by them. shader: the Shader that is traced, if it is one.
    """

    def __init__(
        self,
        module: ir.Module,
        name: str,
        lanes: int,
        names: Sequence[str] = (),
        number: ir.Type = FLOAT,
        shader: Any = None,
    ):
        function = ir.Function(module, ir.FunctionType(ir.VoidType(), [WHOLE.as_pointer()]), name)
        (self._address,), self.lanes, self.module = function.args, lanes, module
        self.number, self.builder = number, ir.IRBuilder(function.append_basic_block())
        self.vector = self._all(number)
        self.arguments = {argument: self.argument(place) for place, argument in enumerate(names)}
        self.shader = shader
        self.counts = {kind: self.reserve(WHOLE) for kind in (shader.counted if shader else ())}
        for place in self.counts.values():
            self.builder.store(WHOLE(0), place)

    def _all(self, kind):
        """Return the type of a group's numbers of a kind: a vector, or with one lane the kind itself."""
        return ir.VectorType(kind, self.lanes) if self.lanes > 1 else kind

    def argument(self, number: int) -> ir.Value:
        """Return one of the function's arguments."""
        return self.builder.load(self.builder.gep(self._address, [WHOLE(number)]))

    def reserve(self, kind: ir.Type) -> ir.Value:
        """Return memory for one value, reserved where the function begins."""
        with self.builder.goto_entry_block():
            self.builder.position_at_start(self.builder.block)  # the last first: in order LLVM spills more with bounds
            return self.builder.alloca(kind)

    def value(self, number: Value | Mask | float) -> Any:
        """Return a number as a Value, if it is not one."""
        if isinstance(number, _Traced):
            return number
        number = float(number)
        return Value(self, constant(self.vector, number.hex()), number)

    def place(self, array: ir.Value, at: ir.Value, kind: ir.Type = FLOAT) -> ir.Value:
        """Return where a number of an array is, by the address of the array."""
        return self.builder.gep(self.builder.inttoptr(array, kind.as_pointer()), [at])

    def _group(self, array, at, kind):
        """Return where the numbers of a group are, from a number of an array on."""
        kind = kind or self.number
        return self.builder.bitcast(self.place(array, at, kind), self._all(kind).as_pointer())

    def load(self, array: ir.Value, at: ir.Value, kind: ir.Type | None = None) -> Value:
        """Return the numbers of a group, which an array has from `at` on; kind: of whole ones."""
        loaded = self.builder.load(self._group(array, at, kind), align=1 if kind else 8)
        return Value(self, self.builder.uitofp(loaded, self.vector) if kind else loaded)

    def store(self, value: Value | float, array: ir.Value, at: ir.Value, kind: ir.Type | None = None) -> None:
        """Write them."""
        vector, place = self.value(value).vector, self._group(array, at, kind)
        if kind:
            vector = self.builder.fptoui(vector, place.type.pointee)
        self.builder.store(vector, place, align=1 if kind else 8)

    def everywhere(self, array: ir.Value, at: ir.Value) -> Value:
        """Return a number of an array for every pixel."""
        undefined = ir.Constant(self.vector, ir.Undefined)
        first = self.builder.insert_element(undefined, self.builder.load(self.place(array, at)), WHOLE(0))
        lanes = ir.Constant(ir.VectorType(ir.IntType(32), self.lanes), 0)
        return Value(self, self.builder.shuffle_vector(first, undefined, lanes))

    def numbers(self, array: ir.Value, form: SimpleNamespace, row: ir.Value) -> SimpleNamespace:
        """Return the numbers of a row of an array, in their form."""
        first = self.builder.mul(row, WHOLE(len(flat(form))))
        return of_form(form, (self.everywhere(array, self.builder.add(first, WHOLE(n))) for n in count()))

    def integer(self, value: Value) -> ir.Value:
        """Return the one whole number that is everywhere in a Value."""
        first = self.builder.extract_element(value.vector, WHOLE(0)) if self.lanes > 1 else value.vector
        return self.builder.fptosi(first, WHOLE)

    def call(self, intrinsic: str, argument: Value | float) -> Value:
        """Return the result of one of LLVM's intrinsic functions."""
        name = f"llvm.{intrinsic}.{f'v{self.lanes}' if self.lanes > 1 else ''}{self.number.intrinsic_name}"
        function = self.module.declare_intrinsic(name, fnty=ir.FunctionType(self.vector, [self.vector]))
        return Value(self, self.builder.call(function, [self.value(argument).vector]))

    sqrt = partialmethod(call, "sqrt")
    floor = partialmethod(call, "floor")
    rint = partialmethod(call, "rint")

    def bits(self, number: Value, operation: str, other: int) -> Value:
        """Return the result of `renderer.operations.bits`."""
        builder, integer = self.builder, ir.VectorType(WHOLE, self.lanes)
        changed = getattr(builder, operation)(builder.bitcast(number.vector, integer), integer([other] * self.lanes))
        return Value(self, builder.bitcast(changed, self.vector))

    def where(self, mask: Mask | bool, value: Value | float, otherwise: Value | float) -> Value:
        """Return the selection of `renderer.operations.where`; mask: a truth value, where literals are compared."""
        if isinstance(mask, bool):
            return self.value(value if mask else otherwise)
        return Value(self, self.builder.select(*(self.value(part).vector for part in (mask, value, otherwise))))

    def variable(self, value: Value | float) -> Variable:
        """Return a Variable."""
        return Variable(self, value)

    def count(self, kind: str, mask: Mask) -> None:
        """Add the number of a mask's pixels to the count of a kind."""
        pixels = self.builder.zext(self.builder.ctpop(self._bits(mask)), WHOLE)
        self.builder.store(self.builder.add(self.builder.load(self.counts[kind]), pixels), self.counts[kind])

    def _bits(self, mask):
        return self.builder.bitcast(mask.vector, ir.IntType(self.lanes))

    def when(self, mask: Mask, body: Step) -> None:
        """Run `body` unless the mask holds for no pixel of the group."""
        bits = self._bits(mask)
        with self.builder.if_then(self.builder.icmp_unsigned("!=", bits, bits.type(0))):
            body()

    def choose(self, alternatives: Sequence, index: Value, result_of: Callable[[Any], Sequence]) -> Sequence:
        """Return `result_of` the alternative of an index that is the same everywhere."""
        if len(alternatives) == 1:
            return result_of(alternatives[0])
        chosen, results = self.integer(index), Variables(self, ())
        for number, alternative in enumerate(alternatives):
            with self.builder.if_then(self.builder.icmp_signed("==", chosen, WHOLE(number))):
                values = result_of(alternative)
                results = results if number else Variables(self, values)
                results.set(values)
        return results.value

    @contextmanager
    def loop(self, start: ir.Value, stop: ir.Value, step: int = 1) -> Iterator[ir.Value]:
        """Emit a loop; the block is its body and is given the number."""
        builder = self.builder
        before, head = builder.block, builder.append_basic_block()
        body, after = builder.append_basic_block(), builder.append_basic_block()
        builder.branch(head)
        builder.position_at_end(head)
        number = builder.phi(WHOLE)
        number.add_incoming(start, before)
        builder.cbranch(builder.icmp_signed("<", number, stop), body, after)
        builder.position_at_end(body)
        yield number
        number.add_incoming(builder.add(number, WHOLE(step)), builder.block)
        builder.branch(head)
        builder.position_at_end(after)

    @contextmanager
    def rows(self) -> Iterator[tuple[ir.Value, ir.Value, ir.Value]]:
        """Emit a loop over rows; the block is its body and is given the row, and where its columns begin and end."""
        builder, arguments = self.builder, self.arguments
        with self.loop(arguments["first_row"], arguments["last_row"]) as row:
            ends = builder.mul(row, WHOLE(2))
            places = (self.place(arguments["columns"], builder.add(ends, WHOLE(n)), WHOLE) for n in (0, 1))
            yield row, *map(builder.load, places)

    def by_squaring(self, exponent: Value, first: Step, square: Step, multiply: Step) -> None:
        """Run the steps that raise a number to a whole power, the same for every pixel: none for 0.

        `square` as often as the exponent's lowest bit says, `first`; then for each higher bit `square`, and `multiply`
        where it is set.
        """
        builder, exponent = self.builder, self.integer(exponent)
        with builder.if_then(builder.icmp_signed(">", exponent, WHOLE(0))):
            zeros = builder.cttz(exponent, BIT(0))
            with self.loop(WHOLE(0), zeros):
                square()
            first()
            rest = builder.lshr(builder.lshr(exponent, zeros), WHOLE(1))
            with self.loop(WHOLE(0), builder.sub(WHOLE(64), builder.ctlz(rest, BIT(0)))) as number:
                square()
                bit = builder.trunc(builder.lshr(rest, number), BIT)
                with builder.if_then(bit):
                    multiply()

    def each_light(self, body: Callable[[SimpleNamespace], None]) -> None:
        """Run `body` on the numbers of one light after another."""
        with self.loop(WHOLE(0), self.arguments["light_count"]) as number:
            body(self.numbers(self.arguments["lights"], self.shader.light, number))
