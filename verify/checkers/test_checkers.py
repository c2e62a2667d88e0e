"""The checkers: what the kernels must refuse, in statements, in certificates and in files; and what they accept."""

import json

import pytest

from proofs import check
from proofs.check import FOLDER, canonical, verdicts
from proofs.engine import kernel
from proofs.engine import stored as stored_file
from proofs.engine.stored import Stale, stored
from proofs.engine.theorem import all_theorems
from verify.checkers.breakages import campaign
from verify.checkers.kernels import accepted, compact
from verify.checkers.proof_checker import why_rejected


def derivation(*steps, variables=("x", "y")):
    """Return a derivation of the given steps: (kind, of, further keys)."""
    listed = [{"step": kind, "of": of, **more} for kind, of, more in steps]
    return {"version": 1, "kind": "derivation", "variables": list(variables), "steps": listed}


def show(of, relation, step="show"):
    return (step, of, {"is": relation})


def assume(of, relation):
    return show(of, relation, "assume")


ONE, X = {"": "1"}, {"x": "1"}
BY_FIRST_FACT = {"rule": "ideal", "cofactors": [[0, ONE]]}
NOTHING = {"rule": "ideal", "cofactors": []}
NEGATIVE = {"rule": "contradiction", "positive": [0], "sum": [["-1", X, []]], "cofactors": []}
EMPTY = {"rule": "contradiction", "positive": [], "sum": [], "cofactors": []}
BY_CASES = {"rule": "cases", "on": X, "branches": {">": NOTHING}}
UNSOUND = [
    ([show(X, "=")], NOTHING, "the two sides differ"),
    ([show({}, ">")], NOTHING, "equations only"),
    ([show({"x^2": "-1"}, ">=")], NEGATIVE, "negative weight"),
    ([show(X, ">=")], EMPTY, "the two sides differ"),
    ([show(X, ">=")], BY_CASES, "no rule"),
    ([show(X, "=")], {"rule": "trust me"}, "no rule"),
    ([("inverse", X, {"new": "r"}), show({"r x": "1", "": "-1"}, "=")], NOTHING, "equations only"),
    ([("root", X, {"new": "w"})], NOTHING, "equations only"),
    ([("define", ONE, {"new": "x"}), show({"x": "1", "": "-1"}, "=")], NOTHING, "twice"),
    ([show({"z": "1"}, "=")], NOTHING, "z stands for nothing"),
    ([show({"x": "1.5"}, "=")], NOTHING, "not a fraction"),
    ([show({"x": "1/0"}, "=")], NOTHING, "not a fraction"),
    ([show({"x^-1": "0"}, "=")], NOTHING, "exponent"),
    ([show({"x^0": "0"}, "=")], NOTHING, "exponent"),
    ([show([], "=")], NOTHING, "a polynomial is missing"),
    ([assume(X, "<>"), show({}, "=")], NOTHING, "no relation"),
    ([assume(X, "toString"), show({}, "=")], NOTHING, "no relation"),
    ([assume(X, ">"), show(X, "=")], BY_FIRST_FACT, "not ="),
    ([show(X, "=")], {"rule": "ideal", "cofactors": [[-1, ONE]]}, "no fact -1"),
    ([show(X, "=")], BY_FIRST_FACT, "no fact 0"),
    ([("conjure", {}, {"new": "w"})], NOTHING, "no step"),
]  # fmt: skip
"""[(steps, the proof of each, what the page's kernel says of it)]"""


SQUARE = show({"x^2": "1"}, ">=")
SQUARES = {"rule": "contradiction", "positive": [0], "sum": [["1", X, []]], "cofactors": []}
GOOD = [derivation(SQUARE), {"proofs": [SQUARES]}]
ONE_IS_ZERO = show(ONE, "=")


def inverse(new):
    """Return the attack that took "" for a name of its own: an inverse of 1 called `new`, then 1 = 0."""
    named = {} if new is None else {"new": new}
    proofs = [EMPTY, BY_FIRST_FACT]
    return [derivation(("inverse", {"": "2"}, named), ONE_IS_ZERO), {"proofs": proofs}]


def refutation(of, point, variables=None):
    """Return the counterexample to of > 0 at a point, whose names are the variables if none are given."""
    return [derivation(show(of, ">"), variables=variables or point) | {"kind": "refutation"}, {"point": point}]


