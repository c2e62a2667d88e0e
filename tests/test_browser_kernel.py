"""The kernel in JavaScript: what it accepts, what it has to reject, and that its arithmetic is exact."""

import json
from fractions import Fraction

import pytest

from proofs.check import consistency
from proofs.engine import kernel
from verify.checkers.breakages import stored
from verify.checkers.kernels import JAVASCRIPT
from verify.checkers.known_bad import NOTHING, UNSOUND, assume, derivation, show

STORED = stored()
ASK = "(text) => { const { check } = certificate_kernel(); return JSON.parse(text).map((pair) => check(...pair)) }"


@pytest.fixture(scope="module")
def javascript(browser):
    """The kernel in an empty tab, as a function: pairs → what it says of each."""
    with browser.new_page() as tab:
        tab.add_script_tag(path=JAVASCRIPT)
        yield lambda pairs: tab.evaluate(ASK, json.dumps(pairs))


def test_the_hypotheses_of_every_stored_statement_hold_at_its_point(javascript):
    """That each certificate is accepted, the page of all claims says: tests/test_checker.py."""
    entries = {name: entry for name, entry in STORED.items() if entry["point"] is not None}
    pairs = [(consistency(entry["statement"]), {"point": entry["point"]}) for entry in entries.values()]
    assert len(pairs) > 180
    for name, answer in zip(entries, javascript(pairs), strict=True):
        assert answer["accepted"] and answer["work"]["identities"] > 0, name


def test_unsound_or_malformed_steps_are_rejected(javascript):
    pairs = [(derivation(*steps), {"proofs": [proof] * len(steps)}) for steps, proof, _ in UNSOUND]
    for (*_, reason), answer in zip(UNSOUND, javascript(pairs), strict=True):
        assert not answer["accepted"] and reason in answer["reason"]
    statement, proofs = derivation(show({}, "=")), {"proofs": [NOTHING]}
    unknown = [(statement | change, proofs) for change in ({"version": 2}, {"kind": "constructor"})]
    answers = javascript([(statement, proofs), *unknown, (statement, {"proofs": []})])
    assert [answer["accepted"] for answer in answers] == [True, False, False, False]


def with_other_coefficients(statement):
    """Yield the derivation with one coefficient doubled, for each coefficient of each step."""
    for number, step in enumerate(statement["steps"]):
        for monomial, coefficient in step["of"].items():
            steps = [*statement["steps"]]
            steps[number] = step | {"of": step["of"] | {monomial: str(2 * Fraction(coefficient))}}
            yield statement | {"steps": steps}


def test_python_s_kernel_says_the_same(javascript):
    """Also of fractions of a hundred digits, of which a false one is off by one unit."""
    of = {"x": f"{3**200}/{2**100}", "": "1/3"}
    proofs, pairs = {"proofs": [{"rule": "ideal", "cofactors": [[0, {"x": "7/11"}]]}]}, []
    for unit in (0, 1):
        product = {"x^2": f"{7 * 3**200 + unit}/{11 * 2**100}", "x": "7/33"}
        pairs.append((derivation(assume(of, "="), show(product, "=")), proofs))
    for name in ("unit_length/length/0", "kink_loci/projection/0", "hit_of_b/quadratic/0"):
        changed = with_other_coefficients(STORED[name]["statement"])
        pairs += [(statement, STORED[name]["certificate"]) for statement in changed]
    accepted = [answer["accepted"] for answer in javascript(pairs)]
    assert accepted == [kernel.check(*pair) is None for pair in pairs]
    assert accepted[:2] == [True, False] and accepted.count(False) > 60
