"""Attacks on the checkers: false claims that must not be proved, true ones that must not be refuted, broken data."""

import json

import pytest
from sympy import (
    Abs,
    Dummy,
    E,
    I,
    Max,
    Min,
    Ne,
    Piecewise,
    Rational,
    S,
    Symbol,
    cos,
    evaluate,
    pi,
    sign,
    sin,
    sqrt,
    symbols,
)  # fmt: skip

from proofs import check
from proofs.check import FOLDER, canonical, reasons, verdicts
from proofs.engine import certificate, kernel
from proofs.engine import stored as stored_file
from proofs.engine.certificate import prove
from proofs.engine.claim import CitedLemma, Claim, Induction, Separation, at_least, equation, greater
from proofs.engine.points import without_unused
from proofs.engine.program import Program
from proofs.engine.search import search
from proofs.engine.statement import Untranslatable
from proofs.engine.stored import NotFound, Stale, statements, stored
from proofs.engine.theorem import Clause, Mutant, Theorem, all_theorems
from proofs.formulas.half_turns import sinpi
from proofs.theorems.cited import sine_below
from verify.checkers import witness
from verify.checkers.breakages import campaign
from verify.checkers.kernels import accepted, compact
from verify.checkers.proof_checker import examine, why_rejected
from verify.checkers.splices import splices
from verify.checkers.test_checkers import EMPTY, NOTHING, derivation, show

x, y, n = symbols("x y n", real=True)
FALSE = (Mutant("x > 1", Claim("a", (greater(x, 1),))), Mutant("x > 2", Claim("b", (greater(x, 2),))))


def graded(*claims, mutants=FALSE, **changes):
    """Return the grade of a theorem of these claims, everything found anew."""
    theorem = Theorem("attack", "", "", claims, mutants, **changes)
    return examine(theorem, {"attack": theorem}, anew=True).grade


def defined(symbol, expression):
    """Return a program of one line."""
    return Program("line", tuple(expression.free_symbols), ((symbol, expression),), (symbol,))


def attack_of_a_defined(**assumption):
    """Return a false claim about a symbol with an assumption that its definition does not bear out."""
    p = Symbol("p", **assumption)
    return Claim("attack", (equation(Abs(p), x - 5), greater(p, x - 6)), (), defined(p, x - 5))


HIDDEN = ["positive", "nonnegative", "negative", "integer", "rational", "zero", "nonzero", "finite", "even", "prime"]


@pytest.mark.parametrize("assumption", HIDDEN)
def test_a_symbol_hides_no_fact(assumption):
    for claim in (attack_of_a_defined(**{assumption: True}), attack_of_a_defined(**{assumption: False})):
        with pytest.raises(Untranslatable, match="plain real"):
            statements(claim, {})
    free = Symbol("p", **{assumption: True})
    for claim in (Claim("shown", (greater(free, 0),)), Claim("given", (greater(x, 0),), (greater(free, 0),))):
        with pytest.raises(Untranslatable, match="plain real"):
            statements(claim, {})


@pytest.mark.parametrize(
    "n", [Symbol("n", positive=True), Symbol("n", even=True), Symbol("n", integer=True, zero=False)]
)
def test_an_induction_is_over_every_whole_number(n):
    with pytest.raises(Untranslatable, match="whole, and nothing else"):
        statements(Induction("attack", n, (equation(x, 0),), ((x, 0, x),)), {})


def test_a_whole_number_is_a_hypothesis():
    """sin πw = 0 of w = x + 1/3 is false; given that it is so for m, it is so for 2m."""
    w, m = symbols("w m", real=True)
    with pytest.raises(NotFound):
        prove(Claim("attack", (equation(sin(pi * w), 0),), (), defined(w, x + Rational(1, 3))), {})
    prove(Claim("twice", (equation(sin(2 * pi * m), 0),), (equation(sin(pi * m), 0),)), {})