ABOVE = derivation(assume(X, ">"), show({"x": "1", "": "-1"}, ">="), variables=["x"])
ABOVE |= {"kind": "refutation"}
ZERO = [
    derivation(("define", {}, {"new": "y"}), show({"y": "1"}, r), variables=()) | {"kind": "refutation"}
    for r in (">", ">=")
]
LINES = {"version": 1, "kind": "separation", "lines": [["b", ["a"]], ["c", ["b"]]], "outputs": ["c"], "avoid": ["a"]}
EMPTY_INDUCTION = {key: [] for key in ("variables", "state", "assume", "show")} | {"start": {}, "next": {}}
EMPTY_INDUCTION |= {"version": 1, "kind": "induction"}
COUNT = EMPTY_INDUCTION | {"state": ["x"], "start": {"x": {}}, "next": {"x": {"x": "1", "": "1"}}, "show": [X]}
BY_ITSELF = {"base": [NOTHING], "step": [BY_FIRST_FACT]}
WELL_FORMED = [
    GOOD,
    [COUNT | {"next": {"x": X}}, BY_ITSELF],
    [LINES | {"avoid": ["d"]}, {"reached": ["a", "b", "c"]}],
    [ABOVE, {"point": {"x": "1/2"}}],
    [ZERO[0], {"point": {}}],  # what is claimed is the polynomial 0, which leaves no name open
    [EMPTY_INDUCTION | {"show": [{}]}, {"base": [NOTHING], "step": [NOTHING]}],
]
STATEMENT, CERTIFICATE = GOOD
STEP = STATEMENT["steps"][0]
BROKEN = {
    **{f"inverse {new!r}": inverse(new) for new in ("", None, "x y", "x", 1, "__proto__", "pi^2")},
    "no show": [derivation(assume(X, ">")), {"proofs": []}],
    "no steps": [derivation(), {"proofs": []}],
    "a proof left over": [STATEMENT, {"proofs": [SQUARES, NOTHING]}],
    "a proof too few": [STATEMENT, {"proofs": []}],
    "an unknown key": [STATEMENT | {"trust": "me"}, CERTIFICATE],
    "an unknown key of a step": [derivation(("show", {"x^2": "1"}, {"is": ">=", "new": "w"})), CERTIFICATE],
    "an unknown key of a certificate": [STATEMENT, CERTIFICATE | {"strengthen": []}],
    "an unknown key of a proof": [STATEMENT, {"proofs": [SQUARES | {"on": {}}]}],
    "version 1.5": [STATEMENT | {"version": 1.5}, CERTIFICATE],
    "version true": [STATEMENT | {"version": True}, CERTIFICATE],
    "a list for a text": [STATEMENT | {"kind": ["derivation"]}, CERTIFICATE],
    **{
        f"the coefficient {c!r}": [derivation(show({"x^2": c}, ">=")), CERTIFICATE]
        for c in ("1e0", "1e999999999", "0.5", 1, 1.5, "+1", "01", "2/2", "1/-2", "1/0", "", None, "0", "1 ", "１")
    },
    **{
        f"the monomial {m!r}": [derivation(show({m: "1", "x^2": "1"}, ">=")), CERTIFICATE]
        for m in ("x x", "x^1000", "x^1", "x^-1", "x^0", "x^02", " x", "x ", "x  y", "x^2^2", "x\t", "^2", "z")
    },
    **{
        f"the index {i!r}": [STATEMENT, {"proofs": [SQUARES | {"positive": [i]}]}]
        for i in (-1, 1, "0", 0.5, None, True, 2**53 + 1)
    },
    "a variable twice": [STATEMENT | {"variables": ["x", "x"]}, CERTIFICATE],
    "an empty induction": [EMPTY_INDUCTION, {"base": [], "step": []}],
    "an empty separation": [
        {"version": 1, "kind": "separation", "lines": [], "outputs": [], "avoid": []},
        {"reached": []},
    ],
    "pi as a coordinate": refutation({"pi": "1", "": "-4"}, {"pi": "31/10"}),
    "off the circle": refutation({"cos(x)": "1", "": "-1"}, {"cos(x)": "0", "sin(x)": "0"}),
    "a cosine alone": refutation({"cos(x)": "1", "": "-1"}, {"cos(x)": "0"}),
    "x = n by induction": [COUNT, BY_ITSELF],
    **{
        f"an induction with {base} and {step} proofs of a claim": [
            COUNT | {"next": {"x": X}},
            {"base": [NOTHING] * base, "step": [BY_FIRST_FACT] * step},
        ]
        for base, step in ((0, 0), (1, 0), (0, 1), (2, 2))
    },
    "its claim assumed": [COUNT | {"assume": [{"of": X, "is": "="}]}, BY_ITSELF],
    "a set that is not closed": [LINES, {"reached": ["b", "c"]}],
    "a name to avoid": [LINES, {"reached": ["a", "b", "c"]}],
    **{f"no counterexample at x = {x}": [ABOVE, {"point": {"x": x}}] for x in ("-1", "1")},
    "no point": [ABOVE, {"point": {}}],
    "0 ≥ 0 refuted": [ZERO[1], {"point": {}}],
    "a name too many": refutation(X, {"x": "0", "y": "0"}, variables=("x",)),
}


