"""Every theorem of `proofs.theorems`, one test each: certificates, samples, edges, mutants; or measurements."""

import pytest

from proofs.engine.theorem import all_theorems
from verify.checkers import measured, proof_checker
from verify.checkers.grades import NOT_RECHECKED
from verify.checkers.known_bad import wrong_verdicts

THEOREMS = all_theorems()


@pytest.fixture(scope="session", autouse=True)
def _checkers_that_refuse_what_is_false():
    """Before anything is graded: known-bad certificates are refused."""
    assert wrong_verdicts(proof_checker.CHECKERS) == []


@pytest.mark.parametrize("theorem_id", THEOREMS)
def test_theorem(theorem_id, record_evidence, pytestconfig):
    theorem = THEOREMS[theorem_id]
    if library := measured.library_for(theorem_id):
        reason = f"needs {library}"
        left_out = {"id": theorem.id, "expected": theorem.expected, "uses": [], "grade": NOT_RECHECKED, "killed": "0/0"}
        record_evidence(left_out | {"reason": reason}, "–")
        pytest.skip(reason)
    if theorem.claims:
        points = proof_checker.LONG_POINTS if pytestconfig.getoption("--long") else proof_checker.POINTS
        found = proof_checker.examine(theorem, THEOREMS, pytestconfig.getoption("search"), points)
    else:
        found = measured.examine(theorem, THEOREMS)
    reason = {"reason": found.problems[0].splitlines()[0]} if found.problems else {}
    record_evidence(found.record | reason | {"killed": f"{found.mutants_killed}/{found.mutants}"})
    assert found.grade == theorem.expected, "\n".join([f"{theorem.id}: {theorem.title}", *found.problems])
