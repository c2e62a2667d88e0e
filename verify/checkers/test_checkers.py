"""The checkers: what the kernels must refuse, in statements, in certificates and in files; and what they accept."""

import json
from pathlib import Path

import pytest

from proofs import check
from proofs.check import FOLDER, canonical, verdicts
from proofs.engine import kernel
from proofs.engine import stored as stored_file
from proofs.engine.stored import Stale, stored
from proofs.engine.theorem import all_theorems
from verify.checkers.breakages import campaign
from verify.checkers.kernels import accepted, compact
from verify.checkers.known_bad import (
    BROKEN,
    BY_FIRST_FACT,
    CERTIFICATE,
    EMPTY_INDUCTION,
    GOOD,
    NOTHING,
    STATEMENT,
    UNSOUND,
    WELL_FORMED,
    assume,
    derivation,
    pair_of,
    refutation,
    show,
    wrong_verdicts,
)
from verify.checkers.proof_checker import why_rejected


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
    pairs = [*BROKEN.values(), *(pair_of(steps, proof) for steps, proof, _ in UNSOUND)]
    for pair, verdicts_of in zip(pairs, accepted(list(map(compact, pairs))), strict=True):
        assert not any(verdicts_of.values()), (pair, verdicts_of)


WEAKENED = {
    "the sign of a coefficient": 'and exact(coefficient) >= 0, "may be negative"',
    "a strict fact": 'require(all(r in (">", "!=") for _, r in strict), "a fact is not strict")',
    "the difference": 'require(not p, "the two sides differ", p)',
    "an equation": """require(facts[index][1] == "=", f"fact {index} is not an equation")""",
    "a closed set": "closed and ",
    "the circle": """require(add(*(multiply(1, p, p) for p in pair)) == multiply(1), f"{name} is off the circle")""",
    "the conclusion": """require(statement["steps"][-1]["step"] == "show", "there is no last goal")""",
}


@pytest.mark.parametrize("rule", WEAKENED)
def test_a_run_tells_a_weakened_kernel(rule):
    text = Path(kernel.__file__).read_text("utf-8")
    assert text.count(WEAKENED[rule]) == 1
    weak = {"__name__": "weak"}
    exec(text.replace(WEAKENED[rule], "" if rule in ("the sign of a coefficient", "a closed set") else "pass"), weak)
    assert wrong_verdicts({"the kernel": kernel.check}) == []
    assert wrong_verdicts({"the weak one": weak["check"]})


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
