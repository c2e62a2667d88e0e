"""Finding cofactors: p = Σ q_i g_i, by division, by a Gröbner basis that remembers where it came from, by denominators.

Nothing here is trusted: the kernel multiplies every answer out.
"""

from itertools import combinations

from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import ring


class Ideal:
    """The ideal of equations g_i = 0 in named variables, the latest name the largest, with cofactors."""

    def __init__(self, names, equations, max_pairs=400, max_terms=300):
        """equations: {index: kernel polynomial}. Beyond the limits the basis stays incomplete (`complete` False)."""
        self.ring, *generators = ring(list(reversed(names)), QQ, lex)
        self.position = {name: i for i, name in enumerate(reversed(names))}
        self.generators = dict(zip(reversed(names), generators, strict=True)) if names else {}
        self.equations = {i: g for i, p in equations.items() if (g := self.element(p))}
        self.basis = []
        for i, g in self.equations.items():
            if self.divide(g)[0]:  # a conclusion that is already in the ideal adds nothing
                self.basis.append((g, {i: self.ring.one}))
        self.complete = self._buchberger(max_pairs, max_terms)

    def element(self, p):
        """Return a kernel polynomial as an element of the ring."""
        terms = {}
        for monomial, coefficient in p.items():
            exponents = [0] * len(self.position)
            for name in monomial:
                exponents[self.position[name]] += 1
            terms[tuple(exponents)] = QQ(coefficient.numerator, coefficient.denominator)
        return self.ring.from_dict(terms)

    def data(self, element):
        """Return an element as {"x^2 y": "-3/2"}."""
        names = [str(g) for g in self.ring.gens]
        result = {}
        for exponents, c in element.terms():
            factors = sorted(n if e == 1 else f"{n}^{e}" for n, e in zip(names, exponents, strict=True) if e)
            result[" ".join(factors)] = f"{c.numerator}" if c.denominator == 1 else f"{c.numerator}/{c.denominator}"
        return dict(sorted(result.items()))

    def divide(self, p):
        """Return (remainder, cofactors {index: element}) of p by the basis."""
        cofactors = {}
        if not self.basis or not p:
            return p, cofactors
        quotients, remainder = p.div([g for g, _ in self.basis])
        for quotient, (_, origin) in zip(quotients, self.basis, strict=True):
            if quotient:
                _accumulate(cofactors, origin, quotient)
        return remainder, cofactors

    def members(self, p, inverses=()):
        """Return the cofactors {index: element} of p, or None. `inverses`: (name, index of its equation), in order."""
        remainder, cofactors = self.divide(p)
        if not remainder:
            return cofactors
        return None if self.complete else self._clear_denominators(p, inverses)

    def _buchberger(self, max_pairs, max_terms):
        done, pairs = 0, list(combinations(range(len(self.basis)), 2))
        while pairs:
            pairs.sort(key=lambda pair: (sum(self._lcm(*pair)), pair), reverse=True)
            i, j = pairs.pop()
            (f, f_origin), (g, g_origin) = self.basis[i], self.basis[j]
            both = self._lcm(i, j)
            if both == tuple(a + b for a, b in zip(f.LM, g.LM, strict=True)):
                continue
            if (done := done + 1) > max_pairs:
                return False
            up = [self._quotient_term(both, h) for h in (f, g)]
            s, cofactors = f * up[0] - g * up[1], {}
            _accumulate(cofactors, f_origin, up[0])
            _accumulate(cofactors, g_origin, -up[1])
            remainder, used = self.divide(s)
            if remainder:
                _accumulate(cofactors, used, -self.ring.one)
                if max(len(q) for q in (remainder, *cofactors.values())) > max_terms:
                    return False
                self.basis.append((remainder, {i: q for i, q in cofactors.items() if q}))
                pairs += [(k, len(self.basis) - 1) for k in range(len(self.basis) - 1)]
        return True

    def _lcm(self, i, j):
        return tuple(map(max, self.basis[i][0].LM, self.basis[j][0].LM))

    def _quotient_term(self, monomial, g):
        return self.ring.term_new(tuple(a - b for a, b in zip(monomial, g.LM, strict=True)), 1 / g.LC)

    def _clear_denominators(self, p, inverses):
        """Multiply p by its denominators, latest first, so that no inverse is left; then divide."""
        start, scaled, cleared = p, {}, []
        numbers = {index for _, index in inverses}
        rest = [(i, g) for i, g in self.equations.items() if i not in numbers]
        for name, index in reversed(inverses):
            if rest and p:
                quotients, p = p.div([g for _, g in rest])
                for (i, _), q in zip(rest, quotients, strict=True):
                    _accumulate(scaled, {i: q}, self.ring.one)
            y = self.generators[name]
            d, k = (self.equations[index] + 1).quo(y), p.degree(y)
            if p and k > 0:
                quotient, p = self._without(p * d**k, y, d)
                scaled = {i: q * d**k for i, q in scaled.items()}
                _accumulate(scaled, {index: quotient}, self.ring.one)
                cleared.append((y, d, k, index))
        remainder, used = self.divide(p)
        if remainder:
            return None
        _accumulate(scaled, used, self.ring.one)
        # Now Π d^k · start = Σ scaled · g; multiply by Π y^k and take Π (y d)^k − 1 away, which is in the ideal.
        product = self.ring.one
        for y, _, k, _ in cleared:
            scaled = {i: q * y**k for i, q in scaled.items()}
        for y, d, k, index in cleared:
            powers = sum(((y * d) ** j for j in range(k)), self.ring.zero)
            _accumulate(scaled, {index: -start * product * powers}, self.ring.one)
            product *= (y * d) ** k
        return {i: q for i, q in scaled.items() if q}

    def _without(self, lifted, y, d):
        """Return (quotient, remainder without y) of `lifted` by y·d − 1."""
        quotient, position = self.ring.zero, self.ring.gens.index(y)
        while lifted and (k := lifted.degree(y)) > 0:
            step = self.ring.from_dict({m: c for m, c in lifted.items() if m[position] == k}).quo(y * d)
            quotient += step
            lifted -= step * (y * d - 1)
        return quotient, lifted


def _accumulate(total, cofactors, factor):
    for i, q in cofactors.items():
        total[i] = total.get(i, 0) + q * factor
