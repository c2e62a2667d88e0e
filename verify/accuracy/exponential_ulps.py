"""Certified errors of our exp, log and power, in units in the last place, as `verify.accuracy.certified_ulps` has them.

What is exact before the lines that are run, and why: in exp, n times LN2_HIGH (53 bits), and the argument less that
(Sterbenz). In log, m − node (Sterbenz), and what is short times what is short; so quotient_short + quotient_rest is q
but for the rounding of `undivided` and `inverse`. log_sum + log_sum_rest is exact (Dekker: the first summand is 0 or
the larger one). Power's product is exact in the same way, but for what is multiplied by log_rest or b_low.
"""

import math
from collections.abc import Iterator
from functools import cache
from itertools import groupby, pairwise
from typing import NamedTuple

from flint import arb, ctx

from proofs.engine.program import Program
from proofs.formulas import exponential as e
from verify.accuracy.pieces import PRECISION, SMALLEST, Piece, Series, ball, lines, piece_ends, worst
from verify.evaluate import code_of
from verify.evaluate.rounding import ZERO, Rounded, between, half_a_unit, run

EXP_PIECES = 80
UNIT, SLACK = arb((1, -53)), arb((1, -41))
REDUCED = arb((1, -84))  # what rounding n LN2_LOW, which is below 2^-32, and the error of LN2_LOW itself do
DOUBLINGS = range(-1074, 1025)
SIZES = (*range(0, 50, 5), 50, 100, 200, 400, 708)  # of ln(base^p), the ends of power's pieces


@cache
def exponential_pieces(program: Program = e.exponential_of_sum, moved: float = 0.0) -> list[Piece]:
    """Return the Pieces of exp over the reduced argument r, |r| ≤ ln 2 / 2; moved: how far the argument may be off."""
    with ctx.workprec(PRECISION):
        code = code_of(lines(program, [s for s, _ in e.exponential_reduction], until=(e.exponential_near,)))
        polynomial = program.expand(e.exponential_near, until=(e.away, e.away_error)) - e.away_error
        series = Series(polynomial, e.away, lambda n: 1 / arb.fac_ui(n))
        end = arb.const_log2() / 2 + SLACK  # n is that of a rounded product, without the argument's error
        ends = [end * (2 * n - EXP_PIECES) / EXP_PIECES for n in range(EXP_PIECES + 1)]
        return [_exponential_piece(code, series, arb(moved), *ends) for ends in pairwise(ends)]


def _exponential_piece(code, series, moved, low, high):
    r = between(low, high)
    least = half_a_unit(r.abs_upper(), ZERO)  # away_error is no larger, and is added where it would be multiplied
    neglected = abs(r.exp() - 1) * least + r.exp() * (least**2 + REDUCED + moved)
    known = {e.exponential_near.name: (low.exp(), high.exp(), series.error(r) + neglected.abs_upper())}
    scope = run(code, {e.away.name: Rounded(r), e.away_error.name: Rounded(arb(0, least))}, known)
    return Piece(low, high, scope[e.exponential_near.name].ulps())


class LogPiece(NamedTuple):
    """The numbers from `low` to `high`, and those times some powers of two.

    ulps: the certified error of log; relative: that of its three parts, of which power makes its product (arb).
    """

    low: arb
    high: arb
    ulps: arb
    relative: arb


@cache
def logarithm_pieces(program: Program = e.natural_logarithm) -> list[LogPiece]:
    """Return the LogPieces of all mantissas, from √½ to √2, and exponents."""
    with ctx.workprec(PRECISION):
        return list(_Logarithm(program).pieces())


