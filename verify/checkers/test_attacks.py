"""Attacks by claims: false ones that must not be proved, true ones that must not be refuted, what has no meaning."""

import json
import sys
from math import prod
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from sympy import (
    Abs,
    Derivative,
    DiracDelta,
    Dummy,
    E,
    Heaviside,
    I,
    Max,
    Min,
    Ne,
    Piecewise,
    Pow,
    Rational,
    S,
    Symbol,
    atan2,
    cos,
    diff,
    evaluate,
    floor,
    log,
    pi,
    sign,
    sin,
    sqrt,
    symbols,
)  # fmt: skip

import proofs.theorems
from proofs import check
from proofs.check import FOLDER, reasons
from proofs.engine import certificate, kernel
from proofs.engine import stored as stored_file
from proofs.engine.certificate import prove
from proofs.engine.claim import CitedLemma, Claim, Induction, Separation, at_least, equation, greater
from proofs.engine.derivative import Untranslatable
from proofs.engine.points import without_unused
from proofs.engine.program import Program
from proofs.engine.search import search
from proofs.engine.stored import NotFound, Stale, statements, stored
from proofs.engine.theorem import Clause, Mutant, Theorem, all_theorems
from proofs.formulas.half_turns import cospi, sinpi
from proofs.theorems.cited import cosine_above, sine_above, sine_below, sine_inside_half_turn, sine_of_half_turn
from verify.checkers import witness
from verify.checkers.kernels import accepted, compact
from verify.checkers.known_bad import CERTIFICATE, STATEMENT, assume, derivation, show
from verify.checkers.proof_checker import by_definition, examine
from verify.checkers.splices import splices

x, y, n, p, w, m = symbols("x y n p w m", real=True)
a, s = symbols("a s", real=True)
FALSE = (Mutant("x > 1", Claim("a", (greater(x, 1),))), Mutant("x > 2", Claim("b", (greater(x, 2),))))
TRUE = (Mutant("x² ≥ 0", Claim("a", (greater(x**2 + 1, 0),))), Mutant("x + 1 > x", Claim("b", (greater(x + 1, x),))))
TINY = Rational(1, 10**41)


def graded(*claims, mutants=FALSE, **changes):
    """Return the grade of a theorem of these claims, everything found anew."""
    theorem = Theorem("attack", "", "", claims, mutants, **changes)
    return examine(theorem, {"attack": theorem}, anew=True).grade


def defined(symbol, expression):
    """Return a program of one line."""
    return Program("line", tuple(expression.free_symbols), ((symbol, expression),), (symbol,))


# What has no translation: no statement is made of it

HIDDEN = ["positive", "nonnegative", "negative", "integer", "rational", "zero", "nonzero", "finite", "even", "prime"]
HIDDEN += ["extended_real", "infinite"]
TAKEN = ["pi", "root_1", "inverse_12", "sum_1", "cos(x)", "sin(pi*x)", "x y", "", "x^2", "2x", "é", "_x", "x\n", "x'"]
with evaluate(False):
    INFINITE = x * (1 / S.Zero)
    UNORDERED = cos(Max(x, 1 / S.Zero))
    TO_THE_ONE = equation(x ** (y / y), x)  # no value where y = 0


