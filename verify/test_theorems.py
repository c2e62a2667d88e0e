"""Every theorem of `proofs.theorems`, one test each: certificates, samples, edges, mutants."""

import pytest

from proofs.engine.theorem import all_theorems
from verify.checkers import kept
from verify.checkers.grades import NOT_RECHECKED
from verify.checkers.proof_checker import LONG_POINTS, POINTS, certificate_problems, examine
from verify.checkers.registry import library_for

THEOREMS = all_theorems()


@pytest.mark.parametrize("theorem_id", THEOREMS)
def test_theorem(theorem_id, record_evidence, pytestconfig):
    theorem = THEOREMS[theorem_id]
    if pytestconfig.getoption("stored"):
        assert certificate_problems(theorem, THEOREMS) == []
        return
    if library := library_for(theorem_id):
        reason = f"needs {library}"
        left_out = {"id": theorem.id, "expected": theorem.expected, "uses": [], "grade": NOT_RECHECKED}
        record_evidence(left_out | {"reason": reason, "killed": "0/0"}, "–")
        pytest.skip(reason)
    points = LONG_POINTS if pytestconfig.getoption("--long") else POINTS
    key = kept.key_of(theorem, points) if kept.may_be_kept(theorem) else None
    found = kept.read(theorem, key) if key and not pytestconfig.getoption("fresh") else None
    took = "kept" if found else None
    if found is None:
        found = examine(theorem, THEOREMS, anew=pytestconfig.getoption("search"), points=points)
        if key:
            kept.keep(found, key)
    record_evidence(found.record | {"killed": f"{found.mutants_killed}/{found.mutants}"}, took)
    assert found.grade == theorem.expected, "\n".join([f"{theorem.id}: {theorem.title}", *found.problems])
