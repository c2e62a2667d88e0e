"""The long run over tampered certificates: a broken kernel ends it, and the committed one was whole."""

import json

import pytest

from tests.long_run import RESULTS
from tests.tampered_certificates import different, trial
from verify.checkers.kernels import CHECKERS


def test_nothing_is_tried_twice():
    assert list(different([(1, 2, True), (1, 3, True), (1, 2, True)])) == [(1, 2, True), (1, 3, True)]


@pytest.mark.parametrize("answer", [None, "no"])
def test_a_kernel_that_always_says_the_same_is_found_out(answer, monkeypatch):
    assert trial("unit_length/g_is_tangent/0", 5, 1)[0] == 5
    monkeypatch.setitem(CHECKERS, "another", lambda *pair: answer)
    with pytest.raises(AssertionError, match="unit_length"):
        trial("unit_length/g_is_tangent/0", 5, 1)


def test_the_committed_run_rejected_everything():
    """It names where and when it was run; `python -m tests.tampered_certificates` runs it again."""
    result = json.loads((RESULTS / "tampered_certificates.json").read_text(encoding="utf-8"))
    numbers = result["numbers"]
    assert numbers["count"] >= 1000
    assert numbers["certificates"] > 200
    rejected = {numbers[f"rejected_by_{kernel}"] for kernel in ("python", "flint", "javascript")}
    assert rejected == {numbers["tampered"]} == {numbers["count"] * numbers["certificates"]}
    assert {"machine", "date", "commit"} <= result["label"].keys()
