"""Relations that hold by definition, by the hypotheses and the program's lines alone. This file is trusted.

With the lines substituted, such a relation reads 0 = 0, or compares two numbers, or is a hypothesis. Reading moves
terms, disregards the order of sums and products, and takes a product, a power or a root of terms that cancel for 0. It
multiplies nothing out, cancels no quotient, and simplifies nothing else.
"""

from collections import Counter

from sympy import Abs, Add, Basic, Expr, Mul, Pow, S, Symbol
from sympy.core.operations import LatticeOp
from sympy.core.relational import Relational


class Reading:
    """Expressions with the program's lines substituted: sums of parts, of which equal ones have one name."""

    def __init__(self) -> None:
        self.sums: dict = {}
        self.factors: dict[Basic, Counter[Expr]] = {}

    def line(self, symbol: Symbol, expression: Expr) -> None:
        """Let a symbol read as the line of a program that defines it."""
        self.sums[symbol], self.factors[symbol] = self.sum(expression), self._factors(expression)

    def difference(self, relation: Relational) -> Expr:
        """Return the reading of left − right."""
        return self.sum(relation.lhs) - self.sum(relation.rhs)

    def sum(self, e: Basic) -> Expr:
        """Return an expression as a sum of rational multiples of parts."""
        if e not in self.sums:
            self.sums[e] = e if e.is_Rational else self._sum(e, *map(self.sum, e.args))
        return self.sums[e]

    def _sum(self, e, *read):
        if e.is_Add:
            return Add(*read)
        if e.is_Mul:
            return self._product(e) if all(e.args) else S.Zero
        if isinstance(e, Pow | Abs) and read[0] == 0:
            return read[0]
        return self._part(e.func, frozenset(read) if isinstance(e, LatticeOp) else read or e)

    def _product(self, e):
        """Return a product, without the numbers among its factors, but with the signs of products among them."""
        factors = self._factors(e)
        numbers = {f for a in e.args for f in self._factors(a) if f.is_Rational and (f >= 0 or not a.is_Mul)}
        number = Mul(*(f ** factors.pop(f) for f in numbers))
        part = Mul(*factors) if factors.total() < 2 else self._part(frozenset(factors.items()))
        return (number * part).expand()

    def _factors(self, e):
        """Return the factors of a product, each a sum as it is read; the number 0 is a part, left to the kernel."""
        if e.is_Mul:
            return sum(map(self._factors, e.args), Counter())
        return self.factors.get(e, Counter([self._part(e) if e == 0 else self.sum(e)]))

    def _part(self, *key):
        return self.sums.setdefault(key, Symbol(f"part {len(self.sums)}"))  # no name of a claim's
