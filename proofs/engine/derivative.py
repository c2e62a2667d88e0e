"""The derivative of an expression by rules, each with the conditions under which it exists. This file is trusted."""

from collections.abc import Callable

from sympy import (
    Abs,
    Add,
    And,
    Derivative,
    Expr,
    Max,
    Min,
    Mul,
    Or,
    Piecewise,
    Pow,
    S,
    Symbol,
    cos,
    pi,
    preorder_traversal,
    sign,
    sin,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFunction

from proofs.engine.half_turns import cospi, sinpi

OUTER = {
    sin: lambda a: cos(a, evaluate=False),
    cos: lambda a: Mul(-1, sin(a, evaluate=False), evaluate=False),
    sinpi: lambda a: Mul(pi, cospi(a, evaluate=False), evaluate=False),
    cospi: lambda a: Mul(-1, pi, sinpi(a, evaluate=False), evaluate=False),
}
TRUE_FOR = {"==": {0}, "!=": {-1, 1}, ">": {1}, ">=": {0, 1}, "<": {-1}, "<=": {-1, 0}}  # signs of left − right
HIGHEST = 3  # derivative of a derivative of …
LARGEST = 999  # powers, ten times multiples of an angle or cases, terms of a product: the kernel's powers go as far
MOST_STEPS = 60  # hypotheses, lines, roots, quotients and conclusions of a claim, or an induction's parts


class NotFound(ValueError):
    """The error that no certificate and no counterexample was found: of which statement, and what is left of it."""


class Untranslatable(NotFound):
    """The error that no rule translates a part of the claim, so there is no statement to prove."""


def small(number: float) -> None:
    """Refuse a number of terms, powers or cases that would take more than seconds to write out."""
    if number > LARGEST:
        raise Untranslatable(f"terms, powers, cases or levels come to {number}, more than {LARGEST}")


def few(steps: int) -> None:
    """Refuse a claim with which a search would take more than seconds."""
    if steps > MOST_STEPS:
        raise Untranslatable(f"hypotheses, lines, roots, quotients and conclusions are more than {MOST_STEPS}")


def derivative(e: Expr, x: Symbol, side: Callable[[Expr], int]) -> Expr:
    """Return ∂e/∂x as it stands, wherever e has a value; raise Untranslatable where no rule differentiates e.

    side(f) returns the sign of f and makes an obligation of f ≠ 0: at f = 0 |f| has a corner, and √f no slope. Near a
    point where f ≠ 0 it keeps its sign, as it is differentiable.
    """

    def by_x(part: Expr) -> Expr:
        return derivative(part, x, side)

    def beside(part: Expr) -> int:  # 0 times its derivative, so that this has to exist, too
        return side(Add(part, Mul(0, by_x(part), evaluate=False), evaluate=False))

    match e:
        case _ if not e.has(x):
            return S.Zero
        case Symbol():
            return S.One
        case Add():
            return Add(*map(by_x, e.args), evaluate=False)
        case Mul():
            products = (Mul(*e.args[:i], by_x(a), *e.args[i + 1 :], evaluate=False) for i, a in enumerate(e.args))
            return Add(*products, evaluate=False)
        case Pow(base=base, exp=exponent) if exponent.is_Rational and (2 * exponent).is_Integer:
            if exponent.is_Integer:
                return Mul(exponent, Pow(base, exponent - 1, evaluate=exponent == 1), by_x(base), evaluate=False)
            powers = (Pow(base, power, evaluate=False) for power in (exponent - S.Half, -S.Half))  # 1/√ of 0 is refused
            return Mul(exponent, *powers, by_x(base), evaluate=False)
        case sin() | cos() | sinpi() | cospi():
            return Mul(OUTER[e.func](e.args[0]), by_x(e.args[0]), evaluate=False)
        case Abs() | sign():
            return Mul(beside(e.args[0]), by_x(e.args[0]) if isinstance(e, Abs) else 0, evaluate=False)
        case Max() | Min():
            best, *others = e.args
            for other in others:
                above = beside(Add(other, Mul(-1, best, evaluate=False), evaluate=False)) > 0
                best = other if above == isinstance(e, Max) else best
            return by_x(best)
        case Piecewise():
            return by_x(branch(e, beside))
        case Derivative():
            return by_x(inner(e, side))
    raise Untranslatable(f"no rule differentiates {e}")


def inner(e: Derivative, side: Callable[[Expr], int]) -> Expr:
    """Return a Derivative's expression differentiated by each of its symbols in turn."""
    result = e.expr
    if len(e.variables) > HIGHEST:
        raise Untranslatable(f"no rule differentiates {len(e.variables)} times")
    for x in e.variables:
        result = derivative(result, x, side)
        small(sum(1 for _ in preorder_traversal(result)) // 10)
    return result


def branch(e: Piecewise, side: Callable[[Expr], int]) -> Expr:
    """Return the value that a Piecewise takes beside the edges of all conditions up to its own."""
    for value, condition in e.args:
        relations = sorted(condition.atoms(Relational), key=str)
        small(10 * len(relations))
        holding = {}
        for relation in relations:
            difference = Add(relation.lhs, Mul(-1, relation.rhs, evaluate=False), evaluate=False)
            holding[relation] = S.true if side(difference) in TRUE_FOR[relation.rel_op] else S.false
        holds = condition.xreplace(holding)
        others = [part for part in condition.atoms(BooleanFunction) if not isinstance(part, And | Or)]
        if others or holds not in (S.true, S.false):
            raise Untranslatable(f"{condition} is no condition of relations")
        if holds:
            return value
    raise Untranslatable(f"{e} has no value where none of its conditions holds")