@pytest.mark.parametrize("name", ["x", "constructor", "toString", "hasOwnProperty", "cos(constructor)"])
def test_the_kernels_accept_what_is_well_formed(name):
    """A name may be one that every object of JavaScript has, wherever names stand."""
    of = {name: "2", "": "-1"}
    proved = derivation(assume(of, "="), show(of, "="), variables=[name])
    proof = BY_FIRST_FACT
    point = dict.fromkeys([name, name.replace("cos", "sin")], "0") | {name: "1"}
    induction = EMPTY_INDUCTION | {"state": [name], "start": {name: {}}, "next": {name: {}}, "show": [{name: "1"}]}
    lines = {"version": 1, "kind": "separation", "lines": [[name, []]], "outputs": [name], "avoid": ["y"]}
    pairs = [
        *WELL_FORMED,
        [proved, {"proofs": [proof]}],
        refutation(of | {"": "-3"}, point),
        [lines, {"reached": [name]}],
    ]
    for verdicts_of in accepted(list(map(compact, [*pairs, [induction, {"base": [NOTHING], "step": [NOTHING]}]]))):
        assert all(verdicts_of.values()), verdicts_of


def test_the_kernels_refuse_what_is_unsound_or_broken():
    unsound = [[derivation(*steps), {"proofs": [proof] * len(steps)}] for steps, proof, _ in UNSOUND]
    pairs = [*BROKEN.values(), *unsound]
    for pair, verdicts_of in zip(pairs, accepted(list(map(compact, pairs))), strict=True):
        assert not any(verdicts_of.values()), (pair, verdicts_of)


def test_a_number_that_a_double_rounds_proves_nothing():
    """2⁵³ + 1 as a literal, of which JavaScript makes 2⁵³; a key twice; a whole number as 1.0."""
    text = compact(GOOD)
    literal = compact([derivation(show({"": 2**53 + 1}, "=")), {"proofs": [NOTHING]}])
    twice = text.replace('"x^2":"1"', '"x^2":"-1","x^2":"1"')
    float_ = text.replace('"version":1', '"version":1.0')
    escaped = text.replace('"x^2"', '"\\u0078^2"')
    deep = "[" * 10**5 + "]" * 10**5
    assert not any(any(each.values()) for each in accepted([literal, twice, float_, escaped, deep]))


def test_a_file_is_its_own_canonical_form():
    pair = {"sha256": "0", "statement": STATEMENT, "certificate": CERTIFICATE, "point": {}}
    data = {"version": 1, "theorem": "attack", "claims": [{"claim": "c", "statements": [pair]}]}
    for text in (
        json.dumps(data),
        canonical(data) + " ",
        canonical(data).replace('"version": 1,', '"version": 1, "version": 1,', 1),
        canonical(data | {"more": 1}),
        canonical(data | {"theorem": "another"}),
    ):
        assert verdicts(text, "attack")[0][0] == "the file"
    assert verdicts(canonical(data), "attack") == [("c", "its sha256 is another statement's")]
    long = derivation(("define", {"x": "1", "": "9" * 500}, {"new": "a"}), show({"a^20": "1"}, "="))
    assert "the two sides differ" in f"{kernel.check(long, {'proofs': [NOTHING]})}"
    assert "thousands of digits" in why_rejected(long, {"proofs": [NOTHING]})
    claim = data["claims"][0]
    for claims in ([], [claim, claim | {"claim": "d", "statements": []}], [claim, claim]):
        assert verdicts(canonical(data | {"claims": claims}), "attack")[0][0] == "the file"
    for text in ("", "[" * 10**5, "9" * 5000, "\udcff", canonical(data).replace('"c"', '"\udcff"')):
        assert verdicts(text, "attack")[0][0] == "the file"


def test_bytes_that_another_writer_would_write_are_no_certificates(tmp_path, monkeypatch, capsys):
    """For the grade as for `proofs.check`: line ends, a byte order mark, what is no UTF-8, an unknown key."""
    theorems = all_theorems()
    good = (FOLDER / "unit_length.json").read_bytes()
    monkeypatch.setattr(check, "FOLDER", tmp_path)
    monkeypatch.setattr(stored_file, "FOLDER", tmp_path)
    (tmp_path / "unit_length.json").write_bytes(good.replace(b'"-1"', b'"1"', 1))
    assert check.main([]) == 1 and "the two sides differ" in capsys.readouterr().out
    (tmp_path / "unit_length.json").write_bytes(good)
    assert check.main([]) == 0 and stored(theorems["unit_length"], theorems)
    key = good.replace(b'"theorem"', b'"trust": "me",\n "theorem"', 1)
    for bad in (good.replace(b"\n", b"\r\n"), b"\xef\xbb\xbf" + good, good + b"\xff", good[:-9], key, b""):
        (tmp_path / "unit_length.json").write_bytes(bad)
        assert check.main([]) == 1
        with pytest.raises(Stale, match="of its stored certificates"):
            stored(theorems["unit_length"], theorems)


def test_the_kernels_agree_on_what_is_broken_at_random():
    assert campaign(2000, seed=3) < 200
