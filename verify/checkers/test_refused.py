"""Claims that have no translation: of what hides an assumption, has no value, or takes too long, nothing is stated."""

from itertools import pairwise
from math import prod

import pytest
from sympy import (
    Abs,
    Add,
    And,
    Contains,
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
from proofs.engine.theorem import all_theorems
from verify.checkers.test_attacks import TRUE, examined, line, n, x, y

HIDDEN = ["nonnegative", "nonzero", "extended_real", "positive"]
TAKEN = ["pi", "root_1", "inverse_12", "cos(x)", "", "2x", "é", "x\n"]
with evaluate(False):
    INFINITE, UNORDERED, NONE_AT_0 = x * (1 / S.Zero), cos(Max(x, 1 / S.Zero)), x ** (y / y)


THEOREMS = {"unit_length": all_theorems()["unit_length"]}
LENT = next(claim for claim in THEOREMS["unit_length"].claims if claim.given)


def of_symbols():
    """Yield (a claim, why it has no statement): a symbol is real, nothing more, and has a name of its own."""
    for hidden in (Symbol("q", **{assumption: True}) for assumption in HIDDEN):
        yield Claim("defined", equation(Abs(hidden), x - 5), (), line(hidden, x - 5)), "plain real"
    above, bound = greater(hidden, 0), Derivative(hidden**2, hidden)
    for changes in (
        {"shows": equation(bound, bound)},
        {"given": above},
        {"lines": Program("p", (x, hidden), {y: x})},
        {"cited": CitedLemma(x <= 10, "Dekker1971", above)},
        {"ranges": {hidden: (0, 1)}},
        {"example": {hidden: 1}},
    ):
        yield Claim("somewhere", greater(x, 0)).but(**changes), "plain real"
    for other in (Symbol("x"), Dummy("x", real=True)):
        yield Claim("another x", equation(x, other)), "plain real|two symbols"
    for name in TAKEN:
        yield Claim("taken", greater(Symbol(name, real=True), 3)), "no name"
    for names in ((n, x), (y, (x, Symbol("x")))):
        yield Separation("of another name", line(y, x + 1), *names), "has no"
    yield Separation("hidden", Program("p", (x, hidden), {y: x + 1}), y, hidden), "plain real"
    yield Induction("hidden", n, equation(x, 0), ((x, 0, x),), ranges={hidden: (0, 1)}), "plain real"


def of_values():
    """Yield (a relation, why it has no statement): an angle is a polynomial, a derivative exists, nobody waits for it.

    Of e·x and of the product of x and a symbol E the cosine would have one name.
    """
    for angle in (Abs(x), I * x, E * x, 0.5 * x, INFINITE):
        yield equation(cos(angle, evaluate=False) ** 2 + sin(x) ** 2, 1), "polynomial"
    for value in (NONE_AT_0, UNORDERED, Piecewise((x, x > 0))):
        yield equation(value, x), "no rule|compar|no value"
    for condition in (y, Contains(x, S.Integers), Xor(x > 0, y > 0)):
        yield equation(Piecewise((1, condition), (0, True)), 0), "no condition of relations"
    for zeroth in (Pow(x, 0, evaluate=False), cos(Pow(1 / x, 0, evaluate=False), evaluate=False)):
        yield equation(zeroth, 1), "exponent 0 is written 1"
    yield equation(Derivative(floor(x), x), 0), "no rule differentiates"
    yield equation(floor(x), 0), "no rule translates"
    nested, many = x, symbols("a:40", real=True)
    for _ in range(3000):
        nested = cos(nested, evaluate=False)
    long = (x + y) ** 10**6, cos(x / 10**7) + cos(x), Pow(2, 10**8, evaluate=False) * x
    sums = sum(Max(each, 0) for each in many), Abs(prod(x + each for each in many))
    wide = Piecewise((1, And(*(x > bound for bound in range(999)), evaluate=False)), (0, True), evaluate=False)
    angles = cos(prod(each + 1 for each in many)), cos(99 * x) * cos(100 * x)
    derivatives = (Derivative(x * sin(x), (x, 10**5)), Derivative(prod(cos(x * each) for each in many), (x, 3)))
    squared = doubled = x
    for _ in range(60):
        squared = Pow(squared, 2, evaluate=False)
    for _ in range(20):
        doubled = Add(doubled, doubled, evaluate=False)
    for endless in (nested, squared, doubled, wide, *long, *sums, *angles, *derivatives):
        yield equation(endless, 0), None


def of_states():
    """Yield (a claim, why it has no statement): a line's name may change with x, and a state with n."""
    for by in (x, y):
        yield Claim("of a line", equation(Derivative(y * x, by), 0), (), line(y, x + 1)), "a line defines"
    none, many = equation(x, 0), symbols("a:80", real=True)
    for shown, given in (
        (none, zeros := [equation(each, 0) for each in many]),
        (equation(sum(map(sqrt, many)), 0), ()),
    ):
        yield Claim("of many", shown, given), "more than 60"
    powers = chain("squares", {many[0]: 2 * x}, *({square: root * root} for root, square in pairwise(many)))
    yield Claim("of powers", equation(many[-1], 0), (), powers), "more than 999"
    yield Induction("of many", n, zeros), "more than 60"
    state = Induction("of states", n, none, ((x, 0, x),))
    for why, shown in (
        ("in an angle", equation(cos(x), 1)),
        ("shows equations", greater(1, x)),
        ("a radical", equation(sqrt(y), x)),
        ("neither given nor chosen", equation(Max(x, y), x)),
        ("an angle that occurs", equation(cos(n * y / 2) * cos(y), 1)),
    ):
        yield state.but(shows=shown), why
    yield state.but(n=Symbol("n", integer=True, zero=False)), "nothing else"
    whole = Symbol("n", integer=True)
    for why, changes in (
        ("two symbols", {"n": whole, "shows": equation(cos(y * whole), cos(n * y))}),
        ("no name", {"n": Symbol("pi", integer=True)}),
        ("twice", {"states": ((x, 1, x), (x, 0, x))}),
        ("starts from", {"states": ((x, y, x), (y, 1, y))}),
        ("what is given", {"given": greater(cos(n * y), 0)}),
    ):
        yield state.but(**changes), why
    for id, name, why in (
        ("nowhere", "length", "it borrows from nowhere/length, which is no claim"),
        ("unit_length", "nothing", "it borrows from unit_length/nothing, which is no claim"),
        ("unit_length", LENT.name, "not all given"),
    ):
        yield Claim("borrower", greater(1, x), borrowed=((id, name),)), why


REFUSED = [*of_symbols(), *((Claim("value", shown), why) for shown, why in of_values()), *of_states()]


@pytest.mark.parametrize(("claim", "why"), REFUSED)
def test_what_no_rule_translates_is_refused(claim, why):
    with pytest.raises(Untranslatable, match=why):
        statements(claim, THEOREMS)


def test_what_has_no_translation_fails_and_is_not_sampled():
    for claim in (claim for claim, _ in REFUSED if not isinstance(claim, Separation)):
        assert examined(claim, mutants=TRUE).grade == "failed"