def untranslatable():
    """Yield (a claim, why there is no statement of it)."""
    for assumption in HIDDEN:  # a symbol hides no fact: neither one that is defined, nor a free one
        for is_so in (True, False):
            q = Symbol("q", **{assumption: is_so})
            shows = (equation(Abs(q), x - 5), greater(q, x - 6))
            yield Claim(f"{assumption} {is_so}", shows, (), defined(q, x - 5)), "plain real"
    for number, other in enumerate((Symbol("x"), Dummy("x", real=True), Symbol("x", extended_real=True))):
        yield Claim(f"another x {number}", (equation(x, other),), (greater(x, 0),)), None
        yield Claim(f"a line of another x {number}", (greater(x, 0),), (), defined(x, other + 1)), None
    for name in TAKEN:  # by the translation, or no name
        symbol = Symbol(name, real=True)
        yield Claim(f"shown {name!r}", (greater(symbol, 3),)), "no name"
        yield Claim(f"defined {name!r}", (greater(symbol, x),), (), defined(symbol, x)), "no name"
    positive = Symbol("q", positive=True)  # nor where no relation looks at it
    unused = Program("p", (x, positive), ((p, x + 1), (w, positive)), (p,))
    lemma, bound = CitedLemma(x <= 10, "Dekker1971", (greater(positive, 0),)), Derivative(positive**2, positive)
    for changes in (
        {"shows": (greater(positive, 0),)},
        {"given": (greater(positive, 0),)},
        {"lines": unused},
        {"lines": Program("p", (x, positive), ((p, x + 1),), (p,))},
        {"cited": (lemma,)},
        {"cited": (CitedLemma(greater(positive + 1, 0), "Dekker1971"),)},
        {"ranges": ((positive, (0, 1)),)},
        {"example": ((positive, 1),)},
        {"shows": (equation(bound, bound),)},
    ):
        (place,) = changes
        yield Claim(place, (greater(x, 0),), (greater(x, 1),)).but(**changes), "plain real"
    for number in (Symbol("n", positive=True), Symbol("n", even=True), Symbol("n", integer=True, zero=False)):
        yield Induction("not every whole number", number, (equation(x, 0),), ((x, 0, x),)), "whole, and nothing else"
    # An angle has a value, and no letter of its own: of e·x and the product of x and a symbol E the cosine would have
    # one name.
    for angle in (1 / x, sqrt(x), Abs(x), I * x, E * x, 0.5 * x, INFINITE):
        square = cos(angle, evaluate=False) ** 2
        yield Claim(f"the angle {angle}", (equation(square + sin(x) ** 2, 1),)), "polynomial"
    yield Claim("exponent", (TO_THE_ONE,)), "no rule"
    program = Program("p", (x,), ((y, x + 1),), (y,))
    for outputs, avoid in (
        ((Symbol("z", real=True),), (x,)),
        ((y,), (Symbol("z", real=True),)),
        ((y,), (x, Symbol("z"))),
    ):
        yield Separation("of another name", program, outputs, avoid), "has no z"
    for corner in (floor(x), Heaviside(x), DiracDelta(x), log(x), atan2(x, y)):
        yield Claim(f"derivative of {corner}", (equation(Derivative(corner, x), 0),)), "no rule differentiates"
        yield Claim(f"derivative of {corner} is", (equation(corner, 0),)), "no rule translates"
    for line in (Derivative(p, x), Derivative(p**2, p), Derivative(p * x, x)):  # a line's name may change with x
        yield Claim(f"of a line, {line}", (equation(line, 0),), (), defined(p, x + 1)), "what a line defines"
    yield Induction("a state twice", n, (equation(x, 0),), ((x, 1, x), (x, 0, x))), "twice"
    yield from ((claim, None) for claim in WITHOUT_A_RULE)
    yield from ((Claim(name, (equation(side, 0),)), None) for name, side in endless())


def endless():
    """Yield (name, a side that nobody waits for, or that no stack holds)."""
    nested, many = x, symbols("a:40", real=True)
    for _ in range(3000):
        nested = cos(nested, evaluate=False)
    yield "nested", nested
    yield from (("a power", (x + y) ** 10**6), ("a monomial", x**10**9), ("an angle", cos(x / 10**7) + cos(x)))
    yield from (("a number", Pow(2, 10**8, evaluate=False) * x), ("a derivative", Derivative(x * sin(x), (x, 10**5))))
    yield from (("cases", sum(Max(each, 0) for each in many)), ("of a product", Abs(prod(x + each for each in many))))


