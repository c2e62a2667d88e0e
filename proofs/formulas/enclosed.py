"""The operations whose rules the enclosing machine has: each is a program, which the machine carries out on bounds."""

from sympy import StrictLessThan, floor, sqrt

from proofs.engine.program import Program
from proofs.formulas.half_turns import rint
from proofs.formulas.registry import by_name
from proofs.formulas.symbols import real, where, x, y

total, product, quotient, root, chosen, left, right = real("total product quotient root chosen left right")
below, nearest = real("below nearest")

RULES = by_name((
    Program("enclosed_sum", (x, y), {total: x + y}),
    Program("enclosed_product", (x, y), {product: x * y}),
    Program("enclosed_quotient", (x, y), {quotient: x / y}),
    Program("enclosed_root", (x,), {root: sqrt(x)}),
    Program("enclosed_floor", (x,), {below: floor(x)}),
    Program("enclosed_nearest", (x,), {nearest: rint(x)}),
    Program(
        "enclosed_selection",
        (left, right, x, y),
        {chosen: where(StrictLessThan(left, right), x, y)},
    ),
))  # fmt: skip
