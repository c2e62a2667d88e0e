"""The kernel in JavaScript, in a browser: points at which it accepts, and what it says of what it rejects.

That it accepts and rejects what the other kernels do, `verify/checkers/test_checkers.py` asks of all of them.
"""

import json

import pytest

from proofs.check import consistency
from verify.checkers.breakages import stored
from verify.checkers.kernels import JAVASCRIPT
from verify.checkers.known_bad import UNSOUND, derivation

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


def test_unsound_or_malformed_steps_are_rejected_in_words(javascript):
    pairs = [(derivation(*steps), {"proofs": [proof] * len(steps)}) for steps, proof, _ in UNSOUND]
    for (*_, reason), answer in zip(UNSOUND, javascript(pairs), strict=True):
        assert not answer["accepted"] and reason in answer["reason"]
