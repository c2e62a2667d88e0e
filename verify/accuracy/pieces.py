"""What the certificates of our elementary functions share: pieces of a range, and polynomials against series."""

from collections.abc import Callable, Collection, Iterable
from typing import NamedTuple

from flint import arb, arb_poly, arb_series, ctx, fmpq
from sympy import Expr, Poly, Rational, Symbol

from proofs.engine.program import Program, chain
from verify.evaluate.rounding import unit_in_the_last_place

PRECISION, TERMS = 160, 40
SMALLEST = -12  # binary exponent below which the lines only scale
FIRST = arb(2) ** (SMALLEST - 1)  # where the piece begins that stands for all below it
PIECES = 40  # a binade


class Piece(NamedTuple):
    """On `low` ≤ argument ≤ `high` the result is off by at most `ulps` (arb) units in its last place."""

    low: arb
    high: arb
    ulps: arb


def ball(rational: Expr) -> arb:
    """Return an exact rational as a ball."""
    return arb(fmpq(int(rational.p), int(rational.q)))


def lines(program: Program, after: Collection[Symbol], until: tuple[Symbol, ...]) -> Program:
    """Return the program's lines that do not stand in `after`, up to those that `until` need."""
    return chain(program.name, {s: x for s, x in program.definitions if s not in after}).keep(*until)


def piece_ends(first: arb, last: arb, cuts: Iterable[arb] = ()) -> list[arb]:
    """Return the ends of pieces from `first` to `last`: PIECES to each binade, evenly, and at the cuts between."""
    ends, low = list(cuts), FIRST
    while low < last:
        ends += [low * (PIECES + i) / PIECES for i in range(PIECES)]
        low *= 2
    return [arb(first), *sorted(end for end in ends if first < end < last), arb(last)]


class Series:
    """A polynomial of one variable against the Taylor series of what it stands for, a function of an arb_series."""

    def __init__(self, expression: Expr, variable: Symbol, function: Callable[[arb_series], arb_series]):
        ctx.cap = TERMS + 2
        taylor = function(arb_series([0, 1]))
        own = [ball(c) for c in reversed(Poly(expression, variable).all_coeffs())]
        self.difference = arb_poly(own) - arb_poly([taylor[n] for n in range(TERMS)])
        self.left_out = [abs(taylor[n]) for n in (TERMS, TERMS + 1)]  # those that follow halve at least

    def error(self, argument: arb) -> arb:
        """Return an upper bound of |polynomial − function| over a ball."""
        tail = sum(c * argument.abs_upper() ** (TERMS + n) for n, c in enumerate(self.left_out))
        return self.difference(argument).abs_upper() + 2 * tail


def worst(pieces: Iterable[Piece]) -> arb:
    """Return the largest certified error of the pieces, in ulps (arb)."""
    return max(piece.ulps for piece in pieces)


def off_by(program: Program, line: Symbol, coefficient: Expr, ulps: int) -> Program:
    """Return the program with a constant of a line off by so many units in its last place: a false variant."""
    off = coefficient + ulps * Rational(float(unit_in_the_last_place(ball(abs(coefficient)))))
    changed = {s: x.xreplace({coefficient: off}) if s == line else x for s, x in program.definitions}
    return Program(program.name, program.inputs, changed, program.outputs)