@pytest.mark.parametrize("other", [Symbol("x"), Dummy("x", real=True), Symbol("x", extended_real=True)])
def test_a_name_means_one_symbol(other):
    with pytest.raises(Untranslatable):
        statements(Claim("attack", (equation(x, other),), (greater(x, 0),)), {})
    with pytest.raises(Untranslatable):
        statements(Claim("attack", (greater(x, 0),), (), defined(x, other + 1)), {})


TAKEN = ["pi", "root_1", "inverse_12", "sum_1", "cos(x)", "sin(pi*x)", "x y", "", "x^2", "2x", "é", "_x", "x\n", "x'"]


@pytest.mark.parametrize("name", TAKEN)
def test_a_name_is_not_one_that_the_translation_makes(name):
    symbol = Symbol(name, real=True)
    for claim in (Claim("attack", (greater(symbol, 3),)), Claim("line", (greater(symbol, x),), (), defined(symbol, x))):
        with pytest.raises(Untranslatable, match="no name"):
            statements(claim, {})


CANCELLED = [equation(sqrt(x) ** 2, x), equation(x * y / x, y), equation((x - y) / (x - y), 1), equation(x, x)]
with evaluate(False):
    AS_THEY_STAND = [
        equation(sqrt(x) ** 2, x),
        equation((x * y) / x, y),
        equation((x - y) / (x - y), 1),
        equation(1 / x - 1 / x, 0),
        equation(cos(x * y / x), cos(y)),
        equation(sinpi(x * y / x), sinpi(y)),
        equation(x * sinpi(y) / x, sinpi(y)),
        equation(sqrt(x) * sqrt(x) * sinpi(y), x * sinpi(y)),
        equation(sign(1 + Abs(1 / x)), 1),
    ]
    ONE = y / y


@pytest.mark.parametrize("relation", CANCELLED, ids=str)
def test_nothing_to_prove_is_by_definition(relation):
    assert graded(Claim("attack", (relation,))) == "by definition"


@pytest.mark.parametrize("relation", AS_THEY_STAND, ids=str)
def test_obligations_come_before_anything_cancels(relation):
    claim = Claim("attack", (relation,))
    with pytest.raises(NotFound):
        prove(claim, {})
    assert graded(claim) == "failed"
    assert prove(claim.but(given=(greater(x, 0), greater(x, y))), {})


def test_an_exponent_is_a_number_as_it_stands():
    """x^(y/y) = x has no value where y = 0."""
    with evaluate(False), pytest.raises(Untranslatable, match="no rule"):
        statements(Claim("attack", (equation(x**ONE, x),)), {})


def test_an_inequality_keeps_its_quotients():
    """x/x ≥ 1 and √x √x ≤ x need x ≠ 0 and x ≥ 0, whichever side they stand on."""
    with evaluate(False):
        attacks = [greater(x / x + 1, 1), greater(sqrt(x) * sqrt(x) + 1, x), greater(x + 1, sqrt(x) * sqrt(x))]
    for relation in attacks:
        with pytest.raises(NotFound):
            prove(Claim("attack", (relation,)), {})


@pytest.mark.parametrize("point", [((pi, Rational(31, 10)),), ((Symbol("pi", real=True), Rational(31, 10)),), ()])
def test_pi_is_no_coordinate(point):
    """π > 3.14 is true, though no certificate shows it: it is not refuted at π = 3.1."""
    claim = Claim("attack", (greater(pi, Rational(314, 100)),))
    true = (Mutant("π > 3", Claim("a", (greater(pi, 3),))), Mutant("π > 2", Claim("b", (greater(pi, 2),))))
    assert graded(claim, mutants=true, expected="refuted", refuted_at=point) == "failed"
    assert witness.sample(claim, "pi", 4).failures == witness.sample(claim, "pi", 4).undefined == []


CIRCLES = [
    (greater(cos(x), Rational(1, 2)), ((x, 0), (cos(x), 0), (sin(x), 1))),
    (greater(cos(1), Rational(1, 2)), ((cos(1), 0), (sin(1), 1))),
    (greater(4, cos(x) + sin(x)), ((x, 0), (cos(x), 2), (sin(x), 3))),
]


