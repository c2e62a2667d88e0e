"""From a claim to a certificate: what is proved, what is not, and what no rule translates."""

import pytest
from sympy import Max, Piecewise, Symbol, cos, oo, sin, sqrt, symbols

from proofs.engine.certificate import prove
from proofs.engine.claim import Claim, Induction, Separation, equation
from proofs.engine.derivative import Untranslatable
from proofs.engine.program import Program
from proofs.engine.search import search
from proofs.engine.statement import cases_of
from proofs.engine.stored import NotFound, statements
from verify.checkers import witness
from verify.checkers.counterexamples import path_to_avoided
from verify.checkers.proof_checker import why_rejected

x, y, z, re, im = symbols("x y z re im", real=True)
n = Symbol("n", integer=True)
POWER = Induction(
    "(cos x + i sin x)^n",
    n,
    (equation(re, cos(n * x)), equation(im, sin(n * x))),
    ((re, 1, re * cos(x) - im * sin(x)), (im, 0, re * sin(x) + im * cos(x))),
)

TRUE = [
    Claim("square", (x**2 - 2 * x * y + y**2 >= 0,), squares=(x - y,)),
    Claim("root", (equation(sqrt(x**2), x),), (x >= 0,)),
    Claim("sum of angles", (equation(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),)),
    Claim("thrice", (equation(cos(3 * x), 4 * cos(x) ** 3 - 3 * cos(x)),)),
    Claim("half", (equation(cos(x), 2 * cos(x / 2) ** 2 - 1),)),
    Claim("cases", (Max(x, y) >= x, abs(x) >= x)),
    Claim("piecewise", (Piecewise((x, x > 0), (-x, True)) >= 0,)),
    Claim("product", (x * y > 0,), (x > 0, y > 0)),
    Claim("transitive", (x < z,), (x < y, y < z)),
    POWER,
]
FALSE = [
    Claim("square", (x**2 - 3 * x * y + y**2 >= 0,), squares=(x - y,)),
    Claim("root of anything", (sqrt(x) >= 0,)),
    Claim("sum of angles", (equation(sin(x + y), sin(x) * cos(y) - cos(x) * sin(y)),)),
    Claim("product", (x * y > 0,), (x > 0, y >= 0)),
    POWER.but(shows=(equation(re, cos(n * x)), equation(im, -sin(n * x)))),
]


@pytest.mark.parametrize("claim", TRUE, ids=lambda c: c.name)
def test_true_claims_are_proved(claim):
    for statement, certificate, _ in prove(claim, {}):
        assert why_rejected(statement, certificate) is None
    assert witness.sample(claim, "true", 40).failures == []


@pytest.mark.parametrize("claim", FALSE, ids=lambda c: c.name)
def test_false_claims_are_not_proved_and_have_counterexamples(claim):
    with pytest.raises(NotFound):
        prove(claim, {})
    seen = witness.sample(claim, "false", 400)
    assert seen.failures or seen.undefined


@pytest.mark.parametrize("expression", [Symbol("n") ** x, sin(sin(x)) / 2**y, Piecewise((x, x > 0), (oo, True))])
def test_what_no_rule_translates_is_an_error(expression):
    with pytest.raises(Untranslatable):
        cases_of(Claim("untranslatable", (equation(expression, 0),)))


def test_separation_follows_the_program():
    program = Program("p", (x,), ((y, x + 1), (z, 2 * y)), (z,))
    apart = Separation("apart", program, (y,), (z,))
    assert search(*statements(apart, {}))["reached"] == ["x", "y"]
    assert path_to_avoided(apart.but(outputs=(z,), avoid=(x,))) == ["z", "y", "x"]
