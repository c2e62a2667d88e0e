"""From a theorem to its grade: what must fail, and what the failure says."""

from dataclasses import replace

import pytest
from sympy import symbols

from proofs.engine.claim import Claim, equation
from proofs.engine.program import Program
from proofs.engine.stored import Stale, stored
from proofs.engine.theorem import Mutant, Step, Theorem, all_theorems, in_order, incomplete
from verify.checkers.grades import NOT_RECHECKED, graded
from verify.checkers.proof_checker import examine

x, y = symbols("x y", real=True)
FALSE = Claim("quotient", (equation((x * y + x) / x, y + 1),))
TRUE = FALSE.but(given=(x > 1,))


def theorem(id, uses=(), claim=TRUE, mutants=None):
    mutants = mutants or (Mutant("2 for 1", claim.but(shows=(equation((x * y + x) / x, y + 2),))),) * 2
    return Theorem(id, id, "", (claim,), mutants, (Step("all", "at once"),), uses=uses)


def test_theorems_that_use_each_other_are_an_error():
    with pytest.raises(ValueError, match=r"cycle: .*first.*"):
        in_order([theorem("first", ("second",)), theorem("second", ("first",))])
    with pytest.raises(ValueError, match="first uses unknown theorems: third"):
        in_order([theorem("first", ("third",))])
    assert list(in_order([theorem("first", ("second",)), theorem("second")])) == ["second", "first"]


def test_a_false_theorem_fails_and_says_why():
    false = theorem("false", claim=FALSE.but(shows=(equation(x / y, y / x),), given=(x > 0, y > 0)))
    found = examine(false, {"false": false}, anew=True)
    assert found.grade == "failed"
    assert "no certificate found for" in found.problems[0]
    assert any("false at {'x'" in problem for problem in found.problems)


def test_a_mutant_that_holds_fails_the_theorem():
    true_mutant = Mutant("the same", TRUE)
    unproved = theorem("weak", mutants=(true_mutant, true_mutant))
    found = examine(unproved, {"weak": unproved}, anew=True)
    assert "mutant accepted: the same" in found.problems
    assert found.grade == "failed"


@pytest.mark.parametrize(
    ("own", "in_the_run"),
    [
        ({"a": ["failed"], "b": ["proved", "a"], "c": ["proved", "b"]}, ["failed"] * 3),
        ({"c": ["proved", "not run"]}, ["failed"]),
        ({"a": ["cited"], "b": ["proved", "a"]}, ["cited", "failed"]),
        ({"a": ["cited"], "b": ["measured", "a"]}, ["cited", "measured"]),
        ({"a": [NOT_RECHECKED], "b": ["measured", "a"], "c": ["failed", "a"]}, [NOT_RECHECKED] * 2 + ["failed"]),
    ],
)
def test_a_grade_counts_what_the_theorem_rests_on(own, in_the_run):
    """own: {id: [its grade, what it uses]}."""
    entries = graded([{"id": id, "grade": grade, "uses": uses} for id, (grade, *uses) in own.items()])
    assert [entry["grade"] for entry in entries] == in_the_run
    assert all(e["uses"][0] in e["reason"] for e in entries if e["grade"] == "failed" != own[e["id"]][0])


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


def test_uses_is_complete():
    """`uses` has what is borrowed or named in a step, and nothing idle; what could be borrowed has to be."""
    program = Program("p", (x,), ((y, x**2),), (y,))
    square = Claim("square", (y >= 0,), lines=program)
    first = theorem("first", claim=square, mutants=(Mutant("", square),) * 2)
    taken = Claim("sum", (y + 1 > 0,), lines=program, borrowed=(("first", "square"),))

    def problems(**changes):
        second = replace(theorem("second", claim=taken, mutants=(Mutant("", taken),) * 2), **changes)
        return incomplete(second, {"first": first, "second": second})

    assert problems() == []
    assert theorem("second", claim=taken).uses == ("first",)
    plain = taken.but(borrowed=())
    assert "second: uses first, but no claim borrows" in problems(uses=("first",), claims=(plain,))[0]
    assert problems(uses=("first",), claims=(plain,), steps=(Step("y ≥ 0", "a square", uses=("first",)),)) == []
    assumed = plain.but(given=(y >= 0,))
    assert problems(claims=(assumed,)) == ["second/sum: borrow y >= 0 from first/square"]
    elsewhere = assumed.but(lines=Program("q", (x,), ((y, x**3),), (y,)))
    assert problems(claims=(elsewhere,)) == []  # another y
    assert problems(uses=("first",), claims=(elsewhere,)) == []