@pytest.mark.parametrize(("relation", "point"), CIRCLES)
def test_a_cosine_follows_from_its_angle(relation, point):
    true = (
        Mutant("x² ≥ 0", Claim("a", (greater(x**2 + 1, 0),))),
        Mutant("x = x + 0", Claim("b", (greater(x + 1, x),))),
    )
    refuted = {"mutants": true, "expected": "refuted", "refuted_at": point}
    assert graded(Claim("attack", (relation,)), **refuted) == "failed"


def test_what_is_undefined_is_not_false():
    claim = Claim("attack", (equation(x / y, x / y + 0 * x),), ())
    with evaluate(False):
        claim = Claim("attack", (equation(x / y, x * (1 / y)),))
    assert witness.fails_at(claim, ((x, 1), (y, 0))) is None
    assert witness.sample(claim, "undefined", 400).failures == []


def test_a_cited_lemma_that_is_false_is_found():
    """x ≤ 10 is false only outside the box from which samples are drawn first."""
    lemma = CitedLemma(x <= 10, "Dekker1971")
    assert graded(Claim("attack", (greater(11, x),), cited=(lemma,))) == "failed"


def test_hypotheses_that_contradict_each_other_prove_nothing():
    for given in ((x > 0, x < 0), (equation(x**2, -1),), (x > 5, x**2 < 20)):
        assert graded(Claim("attack", (equation(x, x + 1),), given)) == "failed"
    whole = Induction("attack", n, (equation(x, 0),), ((x, 0, x),), (y > 0, y < 0))
    assert graded(whole) == "failed"


def test_a_theorem_needs_claims_and_mutants_of_its_own():
    assert graded(Claim("attack", ())) == "failed"
    given = greater(x, y)
    assert graded(Claim("attack", (given,), (given,))) == "by definition"
    claim = Claim("attack", (greater(x**2 + 1, 0),))
    assert graded(claim, mutants=(FALSE[0], FALSE[0])) == "failed"
    assert graded(claim, mutants=(Mutant("itself", claim), FALSE[0])) == "failed"


def test_a_branch_is_taken_where_the_kernel_can_show_it():
    """And shown, whichever argument is the larger one."""
    for larger in (x, y):
        maximum = Claim("max", (equation(Max(x, y), larger),), (at_least(larger, x + y - larger),))
        assert graded(maximum) == "proved"
    for relation in (equation(Max(x, y), x), equation(Abs(x), x)):
        with pytest.raises(NotFound):
            prove(Claim("attack", (relation,)), {})


# The kernels


SQUARE = show({"x^2": "1"}, ">=")
SQUARES = {"rule": "contradiction", "positive": [0], "sum": [["1", {"x": "1"}, []]], "cofactors": []}
GOOD = [derivation(SQUARE), {"proofs": [SQUARES]}]
ONE_IS_ZERO = show({"": "1"}, "=")


def inverse(new):
    """Return the attack that took "" for a name of its own: an inverse of 1 called `new`, then 1 = 0."""
    named = {} if new is None else {"new": new}
    proofs = [EMPTY, {"rule": "ideal", "cofactors": [[0, {"": "1"}]]}]
    return [derivation(("inverse", {"": "2"}, named), ONE_IS_ZERO), {"proofs": proofs}]


def refutation(of, point, variables=None):
    """Return the counterexample to of > 0 at a point, whose names are the variables if none are given."""
    return [derivation(show(of, ">"), variables=variables or point) | {"kind": "refutation"}, {"point": point}]