WITHOUT_A_RULE = [
    Induction("a half of what turns", n, (equation(cos(TINY * n * x) * cos(x), cos(x)),)),
    Induction(
        "a state in an angle",
        n,
        (equation((1 - cos(s)) * y, 1 - a),),
        ((a, 1, a * cos(s)), (y, 0, y + a), (s, 0, s + TINY)),
    ),
    Induction("pi", Symbol("pi", integer=True), (equation(cos(x * Symbol("pi", integer=True)), cos(pi * x)),)),
    Induction("two n", Symbol("n", integer=True), (equation(cos(x * Symbol("n", integer=True)), cos(n * x)),)),
    Induction("a start", n, (equation(x, y),), ((x, y, x), (y, 1, y))),
    Induction("given", n, (equation(x, 0),), ((x, y, x),), (equation(x, 0),)),
    Induction("given n", n, (equation(x, 0),), ((x, 0, x),), (greater(cos(n * y), 0),)),
    Induction("undecided", n, (equation(Max(x, y), x),)),
    Induction("no turn", n, (equation(cos(n * x), 1),)),
    Claim("no branch", (equation(Piecewise((x, x > 0)), x),)),
    Claim("no line", (equation(y, x),), (), defined(y, Piecewise((x, x > 0)))),
    Claim("no order", (equation(UNORDERED, y),)),
]
"""False for n > 0, undefined, or undecided: the first two so little that 50 digits do not see it."""


@pytest.mark.parametrize(("claim", "why"), [*untranslatable()], ids=lambda part: getattr(part, "name", ""))
def test_what_no_rule_translates_is_refused(claim, why):
    with pytest.raises(Untranslatable, match=why):
        statements(claim, {})


def plain_claims():
    """Yield true claims beside those that are refused: of plain symbols, of names that are there, of angles."""
    q, whole = Symbol("q", real=True), Symbol("n", integer=True)
    yield Claim("a line", (equation(Abs(q), x - 5), greater(q, x - 6)), (greater(x, 5),), defined(q, x - 5))
    yield Claim("a lemma", (at_least(x + 1, sin(x)),), (greater(x, 1),), cited=(sine_below(x),))
    yield Separation("a name", Program("p", (x, w), ((y, x + 1), (p, w)), (y, p)), (y,), (w,))
    yield Induction("every whole number", whole, (equation(y, 2 * x),), ((y, 2 * x, 3 * y - 4 * x),))
    turned = ((a, 1, a * cos(x) - s * sin(x)), (s, 0, s * cos(x) + a * sin(x)))
    yield Induction("an angle", whole, (equation(a, cos(whole * x)), equation(s, sin(whole * x))), turned)
    yield Claim("angles", (equation(cos(x / 2) ** 2 - sin(x / 2) ** 2, cos(x)),))
    yield Claim("a power", (at_least((x + y) ** 8, 0),), squares=((x + y) ** 4,))


@pytest.mark.parametrize("claim", [*plain_claims()], ids=lambda claim: claim.name)
def test_what_is_plain_is_proved(claim):
    assert graded(claim) == "proved"


# What is not proved, but with a hypothesis

ROOM = (greater(x, 0), greater(x, y))
STEP, RAMP = Piecewise((1, x > 0), (0, True)), Piecewise((x, x > 0), (0, True))
WITHOUT_DERIVATIVE = [
    *(equation(Derivative(Abs(x), x), d) for d in (sign(x), 1, Abs(x) / x)),
    *(equation(Derivative(step, x), 0) for step in (sign(x), STEP, sign(x) ** 2, Max(sign(x), 2))),
    *(equation(Derivative(corner, x), 1) for corner in (Max(x, 0), RAMP, Min(2 * x, x))),
    equation(Derivative(x * Abs(x), x, 2), 2 * sign(x)),
    equation(2 * sqrt(x) * Derivative(sqrt(x), x), 1),
    equation(Derivative(1 / x, x), -(x**-2)),
    *(equation(diff(corner, x), d) for corner, d in ((Abs(x), sign(x)), (Abs(x) ** 3 / 3, x**2 * sign(x)))),
    equation(diff(RAMP, x), STEP),
    at_least(diff(RAMP, x), 0),
]
"""What is not so where x = 0, and is where x > 0, or more: most of it as `diff` leaves it, or would."""
with evaluate(False):  # obligations come before anything cancels, whichever side of an inequality they stand on
    AS_THEY_STAND = [
        equation(sqrt(x) ** 2, x),
        equation((x * y) / x, y),
        equation((x - y) / (x - y), 1),
        equation(1 / x - 1 / x, 0),
        equation(cos(x * y / x), cos(y)),
        equation(sinpi(x * y / x), sinpi(y)),
        equation(sqrt(x) * sqrt(x) * sinpi(y), x * sinpi(y)),
        equation(sign(1 + Abs(1 / x)), 1),
        greater(x / x + 1, 1),
        greater(sqrt(x) * sqrt(x) + 1, x),
        greater(x + 1, sqrt(x) * sqrt(x)),
    ]
