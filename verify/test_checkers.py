"""The checkers themselves: what they must refuse."""

import copy
import json
from dataclasses import replace
from fractions import Fraction

import pytest
from sympy import Eq, Max, Piecewise, Symbol, cos, oo, sin, sqrt, symbols

from proofs import kernel
from proofs.angles import Untranslatable
from proofs.certificate import FOLDER, Stale, prove, statements, stored
from proofs.claim import Claim, Induction, Separation, equation
from proofs.feasible import feasible
from proofs.program import Program
from proofs.search import NotFound, search
from proofs.statement import derivations, digest
from proofs.theorem import Mutant, Step, Theorem, all_theorems, in_order
from verify import second_checker, witness
from verify.proof_checker import examine, final_grades, path_to_avoided, why_rejected

x, y, z = symbols("x y z", real=True)
CHECKERS = pytest.mark.parametrize("check", [kernel.check, second_checker.check], ids=["kernel", "second"])
STORED = [
    pytest.param(pair["statement"], pair["certificate"], id=f"{path.stem}-{entry['claim']}-{number}")
    for path in sorted(FOLDER.glob("*.json"))
    for entry in json.loads(path.read_text())["claims"]
    for number, pair in enumerate(entry["statements"])
]


def derivation(*steps, variables=("x", "y")):
    """Return a derivation of the given steps: (kind, of, further keys)."""
    listed = [{"step": kind, "of": of, **more} for kind, of, more in steps]
    return {"version": 1, "kind": "derivation", "variables": list(variables), "steps": listed}


def show(of, relation):
    return ("show", of, {"is": relation})


NOTHING = {"rule": "ideal", "cofactors": []}
NEGATIVE = {"rule": "contradiction", "positive": [0], "sum": [["-1", {"x": "1"}, []]], "cofactors": []}
EMPTY = {"rule": "contradiction", "positive": [], "sum": [], "cofactors": []}
HALF = {"rule": "cases", "on": {"x": "1"}, "branches": {">": NOTHING}}
INEQUALITY = {"rule": "ideal", "cofactors": [[0, {"": "1"}]]}


@CHECKERS
@pytest.mark.parametrize(("statement", "certificate"), STORED)
def test_tampered_certificates_are_refused(check, statement, certificate):
    """A certificate with a piece missing, or one number changed, is refused."""
    assert check(statement, certificate) is None
    for tampered in tamper(statement, certificate):
        assert check(statement, tampered) is not None


def tamper(statement, certificate):
    """Return certificates that are false: pieces missing, or one added to a cofactor."""
    if statement["kind"] == "separation":
        return [{"reached": [n for n in certificate["reached"] if n != output]} for output in statement["outputs"]]
    if statement["kind"] == "refutation":
        point = certificate["point"]
        return [{"point": {k: v for k, v in point.items() if k != name}} for name in point]
    key = "proofs" if statement["kind"] == "derivation" else "step"
    wrong = [certificate | {key: certificate[key][:-1]}]
    for number, proof in enumerate(certificate[key]):
        for place in range(len(proof.get("cofactors", []))):
            changed = copy.deepcopy(certificate)
            cofactor = changed[key][number]["cofactors"][place][1]
            cofactor[""] = str(Fraction(cofactor.get("", 0)) + 1)
            wrong.append(changed)
    return wrong


@CHECKERS
@pytest.mark.parametrize(
    ("steps", "proof", "reason"),
    [
        ([show({"x": "1"}, "=")], NOTHING, "not zero"),
        ([show({}, ">")], NOTHING, "an ideal proves equations only"),
        ([show({"x^2": "-1"}, ">=")], NEGATIVE, "a negative weight"),
        ([show({"x": "1"}, ">=")], EMPTY, "1 = 0"),
        ([show({"x": "1"}, ">=")], HALF, "not exhaustive"),
        ([show({"x": "1"}, "=")], {"rule": "trust me"}, "no such rule"),
        ([("inverse", {"x": "1"}, {"new": "r"}), show({"r x": "1", "": "-1"}, "=")], NOTHING, "x may be 0"),
        ([("root", {"x": "1"}, {"new": "w"})], NOTHING, "x may be negative"),
        ([("define", {"": "1"}, {"new": "x"}), show({"x": "1", "": "-1"}, "=")], NOTHING, "x is not new"),
        ([show({"z": "1"}, "=")], NOTHING, "z is not declared"),
        ([("assume", {"x": "1"}, {"is": "<>"}), show({"x": "1"}, "=")], NOTHING, "no such relation"),
        ([("assume", {"x": "1"}, {"is": ">"}), show({"x": "1"}, "=")], INEQUALITY, "not an equation"),
        ([("conjure", {}, {"new": "w"})], NOTHING, "no such step"),
    ],
)  # fmt: skip
def test_unsound_steps_are_refused(check, steps, proof, reason):
    assert check(derivation(*steps), {"proofs": [proof] * len(steps)}) is not None, reason


