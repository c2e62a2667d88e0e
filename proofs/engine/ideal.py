"""Cofactors of a polynomial in an ideal: p = Σ q_i g_i, by a Gröbner basis that records its own cofactors.

Nothing here is trusted: the kernel multiplies every answer out.
"""

from collections.abc import Mapping, Sequence
from itertools import combinations

from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, ring

from proofs.engine.kernel import Polynomial

MAX_PAIRS, MAX_TERMS = 400, 300


class Ideal:
    """The ideal of equations g_i = 0 in named variables, the latest name the largest, with cofactors."""

    def __init__(self, names: Sequence[str], equations: Mapping[int, Polynomial]):
        """Compute the basis of equations, {index: kernel polynomial}: incomplete beyond MAX_PAIRS and MAX_TERMS."""
        self.names = list(reversed(names))
        self.ring, *_ = ring(self.names, QQ, lex)
        equations = {i: g for i, p in equations.items() if (g := self.element(p))}
        self.basis = []
        for i, g in equations.items():
            if self.divide(g)[0]:  # a conclusion that is already in the ideal adds nothing
                self.basis.append((g, {i: self.ring.one}))
        self._buchberger()

    def element(self, p: Polynomial) -> PolyElement:
        """Return a kernel polynomial as an element of the ring."""
        exponents = ((tuple(map(monomial.count, self.names)), c) for monomial, c in p.items())
        return self.ring.from_dict({powers: QQ(c.numerator, c.denominator) for powers, c in exponents})

    def data(self, element: PolyElement) -> dict[str, str]:
        """Return an element as {"x^2 y": "-3/2"}."""
        result = {}
        for exponents, c in element.terms():
            factors = sorted(n if e == 1 else f"{n}^{e}" for n, e in zip(self.names, exponents, strict=True) if e)
            result[" ".join(factors)] = str(c)
        return dict(sorted(result.items()))

    def divide(self, p: PolyElement) -> tuple[PolyElement, dict[int, PolyElement]]:
        """Return (remainder, cofactors {index: element}) of p by the basis."""
        cofactors: dict[int, PolyElement] = {}
        if not self.basis or not p:
            return p, cofactors
        quotients, remainder = p.div([g for g, _ in self.basis])
        for quotient, (_, origin) in zip(quotients, self.basis, strict=True):
            if quotient:
                _accumulate(cofactors, origin, quotient)
        return remainder, cofactors

    def _buchberger(self):
        done, pairs = 0, self._overlapping(combinations(range(len(self.basis)), 2))
        while pairs:
            pairs.sort(key=lambda pair: (sum(self._lcm(*pair)), pair), reverse=True)
            i, j = pairs.pop()
            (f, f_origin), (g, g_origin) = self.basis[i], self.basis[j]
            both = self._lcm(i, j)
            if (done := done + 1) > MAX_PAIRS:
                return
            up = [self.ring.term_new(self.ring.monomial_ldiv(both, h.LM), 1 / h.LC) for h in (f, g)]
            s, cofactors = f * up[0] - g * up[1], {}
            _accumulate(cofactors, f_origin, up[0])
            _accumulate(cofactors, g_origin, -up[1])
            remainder, used = self.divide(s)
            if remainder:
                _accumulate(cofactors, used, -self.ring.one)
                if max(len(q) for q in (remainder, *cofactors.values())) > MAX_TERMS:
                    return
                self.basis.append((remainder, {i: q for i, q in cofactors.items() if q}))
                pairs += self._overlapping((k, len(self.basis) - 1) for k in range(len(self.basis) - 1))

    def _overlapping(self, pairs):
        """Return the pairs whose leading monomials have a name in common: of others the remainder is 0."""
        return [p for p in pairs if self._lcm(*p) != self.ring.monomial_mul(*(self.basis[i][0].LM for i in p))]

    def _lcm(self, i, j):
        return self.ring.monomial_lcm(self.basis[i][0].LM, self.basis[j][0].LM)


def _accumulate(total, cofactors, factor):
    for i, q in cofactors.items():
        total[i] = total.get(i, 0) + q * factor
