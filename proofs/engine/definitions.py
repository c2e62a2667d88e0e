"""What a relation says beside what is given and the lines of its program. This file is trusted.

What says nothing reads 0 = 0 once the lines are put in, or is given then, turned round, multiplied by a number or
weakened. Nothing else is done to it: terms are moved, and the order of sums and products is none; nothing is
multiplied out, and no value is simplified.
"""

from collections import Counter
from collections.abc import Iterable

from sympy import Add, Basic, Expr, Mul, Symbol
from sympy.core.relational import Relational

from proofs.engine.derivative import TRUE_FOR


class Reading:
    """What expressions read once the lines are put in: parts, which have the same name where they read the same."""

    def __init__(self, lines: Iterable[tuple[Symbol, Expr]]):
        self.names: dict[tuple, Symbol] = {}
        self.factors: dict[tuple[type, Symbol], Counter] = {}
        self.parts: dict[Basic, Symbol] = {}
        self.sums: dict[Basic, Expr] = {}
        for symbol, expression in lines:
            self.parts[symbol], self.sums[symbol] = self.part(expression), self.sum(expression)

    def part(self, e: Basic) -> Symbol:
        """Return the name of what an expression reads."""
        if e in self.parts:
            return self.parts[e]
        parts, several = [*map(self.part, e.args)], Counter[Symbol]()
        key = (e.func, *parts) if parts else (e,)
        if e.func in (Add, Mul):
            for each in parts:
                several.update(self.factors.get((e.func, each), [each]))
            key = e.func, frozenset(several.items())
        name = self.parts[e] = self.names.setdefault(key, Symbol(f"part_{len(self.names)}"))
        self.factors[e.func, name] = several
        return name

    def sum(self, e: Expr) -> Expr:
        """Return an expression as a sum of multiples of parts, in which what lines say is a sum, too."""
        if e.is_Add:
            return Add(*map(self.sum, e.args))
        if e.is_Rational:
            return e
        if e.is_Mul and (numbers := [a for a in e.args if a.is_Rational]):
            others = [a for a in e.args if not a.is_Rational]
            return (Mul(*numbers) * self.sum(Mul(*others, evaluate=False))).expand()
        return self.sums.get(e, self.part(e))

    def of(self, relation: Relational) -> list[tuple[Expr, set[int]]]:
        """Return (left − right, the signs for which the relation holds), of parts and of sums."""
        return [(read(relation.lhs) - read(relation.rhs), TRUE_FOR[relation.rel_op]) for read in (self.part, self.sum)]
