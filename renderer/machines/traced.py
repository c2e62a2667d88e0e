"""Traced values: the shader and its kernels run on them once, and every operator emits LLVM's instruction for a vector.

Neither fast-math nor contraction is allowed, so that the bits are NumPy's. Only what a literal 0 or 1 does to a number
is left out: 0·x, x + 0, 1·x, x/1, of which the sign of a zero may differ, and nothing else for a finite x.
"""

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache, partial, partialmethod
from types import SimpleNamespace
from typing import Any

import llvmlite.ir as ir

from renderer.machines.stills import DEAR, OF_LIGHT, SLOW, Still
from renderer.shader.numbers import LIGHT_FORM, flat, of_form
from renderer.shader.shader import Step

FLOAT, BIT, BYTE, WHOLE = ir.DoubleType(), ir.IntType(1), ir.IntType(8), ir.IntType(64)


@cache
def constant(vector: ir.VectorType, digits: str) -> ir.Constant:
    """Return the vector of one float64 everywhere, given by its hexadecimal digits: −0 is not 0."""
    return ir.Constant(vector, float.fromhex(digits))


class Value:
    """A float64 of every pixel of a group; `literal` is its number where it is one; `still` is None if it moves."""

    def __init__(self, machine: "Tracer", vector: ir.Value, literal: float | None = None, still: Still | None = None):
        self.machine, self.vector, self.literal, self.still = machine, vector, literal, still

    def _emit(self, instruction, other, swap=False):
        left, right = self, self.machine.value(other)
        if swap:
            left, right = right, left
        return self.machine.made(Value, instruction, getattr(self.machine.builder, instruction), left, right)

    def __add__(self, other):
        other = self.machine.value(other)
        if self.literal == 0.0:
            return other
        return self if other.literal == 0.0 else self._emit("fadd", other)

    __radd__ = __add__

    def __sub__(self, other):
        return self if self.machine.value(other).literal == 0.0 else self._emit("fsub", other)

    def __rsub__(self, other):
        return self.machine.value(other) - self

    def __mul__(self, other):
        other = self.machine.value(other)
        for one, two in ((self, other), (other, self)):
            if one.literal == 0.0:
                return one
            if one.literal == 1.0:
                return two
        return self._emit("fmul", other)

    __rmul__ = __mul__

    def __truediv__(self, other):
        return self if self.machine.value(other).literal == 1.0 else self._emit("fdiv", other)

    def __rtruediv__(self, other):
        return self._emit("fdiv", other, swap=True)

    def __neg__(self):
        return self.machine.made(Value, "fneg", self.machine.builder.fneg, self)

    def __abs__(self):
        return self.machine.call("fabs", self)

    def _compare(operator):
        def compare(self, other):
            machine = self.machine
            compare = machine.builder.fcmp_unordered if operator == "!=" else machine.builder.fcmp_ordered
            return machine.made(Mask, operator, partial(compare, operator), self, machine.value(other))

        return compare

    __lt__, __le__, __gt__, __ge__, __eq__, __ne__ = map(_compare, ("<", "<=", ">", ">=", "==", "!="))  # type: ignore[arg-type]
    __hash__ = None  # type: ignore[assignment]


class Mask:
    """For which pixels of a group something holds."""

    def __init__(self, machine: "Tracer", vector: ir.Value, still: Still | None = None):
        self.machine, self.vector, self.still = machine, vector, still

    def __and__(self, other):
        return self.machine.made(Mask, "and", self.machine.builder.and_, self, other)

    def __or__(self, other):
        return self.machine.made(Mask, "or", self.machine.builder.or_, self, other)

    def __invert__(self):
        return self.machine.made(Mask, "not", self.machine.builder.not_, self)


def is_dear(operand: Value | Mask) -> bool:
    """Return whether an operand is still and takes longer to compute again than to load from its slot."""
    return isinstance(operand, Value) and operand.still is not None and operand.still.cost >= DEAR


class Variable:
    """A value that changes: memory that LLVM turns into registers."""

    def __init__(self, machine: "Tracer", value: Value | float):
        self.machine, value = machine, machine.value(value)
        self.place = machine.reserve(value.vector.type)
        machine.builder.store(value.vector, self.place)

    @property
    def value(self) -> Value:
        """The present value."""
        return Value(self.machine, self.machine.builder.load(self.place))

    def set(self, value: Value | float, mask: Mask | None = None) -> None:
        """Put a value in its place, where the mask holds."""
        machine, vector = self.machine, self.machine.value(value).vector
        if mask is not None:
            vector = machine.builder.select(mask.vector, vector, machine.builder.load(self.place))
        machine.builder.store(vector, self.place)


