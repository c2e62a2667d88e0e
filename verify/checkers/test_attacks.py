"""Attacks by claims: false ones that must not be proved, true ones that must not be refuted, and empty ones."""

import sys

import pytest
from sympy import (
    Abs,
    Derivative,
    Eq,
    Max,
    Ne,
    Piecewise,
    Rational,
    SympifyError,
    cos,
    diff,
    evaluate,
    pi,
    sign,
    sin,
    sqrt,
    symbols,
    tan,
)  # fmt: skip

import proofs.theorems
from proofs import check
from proofs.check import reasons
from proofs.engine import stored
from proofs.engine.certificate import prove
from proofs.engine.claim import CitedLemma, Claim, Induction, Separation, at_least, equation, greater
from proofs.engine.program import Program, chain
from proofs.engine.stored import NotFound, statements
from proofs.engine.theorem import Clause, Mutant, Theorem, variant
from proofs.theorems.cited import sine_below
from verify.checkers import witness
from verify.checkers.counterexamples import path_to_avoided
from verify.checkers.proof_checker import by_definition, examine
from verify.checkers.theorem_files import refused, why_no_data
from verify.coq import recorded

x, y, n, p, q, a, s = symbols("x y n p q a s", real=True)
TINY = Rational(1, 10**41)


def says(*shows, **more):
    """Return a claim of these relations."""
    return Claim("attack", shows, **more)


TRUE = (Mutant("x² ≥ 0", says(greater(x**2 + 1, 0))), Mutant("x + 1 > x", says(greater(x + 1, x))))


def examined(*claims, mutants=TRUE, statement="", **changes):
    """Return the Examination of a theorem of these claims, all certificates searched anew."""
    theorem = Theorem("attack", "", statement, claims, mutants, **changes)
    return examine(theorem, anew=True)


def line(symbol, expression):
    """Return a program of one line."""
    return chain("line", {symbol: expression})


# Claims that are not proved but with a hypothesis

POSITIVE, ROOM = greater(x, 0), (greater(x, 0), greater(x, y))
WITHOUT_DERIVATIVE = [
    equation(Derivative(Abs(x), x), sign(x)),
    equation(Derivative(sign(x), x), 0),
    equation(Derivative(Max(x, 0), x), 1),
    equation(Derivative(x * Abs(x), x, 2), 2 * sign(x)),
    equation(Derivative(1 / x, x), -(x**-2)),
    at_least(diff(Piecewise((x, x > 0), (0, True)), x), 0),
]
"""Claims that are false at x = 0, and true where x > 0, or more: most of it as `diff` leaves it, or would."""
with evaluate(False):  # obligations come before anything cancels, whichever side of an inequality they stand on
    AS_THEY_STAND = [
        equation(1 / x - 1 / x, 0),
        equation(cos(x * y / x), cos(y)),
        equation(sign(1 + Abs(1 / x)), 1),
        greater(x / x + 1, 1),
        greater(x + 1, sqrt(x) * sqrt(x)),
    ]
UNPROVED = [
    *((says(relation), ROOM) for relation in (*AS_THEY_STAND, *WITHOUT_DERIVATIVE, equation(Max(x, y), x))),
    (says(equation(Derivative(x * sqrt(x), x), 3 * sqrt(x) / 2), given=x >= 0), POSITIVE),
    (says(equation(Derivative(Piecewise((x, sqrt(x) > -1), (0, True)), x), 1), given=x >= 0), POSITIVE),
    (says(equation(sqrt(x**2), x)), x >= 0),
    (says(at_least(x + 1, sin(x)), cited=sine_below(x)), POSITIVE),
]
"""[(a claim, what has to be given for it)]"""


@pytest.mark.parametrize(("claim", "hypotheses"), UNPROVED)
def test_what_does_not_follow_is_not_proved(claim, hypotheses):
    with pytest.raises(NotFound):
        prove(claim)
    assert prove(claim.but(given=hypotheses))


# The grade that a theorem has, and no better one

