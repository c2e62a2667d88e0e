"""The text of `renderer/kernels.py`, and of `renderer/array_kernels.py`.

A kernel is a straight-line program, printed as it stands inside one loop over a row of pixels. Lines that do not
depend on the pixel stand before the loop.
"""

import textwrap
from string import Template

from proofs import elementary
from proofs.algebraic_form import MAX_WAVE_NUMBER
from proofs.finite_difference import HEIGHT_EVALUATIONS
from proofs.height_fields import HEIGHT_FIELDS
from proofs.program import Program, chain
from proofs.symbols import k_u, k_v, real
from renderer.generate.fused import FUSED_KERNELS
from renderer.generate.kernel_list import (
    DISCRIMINANT_OF_A,
    ONCE_A_SCENE,
    ROW_KERNELS,
    field_kernels,
    height_evaluations,
)
from renderer.generate.printers import NumbaPrinter, NumPyPrinter

HEADER = '''\
"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: change the expression instead.

Each `*_row` function runs over the pixels start ≤ i < stop of one row: arguments ending in `_row` are float64 arrays
along the row, the others are scalars, and results are written to the last arrays.
$what
"""
'''

NUMBA_HEADER = (
    Template(HEADER).substitute(what="Compiled without fast-math.")
    + """
import math

import numpy as np
from numba import njit

import renderer.compiled_code  # noqa: F401  (where the compiled code is kept)

inlined = njit(inline="always", error_model="numpy")
compiled = njit(cache=True, nogil=True, error_model="numpy")


@inlined
def pixels(start, stop):
    return range(np.uint64(start), np.uint64(stop))


@inlined
def maximum(a, b):
    return b if b > a else a


@inlined
def minimum(a, b):
    return b if b < a else a


@inlined
def sign(a):
    return 1.0 if a > 0.0 else (-1.0 if a < 0.0 else 0.0)
"""
)

NUMPY_HEADER = (
    Template(HEADER).substitute(what="Nothing is compiled: NumPy does the whole row at once.")
    + """
import math

import numpy as np


def inlined(function):
    return function


compiled = np.errstate(all="ignore")  # a selection computes both of its sides


def pixels(start, stop):
    return (slice(start, stop),)


def power(base, exponent):
    return np.frompyfunc(math.pow, 2, 1)(base, exponent).astype(np.float64)  # NumPy's own may differ in the last bit
"""
)


class ArrayPrinter(NumPyPrinter):
    """Whole rows, but for the power: that is the compiled kernels'."""

    power = "power"


CORES = {"sinpi": elementary.sine_of_half_turns, "cospi": elementary.cosine_of_half_turns}


def of_a_number(name):
    """Return the program of sinpi or cospi of a number that is a float64 already: a product without an error."""
    core = CORES[name]
    lines = ((elementary.product_error, 0 * elementary.product), *core.definitions)
    return Program(name, (elementary.product,), lines, core.outputs)


def elementary_functions():
    """Return [(function name, arguments, program)] of our own elementary functions."""
    functions = [("atan2pi", elementary.angle_in_half_turns)]
    for name, core in CORES.items():
        functions += [(name, of_a_number(name)), (f"{name}_of_product", chain(name, elementary.two_product, core))]
    return functions


def print_function(name, program, printer, decorator="@inlined\n"):
    """Return the text of a scalar function with one result, a line for each definition."""
    arguments = ", ".join(s.name for s in program.inputs)
    lines = [f"{s.name} = {printer.doprint(e)}" for s, e in program.definitions]
    lines.append(f"return {', '.join(s.name for s in program.outputs)}")
    return f"{decorator}def {name}({arguments}):\n" + textwrap.indent("\n".join(lines), "    ") + "\n"


def print_row_kernel(kernel, printer):
    """Return the text of a row kernel: the lines that its outputs need, in the program's order."""
    program, rows = kernel.program, set(kernel.rows)
    targets = dict(zip(program.outputs, kernel.into or program.outputs, strict=True))
    arguments = [f"{s.name}_row" if s in rows else s.name for s in program.inputs]
    arguments += [f"{t.name}_row" for t in targets.values() if f"{t.name}_row" not in arguments]
    needed = program.reaches(*program.outputs)
    varying, before, inside = set(rows), [], []
    for symbol, expression in program.definitions:
        if symbol not in needed:
            continue
        if expression.free_symbols & varying:
            varying.add(symbol)
        line = f"{symbol.name} = {printer.doprint(expression)}"
        (inside if symbol in varying else before).append(line)
    loads = [f"{s.name} = {s.name}_row[i]" for s in program.inputs if s in rows & needed]
    stores = [f"{t.name}_row[i] = {s.name}" for s, t in targets.items()]
    signature = textwrap.wrap(", ".join([*arguments, "start", "stop"]), 105)
    return "\n".join(
        [
            "@compiled",
            f"def {program.name}_row(",
            *(f"    {line}" for line in signature),
            "):",
            *(f"    {line}" for line in before),
            "    for i in pixels(start, stop):",
            *(f"        {line}" for line in (*loads, *inside, *stores)),
            "",
        ]
    )


def field_table():
    """Return the text of the table from a field's name to its kernels."""
    lines = ["FIELDS = {"]
    for field in HEIGHT_FIELDS.values():
        lines.append(f'    "{field.name}": {{')
        for kernel in field_kernels(field):
            role = kernel.program.name.removesuffix(f"_{field.name}")
            lines.append(f'        "{role}": {kernel.program.name}_row,')
        heights = {method: height_evaluations(method, field) for method in HEIGHT_EVALUATIONS}
        lines.append(f'        "height_evaluations": {heights},')
        lines.append(f'        "wave_numbers": {f"wave_numbers_{field.name}" if field.wave_numbers else None},')
        lines.append("    },")
    return "\n".join([*lines, "}", ""])


def wave_numbers_program(field):
    """Return the program (k_u, k_v) → the wave numbers of a field's algebraic form."""
    a, b = real("a b")
    return Program(
        f"wave_numbers_{field.name}", (k_u, k_v), tuple(zip((a, b), field.wave_numbers, strict=True)), (a, b)
    )


def kernels_source(printer=NumbaPrinter, header=NUMBA_HEADER):
    """Return the text of renderer/kernels.py, or that of another back end with its printer and its header."""
    printer = printer()
    fields = HEIGHT_FIELDS.values()
    parts = [print_function(name, program, printer) for name, program in elementary_functions()]
    parts.append(print_function(DISCRIMINANT_OF_A.name, DISCRIMINANT_OF_A, printer, "@compiled\n"))
    parts += [print_function(p.name, p, printer, "") for p in ONCE_A_SCENE]
    parts += [print_row_kernel(kernel, printer) for kernel in (*ROW_KERNELS, *FUSED_KERNELS)]
    for field in fields:
        for kernel in field_kernels(field):
            parts.append(print_row_kernel(kernel, printer))
        if field.wave_numbers:
            parts.append(print_function(f"wave_numbers_{field.name}", wave_numbers_program(field), printer, ""))
    parts += [f"HEIGHT_EVALUATIONS = {HEIGHT_EVALUATIONS}\n", f"MAX_ALGEBRAIC = {MAX_WAVE_NUMBER}\n", field_table()]
    return header + "".join(f"\n\n{part}" for part in parts)


def array_kernels_source():
    """Return the text of renderer/array_kernels.py."""
    return kernels_source(ArrayPrinter, NUMPY_HEADER)
