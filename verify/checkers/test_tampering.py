"""The kernels and the judge of tampered certificates, against each other; the judge and the draw, on their own."""

import json
from itertools import islice

import pytest

from proofs.check import FOLDER
from verify.checkers.by_values import holds
from verify.checkers.kernels import CHECKERS, accepted, compact
from verify.checkers.tampering import draws

COUNT = 5  # of each certificate; `python -m tests.tampered_certificates` draws 1,000
STORED = {path.stem: json.loads(path.read_text("utf-8"))["claims"] for path in sorted(FOLDER.glob("*.json"))}
SQUARE = {
    "version": 1,
    "kind": "derivation",
    "variables": ["x", "y"],
    "steps": [
        {"step": "assume", "is": ">", "of": {"y": "1"}},
        {"step": "show", "is": "!=", "of": {"": "1", "x^2": "1"}},
    ],
}
PROOF = {"rule": "contradiction", "positive": [], "sum": [["1", {"x": "1"}, []]], "cofactors": [[1, {"": "1"}]]}


@pytest.mark.parametrize("theorem", STORED)
def test_a_tampered_certificate_is_rejected_where_its_sides_differ_at_a_point(theorem):
    pairs = [(pair["statement"], pair["certificate"]) for claim in STORED[theorem] for pair in claim["statements"]]
    drawn = [draw for pair in pairs for draw in ((*pair, True), *islice(draws(*pair, seed=1), COUNT))]
    texts = [compact(pair) for *pair, _ in drawn]
    assert all(holds(*pair) for pair in pairs)
    for text, (*_, still), verdicts in zip(texts, drawn, accepted(texts), strict=True):
        assert set(verdicts.values()) == {still}, (verdicts, text)


@pytest.mark.parametrize(
    ("of", "root", "still"),
    [
        ({"": "1", "x^2": "1"}, {"x": "1"}, True),
        ({"": "1", "x^2": "1"}, {"x": "-1"}, True),
        ({"": "1", "x^2": "1"}, {"x": "2"}, False),
        ({"": "1", "x^2": "2"}, {"x": "1"}, False),
        ({"": "1", "x^3": "1"}, {"x": "1"}, False),
        ({"": "-1", "x^2": "1"}, {"x": "1"}, False),
    ],
)
def test_the_judge_of_a_square(of, root, still):
    statement = SQUARE | {"steps": [SQUARE["steps"][0], SQUARE["steps"][1] | {"of": of}]}
    certificate = {"proofs": [PROOF | {"sum": [["1", root, []]]}]}
    assert holds(statement, certificate) == still
    assert {check(statement, certificate) is None for check in CHECKERS.values()} == {still}


def test_draws_are_seeded_different_and_of_every_sort():
    drawn = list(islice(draws(SQUARE, {"proofs": [PROOF]}, seed=3), 300))
    assert drawn == list(islice(draws(SQUARE, {"proofs": [PROOF]}, seed=3), 300))
    assert drawn != list(islice(draws(SQUARE, {"proofs": [PROOF]}, seed=4), 300))
    assert {still for *_, still in drawn} == {True, False}
    goals = [statement["steps"][1]["of"] for statement, *_ in drawn]
    proofs = [certificate["proofs"][0] for _, certificate, _ in drawn]
    assert {"": "1", "x^2": "-1"} in goals  # a sign
    assert {"": "1", "x": "1"} in goals  # an exponent
    assert any(set(goal) - {"", "x^2"} and goal.get("x^2") == "1" for goal in goals)  # a coefficient that was 0
    assert any(proof["cofactors"] != PROOF["cofactors"] for proof in proofs)
    assert any(proof["sum"] != PROOF["sum"] for proof in proofs)