@CHECKERS
def test_an_induction_may_not_assume_its_claim(check):
    """x(0) = 0, x(n + 1) = x(n) + 1: x = 0 for every n is false, whether assumed about the state or not."""
    statement = {
        "version": 1, "kind": "induction", "variables": [], "state": ["x"], "assume": [],
        "start": {"x": {}}, "next": {"x": {"x": "1", "": "1"}}, "show": [{"x": "1"}],
    }  # fmt: skip
    proof = {"rule": "ideal", "cofactors": [[0, {"": "1"}]]}
    certificate = {"strengthen": [], "base": [NOTHING], "step": [proof]}
    assert check(statement, certificate) is not None
    assert check(statement | {"assume": [{"of": {"x": "1"}, "is": "="}]}, certificate) is not None
    assert check(statement | {"next": {"x": {"x": "1"}}}, certificate) is None


@CHECKERS
def test_a_separation_needs_a_closed_set(check):
    statement = {"version": 1, "kind": "separation", "lines": [["b", ["a"]], ["c", ["b"]]], "outputs": ["c"]}
    assert check(statement | {"avoid": ["a"]}, {"reached": ["b", "c"]}) is not None
    assert check(statement | {"avoid": ["a"]}, {"reached": ["a", "b", "c"]}) is not None
    assert check(statement | {"avoid": ["d"]}, {"reached": ["a", "b", "c"]}) is None


@CHECKERS
def test_a_counterexample_must_satisfy_the_hypotheses(check):
    steps = (("assume", {"x": "1"}, {"is": ">"}), show({"x": "1", "": "-1"}, ">="))
    statement = derivation(*steps, variables=("x",)) | {"kind": "refutation"}
    assert check(statement, {"point": {"x": "1/2"}}) is None
    assert check(statement, {"point": {"x": "-1"}}) is not None
    assert check(statement, {"point": {"x": "1"}}) is not None
    assert check(statement, {"point": {}}) is not None


TRUE = [
    Claim("square", (x**2 - 2 * x * y + y**2 >= 0,), squares=(x - y,)),
    Claim("quotient", (equation((x * y + x) / x, y + 1),), (x > 1,)),
    Claim("root", (equation(sqrt(x**2), x),), (x >= 0,)),
    Claim("sum of angles", (equation(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),)),
    Claim("thrice", (equation(cos(3 * x), 4 * cos(x) ** 3 - 3 * cos(x)),)),
    Claim("half", (equation(cos(x), 2 * cos(x / 2) ** 2 - 1),)),
    Claim("cases", (Max(x, y) >= x, abs(x) >= x)),
    Claim("piecewise", (Piecewise((x, x > 0), (-x, True)) >= 0,)),
    Claim("product", (x * y > 0,), (x > 0, y > 0)),
    Claim("transitive", (x < z,), (x < y, y < z)),
]
FALSE = [
    Claim("square", (x**2 - 3 * x * y + y**2 >= 0,), squares=(x - y,)),
    Claim("quotient", (equation((x * y + x) / x, y + 1),)),
    Claim("root", (equation(sqrt(x**2), x),)),
    Claim("root of anything", (sqrt(x) >= 0,)),
    Claim("sum of angles", (equation(sin(x + y), sin(x) * cos(y) - cos(x) * sin(y)),)),
    Claim("thrice", (equation(cos(3 * x), 4 * cos(x) ** 3 + 3 * cos(x)),)),
    Claim("cases", (Max(x, y) > x,)),
    Claim("product", (x * y > 0,), (x > 0, y >= 0)),
]


@pytest.mark.parametrize("claim", TRUE, ids=lambda c: c.name)
def test_true_claims_are_proved(claim):
    for statement, certificate in prove(claim, {}):
        assert why_rejected(statement, certificate) is None
    assert witness.sample(claim, "true", 40).failures == []


@pytest.mark.parametrize("claim", FALSE, ids=lambda c: c.name)
def test_false_claims_are_not_proved_and_have_counterexamples(claim):
    with pytest.raises(NotFound):
        prove(claim, {})
    assert witness.sample(claim, "false", 400).failures


@pytest.mark.parametrize("expression", [Symbol("n") ** x, sin(sin(x)) / 2**y, Piecewise((x, x > 0), (oo, True))])
def test_what_no_rule_translates_is_an_error(expression):
    with pytest.raises(Untranslatable):
        derivations(Claim("untranslatable", (equation(expression, 0),)))


