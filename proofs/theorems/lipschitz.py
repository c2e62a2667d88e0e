"""Normalising is 1-Lipschitz outside the unit ball: how far N' moves when the gradient does."""

from sympy import Rational, sqrt

from proofs.engine.claim import Claim, at_least, equation
from proofs.engine.theorem import Clause, SideCondition, Step, Theorem, variant
from proofs.formulas.bump import g, m, perturbed
from proofs.formulas.symbols import beta, cross, dot, normal, real, vector
from proofs.theorems.relations import equations

a, b = vector("a"), vector("b")
length_a, length_b, apart, turned, product = real("length_a length_b apart turned product")
_change = a / length_a - b / length_b
_outside = (
    *(equation(size**2, dot(p, p)) for size, p in ((length_a, a), (length_b, b))),
    equation(product, dot(a, b)),
    equation(apart**2, dot(a - b, a - b)),
    equation(turned**2, dot(_change, _change)),
)
_normalise = Claim(
    "normalise",
    (
        equation(length_a**2 * length_b**2 - product**2, dot(cross(a, b), cross(a, b))),
        at_least(length_a**2 * length_b**2 - product**2, 0),
        at_least(length_a * length_b - 1, 0),
        at_least(length_a * length_b - product, 0),
        at_least(length_a * length_b + product, 0),
        equation(length_a * length_b * turned**2, 2 * (length_a * length_b - product)),
        equation(apart**2, length_a**2 + length_b**2 - 2 * product),
        at_least(length_a * length_b * (apart**2 - turned**2), 0),
        at_least(apart**2, turned**2),
        at_least(apart, turned),
        at_least(4, turned**2),
        at_least(2, turned),
    ),
    (length_a >= 1, length_b >= 1, apart >= 0, *_outside),
    squares=(*cross(a, b), length_a - length_b),
)
_other_m, _other_g = vector("other_m"), vector("other_g")
_moved = Claim(
    "moved",
    (equation(dot(m - _other_m, m - _other_m), beta**2 * dot(g - _other_g, g - _other_g)),),
    equations(_other_m, normal + beta * _other_g),
    perturbed,
)


def _pair(length):
    """Return two orthogonal vectors of equal length, with what is derived from them."""
    vectors = zip((*a, *b), (length, 0, 0, 0, length, 0), strict=True)
    return (
        *vectors,
        (length_a, length),
        (length_b, length),
        (product, 0),
        (apart, length * sqrt(2)),
        (turned, sqrt(2)),
    )


theorem = Theorem(
    id="normalising_is_lipschitz",
    title="Normalising is 1-Lipschitz outside the unit ball",
    statement=(
        Clause(r"For $|a|, |b| \ge 1$: $\bigl|a/|a| - b/|b|\bigr| \le \min(|a-b|, 2)$.", (_normalise,)),
        Clause(
            r"With $M = N + \beta g$, $|M| \ge 1$: $|\Delta M| = |\beta||\Delta g|$, so "
            r"$|\Delta N'| \le \min(|\beta||\Delta g|, 2)$.",
            (_moved,),
        ),
    ),
    hypotheses=(r"$|a|, |b| \ge 1$",),
    steps=(
        Step(r"$|a/|a|-b/|b||^2 = 2 - 2\,a\cdot b/(|a||b|)$", "expansion"),
        Step(
            r"$|a-b|^2 - |a/|a|-b/|b||^2 = (|a|-|b|)^2 + 2(|a||b|-1)(|a||b|-a\cdot b)/(|a||b|) \ge 0$",
            r"$|a||b| \ge 1$, $|a||b| \ge a\cdot b$",
        ),
        Step(r"$|M| \ge 1$, $M_1-M_2 = \beta(g_1-g_2)$", "the same $N$ and $\\beta$", uses=("unit_length",)),
    ),
    mutants=(
        variant("with the constant ½", _normalise, at_least(apart, 2 * turned)),
        variant(
            "inside the unit ball too",
            _normalise,
            at_least(apart, turned),
            given=(length_a > 0, length_b > 0, apart >= 0, turned >= 0, *_outside),
            at=_pair(Rational(1, 2)),
        ),
        variant("at most 1", _normalise, at_least(1, turned)),
    ),
    side_conditions=(SideCondition(r"$|a|, |b| \ge 1$", "normalise", holds=[_pair(1)], fails=[_pair(Rational(1, 2))]),),
)
