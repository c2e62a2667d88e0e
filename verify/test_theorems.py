"""Every theorem of `proofs.theorems`, one test each: certificates, samples, edges, mutants."""

import pytest

from proofs.engine.theorem import all_theorems
from verify.checkers.proof_checker import LONG_POINTS, POINTS, certificate_problems, examine

THEOREMS = all_theorems()


@pytest.mark.parametrize("theorem_id", THEOREMS)
def test_theorem(theorem_id, record_evidence, pytestconfig):
    theorem = THEOREMS[theorem_id]
    if pytestconfig.getoption("stored"):
        assert certificate_problems(theorem, THEOREMS) == []
        return
    points = LONG_POINTS if pytestconfig.getoption("--long") else POINTS
    found = examine(theorem, THEOREMS, anew=pytestconfig.getoption("search"), points=points)
    record_evidence(found)
    assert found.grade == theorem.expected, "\n".join([f"{theorem.id}: {theorem.title}", *found.problems])