class _Logarithm:
    """The lines of log that round, with what comes before them enclosed by hand."""

    ENCLOSED = (*dict(e.logarithm_reduction), e.quotient, e.log_whole, e.log_quotient, e.log_sum, e.log_lost,
                e.log_sum_rest)  # fmt: skip

    def __init__(self, program):
        self.code = code_of(lines(program, self.ENCLOSED, until=(e.log_near,)))
        tail = program.expand(e.log_tail, until=(e.quotient,))
        self.series = Series(tail, e.quotient, lambda n: arb(2) / n if n % 2 and n > 1 else arb(0))

    def pieces(self) -> Iterator[LogPiece]:
        """Yield the LogPieces, node by node."""
        root = arb(2).sqrt() * (1 + SLACK)
        mantissas = (1 / root, ball(e.NODE_1_FROM), ball(e.NODE_1_BELOW), root)
        for number, ends in enumerate(pairwise(mantissas)):
            node = ball(e.NODES[number])
            low, high = ((m - node) / (m + node) for m in ends)
            for first, last in _runs(*ends):
                start = first * arb.const_log2() + node.log()
                for piece in self._pairs(low, high, start if first == last else None):
                    yield self._piece(number, first, last, *piece)

    @staticmethod
    def _pairs(low, high, start):
        """Return the ends of each piece of q; start: what the logarithm is at q = 0, under one exponent."""
        if start is None:
            return [(low, high)]
        if start.is_zero():
            cuts = [arb((1, -n)).tanh() for n in range(5, 2 - SMALLEST)]
            below, above = (pairwise(piece_ends(arb((1, SMALLEST - 1)), end, cuts)) for end in (-low, high))
            return [*((-far, -near) for near, far in below), *above]
        cuts = (((sign * arb((1, n)) - start) / 2).tanh() for n in range(-4, 10) for sign in (-1, 1))
        return pairwise([low, *sorted(cut for cut in cuts if low < cut < high), high])

    def _piece(self, number, first, last, low, high):
        node, doublings, ln2 = ball(e.NODES[number]), between(first, last), arb.const_log2()
        q, largest = between(low, high), max(abs(low), abs(high))
        rest = largest * (arb((1, -26)) + 4 * UNIT)  # what quotient_short leaves of q
        rest_error = rest * UNIT * 5  # the sum and the division of `inverse`, `undivided` and quotient_rest
        is_plain = number == 1 and first == last == 0
        off = doublings * (ball(e.LN2_SHORT) + ball(e.LN2_REST) - ln2)
        off = abs(off) + abs(ball(e.nodes_short[number]) + ball(e.nodes_rest[number]) - node.log())
        tail = [2 * (end.atanh() - end) for end in (low, high)]
        ends = [n * ln2 + node.log() + 2 * end.atanh() for n, end in ((first, low), (last, high))]
        known = {e.log_tail.name: (*tail, self.series.error(q)), e.log_near.name: (*ends, off.abs_upper())}
        if largest <= arb((1, SMALLEST)):
            known[e.quotient_squared.name] = (ZERO, largest**2)
        near = between(*ends) + arb(0, rest)
        scope = {
            e.quotient.name: Rounded(q, rest_error, rounds=True, ends=(low, high)),
            e.quotient_rest.name: Rounded(arb(0, rest), rest_error),
            e.doublings.name: Rounded(doublings),
            e.node_rest.name: Rounded(ball(e.nodes_rest[number])),
            e.log_sum.name: Rounded(near),
            e.log_sum_rest.name: Rounded(0 if is_plain else arb(0, half_a_unit(near.abs_upper(), ZERO))),
        }
        scope = run(self.code, scope, known)
        parts, least = scope[e.log_rest.name], min(abs(end) for end in ends)
        relative = (parts.error + off.abs_upper() + 3 * UNIT * parts.largest) / least + UNIT * arb((1, -23))
        one = arb((1, min(first, last, key=abs)))  # of the powers of two
        numbers = (node * (1 + end) / (1 - end) * one for end in (low, high))
        return LogPiece(*numbers, scope[e.log_near.name].ulps(), relative)


def _runs(low, high):
    """Return [(first, last)] of DOUBLINGS under which the logarithms of mantissas low to high are of one binade."""

    def binade(n):
        ends = [math.frexp(n * math.log(2) + math.log(float(m)))[1] for m in (low, high)]
        return ends[0] if ends[0] == ends[1] else f"{n} alone"

    groups = [list(group) for _, group in groupby(DOUBLINGS, binade)]
    return [(group[0], group[-1]) for group in groups]


@cache
def power_pieces(program: Program = e.natural_logarithm) -> list[Piece]:
    """Return the Pieces of base^p over |ln(base^p)|: those of exp where its argument is off in proportion to itself."""
    with ctx.workprec(PRECISION):
        relative = max(piece.relative for piece in logarithm_pieces(program))
        return [
            Piece(arb(low), arb(high), worst(exponential_pieces(moved=math.nextafter(float(high * relative), 1))))
            for low, high in pairwise(SIZES)
        ]