UNPROVED = [
    *((Claim(str(relation), (relation,)), ROOM) for relation in AS_THEY_STAND),
    *((Claim(str(relation), (relation,)), (greater(x, 0),)) for relation in WITHOUT_DERIVATIVE),
    (Claim("at the root", (equation(Derivative(x * sqrt(x), x), 3 * sqrt(x) / 2),), (x >= 0,)), (x > 0,)),
    (Claim("a third is whole", (equation(sin(pi * w), 0),), (), defined(w, x + Rational(1, 3))), None),
    (Claim("twice what is whole", (equation(sin(2 * pi * m), 0),)), (equation(sin(pi * m), 0),)),
    (Claim("larger", (equation(Max(x, y), x),)), ROOM),
    (Claim("positive", (equation(Abs(x), x),)), ROOM),
    (Claim("sin x ≤ x for x ≥ 0", (at_least(x + 1, sin(x)),), cited=(sine_below(x),)), (greater(x, 1),)),
]
"""[(a claim, what has to be given for it, or None)]"""


@pytest.mark.parametrize(("claim", "given"), UNPROVED, ids=lambda part: getattr(part, "name", ""))
def test_what_does_not_follow_is_not_proved(claim, given):
    with pytest.raises(NotFound):
        prove(claim, {})
    assert graded(claim) == "failed"
    assert given is None or prove(claim.but(given=given), {})


TRUE_DERIVATIVES = [
    equation(Derivative(x**3 - x * y, x), 3 * x**2 - y),
    equation(Derivative(sin(x * y) * sinpi(x), x), y * cos(x * y) * sinpi(x) + pi * sin(x * y) * cospi(x)),
    equation(Derivative(sqrt(1 + x**2), x) ** 2 * (1 + x**2), x**2),
    equation(Derivative(Abs(1 + x**2), x, 2), 2),
    equation(Derivative(Max(x**2 + 1, 0), x), 2 * x),
    at_least(Piecewise((x, x > 0), (-x, True)), 0),
]


@pytest.mark.parametrize("relation", TRUE_DERIVATIVES, ids=str)
def test_a_derivative_that_exists_is_proved(relation):
    assert prove(Claim("true", (relation,)), {})


NOTHING = (equation(x * y / x, y), equation(sqrt(x) ** 2, x), equation(0 / x, 0), equation(x, x), greater(x, y))


def test_a_relation_that_says_nothing_is_told_apart_from_one_that_says_something():
    for relation in NOTHING:
        claim = Claim("beside", (relation, greater(x**2 + 1, 0)), (greater(x, y),))
        theorem = Theorem("attack", "", "", (claim,), FALSE)
        assert examine(theorem, {}, anew=True).record["by_definition"] == {"beside": [str(relation)]}
    for theorem in all_theorems().values():
        assert not any(by_definition(claim, all_theorems()) for claim in theorem.claims), theorem.id


def test_what_a_file_of_theorems_says_arrives_as_it_is_written(monkeypatch):
    text = """
from sympy import Abs, Derivative, sqrt
from proofs.engine.claim import Claim, equation
from proofs.formulas.symbols import x, y
relations = equation(x * y / x, y), equation(sqrt(x) ** 2, x), equation(0 / x, 0), equation(Derivative(Abs(x), x), 1)
claims = [Claim("written", (relation,)) for relation in relations]
"""
    with TemporaryDirectory() as folder:
        monkeypatch.setattr(proofs.theorems, "__path__", [folder])
        (Path(folder) / "written.py").write_text(text)
        proofs.theorems.run_all()
    for claim in sys.modules.pop("proofs.theorems.written").claims:
        with pytest.raises(NotFound):
            prove(claim, {})
        assert prove(claim.but(given=(greater(x, 0),)), {})


