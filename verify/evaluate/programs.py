"""Programs of other gradients: naive, with rounded products, algebraic for given wave numbers, of higher order.

A difference is Σ wᵢ (h(u + cᵢε) − h(u − cᵢε))/2cᵢε. No wrapping, no clamping: for points clear of the chart's ends.
"""

from collections.abc import Collection

from sympy import Rational, Symbol, prod

from proofs.engine.half_turns import ordinary
from proofs.engine.program import Program, chain
from proofs.engine.vectors import real
from proofs.formulas.algebraic_form import base_of_u, base_of_v, complex_product, complex_square
from proofs.formulas.height_fields import HeightField, cos_u, cos_v, gradient, gradient_from_factors, sin_u, sin_v
from proofs.formulas.pixel import instance
from proofs.formulas.symbols import epsilon, h_u, h_v, k_u, k_v, u, v


def lines(program: Program, after: Collection[Symbol], until: tuple[Symbol, ...]) -> Program:
    """Return the program's lines that do not stand in `after`, up to those that `until` need."""
    return chain(program.name, {s: x for s, x in program.definitions if s not in after}).keep(*until)


def naive(program: Program) -> Program:
    """Return the program with the ordinary sine of a product πku, which is rounded before its sine is taken."""
    return Program("naive", program.inputs, {s: ordinary(e) for s, e in program.definitions}, program.outputs)


def rounded_product_gradient(field: HeightField) -> Program:
    """Return the gradient with the product k·u rounded first, and reduced in half-turns after that."""
    program, products = gradient(field), dict(zip((k_u * u, k_v * v), real("argument_of_u argument_of_v"), strict=True))
    lines = {s: e.xreplace(products) for s, e in program.definitions}
    return chain("rounded", {s: e for e, s in products.items()}, lines, outputs=program.outputs)


def _power(base, exponent, name):
    """Return (programs, (real, imaginary)) of base^exponent by repeated squaring; negative powers conjugate."""
    if exponent < 0:
        base, exponent = (base[0], -base[1]), -exponent
    programs, result, square = [], None, base

    def step(program, kind, *values):
        programs.append(instance(program, f"{name}_{kind}_{bit}", given={program.inputs: values}))
        return programs[-1].outputs

    for bit in range(exponent.bit_length()):
        if bit:
            square = step(complex_square, "square", *square)
        if exponent >> bit & 1:
            result = step(complex_product, "product", *result, *square) if result else square
    return programs, result if exponent else (1 + 0 * base[0], 0 * base[0])


def algebraic_gradient(field: HeightField, ku: float, kv: float) -> Program:
    """Return the program (angles of A, k_u, k_v) → h_u, h_v without a transcendental function, its powers written out.

    ValueError unless the field's wave number in u is even and that in v whole. Theorem: algebraic_gradient.
    """
    a, b = (float(w.subs({k_u: ku, k_v: kv})) for w in field.wave_numbers or ())
    if a % 2 or b % 1:
        raise ValueError(f"ku = {ku:g}, kv = {kv:g} is not allowed for {field.name}: it has no algebraic form")
    of_u, (real_u, imaginary_u) = _power(base_of_u, int(a) // 2, "u")
    of_v, (real_v, imaginary_v) = _power(base_of_v, int(b), "v")
    factors = {cos_u: real_u, sin_u: imaginary_u, cos_v: real_v, sin_v: imaginary_v}
    return chain(f"algebraic_{field.name}", *of_u, *of_v, factors, gradient_from_factors(field)).keep(h_u, h_v)


def richardson(field: HeightField) -> Program:
    """Return Richardson's extrapolation of steps ε, ε/2, ε/4, ε/8: eighth order; 16 height evaluations.

    The weight of a step cε leaves the error's terms ε², ε⁴ … out: Lagrange's at 0, in c².
    """
    lines, sums, steps = {}, {h_u: 0, h_v: 0}, [Rational(1, 2**n) for n in range(4)]
    for number, step in enumerate(steps):
        weight = prod(other**2 / (other**2 - step**2) for other in steps if other != step)
        for result, coordinate in ((h_u, u), (h_v, v)):
            above, below = (field.expression.xreplace({coordinate: coordinate + s * epsilon}) for s in (step, -step))
            apart = real(f"apart_{result}_{number}")
            lines[apart] = above - below
            sums[result] += weight * apart / (2 * step * epsilon)
    return Program(f"richardson_{field.name}", (u, v, k_u, k_v, epsilon), lines | sums, (h_u, h_v))
