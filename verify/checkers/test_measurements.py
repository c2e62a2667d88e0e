"""Measurements, citations and cited lemmas: what reaches which grade, and what must fail."""

import pytest
from flint import arb
from sympy import cos, sin, symbols

from proofs.engine.claim import CitedLemma, Claim, at_least
from proofs.engine.theorem import Mutant, Step, Theorem, all_theorems
from verify.checkers import proof_checker
from verify.checkers.grades import given_cited, graded, summary
from verify.checkers.measured import examine, measurements
from verify.checkers.measurement import REGISTERED, Measurement, measures, rounded

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


def squares(bound=81, certified=False):
    worst = max(n * n for n in range(10))
    numbers = arb if certified else float
    return Measurement(10, numbers(worst), numbers(bound), "squares", numbers={"n": 9}, certified=certified)


@pytest.mark.usefixtures("registry")
def test_a_measurement_holds_and_rejects_its_false_variant():
    measures("measured_here", false={"at most 80": {"bound": 80}})(squares)
    found = examine(measured(), {"measured_here": measured()})
    assert (found.grade, found.mutants, found.mutants_killed) == ("measured", 1, 1)
    assert found.record["measurements"][0] == {
        "samples": 10, "seed": None, "certified": False, "what": "squares", "worst": 81.0, "bound": 81.0,
        "numbers": {"n": 9}, "false_variants": [{"variant": "at most 80", "rejected": True}],
    }  # fmt: skip
    assert examine(measured("certified"), {}).grade == "measured"  # not balls: short of what was expected


@pytest.mark.usefixtures("registry")
def test_balls_are_certified():
    measures("measured_here", false={"at most 80": {"bound": 80}})(lambda bound=81: squares(bound, certified=True))
    assert examine(measured("certified"), {}).grade == "certified"


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
    with pytest.raises(ValueError, match="balls"):
        Measurement(1, 1.0, 2.0, "floats", certified=True)


def test_a_ball_that_may_exceed_its_bound_is_not_accepted():
    wide = Measurement(1, arb(1, 0.5), arb(1.25), "wide", certified=True)
    assert not wide.accepted
    assert Measurement(1, arb(1, 0.5), 2, "wide", certified=True).accepted
    assert not Measurement(1, float("nan"), 1.0, "nothing").accepted
    assert not Measurement(1, 0.0, 1.0, "something else", holds=False).accepted
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


def test_the_source_of_a_lemma_is_in_the_bibliography():
    theorem = given_a_lemma(at_least(x, sin(x)), "Nobody1900")
    assert (
        "the bibliography has no Nobody1900" in proof_checker.examine(theorem, {"lemma": theorem}, anew=True).problems
    )


def test_analysis_among_the_hypotheses_is_told_in_the_grade():
    entry = {"id": "limit", "grade": "proved", "uses": (), "source": "DLMF", "problems": []}
    assert given_cited([entry]) == {"limit": ["DLMF"]}
    assert given_cited([entry | {"grade": "cited"}]) == {"limit": []}