# What a theorem may not be made of


def graded_claims():
    """Yield (the grade, a claim, what else is so of the theorem)."""
    for relation in NOTHING:
        yield "by definition", Claim("nothing to prove", (relation,), (greater(x, y),)), {}
    yield "by definition", Induction("to nothing", n, (equation(x, x), equation(0, 0))), {}
    for larger in (x, y):  # a branch is taken where the kernel can show it, and shown, whichever is the larger one
        given = (at_least(larger, x + y - larger),)
        yield "proved", Claim("maximum", (equation(Max(x, y), larger),), given), {}
    for given in ((x > 0, x < 0), (equation(x**2, -1),), (x > 5, x**2 < 20)):
        yield "failed", Claim("contradiction", (equation(x, x + 1),), given), {}
    yield "failed", Induction("contradiction", n, (equation(x, 0),), ((x, 0, x),), (y > 0, y < 0)), {}
    yield "failed", Claim("nothing", ()), {}
    true = Claim("true", (greater(x**2 + 1, 0),))
    yield "failed", true, {"mutants": (FALSE[0], FALSE[0])}
    yield "failed", true, {"mutants": (Mutant("itself", true), FALSE[0])}
    # x ≤ 10 is false only outside the box from which samples are drawn first; sin x ≤ x where x ≥ 0 is not told.
    lemmas = CitedLemma(x <= 10, "Dekker1971"), CitedLemma(sine_below(x).relation, "Dekker1971")
    yield "failed", Claim("false lemma", (greater(11, x),), cited=lemmas[:1]), {}
    yield "failed", Claim("untold", (at_least(x + 1, sin(x)),), (greater(x, 0),), cited=lemmas[1:]), {}
    for relation, given in FALSE_LEMMAS:
        lemma = CitedLemma(relation, "Dekker1971", given)
        narrow = ((x, (Rational(1, 3), Rational(1, 2))), (y, (Rational(1, 3), Rational(1, 2))))
        shown = Claim(f"false lemma {relation}", (relation,), given, cited=(lemma,), ranges=narrow)
        yield "failed", shown, {}
    itself = Claim("attack", (greater(x, 10),), borrowed=(("attack", "attack"),))
    yield "failed", itself, {}
    yield "failed", itself, {"uses": ("attack",)}
    # True claims are not refuted: π is no coordinate, a cosine follows from its angle, a lemma's condition is not the
    # claim's, and what a line defines is not chosen: 50 digits do not tell x² + 10⁻⁴¹ from 0.
    for point in (((pi, Rational(31, 10)),), ((Symbol("pi", real=True), Rational(31, 10)),), ()):
        yield refuted(greater(pi, Rational(314, 100)), point)
    yield refuted(greater(cos(x), Rational(1, 2)), ((x, 0), (cos(x), 0), (sin(x), 1)))
    yield refuted(greater(cos(1), Rational(1, 2)), ((cos(1), 0), (sin(1), 1)))
    yield refuted(greater(4, cos(x) + sin(x)), ((x, 0), (cos(x), 2), (sin(x), 3)))
    for claim, point in UNSEEN:
        yield "failed", claim, {"mutants": TRUE, "expected": "refuted", "refuted_at": point}


def refuted(relation, point):
    """Return the entry of `graded_claims` of a relation that is said to fail at a point."""
    return "failed", Claim(str(relation), (relation,)), {"mutants": TRUE, "expected": "refuted", "refuted_at": point}


