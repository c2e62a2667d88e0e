"""The kernel in JavaScript: what it accepts, what it has to reject, and that its arithmetic is exact."""

import json
from fractions import Fraction

import pytest

from proofs.check import consistency
from proofs.engine import kernel
from verify.checkers.breakages import stored
from verify.checkers.kernels import JAVASCRIPT
from verify.checkers.known_bad import NOTHING, UNSOUND, derivation, show

STORED = stored()
PAIRS = {name: (entry["statement"], entry["certificate"]) for name, entry in STORED.items()}
ASK = "(text) => { const { check } = certificate_kernel(); return JSON.parse(text).map((pair) => check(...pair)) }"


@pytest.fixture(scope="module")
def javascript(browser):
    """The kernel in an empty tab, as a function: pairs → what it says of each."""
    with browser.new_page() as tab:
        tab.add_script_tag(path=JAVASCRIPT)
        yield lambda pairs: tab.evaluate(ASK, json.dumps(pairs))


def test_the_kernel_is_short():
    """Lines of code, as the formatter breaks them; a quarter of them says what a file looks like."""
    lines = [line.strip() for line in JAVASCRIPT.read_text(encoding="utf-8").splitlines()]
    assert sum(bool(line) and not line.startswith(("/*", "*", "//")) for line in lines) < 330


def test_every_stored_certificate_is_accepted(javascript):
    points = {
        n: [consistency(e["statement"]), {"point": e["point"]}] for n, e in STORED.items() if e["point"] is not None
    }
    pairs = PAIRS | {f"{name}, its point": pair for name, pair in points.items()}
    answers = dict(zip(pairs, javascript(list(pairs.values())), strict=True))
    assert len(PAIRS) > 200 and len(points) > 180
    assert {name: answer["reason"] for name, answer in answers.items() if not answer["accepted"]} == {}
    assert all(answer["work"]["identities"] > 0 for answer in answers.values())


@pytest.mark.parametrize(("steps", "proof", "reason"), UNSOUND)
def test_unsound_or_malformed_steps_are_rejected(javascript, steps, proof, reason):
    answer = javascript([(derivation(*steps), {"proofs": [proof] * len(steps)})])[0]
    assert not answer["accepted"]
    assert reason in answer["reason"]


def test_a_version_or_kind_that_it_does_not_know_is_rejected(javascript):
    statement = derivation(show({}, "="))
    accepted = [javascript([(statement | change, {"proofs": [NOTHING]})])[0]["accepted"]
                for change in ({}, {"version": 2}, {"kind": "constructor"})]  # fmt: skip
    assert accepted == [True, False, False]
    assert not javascript([(statement, {"proofs": []})])[0]["accepted"]


def test_arithmetic_is_exact(javascript):
    large = str(3**200)
    of = {"x": f"{large}/{2**100}", "": "1/3"}
    assume = ("assume", of, {"is": "="})
    proof = {"rule": "ideal", "cofactors": [[0, {"x": "7/11"}]]}
    p = {"x^2": f"{7 * 3**200}/{11 * 2**100}", "x": "7/33"}
    off = p | {"x^2": str(Fraction(7 * 3**200 + 1, 11 * 2**100))}
    good, bad = (derivation(assume, show(of, "=")) for of in (p, off))
    answers = javascript([(good, {"proofs": [proof]}), (bad, {"proofs": [proof]})])
    assert [answer["accepted"] for answer in answers] == [True, False]
    assert answers[1]["residual"] == {"x^2": f"1/{11 * 2**100}"}


def powers(monomial):
    """Return {(name, exponent)} of "x^2 y"."""
    return frozenset((f.partition("^")[0], int(f.partition("^")[2] or 1)) for f in monomial.split())


def with_other_coefficients(statement):
    """Yield the derivation with one coefficient doubled, for each coefficient of each step."""
    for number, step in enumerate(statement["steps"]):
        for monomial, coefficient in step["of"].items():
            other = step | {"of": step["of"] | {monomial: str(2 * Fraction(coefficient))}}
            yield statement | {"steps": [*statement["steps"][:number], other, *statement["steps"][number + 1 :]]}


def test_the_residual_is_the_one_that_python_finds(javascript):
    compared = 0
    for name in ("unit_length/length/0", "kink_loci/projection/0", "hit_of_b/root/0"):
        statement, certificate = PAIRS.get(name) or next(
            pair for n, pair in PAIRS.items() if n.startswith(name.split("/")[0])
        )
        pairs = [(changed, certificate) for changed in with_other_coefficients(statement)]
        for pair, answer in zip(pairs, javascript(pairs), strict=True):
            why = kernel.check(*pair)
            assert answer["accepted"] == (why is None)
            if isinstance(why, kernel.Rejected) and why.args[1]:
                expected = {frozenset((n, word.count(n)) for n in word): str(c) for word, c in why.args[1].items()}
                assert {powers(monomial): c for monomial, c in answer["residual"].items()} == expected
                compared += 1
    assert compared > 60
