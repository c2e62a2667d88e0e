"""The shader and kernels as a WebAssembly module for browsers, compiled by LLVM; no linker is needed.

Every call is inlined and nothing is from libm, so that LLVM's object file of the functions is a module already, but
for its exports.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import llvmlite.binding as llvm
import llvmlite.ir as ir

from book.programs.painting_code import PAINTERS, emit_painter
from renderer.machines.drawing_code import emit
from renderer.machines.native import optimized
from renderer.machines.points_code import emit_points
from renderer.machines.traced import FLOAT, Tracer, Value

LANES = 2
TRIPLE = "wasm32-unknown-unknown"
FEATURES = "+simd128,+nontrapping-fptoint"
MAGIC = b"\0asm\1\0\0\0"
CUSTOM, TYPE, IMPORT, EXPORT, CODE, DATA = 0, 1, 2, 7, 10, 11
MEMORY = b"\3env\x0f__linear_memory\2"
OPERATIONS = {"sum": 0xF0, "product": 0xF2, "quotient": 0xF3, "min": 0xF4, "max": 0xF5, "abs": 0xEC, "root": 0xEF}
OPERATIONS |= {"floor": 0x75, "everywhere": 0x14}  # of vectors


def compiled_module(
    wants: Mapping[str, Any],
    kernels: Mapping[str, Callable],
    painters: Mapping[str, Callable] = PAINTERS,
    of_vectors: Mapping[str, tuple[int, Callable]] = {},
) -> tuple[bytes, dict[str, int]]:
    """Return (a module's bytes, {kernel's name: how many outputs it has}).

    wants: {name: want}, each a function that draws rows (`renderer.machines.drawing_code`). kernels:
    {name: kernel}, each a function over points (`renderer.machines.points_code`). painters: {name: painter}
    (`book.programs.painting_code`). of_vectors: {name: (of how many
    vectors, kernel)}, each a function that a page's own code calls. The module imports `env.__linear_memory`.
    """
    module = ir.Module()
    module.triple = TRIPLE
    for name, want in wants.items():
        emit(module, name, want, LANES)
    outputs = {name: emit_points(module, name, kernel, LANES) for name, kernel in kernels.items()}
    for name, painter in painters.items():
        emit_painter(module, name, painter)
    for name, (count, kernel) in of_vectors.items():
        tracer = _Vectors(module, name, count)
        tracer.builder.ret(kernel(*(Value(tracer, vector) for vector in tracer.function.args)).vector)
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple(TRIPLE).create_target_machine(features=FEATURES, opt=2, reloc="static")
    return exported(target.emit_object(optimized(module, target)), [*wants, *kernels, *painters, *of_vectors]), outputs


class _Vectors(Tracer):
    """A machine that emits a function of so many vectors, which returns one; no loop is around it."""

    def __init__(self, module, name, count):
        self.module, self.lanes, self.number, self.vector = module, LANES, FLOAT, ir.VectorType(FLOAT, LANES)
        self.function = ir.Function(module, ir.FunctionType(self.vector, [self.vector] * count), name)
        self.builder = ir.IRBuilder(self.function.append_basic_block())


def emitted(of_vectors: Mapping[str, tuple[int, Callable]]) -> dict[str, Any]:
    """Return what code is made of that a page emits: functions of an address over points, beside a module of ours.

    {"head": the bytes it begins with, its types (that of such a function is the first) and its imports: the memory and
    the module's functions of vectors, "codes": {operation: its bytes}, "functions": how many are imported}.
    """
    types = [b"\x60\1\x7f\0", *(b"\x60" + _leb(n) + b"\x7b" * n + b"\1\x7b" for n in (1, 2, 3))]
    imports = [b"\3env" + _text(name) + b"\0" + _leb(count) for name, (count, _) in of_vectors.items()]
    imports.append(MEMORY + b"\0\1")
    sections = (_section(kind, _leb(len(of)) + b"".join(of)) for kind, of in ((TYPE, types), (IMPORT, imports)))
    codes = {name: b"\xfd" + _leb(code) for name, code in OPERATIONS.items()}
    codes |= {"load": b"\xfd\0\3\0", "store": b"\xfd\x0b\3\0"}
    codes |= {name: b"\x10" + _leb(number) for number, name in enumerate(of_vectors)}
    return {
        "head": [*MAGIC, *b"".join(sections)],
        "codes": {name: [*code] for name, code in codes.items()},
        "functions": len(of_vectors),
    }


def exported(program: bytes, names: Sequence[str]) -> bytes:
    """Return an object file as a module that exports its functions, whose names are given in their order.

    Raises ValueError if it has data, or imports more than the memory: then a linker would be needed.
    """
    parts = [MAGIC]
    for kind, content in _sections(program[len(MAGIC) :]):
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
    return b"\1" + MEMORY + content[1 + len(MEMORY) :][:2]


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
