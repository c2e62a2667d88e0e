"""What a relation says beside what is given and the lines of its program. This file is trusted.

What says nothing reads 0 = 0 once the lines are put in, or is given then. Terms are moved, and the order of sums and
products is none; nothing is multiplied out, no quotient cancels, and no value is simplified but 0: a product, a power
or a root of terms that cancel.
"""

from collections import Counter
from collections.abc import Iterable

from sympy import Abs, Add, Basic, Expr, Mul, Pow, S, Symbol
from sympy.core.operations import LatticeOp
from sympy.core.relational import Relational

from proofs.engine.derivative import TRUE_FOR


class Reading:
    """What expressions read once the lines are put in: sums of parts, which have one name where they read the same."""

    def __init__(self, lines: Iterable[tuple[Symbol, Expr]]):
        self.names: dict[tuple, Symbol] = {}
        self.sums: dict[Basic, Expr] = {}
        self.factors: dict[Basic, Counter[Expr]] = {}
        for symbol, expression in lines:
            self.sums[symbol], self.factors[symbol] = self.sum(expression), self._factors(expression)

    def of(self, relation: Relational) -> tuple[Expr, set[int]]:
        """Return (left − right, the signs for which the relation holds)."""
        return self.sum(relation.lhs) - self.sum(relation.rhs), TRUE_FOR[relation.rel_op]

    def sum(self, e: Basic) -> Expr:
        """Return an expression as a sum of rational multiples of parts."""
        if e not in self.sums:
            self.sums[e] = e if e.is_Rational else self._sum(e, *map(self.sum, e.args))
        return self.sums[e]

    def _sum(self, e, *read):
        if e.is_Add:
            return Add(*read)
        if (e.is_Mul and not all(e.args)) or (isinstance(e, Pow | Abs) and read[0] == 0):
            return S.Zero
        if e.is_Mul:
            return self._product(e.args)
        return self._part(e.func, frozenset(read) if isinstance(e, LatticeOp) else read or e)

    def _product(self, of):
        """Return a product, without the numbers among its factors, but with the signs of products among them."""
        number, factors = S.One, Counter[Expr]()
        for a in of:
            for factor, times in self._factors(a).items():
                if factor.is_Rational and (factor >= 0 or not a.is_Mul):
                    number *= factor**times
                else:
                    factors[factor] += times
        if factors.total() < 2:
            return (number * Mul(*factors)).expand()
        return number * self._part(frozenset(factors.items()))

    def _factors(self, e):
        """Return the factors of a product. That terms cancel is read, and that a number is 0 is left to the kernel."""
        if e not in self.factors:
            each = [self._part(e) if e == 0 else self.sum(e)]
            self.factors[e] = sum(map(self._factors, e.args), Counter()) if e.is_Mul else Counter(each)
        return self.factors[e]

    def _part(self, *key):
        return self.names.setdefault(key, Symbol(f"part {len(self.names)}"))  # no name of a claim's
