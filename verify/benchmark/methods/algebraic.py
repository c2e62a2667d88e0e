"""The algebraic gradient for given wave numbers as one straight-line program: the powers are written out."""

from proofs.engine.program import Program, chain
from proofs.formulas.algebraic_form import base_of_u, base_of_v, complex_product, complex_square
from proofs.formulas.height_fields import cos_u, cos_v, gradient_from_factors, sin_u, sin_v
from proofs.formulas.pixel import instance
from proofs.formulas.symbols import cos_phi, cos_theta, h_u, h_v, k_u, k_v, sin_phi, sin_theta


def _step(program, name, values):
    """Return an instance of a complex operation on the given pairs, and its result."""
    step = instance(program, name, given=dict(zip(program.inputs, values, strict=True)))
    return step, step.outputs


def _power(base, exponent, name):
    """Return (programs, (real, imaginary)) of base^exponent by repeated squaring; negative powers conjugate."""
    if exponent < 0:
        base, exponent = (base[0], -base[1]), -exponent
    programs, result, square = [], None, base
    for bit in range(exponent.bit_length()):
        if bit:
            step, square = _step(complex_square, f"{name}_square_{bit}", square)
            programs.append(step)
        if exponent >> bit & 1:
            if result is None:
                result = square
            else:
                step, result = _step(complex_product, f"{name}_product_{bit}", (*result, *square))
                programs.append(step)
    return programs, result if exponent else (1 + 0 * base[0], 0 * base[0])


def algebraic_gradient(field, ku, kv):
    """Return the program (angles of A, k_u, k_v) → h_u, h_v without a transcendental function.

    ValueError unless the field's wave number in u is even and that in v whole. Theorem: algebraic_gradient.
    """
    a, b = (float(w.subs({k_u: ku, k_v: kv})) for w in field.wave_numbers)
    if a % 2 or b % 1:
        raise ValueError(f"ku = {ku:g}, kv = {kv:g} is not allowed for {field.name}: it has no algebraic form")
    of_u, (real_u, imaginary_u) = _power(base_of_u, int(a) // 2, "u")
    of_v, (real_v, imaginary_v) = _power(base_of_v, int(b), "v")
    lines = ((cos_u, real_u), (sin_u, imaginary_u), (cos_v, real_v), (sin_v, imaginary_v))
    angles = (cos_theta, sin_theta, cos_phi, sin_phi)
    factors = Program("factors", (*angles, *(s for p in (*of_u, *of_v) for s in p.outputs)), lines, (sin_u, cos_u))
    tail = gradient_from_factors(field)
    return chain(f"algebraic_{field.name}", *of_u, *of_v, factors, tail).keep(h_u, h_v)
