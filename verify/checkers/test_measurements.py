"""Measurements, citations and cited lemmas: what reaches which grade, and what must fail."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest
from flint import arb
from sympy import cos, sin, symbols

from proofs.engine.claim import CitedLemma, Claim, at_least
from proofs.engine.theorem import Mutant, Step, Theorem, all_theorems
from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import PIECES, errors_on_pieces
from verify.checkers import proof_checker
from verify.checkers.grades import given_cited, graded, summary
from verify.checkers.measured import examine, measurements
from verify.checkers.measurement import REGISTERED, Enclosure, Measurement, measures, rounded

x = symbols("x", real=True)


@pytest.fixture
def registry(monkeypatch):
    """Measurements that are registered in a test are forgotten after it."""
    measurements()
    for id in list(REGISTERED):
        monkeypatch.setitem(REGISTERED, id, list(REGISTERED[id]))
    yield
    REGISTERED.pop("measured_here", None)


def measured(expected="measured", **more):
    return Theorem("measured_here", "A measurement", "", expected=expected, **more)


def squares(bound=81.0):
    return Measurement(10, float(max(n * n for n in range(10))), bound, "squares", numbers={"n": 9})


@pytest.mark.usefixtures("registry")
def test_a_measurement_holds_and_rejects_its_false_variant():
    measures("measured_here", false={"at most 80": {"bound": 80}})(squares)
    found = examine(measured(), {"measured_here": measured()})
    assert (found.grade, found.mutants, found.mutants_killed) == ("measured", 1, 1)
    assert found.record["measurements"][0] == {
        "samples": 10, "seed": None, "certified": False, "what": "squares", "worst": 81.0, "bound": 81.0,
        "numbers": {"n": 9}, "false_variants": [{"variant": "at most 80", "rejected": True}],
    }  # fmt: skip
    assert examine(measured("certified"), {}).grade == "measured"  # not enclosed: short of what was expected


@pytest.mark.usefixtures("registry")
def test_a_measurement_that_accepts_anything_fails():
    measures("measured_here", false={"at most 81": {"bound": 81}})(squares)
    found = examine(measured(), {})
    assert found.grade == "failed"
    assert found.problems == ["squares: does not reject the false variant “at most 81”"]


@pytest.mark.usefixtures("registry")
def test_a_measurement_that_does_not_hold_fails():
    measures("measured_here", false={"at most 80": {"bound": 80}})(lambda bound=80: squares(bound))
    assert examine(measured(), {}).grade == "failed"


def test_without_a_measurement_nothing_is_measured():
    assert examine(measured(), {}).grade == "failed"
    assert proof_checker.examine(measured(), {}).grade == "failed"
    with pytest.raises(ValueError, match="false variant"):
        measures("measured_here", false={})


SINE = Enclosure(
    PIECES["sinpi"](), ((0.001, 0.25),), partial(errors_on_pieces, "sinpi"), CERTIFIED["sinpi"], "sine, in ulps"
)
TAMPERED = {
    "no statement": {"what": ""},
    "nothing": {"pieces": []},
    "no range": {"over": ()},
    "an infinite bound": {"bound": arb("inf")},
    "a bound that is nan": {"bound": arb("nan")},
    "a bound that is a float": {"bound": 1.34},
    "a smaller bound": {"bound": Fraction(133, 100)},
    "one number": {"pieces": [(arb(0.125), arb(0.125), arb(1))], "over": ((0.125, 0.125),)},
    "one piece": {"pieces": SINE.pieces[:1]},
    "a gap": {"pieces": SINE.pieces[:300] + SINE.pieces[301:]},
    "beyond its pieces": {"over": ((0.001, 0.26),)},
    "a wide ball": {"pieces": [*SINE.pieces[1:], (*SINE.pieces[0][:2], arb(1, 1))]},
    "an enclosure of another number": {"pieces": [(arb(0), arb(1), arb(0.5))]},
    "another function": {"at": partial(errors_on_pieces, "sinpi_of_product")},
    "its own function": {"at": lambda points: 0 * points},
}


@pytest.mark.parametrize("changes", TAMPERED.values(), ids=TAMPERED)
def test_an_enclosure_is_taken_apart_and_tried(changes):
    assert SINE.why_refused() == ""
    assert replace(SINE, **changes).why_refused()


@pytest.mark.usefixtures("registry")
@pytest.mark.parametrize(("words", "grade"), [("At most 1.34 ulps.", "certified"), ("At most 1.3 ulps.", "failed")])
def test_what_is_enclosed_is_what_the_words_state(words, grade):
    measures("measured_here", false={"at most 1.33": {"bound": Fraction(133, 100)}})(
        lambda bound=SINE.bound: replace(SINE, bound=bound)
    )
    assert examine(replace(measured("certified"), statement=words), {}).grade == grade


NAN, INFINITE = math.nan, math.inf
NOT_MEASURED = [(0, 1.0, 2.0), (-1, 1.0, 2.0), (INFINITE, 1.0, 2.0), (1, NAN, 2.0), (1, INFINITE, INFINITE)]
NOT_MEASURED += [(1, 1.0, INFINITE), (1, 1.0, NAN), (1, -INFINITE, 2.0), (1, 3.0, 2.0)]


def test_a_measurement_is_of_finite_samples_and_has_a_finite_bound():
    assert Measurement(1, 1.0, 2.0, "something").why_refused() == ""
    assert all(Measurement(*numbers, "something").why_refused() for numbers in NOT_MEASURED)
    assert Measurement(1, 1.0, 2.0, "").why_refused()
    assert Measurement(1, 0.0, 1.0, "something else", holds=False).why_refused()
    assert rounded(2 / 3) == 0.666667


def test_every_measurement_belongs_to_a_theorem():
    """One without claims: those that have some are proved, or fail."""
    assert all(not all_theorems()[id].claims for id in measurements())


def test_a_citation_needs_a_source_in_the_bibliography():
    with pytest.raises(ValueError, match="needs a source"):
        measured("cited")
    assert examine(measured("cited", source="Blinn1978"), {}).grade == "cited"
    unknown = examine(measured("cited", source="Nobody1900"), {})
    assert (unknown.grade, unknown.problems) == ("failed", ["the bibliography has no Nobody1900"])


def given_a_lemma(relation, source="Blinn1978"):
    """Return a theorem about sin x on [0, 1] that follows from a cited lemma."""
    claim = Claim(
        "sine",
        (at_least(x, sin(x) * cos(x) ** 2),),
        (x >= 0, x <= 1, sin(x) >= 0),
        cited=(CitedLemma(relation, source, (x >= 0,)),),
    )
    mutants = (
        Mutant("−x", claim.but(shows=(at_least(-x, sin(x)),))),
        Mutant("x/2", claim.but(shows=(at_least(x / 2, sin(x)),))),
    )
    return Theorem("lemma", "A lemma", "", (claim,), mutants, (Step("all", "at once"),))


def test_what_rests_on_a_cited_lemma_says_so():
    theorem = given_a_lemma(at_least(x, sin(x)))
    found = proof_checker.examine(theorem, {"lemma": theorem}, anew=True)
    assert found.problems == []
    (entry, user) = graded([found.record, {"id": "user", "uses": ["lemma"], "grade": "proved"}])
    assert entry["grade_line"] == "proved, given Blinn1978"
    assert user["grade_line"] == "proved, given Blinn1978"
    assert entry["cited_lemmas"] == [{"relation": "x >= sin(x)", "source": "Blinn1978"}]
    assert summary([entry, user]) == {"proved_given_cited": 2}
    unknown = given_a_lemma(at_least(x, sin(x)), "Nobody1900")
    found = proof_checker.examine(unknown, {"lemma": unknown}, anew=True)
    assert "the bibliography has no Nobody1900" in found.problems


def test_analysis_among_the_hypotheses_is_told_in_the_grade():
    entry = {"id": "limit", "grade": "proved", "uses": (), "source": "DLMF", "problems": []}
    assert given_cited([entry]) == {"limit": ["DLMF"]}
    assert given_cited([entry | {"grade": "cited"}]) == {"limit": []}


def test_what_coq_has_proved_here_is_given_by_no_source():
    """It proves a claim from nothing that is cited or borrowed; who uses it may still rest on another source."""
    entries = [
        {"id": "limit", "grade": "proved", "uses": (), "source": "DLMF"},
        {"id": "product", "grade": "proved", "uses": ("limit",), "source": "Dekker1971"},
    ]
    told = {formal: [e["grade_line"] for e in graded(entries, formal)] for formal in ((), ("limit",), ("product",))}
    assert told == {
        (): ["proved, given DLMF", "proved, given DLMF, Dekker1971"],
        ("limit",): ["proved", "proved, given Dekker1971"],
        ("product",): ["proved, given DLMF", "proved"],
    }
