"""Angles as sums of whole multiples of atoms, so that the addition formulas apply. Trusted, like
`proofs.engine.statement`."""

from collections.abc import Iterable
from math import lcm

from sympy import Expr, cos, expand_mul, pi, sin

from proofs.formulas.half_turns import ordinary

Part = tuple[tuple[Expr, Expr] | None, Expr | None, int]


class Untranslatable(ValueError):
    """The claim has a part that no rule translates."""


class Angles:
    """The atoms of all the angles of some expressions: an atom is divided by the denominators that occur with it."""

    def __init__(self, expressions: Iterable[Expr]):
        self.denominators: dict[Expr, int] = {}
        for expression in expressions:
            for e in ordinary(expression).atoms(sin, cos):
                for term in expand_mul(e.args[0]).as_ordered_terms():
                    multiple, atom = term.as_coeff_Mul()
                    self.denominators[atom] = lcm(self.denominators.get(atom, 1), int(multiple.q))

    def parts(self, angle: Expr) -> list[Part]:
        """Return [(None, atom, whole multiple)] of an angle; a number has ((cos, sin), None, 1) instead."""
        found: list[Part] = []
        for term in sorted(expand_mul(angle).as_ordered_terms(), key=str):
            multiple, atom = term.as_coeff_Mul()
            if atom is pi or term == 0:
                number = cos(term), sin(term)
                if number[0].has(cos) or number[1].has(sin):
                    raise Untranslatable(f"no closed form of cos({term})")
                found.append((number, None, 1))
            else:
                denominator = self.denominators[atom]
                found.append((None, atom / denominator, int(multiple * denominator)))
        return found
