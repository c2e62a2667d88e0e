"""The operations whose rules the enclosing machine has: each is a program, which the machine carries out on bounds.

And what the kernels of elementary functions stand for.
"""

from sympy import StrictLessThan, exp, floor, log, sqrt

from proofs.engine.program import Program, chain
from proofs.formulas.elementary import product, product_error
from proofs.formulas.exponential import exponent, exponential, number, power
from proofs.formulas.half_turns import atan2pi, cospi, rint, sinpi
from proofs.formulas.symbols import real, where, x, y

left, right = real("left right")

RULES = {
    name: chain(name, {real(result): value})
    for name, result, value in (
        ("enclosed_sum", "total", x + y),
        ("enclosed_product", "product", x * y),
        ("enclosed_quotient", "quotient", x / y),
        ("enclosed_root", "root", sqrt(x)),
        ("enclosed_floor", "below", floor(x)),
        ("enclosed_nearest", "nearest", rint(x)),
        ("enclosed_sine", "sine", sinpi(x * y)),
        ("enclosed_cosine", "cosine", cospi(x * y)),
        ("enclosed_angle", "angle", atan2pi(y, x)),
        ("enclosed_exponential", "exponential", exp(x)),
        ("enclosed_logarithm", "logarithm", log(x)),
        ("enclosed_selection", "chosen", where(StrictLessThan(left, right), x, y)),
    )
}

STANDS_FOR = {
    "sinpi": RULES["enclosed_sine"],
    "cospi": RULES["enclosed_cosine"],
    "angle": RULES["enclosed_angle"],
    "exp": Program("exponential_of_sum", (product, product_error), {exponential: exp(product + product_error)}),
    "log": RULES["enclosed_logarithm"],
    "power": Program("raised", (number, exponent), {power: number**exponent}),
}
"""{kernel: what it stands for}, as a program of the name that Coq has for what the kernel carries out"""