ABOVE = derivation(("assume", {"x": "1"}, {"is": ">"}), show({"x": "1", "": "-1"}, ">="), variables=["x"])
ABOVE |= {"kind": "refutation"}
ZERO = [
    derivation(("define", {}, {"new": "y"}), show({"y": "1"}, r), variables=()) | {"kind": "refutation"}
    for r in (">", ">=")
]
LINES = {"version": 1, "kind": "separation", "lines": [["b", ["a"]], ["c", ["b"]]], "outputs": ["c"], "avoid": ["a"]}
EMPTY_INDUCTION = {key: [] for key in ("variables", "state", "assume", "show")} | {"start": {}, "next": {}}
EMPTY_INDUCTION |= {"version": 1, "kind": "induction"}
COUNT = EMPTY_INDUCTION | {"state": ["x"], "start": {"x": {}}, "next": {"x": {"x": "1", "": "1"}}, "show": [{"x": "1"}]}
BY_ITSELF = {"base": [NOTHING], "step": [{"rule": "ideal", "cofactors": [[0, {"": "1"}]]}]}
WELL_FORMED = [
    GOOD,
    [COUNT | {"next": {"x": {"x": "1"}}}, BY_ITSELF],
    [LINES | {"avoid": ["d"]}, {"reached": ["a", "b", "c"]}],
    [ABOVE, {"point": {"x": "1/2"}}],
    [ZERO[0], {"point": {}}],  # what is claimed is the polynomial 0, which leaves no name open
    [EMPTY_INDUCTION | {"show": [{}]}, {"base": [NOTHING], "step": [NOTHING]}],
]
STATEMENT, CERTIFICATE = GOOD
STEP = STATEMENT["steps"][0]
BROKEN = {
    **{f"inverse {new!r}": inverse(new) for new in ("", None, "x y", "x", 1, "__proto__", "pi^2")},
    "no show": [derivation(("assume", {"x": "1"}, {"is": ">"})), {"proofs": []}],
    "no steps": [derivation(), {"proofs": []}],
    "a proof left over": [STATEMENT, {"proofs": [SQUARES, NOTHING]}],
    "a proof too few": [STATEMENT, {"proofs": []}],
    "an unknown key": [STATEMENT | {"trust": "me"}, CERTIFICATE],
    "an unknown key of a step": [derivation(("show", {"x^2": "1"}, {"is": ">=", "new": "w"})), CERTIFICATE],
    "an unknown key of a certificate": [STATEMENT, CERTIFICATE | {"strengthen": []}],
    "an unknown key of a proof": [STATEMENT, {"proofs": [SQUARES | {"on": {}}]}],
    "version 1.5": [STATEMENT | {"version": 1.5}, CERTIFICATE],
    "version true": [STATEMENT | {"version": True}, CERTIFICATE],
    "a list for a text": [STATEMENT | {"kind": ["derivation"]}, CERTIFICATE],
    **{
        f"the coefficient {c!r}": [derivation(show({"x^2": c}, ">=")), CERTIFICATE]
        for c in ("1e0", "1e999999999", "0.5", 1, 1.5, "+1", "01", "2/2", "1/-2", "1/0", "", None, "0", "1 ", "１")
    },
    **{
        f"the monomial {m!r}": [derivation(show({m: "1", "x^2": "1"}, ">=")), CERTIFICATE]
        for m in ("x x", "x^1000", "x^1", "x^-1", "x^0", "x^02", " x", "x ", "x  y", "x^2^2", "x\t", "^2", "z")
    },
    **{
        f"the index {i!r}": [STATEMENT, {"proofs": [SQUARES | {"positive": [i]}]}]
        for i in (-1, 1, "0", 0.5, None, True, 2**53 + 1)
    },
    "a variable twice": [STATEMENT | {"variables": ["x", "x"]}, CERTIFICATE],
    "an empty induction": [EMPTY_INDUCTION, {"base": [], "step": []}],
    "an empty separation": [
        {"version": 1, "kind": "separation", "lines": [], "outputs": [], "avoid": []},
        {"reached": []},
    ],
    "pi as a coordinate": refutation({"pi": "1", "": "-4"}, {"pi": "31/10"}),
    "off the circle": refutation({"cos(x)": "1", "": "-1"}, {"cos(x)": "0", "sin(x)": "0"}),
    "a cosine alone": refutation({"cos(x)": "1", "": "-1"}, {"cos(x)": "0"}),
    "x = n by induction": [COUNT, BY_ITSELF],
    "its claim assumed": [COUNT | {"assume": [{"of": {"x": "1"}, "is": "="}]}, BY_ITSELF],
    "a set that is not closed": [LINES, {"reached": ["b", "c"]}],
    "a name to avoid": [LINES, {"reached": ["a", "b", "c"]}],
    **{f"no counterexample at x = {x}": [ABOVE, {"point": {"x": x}}] for x in ("-1", "1")},
    "no point": [ABOVE, {"point": {}}],
    "0 ≥ 0 refuted": [ZERO[1], {"point": {}}],
    "a name too many": refutation({"x": "1"}, {"x": "0", "y": "0"}, variables=("x",)),
}


