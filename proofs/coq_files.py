"""The files printed for Coq: programs (Formulas.v), float64 operations (Float64.v), claims (Statements.v)."""

from collections.abc import Callable, Mapping
from typing import Any

from proofs.engine.program import Program
from proofs.engine.registry import by_name
from proofs.engine.theorem import all_theorems
from proofs.formulas import (
    algebraic_form,
    bump,
    camera,
    chart,
    displacement,
    elementary,
    enclosed,
    exponential,
    finite_difference,
    height_fields,
    image_derivative,
    shading,
    shadow,
    shadow_cone,
    tangent_frame,
)
from proofs.printers.coq import in_module, module_of
from proofs.printers.coq_float64 import carried_out, rule
from proofs.printers.coq_statements import statements_of

FORMULAS = """(* Printed from proofs/formulas by `python -m renderer.generate`. Do not edit: change the formula instead.
   Each module is one program of the chapter; each definition is one line of its derivation. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries.
Open Scope R_scope.
"""

MODULES = (
    camera,
    chart,
    tangent_frame,
    bump,
    shading,
    shadow,
    shadow_cone,
    algebraic_form,
    displacement,
    image_derivative,
)

HALF_TURN_POLYNOMIALS = Program(
    "half_turn_polynomials",
    (elementary.remainder,),
    tuple(elementary.reduction.items())[[*elementary.reduction].index(elementary.z) :],
    (elementary.sine_near, elementary.cosine_near),
)
"""The polynomials of the kernels' sine and cosine, of a reduced argument."""
OF_RATIO = (elementary.ratio_squared, elementary.arctangent_tail, elementary.small_part)
ARCTANGENT_POLYNOMIAL = Program(
    "arctangent_polynomial",
    (elementary.ratio, elementary.node_correction),
    {symbol: elementary.angle_in_half_turns[symbol] for symbol in OF_RATIO},
)
"""The polynomial of the kernels' atan2pi, once a node is taken off: the arctangent of a small ratio, over π."""
EXPONENTIAL_POLYNOMIAL = Program(
    "exponential_polynomial",
    (exponential.away, exponential.away_error),
    exponential.exponential_of_sum.definitions[len(exponential.exponential_reduction) : -1],
)
"""The polynomial of the kernels' exp, once the doublings are taken off."""
OF_QUOTIENT = (exponential.quotient_squared, exponential.log_tail)
LOGARITHM_POLYNOMIAL = Program(
    "logarithm_polynomial",
    (exponential.quotient,),
    {symbol: exponential.logarithm_in_three[symbol] for symbol in OF_QUOTIENT},
)
"""The polynomial that the kernels' log adds to twice a quotient q: 2 artanh q − 2q."""


def programs() -> dict[str, Program]:
    """Return {name: program} of all programs that are printed, in the order of the modules of proofs/formulas."""
    printed = [p for module in MODULES for p in vars(module).values() if isinstance(p, Program)]
    printed += [*image_derivative.base_derivatives.values()]
    printed += [HALF_TURN_POLYNOMIALS, ARCTANGENT_POLYNOMIAL, EXPONENTIAL_POLYNOMIAL, LOGARITHM_POLYNOMIAL]
    programs_of = (height_fields.height, height_fields.gradient, *finite_difference.METHODS.values())
    printed += [program(field) for field in height_fields.HEIGHT_FIELDS.values() for program in programs_of]
    return by_name(printed)


def formulas_source() -> str:
    """Return the text of proofs/formal/Formulas.v."""
    return FORMULAS + "".join(f"\n{module_of(program)}" for program in programs().values())


FLOAT64 = """(* Printed from proofs/formulas by `python -m renderer.generate`. Do not edit: change the formula.
   The float64 operations of kernels, one after the other as they are carried out, each rounded. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Float.
Open Scope R_scope.
"""


def float64_module(program: Program, operations: Mapping[str, Any], *variables: str) -> str:
    """Return a program's float64 operations as the text of a Coq module; variables: those beside the inputs."""
    return in_module(f"{program.name}_float64", [*variables, *carried_out(program, operations)])


def float64_source(operations: Mapping[str, Any], kernels: Mapping[str, Any], counted: Callable) -> str:
    """Return the text of proofs/formal/Float64.v: the operations of kernels as they are carried out.

    operations: the functions that kernels call. kernels: by name. counted: (value, count) → a number that counts its
    roundings.
    """
    single = [
        elementary.two_product,
        HALF_TURN_POLYNOMIALS,
        elementary.sine_of_half_turns,
        elementary.cosine_of_half_turns,
        elementary.angle_in_half_turns,
        exponential.exponential_of_sum,
        exponential.natural_logarithm,
        exponential.raised,
        camera.hit_of_b,
        bump.perturbed,
        shading.light_direction,
        shading.blinn_highlight,
        shading.squared_highlight,
        shading.phong_highlight,
        shading.light_term,
        shading.clip,
    ]
    programs_of = (height_fields.height, height_fields.gradient_from_factors, height_fields.gradient)
    for field in filter(lambda field: field.wave_numbers, height_fields.HEIGHT_FIELDS.values()):
        single += [program(field) for program in programs_of]
    modules = [float64_module(program, operations) for program in single]
    for method in finite_difference.METHODS.values():
        any_field = method(height_fields.ANY_FIELD)
        modules.append(float64_module(any_field, operations, "Variable height : R -> R -> R -> R -> R."))
    rules = {program.name: rule(program, kernels, counted) for program in enclosed.RULES.values()}
    modules += [in_module(f"{name}_float64", lines) for name, lines in rules.items()]
    return FLOAT64 + "".join(f"\n{module}" for module in modules)


def statements_source() -> str:
    """Return the text of proofs/formal/Statements.v."""
    return statements_of(all_theorems().values())
