"""The two checkers of certificates: what both must refuse."""

import pytest

from verify.checkers import kernels

CHECKERS = pytest.mark.parametrize("check", kernels.CHECKERS.values(), ids=kernels.CHECKERS)


def derivation(*steps, variables=("x", "y")):
    """Return a derivation of the given steps: (kind, of, further keys)."""
    listed = [{"step": kind, "of": of, **more} for kind, of, more in steps]
    return {"version": 1, "kind": "derivation", "variables": list(variables), "steps": listed}


def show(of, relation):
    return ("show", of, {"is": relation})


NOTHING = {"rule": "ideal", "cofactors": []}
NEGATIVE = {"rule": "contradiction", "positive": [0], "sum": [["-1", {"x": "1"}, []]], "cofactors": []}
EMPTY = {"rule": "contradiction", "positive": [], "sum": [], "cofactors": []}
BY_CASES = {"rule": "cases", "on": {"x": "1"}, "branches": {">": NOTHING}}
INEQUALITY = {"rule": "ideal", "cofactors": [[0, {"": "1"}]]}
UNSOUND = [
    ([show({"x": "1"}, "=")], NOTHING, "the two sides differ"),
    ([show({}, ">")], NOTHING, "equations only"),
    ([show({"x^2": "-1"}, ">=")], NEGATIVE, "negative weight"),
    ([show({"x": "1"}, ">=")], EMPTY, "the two sides differ"),
    ([show({"x": "1"}, ">=")], BY_CASES, "no rule"),
    ([show({"x": "1"}, "=")], {"rule": "trust me"}, "no rule"),
    ([("inverse", {"x": "1"}, {"new": "r"}), show({"r x": "1", "": "-1"}, "=")], NOTHING, "equations only"),
    ([("root", {"x": "1"}, {"new": "w"})], NOTHING, "equations only"),
    ([("define", {"": "1"}, {"new": "x"}), show({"x": "1", "": "-1"}, "=")], NOTHING, "twice"),
    ([show({"z": "1"}, "=")], NOTHING, "z stands for nothing"),
    ([show({"x": "1.5"}, "=")], NOTHING, "not a fraction"),
    ([show({"x": "1/0"}, "=")], NOTHING, "not a fraction"),
    ([show({"x^-1": "0"}, "=")], NOTHING, "exponent"),
    ([show({"x^0": "0"}, "=")], NOTHING, "exponent"),
    ([show([], "=")], NOTHING, "a polynomial is missing"),
    ([("assume", {"x": "1"}, {"is": "<>"}), show({}, "=")], NOTHING, "no relation"),
    ([("assume", {"x": "1"}, {"is": "toString"}), show({}, "=")], NOTHING, "no relation"),
    ([("assume", {"x": "1"}, {"is": ">"}), show({"x": "1"}, "=")], INEQUALITY, "not ="),
    ([show({"x": "1"}, "=")], {"rule": "ideal", "cofactors": [[-1, {"": "1"}]]}, "no fact -1"),
    ([show({"x": "1"}, "=")], {"rule": "ideal", "cofactors": [[0, {"": "1"}]]}, "no fact 0"),
    ([("conjure", {}, {"new": "w"})], NOTHING, "no step"),
]  # fmt: skip
"""[(steps, the proof of each, what the page's kernel says of it)]"""


@CHECKERS
@pytest.mark.parametrize(("steps", "proof", "reason"), UNSOUND)
def test_unsound_steps_are_refused(check, steps, proof, reason):
    assert check(derivation(*steps), {"proofs": [proof] * len(steps)}) is not None, reason