@pytest.mark.parametrize("name", ["x", "constructor", "toString", "hasOwnProperty", "cos(constructor)"])
def test_the_kernels_accept_what_is_well_formed(name):
    """A name may be one that every object of JavaScript has, wherever names stand."""
    of = {name: "2", "": "-1"}
    proved = derivation(("assume", of, {"is": "="}), show(of, "="), variables=[name])
    proof = {"rule": "ideal", "cofactors": [[0, {"": "1"}]]}
    point = dict.fromkeys([name, name.replace("cos", "sin")], "0") | {name: "1"}
    induction = EMPTY_INDUCTION | {"state": [name], "start": {name: {}}, "next": {name: {}}, "show": [{name: "1"}]}
    lines = {"version": 1, "kind": "separation", "lines": [[name, []]], "outputs": [name], "avoid": ["y"]}
    pairs = [
        *WELL_FORMED,
        [proved, {"proofs": [proof]}],
        refutation(of | {"": "-3"}, point),
        [lines, {"reached": [name]}],
    ]
    for verdicts_of in accepted(list(map(compact, [*pairs, [induction, {"base": [NOTHING], "step": [NOTHING]}]]))):
        assert all(verdicts_of.values()), verdicts_of


def test_the_kernels_refuse_what_is_broken():
    for name, verdicts_of in zip(BROKEN, accepted(list(map(compact, BROKEN.values()))), strict=True):
        assert not any(verdicts_of.values()), (name, verdicts_of)


def test_a_number_that_a_double_rounds_proves_nothing():
    """2⁵³ + 1 as a literal, of which JavaScript makes 2⁵³; a key twice; a whole number as 1.0."""
    text = compact(GOOD)
    literal = compact([derivation(show({"": 2**53 + 1}, "=")), {"proofs": [NOTHING]}])
    twice = text.replace('"x^2":"1"', '"x^2":"-1","x^2":"1"')
    float_ = text.replace('"version":1', '"version":1.0')
    escaped = text.replace('"x^2"', '"\\u0078^2"')
    deep = "[" * 10**5 + "]" * 10**5
    assert not any(any(each.values()) for each in accepted([literal, twice, float_, escaped, deep]))


def test_a_file_is_its_own_canonical_form():
    pair = {"sha256": "0", "statement": STATEMENT, "certificate": CERTIFICATE, "point": {}}
    data = {"version": 1, "theorem": "attack", "claims": [{"claim": "c", "statements": [pair]}]}
    for text in (
        json.dumps(data),
        canonical(data) + " ",
        canonical(data).replace('"version": 1,', '"version": 1, "version": 1,', 1),
        canonical(data | {"more": 1}),
        canonical(data | {"theorem": "another"}),
    ):
        assert verdicts(text, "attack")[0][0] == "the file"
    assert verdicts(canonical(data), "attack") == [("c", "its sha256 is another statement's")]
    long = derivation(("define", {"x": "1", "": "9" * 500}, {"new": "a"}), show({"a^20": "1"}, "="))
    assert "the two sides differ" in f"{kernel.check(long, {'proofs': [NOTHING]})}"
    assert "thousands of digits" in why_rejected(long, {"proofs": [NOTHING]})
    claim = data["claims"][0]
    for claims in ([], [claim, claim | {"claim": "d", "statements": []}], [claim, claim]):
        assert verdicts(canonical(data | {"claims": claims}), "attack")[0][0] == "the file"
    for text in ("", "[" * 10**5, "9" * 5000, "\udcff", canonical(data).replace('"c"', '"\udcff"')):
        assert verdicts(text, "attack")[0][0] == "the file"


