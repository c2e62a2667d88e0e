"""Angles: their cosines and sines as polynomials, by the addition formulas. This file is trusted.

An angle is a sum of whole multiples of atoms, each divided by the denominators that occur with it. An atom gives two
variables with c² + s² = 1; in an induction, where it is a multiple of n, two states.
"""

from collections.abc import Iterable, Iterator
from math import lcm, prod

from sympy import Basic, Expr, Float, Poly, Rational, S, Symbol, cos, expand_mul, pi, sin
from sympy.polys.polyerrors import BasePolynomialError

from proofs.engine.derivative import Untranslatable, small
from proofs.engine.half_turns import cospi, sinpi

COSINES, SINES = (cos, cospi), (sin, sinpi)


def angle_of(e: Expr) -> Expr:
    """Return the angle of which a cosine or a sine is taken."""
    return pi * e.args[0] if isinstance(e, sinpi | cospi) else e.args[0]


def angles_in(expressions: Iterable[Basic]) -> Iterator[Expr]:
    """Yield the angles in expressions and relations."""
    for e in expressions:
        yield from map(angle_of, e.atoms(*COSINES, *SINES))


def _written_out(e):
    """Return how many terms an expression has at most, once its products are written out."""
    parts = map(_written_out, e.args)
    if e.is_Pow and e.exp.is_Integer:
        return max(abs(int(e.exp)), next(parts) ** min(abs(int(e.exp)), 10))
    return max(prod(parts) if e.is_Mul else sum(parts), 1)


def terms_of(angle: Expr) -> list[tuple[Rational, Expr]]:
    """Return [(rational, atom)] of an angle, which has to be a polynomial over the rationals in symbols and π."""
    small(_written_out(angle))
    terms = [term.as_coeff_Mul() for term in sorted(expand_mul(angle).as_ordered_terms(), key=str)]
    try:
        for _, atom in terms:
            Poly(atom, pi, *atom.free_symbols, domain="QQ")
        rational = all(multiple.is_Rational and not atom.has(Float) for multiple, atom in terms)
    except BasePolynomialError:
        rational = False
    if not rational:
        raise Untranslatable(f"the angle {angle} is no polynomial over the rationals: it may have no value")
    return terms


def circle_of(part: Expr) -> tuple[Symbol, Symbol]:
    """Return the symbols for the cosine and the sine of an angle."""
    c, s = (Symbol(f"{name}({part})".replace(" ", ""), real=True) for name in ("cos", "sin"))
    return c, s


def denominators_of(angles: Iterable[Expr]) -> dict[Expr, int]:
    """Return {atom: its common denominator}: each angle has whole multiples of the atom divided by it."""
    found: dict[Expr, int] = {}
    for multiple, atom in (term for angle in angles for term in terms_of(angle)):
        found[atom] = lcm(found.get(atom, 1), int(multiple.q))
    return found


def parts_of(angle: Expr, denominators: dict[Expr, int]) -> Iterator[tuple[int, Expr, tuple[Expr, Expr] | None]]:
    """Yield (times, part, its cosine and sine where they are numbers of radicals) of an angle, which is their sum."""
    for multiple, atom in terms_of(angle):
        if atom is pi or multiple == 0:
            known = cos(multiple * atom), sin(multiple * atom)
            if any(value.has(cos, sin) for value in known):
                raise Untranslatable(f"no closed form of cos({multiple * atom})")
            yield 1, atom, known
        else:
            times = multiple * denominators.get(atom, S.Zero)
            small(10 * abs(times))
            if not times.is_Integer or not times:
                raise Untranslatable(f"{multiple * atom} is no whole multiple of an angle that occurs")
            yield int(times), atom / denominators[atom], None
