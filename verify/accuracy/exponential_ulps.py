"""Certified errors of our exp, log and power, in units in the last place, as `verify.accuracy.certified_ulps` has them.

What is exact before the lines that are run, and why: in exp, n times LN2_SHORT (27 bits), and the argument less that
(Sterbenz). In log, m − node (Sterbenz), and what is short times what is short, so that a_high + quotient_rest is q but
for the rounding of `undivided` and `inverse`; and log_sum + log_sum_rest (Dekker: the first summand is 0 or the larger
one), so that only log_low and the last sum round. Power's product is exact in the same way, but for what is multiplied
by log_rest or b_low.
"""

import math
from functools import cache
from itertools import pairwise

from flint import arb, arb_series, ctx

from proofs.engine.program import Program
from proofs.formulas import exponential as e
from verify.accuracy.pieces import FIRST, PRECISION, Piece, Series, ball, lines, piece_ends, worst
from verify.evaluate import code_of
from verify.evaluate.rounding import ZERO, Rounded, between, half_a_unit, run

PIECES = 40  # of exp, on either side of 0
HALF, UNIT, SLACK = arb(0.5), arb(2) ** -53, arb(2) ** -23
REDUCED = arb(2) ** -61  # what rounding n LN2_REST, which is below 2^-9, and the error of LN2_REST itself do
DOUBLINGS = range(-5, 6)  # under others the errors of the logarithm's parts grow no faster than it does
SIZES = (*range(0, 50, 5), 50, 100, 200, 400, 708)  # of ln(base^p), the ends of power's pieces


@cache
def exponential_pieces(program: Program = e.exponential_of_sum, moved: float = 0.0) -> list[Piece]:
    """Return the Pieces of exp over the reduced argument r, |r| ≤ ln 2 / 2; moved: how far the argument may be off."""
    with ctx.workprec(PRECISION):
        code = code_of(lines(program, [*e.exponential_reduction], (e.exponential_near,)))
        polynomial = program.expand(e.exponential_near, until=(e.away, e.away_error)) - e.away_error
        series = Series(polynomial, e.away, arb_series.exp)
        end = arb.const_log2() / 2 + arb(2) ** -41  # n is that of a rounded product, without the argument's error
        ends = [end * n / PIECES for n in range(-PIECES, PIECES + 1)]
        return [_exponential_piece(code, series, moved, *ends) for ends in pairwise(ends)]


def _exponential_piece(code, series, moved, low, high):
    r = between(low, high)
    least = half_a_unit(r.abs_upper(), ZERO)  # away_error is no larger, and is added where it would be multiplied
    neglected = abs(r.exp() - 1) * least + r.exp() * (least**2 + REDUCED + moved)
    known = {"exponential_near": (low.exp(), high.exp(), series.error(r) + neglected.abs_upper())}
    scope = run(code, {"away": Rounded(r), "away_error": Rounded(arb(0, least))}, known)
    return Piece(low, high, scope["exponential_near"].ulps())


@cache
def logarithm_pieces(program: Program = e.natural_logarithm) -> list[Piece]:
    """Return the Pieces of log: mantissas at each node, under DOUBLINGS; close to 1 those above: of −q it is −log."""
    with ctx.workprec(PRECISION):
        given = [*e.logarithm_reduction, e.quotient, e.log_whole, e.log_quotient]
        code = code_of(lines(program, given, (e.log_rest,)))
        tail = program.expand(e.log_tail, until=(e.quotient,))
        series = Series(tail, e.quotient, lambda q: ((1 + q) / (1 - q)).log() - 2 * q)
        root, pieces = arb(2).sqrt() * (1 + SLACK), []
        mantissas = (1 / root, ball(e.NODE_1_FROM), ball(e.NODE_1_BELOW), root)
        for number, ends in enumerate(pairwise(mantissas)):
            low, high = ((m - ball(e.NODES[number])) / (m + ball(e.NODES[number])) for m in ends)
            for doublings in DOUBLINGS:
                at_1 = number == 1 and doublings == 0
                quotients = piece_ends(FIRST, max(-low, high)) if at_1 else [low, high]
                pieces += [_logarithm_piece(code, series, number, doublings, *pair) for pair in pairwise(quotients)]
        return pieces


def _logarithm_piece(code, series, number, doublings, low, high):
    node, ln2, largest = ball(e.NODES[number]), arb.const_log2(), max(abs(low), abs(high))
    tail, known = [2 * (end.atanh() - end) for end in (low, high)], {}
    known["log_tail"] = (*tail, series.error(between(low, high)))
    if largest <= 2 * FIRST:
        known["quotient_squared"] = (ZERO, largest**2)
    rest = largest * (arb(2) ** -26 + 4 * UNIT)  # what a_high leaves of q
    rest_error = rest * UNIT * 5  # the sum and the division of `inverse`, `undivided` and quotient_rest
    scope = {
        "quotient": Rounded(between(low, high), rest_error, rounds=True, ends=(low, high)),
        "quotient_rest": Rounded(arb(0, rest), rest_error),
        "doublings": Rounded(doublings),
        "node_rest": Rounded(ball(e.nodes_rest[number])),
    }
    parts = run(code, scope, known)["log_rest"]
    off = abs(doublings * (ball(e.LN2_SHORT) + ball(e.LN2_REST) - ln2))
    off += abs(ball(e.nodes_short[number]) + ball(e.nodes_rest[number]) - node.log())
    least = min(abs(doublings * ln2 + node.log() + 2 * end.atanh()) for end in (low, high))
    relative = (parts.error + off + 3 * UNIT * parts.largest) / least + UNIT * SLACK
    ends = (node * (1 + end) / (1 - end) * arb(2) ** doublings for end in (low, high))
    return Piece(*ends, HALF + (relative / UNIT).upper())


@cache
def power_pieces() -> list[Piece]:
    """Return the Pieces of base^p over |ln(base^p)|: those of exp where its argument is off in proportion to itself."""
    with ctx.workprec(PRECISION):
        relative = (worst(logarithm_pieces()) - HALF) * UNIT  # of what is rounded last in log, and here is not
        off = [math.nextafter(float(relative * high), 1) for high in SIZES]
        ulps = [worst(exponential_pieces(moved=moved)) for moved in off[1:]]
        return [Piece(arb(low), arb(high), u) for (low, high), u in zip(pairwise(SIZES), ulps, strict=True)]