def test_bytes_that_another_writer_would_write_are_no_certificates(tmp_path, monkeypatch, capsys):
    """For the grade as for `proofs.check`: line ends, a byte order mark, what is no UTF-8, an unknown key."""
    theorems = all_theorems()
    good = (FOLDER / "unit_length.json").read_bytes()
    monkeypatch.setattr(check, "FOLDER", tmp_path)
    monkeypatch.setattr(stored_file, "FOLDER", tmp_path)
    (tmp_path / "unit_length.json").write_bytes(good)
    assert check.main([]) == 0 and stored(theorems["unit_length"], theorems)
    key = good.replace(b'"theorem"', b'"trust": "me",\n "theorem"', 1)
    for bad in (good.replace(b"\n", b"\r\n"), b"\xef\xbb\xbf" + good, good + b"\xff", good[:-9], key, b""):
        (tmp_path / "unit_length.json").write_bytes(bad)
        assert check.main([]) == 1
        with pytest.raises(Stale, match="of its stored certificates"):
            stored(theorems["unit_length"], theorems)


def test_no_case_is_left_out_for_what_a_lemma_says_outside_its_conditions(tmp_path, monkeypatch):
    """max(0, x) = x, and "if x ≥ 0, then x + p² ≥ 0": the case x < 0 contradicts the conclusion, not the lemma."""
    monkeypatch.setattr(stored_file, "FOLDER", tmp_path)
    lemma = CitedLemma(at_least(x + P**2, 0), "Dekker1971", (at_least(x, 0),))
    claim = Claim("c", (equation(P, x),), (), defined(P, Max(0, x)), cited=(lemma,))
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


def test_the_kernels_agree_on_what_is_broken_at_random():
    assert campaign(2000, seed=3) < 200


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


def test_a_claim_borrows_from_no_claim_of_its_own():
    """Nor from a theorem that rests on its own, nor a conclusion whose hypotheses are not given."""
    itself = Claim("attack", (greater(x, 10),), borrowed=(("attack", "attack"),))
    assert graded(itself) == graded(itself, uses=("attack",)) == "failed"
    one, two = (
        Theorem(a, "", "", (Claim("c", (greater(x, 10),), borrowed=((b, "c"),)),), FALSE, uses=(b,))
        for a, b in (("one", "two"), ("two", "one"))
    )
    assert examine(one, {"one": one, "two": two}, anew=True).grade == "failed"
    p = Symbol("p", real=True)
    near = Program("near", (x,), ((p, x + 3 - Rational(1, 10**6)),), (p,))
    lemma = Theorem("lemma", "", "", (Claim("c", (greater(p + 1, 0),), (greater(p, 0),)),), FALSE)
    borrowing = Claim("c", (greater(p + 1, 0),), (), near, borrowed=(("lemma", "c"),))
    borrower = Theorem("attack", "", "", (borrowing,), FALSE, uses=("lemma",))
    with pytest.raises(ValueError, match="not all given"):
        examine(borrower, {"lemma": lemma, "attack": borrower}, anew=True)


with evaluate(False):
    INFINITE = x * (1 / S.Zero)
    UNORDERED = cos(Max(x, 1 / S.Zero))


