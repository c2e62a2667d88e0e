"""Expressions and relations over numbers of 50 digits, or over balls: what the second witness evaluates."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import mpmath
from sympy import And, Basic, Derivative, Expr, Mul, Symbol, evaluate, prod, sympify

from verify.evaluate import DIGITS, MPMATH, Evaluator, code_of, compare

Lines = Sequence[tuple[Symbol, Expr]]
WORKING_DIGITS = DIGITS + 15
TOLERANCE, ROUNDING = mpmath.mpf(10) ** -40, mpmath.mpf(10) ** -58


class Undefined(ArithmeticError):
    """A division by zero, the root of a negative number, an infinity; or balls that leave a comparison open."""


def decided(left: Any, relation: str, right: Any) -> bool:
    """Return whether a relation holds; raise Undefined where balls do not decide it."""
    holds = compare(left, relation, right)
    if holds is None:
        raise Undefined(f"{left} {relation} {right} is open")
    return holds


def _real(number):
    number = +mpmath.mpmathify(number)
    if not isinstance(number, mpmath.mpf) or not mpmath.isfinite(number):
        raise Undefined("complex or infinite")
    return number


def _step(x, *_):
    return mpmath.mpf(x > 0) if x else mpmath.nan


NUMBERS = MPMATH | {"compare": decided, "real": _real, "Heaviside": _step, "DiracDelta": lambda x, *_: 0 * _step(x)}
"""Functions that the code calls, at mpmath's working precision, where every comparison has to be decided."""


def differentiated(expression: Basic) -> Basic:
    """Return an expression with its derivatives taken by SymPy, independently of the translation's rules.

    Nothing else is evaluated, but products of numbers, such as −1 · 0: left as it stands, SymPy may take one for no
    integer.
    """
    expression = sympify(expression)
    taken = {part: _without_products_of_numbers(part).doit() for part in expression.atoms(Derivative)}
    with evaluate(False):
        return expression.xreplace(taken)


def _without_products_of_numbers(expression):
    numbers = {m: prod(m.args) for m in expression.atoms(Mul) if all(a.is_Rational for a in m.args)}
    with evaluate(False):
        return expression.xreplace(numbers)


class Code(Evaluator):
    """Expressions over some values, and over definitions in terms of these: printed once, for numbers and for balls."""

    def __init__(self, expressions: Sequence[Basic], definitions: Lines = ()):
        self.code = code_of((*definitions, *enumerate(map(differentiated, expressions))))
        self.results = [str(number) for number in range(len(expressions))]

    def __call__(self, values: Mapping, names: Mapping = NUMBERS) -> list:
        """Return the expressions' real values at {symbol: value}, or raise Undefined."""
        try:
            computed = self.run({str(s): v for s, v in values.items()}, names)
            return [names["real"](computed[number]) for number in self.results]
        except (ZeroDivisionError, ValueError, TypeError, NameError) as error:
            raise Undefined(str(error)) from None


def parts_of(relations: Iterable[Basic]) -> list[Basic]:
    """Return the relations that conjunctions are made of, without those that are true."""
    flat = [part for r in relations for part in (r.args if isinstance(r, And) else (r,))]
    return [part for part in flat if part != True]  # noqa: E712  (SymPy's true is not Python's)


class Relations:
    """Relations over inputs and definitions, as code: call it with values to learn whether all hold, to 40 digits.

    Hypotheses are compared to seven digits fewer than are worked with, and at least to 58.
    slack: by how much, relatively, an inequality may fail; 0 for hypotheses.
    """

    def __init__(self, relations: Iterable[Basic], definitions: Lines = (), slack: mpmath.mpf = TOLERANCE):
        self.slack = slack
        pairs = [(r.lhs, r.rel_op, r.rhs) if r != False else (0, "==", 1) for r in parts_of(relations)]  # noqa: E712
        self.code = Code([side for left, _, right in pairs for side in (left, right)], definitions)
        self.operators = [relation for _, relation, _ in pairs]

    def __call__(self, values: Mapping) -> bool:
        sides = self.code(values)
        return all(map(self._holds, self.operators, sides[::2], sides[1::2]))

    def _holds(self, relation, left, right):
        size = 1 + abs(left) + abs(right)
        if relation in ("==", "!="):
            rounding = min(ROUNDING, mpmath.mpf(10) ** (7 - mpmath.mp.dps))
            return (abs(left - right) <= max(self.slack, rounding) * size) == (relation == "==")
        if relation in ("<=", ">="):
            right += (self.slack if relation == "<=" else -self.slack) * size
        return decided(left, relation, right)