SEPARATION = Separation("a name", Program("p", (x, a), {y: x + 1, p: a}, (y, p)), y, a)
PUT_IN = chain("lines", {p: x - 5}, {q: p * y})
RESTATED = [
    equation(q, y * (x - 5)),
    equation(Abs(p - x + 5), 0),
    equation(Max(p, y), Max(x - 5, y)),
    greater(p - x, -6),
    greater(2, 1),
    at_least((x - 5) * (y + 1), 0),
    Ne(0, p * (1 + y)),
]
NOTHING_SAID = [
    *(says(r, given=greater((x - 5) * (y + 1), 0), lines=PUT_IN) for r in RESTATED),
    Separation("from an input", Program("p", (x, a), {y: x + a}, y), x, a),
    Induction("to nothing", n, (equation(x, x), equation(0, 0))),
]
"""Relations that lines or hypotheses already state, or that need no proof."""
CONTRADICTIONS = [
    says(equation(x, x + 1), given=(x > 5, x**2 < 20)),
    Induction("from a contradiction", n, equation(x, 0), ((x, 0, x),), (y > 0, y < 0)),
]
SINE = says(greater(sin(x) + 1, x), given=(equation(sin(x), x + Rational(1, 10**441)), x >= 0))
"""Of no x, which no kernel knows, and 400 digits do not tell."""
FALSE_LEMMAS = [
    (at_least(x, sin(x)), (), "false at"),
    (at_least(x, sin(x) + TINY), at_least(x, 0), "Coq's record of the files as they are has no proof"),
]
"""[(what a sample shows to be false, or none, its conditions, why it is refused)]"""
UNSEEN = [
    (says(Ne(x**2 + TINY, 0, evaluate=False), cited=CitedLemma(greater(x + 1, x), "DLMF", x >= 1)), ((x, 0),)),
    (says(Ne(cos(p), 1), given=(x >= 0, x < 1), lines=line(p, x + TINY)), ((x, 0), (p, 0))),
]
UNREFUTED = [
    (says(greater(pi, Rational(314, 100))), {pi: Rational(31, 10)}),
    (says(equation(Derivative(Piecewise((0, Eq(x, 0)), (x, True)), x), 1)), {x: 0}),
    (says(Ne(x * sign(x) + TINY, 0, evaluate=False)), {x: 0}),
    *UNSEEN,
]
"""[(a true claim, a point where it is said to fail)]: π is no coordinate, a lemma's condition is not the claim's, and
what a line defines is not chosen: 50 digits do not tell x² + 10⁻⁴¹ from 0."""
FAILED = [
    *(("contradict each other", claim, {}) for claim in CONTRADICTIONS),
    ("no sample satisfies", SINE, {}),
    ("nothing is claimed", says(), {}),
    *((why, says(r, given=g, cited=CitedLemma(r, "DLMF", g)), {}) for r, g, why in FALSE_LEMMAS),
    ("bibliography has no Nobody", says(at_least(x + 1, x), cited=CitedLemma(at_least(x + 2, x), "Nobody")), {}),
    *(("no certificate found", c, {"expected": "refuted", "refuted_at": point}) for c, point in UNREFUTED),
]


@pytest.mark.parametrize(("why", "claim", "changes"), FAILED)
def test_a_theorem_fails(why, claim, changes):
    examination = examined(claim, **changes)
    assert examination.grade == "failed" and why in str(examination.problems)


@pytest.mark.parametrize("claim", NOTHING_SAID)
def test_what_says_nothing_holds_by_definition(claim):
    assert len(by_definition(claim)) == len(getattr(claim, "shows", "-"))


def test_the_search_for_counterexamples_sees_what_is_there_and_no_more():
    """It finds a path to an output and a failure at 50 digits, and takes no 1/0 for one."""
    assert path_to_avoided(SEPARATION) is None and path_to_avoided(SEPARATION.but(avoid=x)) == ["y", "x"]
    assert all(witness.fails_at(claim, point) is not None for claim, point in UNSEEN)
    with evaluate(False):
        claim = says(equation(x / y, x * (1 / y)))
    assert witness.fails_at(claim, ((x, 1), (y, 0))) is None
    assert witness.outcome(says(equation(tan(x), 0)), ((x, 0),)) == "undefined"
    assert witness.sample(claim, "undefined", 400).failures == []


