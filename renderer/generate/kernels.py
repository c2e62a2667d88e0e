"""The text of `renderer/kernels.py`: every program that drawing needs, as a plain Python function."""

import builtins
import textwrap
from collections.abc import Callable, Mapping
from inspect import isfunction
from typing import Any

from proofs.engine.program import Program
from proofs.formulas.algebraic_form import MAX_WAVE_NUMBER
from proofs.formulas.certified import ROUNDINGS, SMALL_POWER
from proofs.formulas.elementary import product_error
from proofs.formulas.finite_difference import HEIGHT_EVALUATIONS, METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField
from proofs.formulas.shading import LIGHT_MODELS
from renderer.generate import programs
from renderer.generate.printer import KernelPrinter

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


def print_function(name: str, program: Program, printer: KernelPrinter, before: str = "") -> str:
    """Return the text of a function of a program's inputs that returns its outputs, a line for each definition.

    before: further parameters, as text. The error of a product is 0 unless it is given.
    """
    needed = program.reaches(*program.outputs)
    printed = {s.name: printer.doprint(e) for s, e in program.definitions if s in needed}
    results, used = [s.name for s in program.outputs], set().union(*(e.free_symbols for _, e in program.definitions))
    at_once = f"return {', '.join(printed.values())}"
    if list(printed) == results and used.isdisjoint(program.outputs) and len(at_once) <= 100:
        lines = [at_once]
    else:
        lines = [*(f"{name} = {text}" for name, text in printed.items()), f"return {', '.join(results)}"]
    parameters = ", ".join("product_error=0.0" if s == product_error else s.name for s in program.inputs)
    return "\n".join([f"def {name}({before}{parameters}):", *(f"    {line}" for line in lines), ""])


def function_of(program: Program, names: Mapping[str, Any] | None = None) -> Callable:
    """Return a program as a Python function of its inputs, in order, that returns its outputs.

    Without more it computes what a kernel does, to the last bit, on float64 numbers and arrays or traced values.
    names: what the printed text may call instead.
    """
    from renderer import kernels  # not above: they may be what is about to be printed

    scope = dict(vars(kernels) if names is None else names)
    exec(print_function(program.name, program, KernelPrinter()), scope)
    return scope[program.name]


def field_entry(field: HeightField) -> str:
    """Return the text of a field's entry in FIELDS: its kernels, its differences, how many heights each evaluates."""
    lines = [f'"{role}": {program.name},' for role, program in programs.field_programs(field).items()]
    if not field.wave_numbers:
        lines.append('"wave_numbers": None,')
    lines.append(", ".join(f'"{method}": {programs.difference_of(method, field)}' for method in METHODS) + ",")
    heights = {method: programs.height_evaluations(method, field) for method in METHODS}
    lines.append(f'"height_evaluations": {heights},'.replace("'", '"'))
    return f'    "{field.name}": {{\n' + textwrap.indent("\n".join(lines), " " * 8) + "\n    },"


def kernels_source() -> str:
    """Return the text of renderer/kernels.py. Raises ValueError where a kernel would call what there is none of."""
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


def refuse_unknown_calls(known: dict[str, Any]) -> None:
    """Raise ValueError where a function that was made in the scope `known` calls what is not there."""
    for kernel in (f for f in known.values() if isfunction(f) and f.__globals__ is known):
        if unknown := {*kernel.__code__.co_names} - known.keys() - {*dir(builtins)}:
            raise ValueError(f"{kernel.__name__} is not allowed: it calls {', '.join(unknown)}, which no kernel has")