class Tracer:
    """A machine whose values are traced: it emits a function that `lanes` pixels at a time go through.

    The function's one parameter is the address of an array of int64: its arguments.
    """

    def __init__(self, module: ir.Module, name: str, lanes: int, kinds: Iterable[str] = (), number: ir.Type = FLOAT):
        function = ir.Function(module, ir.FunctionType(ir.VoidType(), [WHOLE.as_pointer()]), name)
        (self._arguments,), self.lanes, self.module = function.args, lanes, module
        self.vector, self.mask = ir.VectorType(number, lanes), ir.VectorType(BIT, lanes)
        self.entry = function.append_basic_block()
        self.builder = ir.IRBuilder(self.entry)
        self.counts = {kind: self.reserve(WHOLE) for kind in kinds}
        for place in self.counts.values():
            self.builder.store(WHOLE(0), place)
        self.light_numbers = self.light_count = self.light = None
        self.stills: Any = None
        self.storing, self.kept_at = False, None  # where the group's still values are

    def argument(self, number: int) -> ir.Value:
        """Return one of the function's arguments."""
        return self.builder.load(self.builder.gep(self._arguments, [WHOLE(number)]))

    def reserve(self, kind: ir.Type) -> ir.Value:
        """Return memory for one value, reserved where the function begins."""
        with self.builder.goto_block(self.entry):
            self.builder.position_at_start(self.entry)
            return self.builder.alloca(kind)

    def value(self, number: Value | float) -> Value:
        """Return a number as a Value, if it is not one."""
        if isinstance(number, Value):
            return number
        number = float(number)
        return Value(self, constant(self.vector, number.hex()), number, self.still_input(number))

    def still_input(self, what: Hashable, of_light: bool = False) -> Still | None:
        """Return the Still of an input or a constant, by its name or number; None where no still value is kept."""
        return self.stills and self.stills.input(what, of_light)

    def made(self, kind: type, name: str, emit: Callable, *operands: Value | Mask) -> Any:
        """Return what an instruction makes of operands: a Value or a Mask, still if all of them are."""
        still = self.stills and self.stills.made(name, [operand.still for operand in operands])
        if not still:
            operands = tuple(self.kept(one) if is_dear(one) else one for one in operands)
        made = kind(self, emit(*(operand.vector for operand in operands)), still=still)
        return self.kept(made) if still and name in SLOW else made

    def kept(self, value: Any) -> Value:
        """Return a still Value: stored in its slot, or loaded from there; as it is, if it has none."""
        still, builder, number = value.still, self.builder, self.stills.slot(value.still, new=self.storing)
        if number is None:
            return value
        slot = WHOLE(number)
        if still.of_light:
            slot = builder.add(builder.mul(self.light, WHOLE(OF_LIGHT)), slot)
        place, vector = builder.gep(self.kept_at, [slot]), value.vector
        if self.storing:
            builder.store(vector, place, align=8)
        else:
            vector = builder.load(place, align=8)
        return Value(self, vector, still=still._replace(cost=0))

    def everywhere(self, scalar: ir.Value, still: Still | None = None) -> Value:
        """Return the Value that is one scalar for every pixel."""
        undefined = ir.Constant(self.vector, ir.Undefined)
        first = self.builder.insert_element(undefined, scalar, WHOLE(0))
        lanes = ir.Constant(ir.VectorType(ir.IntType(32), self.lanes), 0)
        return Value(self, self.builder.shuffle_vector(first, undefined, lanes), still=still)

    def whole(self, value: Value) -> ir.Value:
        """Return the one whole number that is everywhere in a Value."""
        return self.builder.fptosi(self.builder.extract_element(value.vector, WHOLE(0)), WHOLE)

    def call(self, intrinsic: str, *arguments: Value | float) -> Value:
        """Return what one of LLVM's own functions makes of Values."""
        values = [self.value(argument) for argument in arguments]
        name = f"llvm.{intrinsic}.v{self.lanes}{self.vector.element.intrinsic_name}"
        known = self.module.globals.get(name)
        function = known or ir.Function(self.module, ir.FunctionType(self.vector, [self.vector] * len(values)), name)
        return self.made(Value, intrinsic, lambda *vectors: self.builder.call(function, vectors), *values)

    sqrt = partialmethod(call, "sqrt")
    floor = partialmethod(call, "floor")
    rint = partialmethod(call, "rint")

    def bits(self, number: Value, operation: str, other: int) -> Value:
        """As `renderer.operations.bits`."""
        builder, whole = self.builder, ir.VectorType(WHOLE, self.lanes)

        def emit(vector):
            changed = getattr(builder, operation)(builder.bitcast(vector, whole), whole([other] * self.lanes))
            return builder.bitcast(changed, self.vector)

        return self.made(Value, f"{operation} {other}", emit, number)

    def where(self, mask: Mask, value: Value | float, otherwise: Value | float) -> Value:
        return self.made(Value, "select", self.builder.select, mask, self.value(value), self.value(otherwise))

    def variable(self, value: Value | float) -> Variable:
        """Return a Variable."""
        return Variable(self, value)

    def count(self, kind: str, mask: Mask) -> None:
        """Add the number of a mask's pixels to what is counted of a kind."""
        bits = self._bits(mask)
        pixels = self.builder.zext(self.builder.ctpop(bits), WHOLE)
        place = self.counts[kind]
        self.builder.store(self.builder.add(self.builder.load(place), pixels), place)

    def _bits(self, mask):
        return self.builder.bitcast(mask.vector, ir.IntType(self.lanes))

    def when(self, mask: Mask, body: Step) -> None:
        """Run `body` unless the mask holds for no pixel of the group."""
        bits = self._bits(mask)
        with self.builder.if_then(self.builder.icmp_unsigned("!=", bits, bits.type(0))):
            body()

    def choose(
        self, alternatives: Sequence, index: Value, result_of: Callable[[Any], Sequence], count: int = 2
    ) -> Sequence:
        """Return `result_of` the alternative of an index that is the same everywhere: so many numbers of each."""
        if len(alternatives) == 1:
            return result_of(alternatives[0])
        index, results = self.whole(index), [self.variable(0.0) for _ in range(count)]
        for number, alternative in enumerate(alternatives):
            with self.tracing(alternative), self.builder.if_then(self.builder.icmp_signed("==", index, WHOLE(number))):
                for variable, value in zip(results, result_of(alternative), strict=True):
                    variable.set(value)
        return [variable.value for variable in results]

    @contextmanager
    def tracing(self, alternative: Hashable) -> Iterator[None]:
        """In the block, an alternative is traced: it has its own still values."""
        if self.stills:
            self.stills.alternative = alternative
        yield
        if self.stills:
            self.stills.alternative = None

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
    def rows(self, given: Mapping[str, ir.Value], columns: ir.Value) -> Iterator[tuple[ir.Value, ir.Value, ir.Value]]:
        """Emit a loop over rows; the block is its body and is given the row, and where its columns begin and end."""
        builder = self.builder
        with self.loop(given["first_row"], given["last_row"]) as row:
            ends = builder.mul(row, WHOLE(2))
            begin, end = (builder.load(builder.gep(columns, [builder.add(ends, WHOLE(n))])) for n in (0, 1))
            yield row, begin, end

    def by_squaring(self, exponent: Value, first: Step, square: Step, multiply: Step) -> None:
        """Run what raises something to a whole power that is everywhere the same: nothing for 0.

        `square` as often as the exponent's lowest bit says, `first`; then for each higher bit `square`, and `multiply`
        where it is set.
        """
        builder, exponent = self.builder, self.whole(exponent)
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
        with self.loop(WHOLE(0), self.light_count) as number:
            self.light = number
            body(of_form(LIGHT_FORM, self.numbers(self.light_numbers, LIGHT_FORM, number)))

    def numbers(self, pointer: ir.Value, form: SimpleNamespace, number: ir.Value | None = None) -> Iterator[Value]:
        """Yield the Values of an array of numbers of a form, or of its row `number`."""
        count = len(flat(form))
        for column in range(count):
            index = WHOLE(column)
            if number is not None:
                index = self.builder.add(self.builder.mul(number, WHOLE(count)), index)
            scalar = self.builder.load(self.builder.gep(pointer, [index]))
            yield self.everywhere(scalar, self.still_input(("light" if number else "scene", column), bool(number)))