def test_translation_is_deterministic_and_sensitive():
    claim = Claim("angles", (equation(sin(x + y), sin(y + x)),), (Eq(x**2, y),))
    (first,), (second,) = derivations(claim), derivations(claim)
    assert digest(first) == digest(second)
    (other,) = derivations(claim.but(given=(Eq(x**2, -y),)))
    assert digest(first) != digest(other)


def test_induction_on_powers():
    """(c + is)^n = cos nα + i sin nα; not with the sign turned."""
    n, a, re, im = Symbol("n", integer=True), *symbols("alpha re im", real=True)
    states = ((re, 1, re * cos(a) - im * sin(a)), (im, 0, re * sin(a) + im * cos(a)))
    claim = Induction("power", n, (equation(re, cos(n * a)), equation(im, sin(n * a))), states)
    ((statement, certificate),) = prove(claim, {})
    assert why_rejected(statement, certificate) is None
    assert witness.sample(claim, "power", 40).failures == []
    wrong = claim.but(shows=(equation(re, cos(n * a)), equation(im, -sin(n * a))))
    with pytest.raises(NotFound):
        prove(wrong, {})
    assert witness.sample(wrong, "power", 40).failures


def test_separation_follows_the_program():
    program = Program("p", (x,), ((y, x + 1), (z, 2 * y)), (z,))
    apart = Separation("apart", program, (y,), (z,))
    assert search(*statements(apart, {}))["reached"] == ["x", "y"]
    joined = apart.but(outputs=(z,), avoid=(x,))
    with pytest.raises(NotFound):
        search(*statements(joined, {}))
    assert path_to_avoided(joined) == ["z", "y", "x"]


def test_linear_programming():
    one = Fraction(1)
    assert feasible([{"a": one}, {"a": -one, "b": one}], {"b": one}) == {0: 1, 1: 1}
    assert feasible([{"a": one}], {"a": -one}) is None


def theorem(id, uses=(), claim=TRUE[1], mutants=None):
    mutants = mutants or (Mutant("2 for 1", claim.but(shows=(equation((x * y + x) / x, y + 2),))),) * 2
    return Theorem(id, id, "s3", "", (claim,), mutants, (Step("all", "at once"),), uses=uses)


def test_theorems_that_use_each_other_are_an_error():
    with pytest.raises(ValueError, match=r"cycle: .*first.*"):
        in_order([theorem("first", ("second",)), theorem("second", ("first",))])
    with pytest.raises(ValueError, match="first uses unknown theorems: third"):
        in_order([theorem("first", ("third",))])
    assert list(in_order([theorem("first", ("second",)), theorem("second")])) == ["second", "first"]


def test_a_false_theorem_fails_and_says_why():
    false = theorem("false", claim=FALSE[1].but(shows=(equation(x / y, y / x),), given=(x > 0, y > 0)))
    found = examine(false, {"false": false}, anew=True)
    assert found.grade == "failed"
    assert "no certificate found for" in found.problems[0]
    assert any("false at {'x'" in problem for problem in found.problems)


def test_a_mutant_that_holds_fails_the_theorem():
    true_mutant = Mutant("the same", TRUE[1])
    unproved = theorem("weak", mutants=(true_mutant, true_mutant))
    found = examine(unproved, {"weak": unproved}, anew=True)
    assert "mutant accepted: the same" in found.problems
    assert found.grade == "failed"


def test_what_rests_on_an_unproved_theorem_is_not_proved():
    def entry(id, grade, uses=()):
        return {"id": id, "grade": grade, "uses": list(uses)}

    grades = final_grades([entry("a", "failed"), entry("b", "proved", ["a"]), entry("c", "proved", ["b"])])
    assert [grades[id][0] for id in "abc"] == ["failed", "failed", "failed"]
    assert "a" in grades["b"][1]
    assert final_grades([entry("c", "proved", ["b"])])["c"][0] == "failed"


FRAME = all_theorems()["tangent_frame"].claim("orthonormal")
EDITED = [s for s, expression in FRAME.lines.definitions if expression != 0]


@pytest.mark.parametrize("symbol", EDITED, ids=str)
def test_an_edited_line_is_caught(symbol):
    """One added to a line of the frame's program: the stored certificate is stale, and no new one is found."""
    theorems = all_theorems()
    definitions = tuple((s, e + 1 if s == symbol else e) for s, e in FRAME.lines.definitions)
    program = Program("edited", FRAME.lines.inputs, definitions, FRAME.lines.outputs)
    edited = replace(theorems["tangent_frame"], claims=(FRAME.but(lines=program),), side_conditions=())
    with pytest.raises(Stale, match="tangent_frame/orthonormal"):
        stored(edited, theorems)
    found = examine(edited, theorems)
    assert found.grade == "failed"
    assert "searched anew: no certificate found for" in found.problems[0]
