"""The text of `proofs/formal/Float64.v`: kernels' float64 operations, one after the other, as Coq definitions."""

from proofs.engine.program import Program
from proofs.formulas import bump, camera, elementary, enclosed, exponential, finite_difference, height_fields, shading
from renderer.generate.coq import HALF_TURN_POLYNOMIALS, in_module
from renderer.generate.programs import ANY_FIELD
from renderer.generate.rules import carried_out, rule

HEADER = """(* Printed from proofs/formulas by `python -m renderer.generate`. Do not edit: change the formula.
   The float64 operations of kernels, one after the other as they are carried out, each rounded. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Float.
Open Scope R_scope.
"""


def float64_module(program: Program, *variables: str) -> str:
    """Return a program's float64 operations as the text of a Coq module; variables: those beside the inputs."""
    return in_module(f"{program.name}_float64", [*variables, *carried_out(program)])


def float64_source() -> str:
    """Return the text of proofs/formal/Float64.v: the operations of kernels as they are carried out."""
    kernels = [
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
        kernels += [program(field) for program in programs_of]
    modules = [float64_module(program) for program in kernels]
    modules.append(float64_module(finite_difference.central(ANY_FIELD), "Variable height : R -> R -> R -> R -> R."))
    modules += [in_module(f"{program.name}_float64", rule(program)) for program in enclosed.RULES.values()]
    return HEADER + "".join(f"\n{module}" for module in modules)
