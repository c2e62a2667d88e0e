"""What a statement is as data: the format that the kernel and the second checker read. This file is trusted.

Format, version 1 (JSON). A polynomial is {"x^2 y": "-3/2", "": "1"}: names (no blank, no ^), powers, exact rationals.
A statement has a `kind`. A "derivation" has `variables` (all real numbers, unless a step says more) and `steps`, each
with a polynomial `of`:

    assume   of ⋈ 0 is given; ⋈ is `is`: "=", "!=", ">", ">="
    define   `new` abbreviates `of`
    root     `new` = √of; needs a proof of `of` ≥ 0; gives new² = of and new ≥ 0
    inverse  `new` = 1/of; needs a proof of `of` ≠ 0; gives new · of = 1
    show     of ⋈ 0 has to be proved; later steps may use it

A "separation" has `lines` [[name, [names it uses]], …], `outputs`, `avoid`. An "induction" has `variables`, `state`,
`assume` (about the variables), `start` and `next` (polynomials of each state), `show` (polynomials, zero for every n).
"""

from functools import cache

from sympy import Expr, Poly, Rational, expand

VERSION = 1
TRUE_FOR = {"==": {0}, "!=": {-1, 1}, ">": {1}, ">=": {0, 1}, "<": {-1}, "<=": {-1, 0}}  # signs of left − right
RELATIONS = {frozenset(s): (f, r) for f, r, s in (
    (1, "=", {0}), (1, "!=", {-1, 1}), (1, ">", {1}), (1, ">=", {0, 1}), (-1, ">", {-1}), (-1, ">=", {-1, 0})
)}  # fmt: skip


@cache
def polynomial_data(expression: Expr) -> dict[str, str]:
    """Return a polynomial expression in symbols as {"x^2 y": "-3/2"}, sorted."""
    expression = expand(expression)
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    if not symbols:
        return {} if expression == 0 else {"": str(Rational(expression))}
    data = {}
    for monomial, coefficient in Poly(expression, *symbols, domain="QQ").terms():
        factors = (s.name if e == 1 else f"{s.name}^{e}" for s, e in zip(symbols, monomial, strict=True) if e)
        data[" ".join(factors)] = str(coefficient)
    return dict(sorted(data.items()))