@pytest.mark.parametrize("angle", [1 / x, sqrt(x), Abs(x), cos(x), I * x, E * x, 0.5 * x, (x + 0.5) ** 2, INFINITE])
def test_an_angle_has_a_value(angle):
    """And no letter of its own: of e·x and the product of x and a symbol E the cosine would have one name."""
    with pytest.raises(Untranslatable, match="polynomial"):
        statements(Claim("attack", (equation(cos(angle, evaluate=False) ** 2 + sin(x) ** 2, 1),)), {})


def test_a_separation_is_about_names_of_its_program():
    program = Program("p", (x,), ((y, x + 1),), (y,))
    with pytest.raises(Untranslatable, match="has no z"):
        statements(Separation("attack", program, (Symbol("z", real=True),), (x,)), {})


TINY = Rational(1, 10**41)
a, s = symbols("a s", real=True)


@pytest.mark.parametrize(
    "claim",
    [
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
    ],
    ids=lambda claim: claim.name,
)
def test_what_the_translation_has_no_rule_for_is_refused(claim):
    """False for n > 0, undefined, or undecided: the first two so little that 50 digits do not see it."""
    with pytest.raises(Untranslatable):
        statements(claim, {})


def test_an_induction_to_nothing_is_by_definition():
    assert graded(Induction("attack", n, (equation(x, x), equation(0, 0)))) == "by definition"


P = Symbol("p", real=True)
LATE = CitedLemma(greater(x + 1, x), "Dekker1971", (x >= 1,))
TRUE = (Mutant("x² ≥ 0", Claim("a", (greater(x**2 + 1, 0),))), Mutant("x + 1 > x", Claim("b", (greater(x + 1, x),))))


@pytest.mark.parametrize(
    ("claim", "point"),
    [
        (Claim("lemma", (Ne(x**2 + TINY, 0, evaluate=False),), cited=(LATE,)), ((x, 0),)),
        (Claim("line", (Ne(cos(P), 1),), (x >= 0, x < 1), defined(P, x + TINY)), ((x, 0), (P, 0))),
    ],
    ids=lambda part: part.name if isinstance(part, Claim) else "",
)
def test_a_true_claim_is_not_refuted_by_what_is_not_its_own(claim, point):
    """A lemma's condition, or a value of a name that a line defines: 50 digits do not tell x² + 10⁻⁴¹ from 0."""
    assert witness.fails_at(claim, point) is not None
    assert graded(claim, mutants=TRUE, expected="refuted", refuted_at=point) == "failed"


def test_a_state_has_one_recurrence():
    twice = Induction("attack", n, (equation(x, 0),), ((x, 1, x), (x, 0, x)))
    with pytest.raises(Untranslatable, match="twice"):
        statements(twice, {})


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
    absurd = derivation(("assume", {"x": "1"}, {"is": ">"}), ("assume", {"x": "-1"}, {"is": ">"}), show({"": "1"}, "="))
    proof = {"rule": "contradiction", "positive": [0], "sum": [["1", {"": "1"}, [1]]], "cofactors": []}
    case = absurd | {"variables": ["x"]}, {"proofs": [proof]}, None
    assert kernel.check(*case[:2]) is None
    assert reasons([case, case]) == ["its hypotheses contradict each other"] * 2
    assert reasons([case, (STATEMENT, CERTIFICATE, {})]) == [None, None]
    branches = Claim("clamped", (at_least(Min(1, Max(0, x)), 0),))
    cases = prove(branches, {})
    assert reasons(cases) == [None] * len(cases)


def test_what_is_cited_is_cited_with_its_conditions():
    """sin x ≤ x holds for x ≥ 0: where that is not proved, or not told, the lemma is not to be had."""
    claim = Claim("attack", (at_least(x + 1, sin(x)),), cited=(sine_below(x),))
    with pytest.raises(NotFound):
        prove(claim, {})
    assert prove(claim.but(given=(greater(x, 1),)), {})
    untold = CitedLemma(sine_below(x).relation, "Dekker1971")
    assert graded(claim.but(given=(greater(x, 0),), cited=(untold,))) == "failed"
