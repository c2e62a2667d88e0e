"""Claims without a translation: those that hide an assumption, have no value, or take too long."""

from itertools import pairwise
from math import prod

import pytest
from sympy import (
    Abs,
    Add,
    Derivative,
    Dummy,
    E,
    I,
    Max,
    Piecewise,
    Pow,
    S,
    Symbol,
    Xor,
    cos,
    evaluate,
    floor,
    sin,
    sqrt,
    symbols,
)  # fmt: skip

from proofs.engine.claim import CitedLemma, Claim, Induction, Separation, equation, greater
from proofs.engine.derivative import Untranslatable
from proofs.engine.program import Program, chain
from proofs.engine.stored import statements
from verify.checkers.test_attacks import TRUE, examined, line, n, x, y

with evaluate(False):
    UNORDERED, NONE_AT_0 = cos(Max(x, 1 / S.Zero)), x ** (y / y)
HIDDEN, WHOLE, MANY = Symbol("q", positive=True), Symbol("n", integer=True), symbols("a:80", real=True)
SHOWN, NONE, ABOVE = Claim("shown", greater(x, 0)), equation(x, 0), greater(HIDDEN, 0)
STATE = Induction("of states", n, NONE, ((x, 0, x),))
SYMBOLS = [
    *(
        (SHOWN.but(**changes), "plain real")
        for changes in (
            {"shows": equation(Derivative(HIDDEN**2, HIDDEN), HIDDEN)},
            {"given": ABOVE},
            {"lines": Program("p", (x, HIDDEN), {y: x})},
            {"cited": CitedLemma(x <= 10, "Dekker1971", ABOVE)},
            {"ranges": {HIDDEN: (0, 1)}},
            {"shows": equation(Symbol("q", extended_real=True), 0)},
        )
    ),
    *((SHOWN.but(shows=equation(x, s)), "plain real|two symbols") for s in (Symbol("x"), Dummy("x", real=True))),
    *(
        (SHOWN.but(shows=greater(Symbol(name, real=True), 3)), "no name")
        for name in ("pi", "root_1", "cos(x)", "", "é", "x\n")
    ),
    (Separation("of another name", line(y, x + 1), y, (x, Symbol("x"))), "has no"),
    (Separation("hidden", Program("p", (x, HIDDEN), {y: x + 1}), y, HIDDEN), "plain real"),
]
"""[(a claim, why it has no statement)]: a symbol is real, nothing more, and has a name of its own."""


def endless():
    """Yield expressions that would take years: deep, shared, of many terms, digits, cases, angles, derivatives."""
    nested = doubled = x
    for _ in range(3000):
        nested = cos(nested, evaluate=False)
    for _ in range(20):
        doubled = Add(doubled, doubled, evaluate=False)
    yield from (nested, doubled, (x + y) ** 10**6, Pow(2, 10**8, evaluate=False) * x, cos(x / 10**7) + cos(x))
    yield from (sum(Max(each, 0) for each in MANY), cos(prod(each + 1 for each in MANY)), cos(99 * x) * cos(100 * x))
    yield Derivative(x * sin(x), (x, 10**5))


VALUES = [
    *((cos(angle, evaluate=False) ** 2, "polynomial") for angle in (Abs(x), I * x, E * x, 0.5 * x)),
    *((value, "no rule|compar|no value") for value in (NONE_AT_0, UNORDERED, Piecewise((x, x > 0)))),
    *((Piecewise((1, condition), (0, True)), "no condition of relations") for condition in (y, Xor(x > 0, y > 0))),
    (Pow(x, 0, evaluate=False), "exponent 0 is written 1"),
    (cos(Pow(1 / x, 0, evaluate=False), evaluate=False), "exponent 0 is written 1"),
    (Derivative(floor(x), x), "no rule differentiates"),
    (floor(x), "no rule translates"),
    *((value, None) for value in endless()),
]
"""[(an expression, why it has no statement)]: an angle is a polynomial, a derivative exists, nobody waits for it.

Of e·x and of the product of x and a symbol E the cosine would have one name.
"""
SQUARES = chain("squares", {MANY[0]: 2 * x}, *({square: root * root} for root, square in pairwise(MANY)))
ZEROS = [equation(each, 0) for each in MANY]
STATES = [
    *((SHOWN.but(shows=equation(Derivative(y * x, by), 0), lines=line(y, x + 1)), "a line defines") for by in (x, y)),
    (SHOWN.but(given=ZEROS), "more than 60"),
    (SHOWN.but(shows=equation(MANY[-1], 0), lines=SQUARES), "more than 999"),
    *(
        (STATE.but(**changes), why)
        for why, changes in (
            ("in an angle", {"shows": equation(cos(x), 1)}),
            ("shows equations", {"shows": greater(1, x)}),
            ("a radical", {"shows": equation(sqrt(y), x)}),
            ("neither given nor chosen", {"shows": equation(Max(x, y), x)}),
            ("an angle that occurs", {"shows": equation(cos(n * y / 2) * cos(y), 1)}),
            ("nothing else", {"n": Symbol("n", integer=True, zero=False)}),
            ("two symbols", {"n": WHOLE, "shows": equation(cos(y * WHOLE), cos(n * y))}),
            ("twice", {"states": ((x, 1, x), (x, 0, x))}),
            ("starts from", {"states": ((x, y, x), (y, 1, y))}),
            ("what is given", {"given": greater(cos(n * y), 0)}),
        )
    ),
]
"""[(a claim, why it has no statement)]: a line's name may change with x, and a state with n."""
REFUSED = [*SYMBOLS, *((SHOWN.but(shows=equation(value, x)), why) for value, why in VALUES), *STATES]


@pytest.mark.parametrize(("claim", "why"), REFUSED)
def test_what_no_rule_translates_is_refused(claim, why):
    with pytest.raises(Untranslatable, match=why):
        statements(claim)


@pytest.mark.parametrize("claim", (SYMBOLS[0][0], STATES[0][0], STATE.but(shows=greater(1, x))))
def test_what_has_no_translation_fails_and_is_not_sampled(claim):
    examination = examined(claim, mutants=TRUE)
    assert examination.grade == "failed" and "witness" not in examination.record
