"""Printer of `renderer/kernels.py`: every program that drawing needs, as a plain Python function."""

import textwrap
from collections.abc import Callable, Mapping
from typing import Any

from proofs.engine.program import Program
from proofs.formulas.algebraic_form import MAX_WAVE_NUMBER
from proofs.formulas.certified import ROUNDINGS, SMALL_POWER
from proofs.formulas.finite_difference import HEIGHT_EVALUATIONS, METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField
from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.symbols import k_u, k_v, u, v
from proofs.printers import python
from proofs.printers.python import KernelPrinter, print_function, refuse_unknown_calls
from renderer.generate import programs

HEADER = '''"""Printed from proofs/ by `python -m renderer.generate`. Do not edit: change the expression instead.

Each function is one program of the chapter, a line for each line of its derivation. It works on whatever it is given:
NumPy's arrays and float64 numbers (under `numpy.errstate`: a selection computes both of its sides), traced values.
"""

from renderer.operations import (
    Constant,
    binary_exponent,
    elementary,
    floor,
    inf,
    maximum,
    minimum,
    nan,
    pi,
    power_of_two,
    rint,
    sign,
    sqrt,
    sum_of_half_turns,
    where,
)
'''


def function_of(program: Program, names: Mapping[str, Any] | None = None) -> Callable:
    """Return a program as a Python function of its inputs, in order, that returns its outputs.

    By default it has a kernel's bits, on float64 numbers and arrays or traced values. names: the functions that the
    printed text calls, by name, in place of those of `renderer.operations`.
    """
    from renderer import kernels  # not above: they may be what is about to be printed

    return python.function_of(program, vars(kernels) if names is None else names)


def field_entry(field: HeightField) -> str:
    """Return the text of a field's entry in FIELDS: its kernels, its differences, how many heights each evaluates."""
    lines = [f'"{role}": {program.name},' for role, program in programs.field_programs(field).items()]
    if not field.wave_numbers:
        lines.append('"wave_numbers": None,')
    without = [k.name for k in (k_u, k_v) if not field.expression.subs(k, 0).free_symbols & {u, v}]
    lines.append(f'"level_without": {tuple(without)},'.replace("'", '"'))
    lines.append(", ".join(f'"{method}": {programs.difference_of(method, field)}' for method in METHODS) + ",")
    heights = {method: programs.height_evaluations(method, field) for method in METHODS}
    lines.append(f'"height_evaluations": {heights},'.replace("'", '"'))
    return f'    "{field.name}": {{\n' + textwrap.indent("\n".join(lines), " " * 8) + "\n    },"


def kernels_source() -> str:
    """Return the text of renderer/kernels.py. Raises ValueError where a kernel would call an unknown function."""
    printer, fields = KernelPrinter(), HEIGHT_FIELDS.values()
    parts = [
        "@elementary\n" * (name in programs.ELEMENTARY) + print_function(name, program, printer)
        for name, program in programs.named().items()
    ]
    parts += [print_function(name, program, printer, "height, ") for name, program in programs.differences().items()]
    roundings = {name: float(most) for name, most in ROUNDINGS.items()}
    parts.append(f"ROUNDINGS = {roundings}\n".replace("'", '"') + f"SMALL_POWER = {float(SMALL_POWER)!r}\n")
    parts.append(f"HEIGHT_EVALUATIONS = {HEIGHT_EVALUATIONS}\nMAX_ALGEBRAIC = {MAX_WAVE_NUMBER}\n".replace("'", '"'))
    parts.append("\n".join(["FIELDS = {", *map(field_entry, fields), "}", ""]))
    models = [
        f'    "{m.name}": ({m.program.name}, {m.squared.name if m.squared else None}),' for m in LIGHT_MODELS.values()
    ]
    parts.append(
        "\n".join(["LIGHT_MODELS = {", *models, "}", '"""{name: (its kernel, that of the squared base)}"""', ""])
    )
    source = HEADER + "".join(f"\n\n{part}" for part in parts)
    known: dict[str, Any] = {}
    exec(source, known)
    refuse_unknown_calls(known)
    return source