def test_a_lemma_counts_where_coq_has_proved_the_claim_without_it(monkeypatch):
    """Otherwise a false claim would follow from a false lemma."""
    claim = says(at_least(x + 1, sin(x)), given=POSITIVE, cited=sine_below(x))
    mutants = [variant(f"x − {n}", claim, at_least(x - n, sin(x))) for n in (1, 2)]
    for accepted, grade in (({}, "failed"), ({"attack": {"claims": ["attack__attack"]}}, "proved")):
        monkeypatch.setattr(recorded, "record", lambda accepted=accepted: accepted)
        assert examined(claim, mutants=mutants).grade == grade


def test_a_relation_that_says_nothing_fails_alone_and_beside_others():
    for shows in (x >= y, (x >= y, greater(x**2 + 1, 0))):
        claim = says().but(shows=shows, given=greater(x, y))
        examination = examined(claim, mutants=[variant(f"x > {n}", claim, greater(x, n)) for n in (50, 60)])
        assert examination.problems == ["attack: x >= y says nothing"]


def test_what_a_file_of_theorems_says_arrives_as_it_is_written(monkeypatch, tmp_path):
    text = """
from sympy import Abs, Derivative, sqrt
from proofs.engine.claim import Claim, equation
from proofs.formulas.symbols import x, y
relations = equation(x * y / x, y), equation(sqrt(x) ** 2, x), equation(Derivative(Abs(x), x), 1)
claims = [Claim("written", relation) for relation in relations]
"""
    monkeypatch.setattr(proofs.theorems, "__path__", [str(tmp_path)])
    (tmp_path / "written.py").write_text(text)
    proofs.theorems.run_all()
    for claim in sys.modules.pop("proofs.theorems.written").claims:
        test_what_does_not_follow_is_not_proved(claim, POSITIVE)
    for program in ("cos('print(1)')", "x.subs(x, 'print(1)')", "[*map(Abs, ['print(1)'])]"):  # no text is run
        (tmp_path / "written.py").write_text(f"from proofs.theorems.language import *\n{program}")
        with pytest.raises(TypeError, match="NoneType"):
            proofs.theorems.run_all()


HONEST = """from sympy import cos, pi
from proofs.formulas import camera
from proofs.theorems.language import *
claim = Claim("c", greater(x**2 + 1, S.Zero))
"""
PROGRAMS = [
    "from verify.checkers import grades",
    "from proofs.engine.theorem import Theorem",
    "from . import language",
    "from sympy import *",
    "from sympy import lambdify as cos",
    "from proofs.formulas.camera import diff",
    "slope = x.diff(x)",
    "slope = Derivative(x, x).doit()",
    "slope = diff(x, x)",
    "Claim.everywhere = lambda self: []",
    "camera.chain: object = None",
    "del Claim.everywhere",
    "for Claim.name in 'ab': pass",
    "HEIGHT_FIELDS['sine'] = ridges",
    "HEIGHT_FIELDS.update(sine=ridges)",
    "S('__import__')",
    "exec('1')",
    "run = eval",
    "setattr(Claim, 'name', 1)",
    "grades = __import__('verify')",
    "modules = claim.__class__.__mro__",
    "getattr(claim, 'name')",
    "class Claim(Claim): pass",
    "def f():\n    import os",
    "def f():\n    global x",
    "HEIGHT_FIELDS |= {'sine': ridges}",
    "[open for _ in range(3)]",
    "from proofs.engine.claim import sympify",
    "from proofs.engine.claim import put",
    "from proofs.theorems import import_module",
    "from proofs.formulas.ranges import operator",
    "x._assumptions._tell('positive', True)",
    "HEIGHT_FIELDS.PERIODIC.insert(0, x)",
    "(x for x in ()).gi_frame.f_builtins",
]


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_file_of_theorems_is_data(program):
    assert why_no_data(HONEST) == [] == refused()
    assert why_no_data(HONEST + program)


