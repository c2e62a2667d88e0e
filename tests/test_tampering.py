"""Tampered certificates are rejected by three kernels, the browser's among them; a broken kernel is found out."""

import pytest

from tests.tampered_certificates import accepted, load_kernel, stored, trial

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
            false, different, _ = trial(name, COUNT, 1, javascript)
            assert false == COUNT and different > 1


@pytest.mark.parametrize("answer", [True, False])
def test_a_kernel_that_always_says_the_same_is_found_out(answer):
    with pytest.raises(AssertionError, match="unit_length"):
        trial("unit_length/g_is_tangent/0", COUNT, 1, lambda pairs: [{"accepted": answer}] * len(pairs))


def test_verdicts_are_in_the_order_of_the_kernels(javascript):
    pair = stored()["unit_length/g_is_tangent/0"]
    assert accepted([pair], javascript) == [(True, True, True)]
    assert accepted([pair], lambda pairs: [{"accepted": False}]) == [(True, True, False)]
