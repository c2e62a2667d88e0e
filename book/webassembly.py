"""The shader and kernels as a WebAssembly module for browsers, compiled by LLVM; no linker is needed.

Every call is inlined and nothing is from libm, so that LLVM's object file of the functions is a module already, but
for its exports.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import llvmlite.binding as llvm
import llvmlite.ir as ir

from book.painting_code import PAINTERS, emit_painter
from renderer.machines.drawing_code import emit
from renderer.machines.native import optimized
from renderer.machines.points_code import emit_points
from renderer.machines.traced import FLOAT, Tracer, Value

LANES = 2
TRIPLE = "wasm32-unknown-unknown"
FEATURES = "+simd128,+nontrapping-fptoint"
HEADER_SIZE = 8
CUSTOM, IMPORT, EXPORT, CODE, DATA = 0, 2, 7, 10, 11


def compiled_module(
    wants: Mapping[str, Any],
    kernels: Mapping[str, Callable],
    painters: Mapping[str, Callable] = PAINTERS,
    of_vectors: Mapping[str, Callable] = {},
) -> tuple[bytes, dict[str, int]]:
    """Return (a module's bytes, {kernel's name: how many outputs it has}).

    wants: {name: want}, each a function that draws rows (`renderer.machines.drawing_code`). kernels:
    {name: kernel}, each a function over points (`renderer.machines.points_code`). painters: {name: painter}
    (`book.painting_code`). of_vectors: {name: kernel of one number}, each a function of a vector, for code that is
    compiled in the page. The module imports `env.__linear_memory`.
    """
    module = ir.Module()
    module.triple = TRIPLE
    for name, want in wants.items():
        emit(module, name, want, LANES)
    outputs = {name: emit_points(module, name, kernel, LANES) for name, kernel in kernels.items()}
    for name, painter in painters.items():
        emit_painter(module, name, painter)
    for name, kernel in of_vectors.items():
        tracer = _Vectors(module, name)
        tracer.builder.ret(kernel(Value(tracer, tracer.function.args[0])).vector)
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple(TRIPLE).create_target_machine(features=FEATURES, opt=2, reloc="static")
    return exported(target.emit_object(optimized(module, target)), [*wants, *kernels, *painters, *of_vectors]), outputs


class _Vectors(Tracer):
    """A machine that emits a function of one vector, which returns another; no loop is around it."""

    def __init__(self, module, name):
        self.module, self.lanes, self.number, self.vector = module, LANES, FLOAT, ir.VectorType(FLOAT, LANES)
        self.function = ir.Function(module, ir.FunctionType(self.vector, [self.vector]), name)
        self.builder = ir.IRBuilder(self.function.append_basic_block())


def exported(program: bytes, names: Sequence[str]) -> bytes:
    """Return an object file as a module that exports its functions, whose names are given in their order.

    Raises ValueError if it has data, or imports more than the memory: then a linker would be needed.
    """
    parts = [program[:HEADER_SIZE]]
    for kind, content in _sections(program[HEADER_SIZE:]):
        if kind == DATA or (kind == IMPORT and content != _memory_alone(content)):
            raise ValueError(f"the object file needs a linker: section {kind} is {content!r}")
        if kind == CODE:
            exports = b"".join(_text(name) + b"\0" + _leb(index) for index, name in enumerate(names))
            parts.append(_section(EXPORT, _leb(len(names)) + exports))
        if kind != CUSTOM:
            parts.append(_section(kind, content))
    return b"".join(parts)


def _memory_alone(content):
    """Return the import section of the memory alone, whatever its limits are."""
    memory = b"\1" + _text("env") + _text("__linear_memory") + b"\2"
    return memory + content[len(memory) : len(memory) + 2]


def _leb(number):
    """Return a whole number in WebAssembly's spelling, LEB128."""
    digits = b""
    while True:
        number, low = number >> 7, number & 127
        digits += bytes([low | (128 if number else 0)])
        if not number:
            return digits


def _number(content, at):
    """Return (the number that begins at a place, where it ends)."""
    number = shift = 0
    while True:
        number |= (content[at] & 127) << shift
        at, shift = at + 1, shift + 7
        if content[at - 1] < 128:
            return number, at


def _text(text):
    return _leb(len(text)) + text.encode()


def _section(kind, content):
    return bytes([kind]) + _leb(len(content)) + content


def _sections(content):
    """Yield (kind, content) of the sections of a module."""
    at = 0
    while at < len(content):
        size, begin = _number(content, at + 1)
        yield content[at], content[begin : begin + size]
        at = begin + size