FALSE_LEMMAS = [
    (at_least(x, sin(x) + TINY), (at_least(x, 0),)),
    (greater(x * y, 0), (at_least(x * y, 0),)),
    (greater((7 * x - 1) ** 2, 0), ()),
    (at_least(20, x), (greater(x, 0),)),
    (Ne(x * (x - 5) + 1, 1, evaluate=False), ()),
    (at_least((7 * x - 1) ** 2, TINY), ()),
    (at_least(10**20, x), (x >= 0,)),
    (at_least(5 - x, Rational(1, 10**5)), (x < 5,)),
    (Ne(sin(x), Rational(1, 2), evaluate=False), ()),
    (at_least(sin(pi * x), TINY), (x > 0, x < 1)),
]
"""[(what is false at or beside an edge, at one point or far away, or by less than 10⁻⁴⁰, the conditions)]"""
TRUE_LEMMAS = [sine_below(x), sine_above(x), cosine_above(x), sine_inside_half_turn(x), sine_of_half_turn(x)]
TRUE_LEMMAS.append(CitedLemma(greater(x * y, 0), "DLMF", (x > 0, y > 0)))
LATE = CitedLemma(greater(x + 1, x), "Dekker1971", (x >= 1,))
UNSEEN = [
    (Claim("lemma", (Ne(x**2 + TINY, 0, evaluate=False),), cited=(LATE,)), ((x, 0),)),
    (Claim("line", (Ne(cos(p), 1),), (x >= 0, x < 1), defined(p, x + TINY)), ((x, 0), (p, 0))),
]
"""[(a true claim, a point where 50 digits see it fail)]"""


@pytest.mark.parametrize(("grade", "claim", "changes"), [*graded_claims()], ids=lambda part: getattr(part, "name", ""))
def test_a_theorem_has_no_better_grade(grade, claim, changes):
    assert graded(claim, **changes) == grade


def test_what_a_source_says_is_not_refuted():
    for lemma in TRUE_LEMMAS:
        assert witness.lemma_fails_at(lemma, "lemma", 32) is None


def test_50_digits_see_neither_what_is_undefined_nor_what_is_unseen_as_it_is():
    with evaluate(False):
        claim = Claim("attack", (equation(x / y, x * (1 / y)),))
    assert witness.fails_at(claim, ((x, 1), (y, 0))) is None
    assert witness.sample(claim, "undefined", 400).failures == []
    above = Claim("π > 3.14, though no certificate shows it", (greater(pi, Rational(314, 100)),))
    assert witness.sample(above, "pi", 4).failures == witness.sample(above, "pi", 4).undefined == []
    assert all(witness.fails_at(claim, point) is not None for claim, point in UNSEEN)


def test_no_case_is_left_out_for_what_a_lemma_says_outside_its_conditions(tmp_path, monkeypatch):
    """max(0, x) = x, and "if x ≥ 0, then x + p² ≥ 0": the case x < 0 contradicts the conclusion, not the lemma."""
    monkeypatch.setattr(stored_file, "FOLDER", tmp_path)
    lemma = CitedLemma(at_least(x + p**2, 0), "Dekker1971", (at_least(x, 0),))
    claim = Claim("c", (equation(p, x),), (), defined(p, Max(0, x)), cited=(lemma,))
    theorem, cases = Theorem("attack", "", "", (claim,), FALSE), []
    for said in statements(claim, {}):
        try:
            cases += [(said, search(said), {"x": "1"})]
        except NotFound:
            cases += [(check.contradiction(said), search(check.contradiction(said)), None)]
    assert reasons(cases) == [None, None]
    (tmp_path / "attack.json").write_text(certificate.text(theorem, [(claim, cases)]), encoding="utf-8")
    with pytest.raises(Stale, match="no longer say"):
        stored(theorem, {"attack": theorem})


def test_no_mutant_is_proved_by_the_certificates_of_its_theorem():
    theorems, tried = all_theorems(), []
    for theorem in theorems.values():
        if theorem.claims and theorem.expected != "refuted":
            tried += [pairs for mutant in theorem.mutants for pairs in splices(theorem, mutant.claim, theorems)]
    answers = iter(accepted([compact(pair) for pairs in tried for pair in pairs]))
    verdicts_of = [[next(answers) for _ in pairs] for pairs in tried]
    assert len(tried) > 400
    for answered in verdicts_of:
        assert not any(all(each[kernel_] for each in answered) for kernel_ in answered[0])
        assert all(len(set(each.values())) == 1 for each in answered)