@pytest.mark.parametrize("changes", [{"shows": "x > 0"}, {"given": "1"}, {"ranges": {x: (0, "__import__('os')")}}])
def test_a_claim_reads_no_text(changes):
    with pytest.raises((SympifyError, ValueError, TypeError)):
        TRUE[0].claim.but(**changes)


def no_variant(claim, *mutants):
    """Return the problems with some false variants of a claim."""
    problems = examined(claim, mutants=mutants).problems
    return [problem for problem in problems if any(mutant.text in problem for mutant in mutants)]


SQUARE = says(greater(x**2 + 1, 0), given=x > -5)
NEAR = says(Ne(x**4 * y**2 + x**2 * y**4 - 3 * x**2 * y**2 + 1 + TINY / 10**4, 0, evaluate=False))
with evaluate(False):
    NOTHING = [greater(0 * x, 1), greater(x - x, 1)]
NO_VARIANTS = [
    *((SQUARE.but(shows=relation), "about nothing") for relation in NOTHING),
    (SQUARE.but(shows=greater(pi, 4)), "is about pi"),
    (SQUARE.but(name="other", shows=greater(x, 9)), "has no claim other"),
    (SQUARE.but(shows=greater(p, 9), lines=line(p, x)), "changes shows, lines"),
    (SQUARE.but(squares=x), "changes nothing"),
    (Induction("attack", n, equation(x, 2), ((x, 1, x),)), "has no claim attack"),
]


@pytest.mark.parametrize(("mutant", "why"), NO_VARIANTS)
def test_a_false_variant_changes_one_field_of_its_claim(mutant, why):
    good = Mutant("x² > 9", SQUARE.but(shows=greater(x**2, 9)))
    assert not no_variant(SQUARE, good, variant("x² > 8", SQUARE, greater(x**2, 8)))
    assert any(why in problem for problem in no_variant(SQUARE, good, Mutant("no variant", mutant)))


def test_a_counterexample_is_exact_or_enclosed():
    """A true variant that 50 digits take for false has none."""
    false = NEAR.but(shows=Ne(x, y, evaluate=False))
    near = Mutant(
        "not 0, by 10⁻⁴⁵", NEAR.but(shows=Ne(NEAR.shows[0].lhs - TINY / 10**5, 0, evaluate=False)), {x: 1, y: 1}
    )
    assert any("neither exact nor enclosed" in why for why in no_variant(NEAR, Mutant("x ≠ y", false), near))


def test_a_clause_without_a_claim_is_refused():
    words = Clause("A square is not negative,", TRUE[0].claim), Clause("nor is a fourth power.")
    for wrong in (words, words[1:]):
        with pytest.raises(ValueError, match=r"clause|claims"):
            examined(statement=wrong, mutants=TRUE)


# Cases that are left out, or cannot occur


def test_no_case_is_left_out_for_what_a_lemma_says_outside_its_conditions():
    """max(0, x) = x, and "if x ≥ 0, then x + p² ≥ 0": the case x < 0 contradicts the conclusion, not the lemma."""
    lemma = CitedLemma(at_least(x + p**2, 0), "Dekker1971", at_least(x, 0))
    claim = says(equation(p, x), lines=line(p, Max(0, x)), cited=lemma)
    for cases in statements(claim):
        empty = check.contradiction(cases)
        entry = {"statement": empty, "sha256": check.digest(empty)}
        assert stored._still_proves(claim.but(cited=()), cases, entry)
        assert not stored._still_proves(claim, cases, entry)


def test_a_point_shows_that_hypotheses_can_hold():
    """The point is exact, of the kernel's names; without it, or at a wrong one, a proof is void."""
    given = (equation(x**2, 4), at_least(y, 0), at_least(sqrt(y) * x, 1))
    ((*proof, point),) = prove(says(equation(x**4, 16), greater(sqrt(y) + x, 0), given=given))
    assert reasons([(*proof, point)]) == [None]
    for wrong in (None, {}, point | {"x": "3"}, point | {"z": "0"}):
        assert reasons([(*proof, wrong)]) != [None]
