"""Every theorem of `proofs.theorems`, one test each: certificates, samples, edges, mutants; or measurements."""

import pytest

from proofs.check import consistency
from proofs.engine.theorem import WITHOUT_CLAIMS, all_theorems
from verify.checkers import measurements, proof_checker, second_checker
from verify.checkers.grades import NOT_RECHECKED
from verify.checkers.known_bad import reasons_of, wrong_verdicts

THEOREMS = all_theorems()


@pytest.fixture(scope="session", autouse=True)
def _kernel_that_refuses_what_is_false():
    """Before anything is graded: known-bad certificates are refused."""
    assert wrong_verdicts(reasons_of) == []


def test_the_second_checker_agrees(record_property, pytestconfig):
    """It accepts every certificate, and the points at which hypotheses hold, and refuses known-bad ones."""
    if not second_checker.node():
        pytest.skip("the second checker was not run: it needs Node, on the PATH or playwright's")
    ids, pairs = pytestconfig.getoption("theorem") or THEOREMS, {}
    for name, entry in second_checker.stored().items():
        if name.partition("/")[0] in ids:
            pairs[name] = entry["statement"], entry["certificate"]
            if entry["point"] is not None:
                pairs[f"{name} at its point"] = consistency(entry["statement"]), {"point": entry["point"]}
    reasons = second_checker.reasons_of([*map(second_checker.compact, pairs.values())])
    assert {name: why for name, why in zip(pairs, reasons, strict=True) if why} == {}
    assert wrong_verdicts(second_checker.reasons_of) == []
    record_property("agreed", "the second checker")


def test_theorem(theorem_id, record_evidence, pytestconfig):
    theorem = THEOREMS[theorem_id]
    library = measurements.library_needed() if theorem.expected in WITHOUT_CLAIMS else None
    if library:
        reason = f"needs {library}"
        left_out = {"id": theorem.id, "expected": theorem.expected, "uses": [], "grade": NOT_RECHECKED, "killed": "0/0"}
        record_evidence(left_out | {"reason": reason}, "–")
        pytest.skip(reason)
    points = proof_checker.LONG_POINTS if pytestconfig.getoption("--long") else proof_checker.POINTS
    examination = proof_checker.examine(theorem, pytestconfig.getoption("search"), points)
    reason = {"reason": examination.problems[0].splitlines()[0]} if examination.problems else {}
    record_evidence(examination.record | reason | {"killed": f"{examination.mutants_killed}/{examination.mutants}"})
    assert examination.grade == theorem.expected, "\n".join([f"{theorem.id}: {theorem.title}", *examination.problems])
