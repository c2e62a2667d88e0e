"""The operations whose rules the enclosing machine has: each is a program, which the machine carries out on bounds."""

from sympy import StrictLessThan, exp, floor, log, sqrt

from proofs.engine.half_turns import atan2pi, cospi, rint, sinpi
from proofs.engine.program import chain
from proofs.engine.vectors import real, where
from proofs.formulas.symbols import x, y

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
        ("enclosed_power", "raised", x**y),
        ("enclosed_selection", "chosen", where(StrictLessThan(left, right), x, y)),
    )
}
