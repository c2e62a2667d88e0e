"""The language of theorems, which a file of theorems imports whole: claims, relations, symbols, fields, numbers.

Such a file is data: no registration, and no program. A claim is made of relations over the lines of a program of
`proofs/`, never typed again. `oren_nayar.py` of tests/examples/light_model is short.

Symbols are real and nothing more, `real("x y")`: a sign is a hypothesis in `given`, and that m is whole is sin πm = 0.

Relations arrive as they are written: SymPy evaluates nothing here. Substitute by `xreplace`, or by `Program.at`, and
write `Derivative`, never `diff`: a rule of `proofs/engine/derivative.py` takes it, or says why there is none. A
function that makes formulas is `evaluated`. A relation that reads 0 = 0 in the end, or is given, is refused: make one
side a line of a program.

Words are claims: a statement may be {text: the claims that say it}, or what Coq proves from a file by hand,
`coq("name digest")`: read its text, which a run prints with the digest, beside the words. Steps are {what: why}. One
claim, relation or point may stand where several may, and so may lists of them in lists.

Mutants are near misses, at least two; each has the name of a claim, changes one field of it, and has to be refused, and
to have a counterexample that is exact or enclosed in balls. Give `at=` the point that sampling is unlikely to hit: a
rational one is exact. None may say what another says. A side condition has points on it, or just past it, where the
claim `holds`, `fails` or is `undefined`. A false statement has the exact point in `refuted_at`, and the true variants
as its mutants.

A certificate that is not found names the polynomial and what is left of it. Show a lemma first (`shows` is in order),
hint the `squares` of an inequality, or find out from the samples that the claim is false. A stale one belongs to
formulas that have changed: search anew, and read the diff. Of hypotheses a point is searched for at which they hold.
"the point is not a counterexample" or a case "for 1 = 0" says that none was found: most likely they contradict
each other.

A lemma from the literature is `cited=CitedLemma(relation, source, given)`, and the grade says so. `given` are the
source's conditions; the claim has to prove them, samples test the lemma under these alone, and Coq has to prove the
claim without it. Coq alone proves what float64 loses of a printed program, a `Rounded` claim in the theorem's
`rounded=`. Where its tactic `claim` is not enough for a claim, `proofs/formal/Hits.v` shows what is.
"""

from collections.abc import Sequence

from sympy import Abs, Basic, Derivative, Expr, Max, Mul, Or, Pow, Rational, S, Symbol, cos, pi, sign, sin, sqrt

from proofs.engine.claim import (
    CitedLemma,
    Claim,
    Encloses,
    Induction,
    Rounded,
    Separation,
    at_least,
    equation,
    greater,
    number,
)
from proofs.engine.program import Program, Some, chain, evaluated, flat
from proofs.engine.theorem import SideCondition, Theorem, coq, variant
from proofs.engine.vectors import Vector, cross, dot, real, squared, vector, vectors, where
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import *
from proofs.theorems.cited import cosine_above, sine_above, sine_below, sine_inside_half_turn, sine_of_half_turn

sine, ridges, rings = (HEIGHT_FIELDS[name] for name in ("sine", "ridges", "rings"))
SIDES = ("above", 1), ("below", -1)  # of a crease of an absolute value: the sign of its argument
HALF, QUARTER = Rational(1, 2), Rational(1, 4)
lengths_of_a = (eye > 0, radius > 0, eye > radius)  # the hypotheses on the spheres' lengths
lengths_of_b = (eye > 0, ball_radius > 0)


def equations(left: Sequence[Expr], right: Sequence[Expr]) -> tuple[Basic, ...]:
    """Return the equations of two vectors."""
    return tuple(equation(a, b) for a, b in zip(left, right, strict=True))


def positive(*expressions: Some) -> tuple[Basic, ...]:
    """Return that each is > 0."""
    return tuple(greater(e, 0) for e in flat(expressions))


def nonnegative(*expressions: Some) -> tuple[Basic, ...]:
    """Return that each is ≥ 0."""
    return tuple(at_least(e, 0) for e in flat(expressions))


def zero(*expressions: Some) -> tuple[Basic, ...]:
    """Return that each is 0."""
    return tuple(equation(e, 0) for e in flat(expressions))


def negated(claim: Claim) -> Basic:
    """Return the first equation that a claim shows, its left side with the other sign."""
    return equation(-claim.shows[0].lhs, claim.shows[0].rhs)


def both_ways(bound: Expr, *quantities: Expr) -> tuple[Basic, ...]:
    """Return −bound ≤ quantity ≤ bound of each quantity."""
    return nonnegative([(bound - quantity, bound + quantity) for quantity in quantities])


@evaluated
def named(function: Expr) -> Symbol:
    """Return the name that the translation gives to a cosine or a sine, for hints about squares."""
    return Symbol(str(function.doit()).replace(" ", ""), real=True)


def without(factor: Expr, product: Expr) -> Expr:
    """Return a product without one of its factors: without π, which is no coordinate of a point, say.

    Raises ValueError where it has no such factor.
    """

    def factors(e):
        return [f for part in e.args for f in factors(part)] if e.is_Mul else [e]

    rest = factors(product)
    rest.remove(factor)
    return Mul(*rest)
