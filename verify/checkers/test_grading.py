"""From a theorem to its grade: what must fail, and what the failure says."""

from dataclasses import replace

import pytest
from sympy import symbols

from proofs.engine.claim import Claim, equation
from proofs.engine.theorem import Theorem, all_theorems, in_order, variant
from verify.checkers.grades import NOT_RECHECKED, graded
from verify.checkers.proof_checker import examine

x, y = symbols("x y", real=True)
FALSE = Claim("quotient", equation((x * y + x) / x, y + 1))
TRUE = FALSE.but(given=x > 1)


def theorem(id, uses=(), claim=TRUE):
    mutants = [variant("2 for 1", claim, equation((x * y + x) / x, y + 2))] * 2
    return Theorem(id, id, "", claim, mutants, {"all": ("at once", uses)})


def test_theorems_that_use_each_other_are_an_error():
    with pytest.raises(ValueError, match=r"cycle: .*first.*"):
        in_order([theorem("first", "second"), theorem("second", "first")])
    with pytest.raises(ValueError, match="first uses unknown theorems: third"):
        in_order([theorem("first", "third")])
    assert list(in_order([theorem("first", "second"), theorem("second")])) == ["second", "first"]


def test_a_false_theorem_fails_and_says_why():
    """A theorem whose certificate is missing or stale fails, even where a new one is found."""
    false = theorem("false", claim=FALSE.but(shows=equation(x / y, y / x), given=(x > 0, y > 0)))
    for anew, of_theorem, why in (
        (True, false, "no certificate found for"),
        (False, false, "searched anew: no certificate found for"),
        (False, theorem("true"), "searched anew: a certificate exists"),
    ):
        examination = examine(of_theorem, anew=anew)
        assert examination.grade == "failed" and why in examination.problems[0]
        assert any("false at {'x'" in problem for problem in examination.problems) == (of_theorem is false)


def test_a_mutant_that_holds_fails_the_theorem():
    """A search proves the mutant, and there is no counterexample."""
    real = all_theorems()["unit_length"]
    mutants = [variant("the same", real.claims[0])] * 2
    examination = examine(replace(real, mutants=mutants, side_conditions=()))
    assert {problem.partition(":")[0] for problem in examination.problems} == {
        "these say the same",
        "mutant accepted",
        "the same",
        "mutant without a counterexample",
    }
    assert examination.mutants_killed == 0


RUNS = [  # of each theorem its id, its own grade, its grade in the run, and what it uses
    [("a", "failed", "failed"), ("b", "proved", "failed", "a"), ("c", "proved", "failed", "b")],
    [("c", "proved", "failed", "not run"), ("d", "certified", "failed", "e"), ("e", "measured", "measured")],
    [("a", "certified", "certified"), ("b", "proved", "failed", "a"), ("c", "measured", "measured", "a")],
    [("a", "refuted", "refuted"), ("b", "proved", "failed", "a"), ("c", "certified", "certified", "a")],
    [("a", "proved", "proved"), ("b", "refuted", "refuted", "a"), ("c", "refuted", "failed", "b")],
    [("a", NOT_RECHECKED, NOT_RECHECKED), ("b", "measured", NOT_RECHECKED, "a"), ("c", "failed", "failed", "a")],
]


@pytest.mark.parametrize("run", RUNS)
def test_a_grade_counts_what_the_theorem_rests_on(run):
    entries = graded([{"id": id, "grade": alone, "uses": uses} for id, alone, _, *uses in run])
    for entry, (_, alone, told, *uses) in zip(entries, run, strict=True):
        assert entry["grade"] == told
        assert alone == told or uses[0] in entry["reason"] or told == NOT_RECHECKED