def test_a_claim_borrows_nothing_from_a_theorem_that_rests_on_it_nor_what_is_not_given():
    one, two = (
        Theorem(a, "", "", (Claim("c", (greater(x, 10),), borrowed=((b, "c"),)),), FALSE, uses=(b,))
        for a, b in (("one", "two"), ("two", "one"))
    )
    assert examine(one, {"one": one, "two": two}, anew=True).grade == "failed"
    near = Program("near", (x,), ((p, x + 3 - Rational(1, 10**6)),), (p,))
    lemma = Theorem("lemma", "", "", (Claim("c", (greater(p + 1, 0),), (greater(p, 0),)),), FALSE)
    borrowing = Claim("c", (greater(p + 1, 0),), (), near, borrowed=(("lemma", "c"),))
    borrower = Theorem("attack", "", "", (borrowing,), FALSE, uses=("lemma",))
    with pytest.raises(ValueError, match="not all given"):
        examine(borrower, {"lemma": lemma, "attack": borrower}, anew=True)


def test_a_clause_without_a_claim_is_argued():
    true = Claim("said", (greater(x**2 + 1, 0),))
    words = (Clause("A square is not negative,", (true,)), Clause("nor is a fourth power.", argued="not written down"))
    theorem = Theorem("attack", "", words, mutants=FALSE, expected="argued")
    assert examine(theorem, {"attack": theorem}, anew=True).grade == "argued"
    for wrong in ((words[0], Clause("More.")), (words[1],)):
        with pytest.raises(ValueError, match=r"clause|claims"):
            Theorem("attack", "", wrong, mutants=FALSE)


def test_a_hypothesis_that_no_proof_uses_is_left_out():
    """None is in a stored statement; and a statement that lacks another hypothesis is not today's."""
    used = Claim("used", (greater(x, 0),), (greater(x, 1),))
    ((one, *_),), ((two, *_),) = prove(used, {}), prove(used.but(given=(greater(x, 1), greater(y, 1))), {})
    assert one["steps"] == two["steps"]
    for path in FOLDER.glob("*.json"):
        for claim in json.loads(path.read_text("utf-8"))["claims"]:
            pairs = [(entry["statement"], entry["certificate"]) for entry in claim["statements"]]
            assert all(without_unused(*pair) == pair for pair in pairs if pair[0]["kind"] == "derivation"), path.stem


def test_a_point_shows_that_hypotheses_can_hold():
    """An exact one, of the kernel's names; without it, or at another point, a proof proves nothing."""
    given = (equation(x**2, 4), at_least(y, 0), at_least(sqrt(y) * x, 1))
    ((statement, certificate, point),) = prove(
        Claim("attack", (equation(x**4, 16), greater(sqrt(y) + x, 0)), given), {}
    )
    assert point == {"root_1": "1", "x": "2", "y": "1"}
    assert reasons([(statement, certificate, point)]) == [None]
    wrong = (point | {"x": "3"}, point | {"root_1": "-1"}, point | {"z": "0"}, {"x": "2"})
    assert all(reasons([(statement, certificate, each)]) != [None] for each in (None, {}, *wrong))
    for given in ((x > 0, x < 0), (equation(x, y), equation(y, x + 1))):
        contradicted = prove(Claim("attack", (equation(x, x + 1),), given), {})
        assert reasons(contradicted) == ["its hypotheses contradict each other"]


def test_a_case_that_cannot_occur_is_no_claim():
    """Of |x| < 0 no case can occur: each is proved impossible, and the claim is refused."""
    absurd = derivation(assume({"x": "1"}, ">"), assume({"x": "-1"}, ">"), show({"": "1"}, "="))
    proof = {"rule": "contradiction", "positive": [0], "sum": [["1", {"": "1"}, [1]]], "cofactors": []}
    case = absurd | {"variables": ["x"]}, {"proofs": [proof]}, None
    assert kernel.check(*case[:2]) is None
    assert reasons([case, case]) == ["its hypotheses contradict each other"] * 2
    assert reasons([case, (STATEMENT, CERTIFICATE, {})]) == [None, None]
    branches = Claim("clamped", (at_least(Min(1, Max(0, x)), 0),))
    cases = prove(branches, {})
    assert reasons(cases) == [None] * len(cases)
