"""Tampered certificates are rejected by three kernels, the browser's among them; a broken kernel is found out."""

import json

import pytest

from tests.tampered_certificates import RESULT, accepted, different, load_kernel, stored, trial

pytestmark = pytest.mark.browser
COUNT = 5  # false changes of each certificate; the committed run has 1,000


@pytest.fixture(scope="module")
def javascript(browser):
    context = browser.new_context()
    yield load_kernel(context.new_page())
    context.close()


THEOREMS = sorted({name.partition("/")[0] for name in stored()})


@pytest.mark.parametrize("theorem", THEOREMS)
def test_three_kernels_reject_what_is_false_and_accept_the_original(theorem, javascript):
    for name in stored():
        if name.startswith(f"{theorem}/"):
            assert trial(name, COUNT, 1, javascript)[0] == COUNT


def test_nothing_is_tried_twice():
    assert list(different([(1, 2, True), (1, 3, True), (1, 2, True)])) == [(1, 2, True), (1, 3, True)]


@pytest.mark.parametrize("answer", [True, False])
def test_a_kernel_that_always_says_the_same_is_found_out(answer):
    with pytest.raises(AssertionError, match="unit_length"):
        trial("unit_length/g_is_tangent/0", COUNT, 1, lambda pairs: [{"accepted": answer}] * len(pairs))


def test_verdicts_are_in_the_order_of_the_kernels(javascript):
    pair = stored()["unit_length/g_is_tangent/0"]
    assert accepted([pair], javascript) == [(True, True, True)]
    assert accepted([pair], lambda pairs: [{"accepted": False}]) == [(True, True, False)]


def test_the_committed_run_rejected_everything():
    """It names where and when it was run; `python -m tests.tampered_certificates` runs it again."""
    result = json.loads(RESULT.read_text(encoding="utf-8"))
    numbers = result["numbers"]
    assert numbers["count"] >= 1000
    assert numbers["certificates"] > 200
    rejected = {numbers[f"rejected_by_{kernel}"] for kernel in ("python", "flint", "javascript")}
    assert rejected == {numbers["tampered"]} == {numbers["count"] * numbers["certificates"]}
    assert {"machine", "date", "commit"} <= result["label"].keys()
