"""The checkers: what the kernels must refuse, in statements, in certificates and in files; and what they accept."""

import json
from pathlib import Path

import pytest

from proofs import check
from proofs.check import FOLDER, canonical
from proofs.engine import kernel, stored
from proofs.engine.theorem import all_theorems
from verify.checkers.breakages import campaign
from verify.checkers.kernels import accepted, compact
from verify.checkers.known_bad import (
    BROKEN,
    BY_FIRST_FACT,
    GOOD,
    NOTHING,
    UNSOUND,
    WELL_FORMED,
    assume,
    derivation,
    pair_of,
    show,
    wrong_verdicts,
)


def of_a_hundred_digits(off):
    """Return a product of fractions, which is true where it is off by no unit."""
    of, proof = {"x": f"{3**200}/{2**100}", "": "1/3"}, {"rule": "ideal", "cofactors": [[0, {"x": "7/11"}]]}
    product = {"x^2": f"{7 * 3**200 + off}/{11 * 2**100}", "x": "7/33"}
    return pair_of([assume(of, "="), show(product, "=")], proof)


def test_the_kernels_accept_what_is_well_formed():
    """A name may be one that every object of JavaScript has."""
    pairs = [*WELL_FORMED, of_a_hundred_digits(off=0)]
    for name in ("constructor", "toString", "hasOwnProperty", "cos(constructor)"):
        steps = assume({name: "1"}, "="), show({name: "1"}, "=")
        pairs.append([derivation(*steps, variables=[name]), {"proofs": [BY_FIRST_FACT]}])
    for pair, verdicts_of in zip(pairs, accepted(list(map(compact, pairs))), strict=True):
        assert all(verdicts_of.values()), (pair, verdicts_of)


def test_the_kernels_refuse_what_is_unsound_or_broken():
    """And a number that a double rounds, 2⁵³ + 1 as a literal; a key twice; a whole number as 1.0."""
    pairs = [*BROKEN.values(), *(pair_of(steps, proof) for steps, proof, _ in UNSOUND)]
    pairs += [[derivation(show({"": 2**53 + 1}, "=")), {"proofs": [NOTHING]}], of_a_hundred_digits(off=2)]
    pairs += [[GOOD[0] | unknown, GOOD[1]] for unknown in ({"version": 2}, {"kind": "constructor"})]
    texts, good = [*map(compact, pairs), "[" * 10**5 + "]" * 10**5], compact(GOOD)
    for was, bad in (('"x^2":"1"', '"x^2":"-1","x^2":"1"'), ('"x^2"', '"\\u0078^2"'), ('"version":1', '"version":1.0')):
        texts.append(good.replace(was, bad))
    for text, verdicts_of in zip(texts, accepted(texts), strict=True):
        assert not any(verdicts_of.values()), (text, verdicts_of)


WEAKENED = {
    "the sign of a coefficient": (" and exact(coefficient) >= 0", ""),
    "a closed set": ("closed and ", ""),
    "a strict fact": ('require(all(r in (">", "!=") for _, r in strict), "a fact is not strict")', "pass"),
    "the difference": ('require(not p, "the two sides differ", p)', "pass"),
    "an equation": ("""require(facts[index][1] == "=", f"fact {index} is not an equation")""", "pass"),
    "the circle": ("require(add(*(multiply(1, p, p) for p in pair)) == multiply(1), ", "(True, "),
    "the conclusion": ("""require(statement["steps"][-1]["step"] == "show", "there is no last goal")""", "pass"),
}


def test_a_run_tells_a_weakened_kernel():
    """That the kernel as it stands gives no wrong verdict, each run of the theorems begins with."""
    text, weak = Path(kernel.__file__).read_text("utf-8"), {}
    for rule, (strong, weaker) in WEAKENED.items():
        assert text.count(strong) == 1
        names = {"__name__": "weak"}
        exec(text.replace(strong, weaker), names)
        weak[rule] = names["check"]
    assert {wrong.partition(" accepts ")[0] for wrong in wrong_verdicts(weak)} == WEAKENED.keys()


def test_a_case_that_cannot_occur_is_no_claim():
    """Of |x| < 0 no case can occur: each is proved impossible, and the claim is refused."""
    absurd = derivation(assume({"x": "1"}, ">"), assume({"x": "-1"}, ">"), show({"": "1"}, "="), variables=["x"])
    proof = {"rule": "contradiction", "positive": [0], "sum": [["1", {"": "1"}, [1]]], "cofactors": []}
    case = absurd, {"proofs": [proof]}, None
    assert check.reasons([case, case]) == ["its hypotheses contradict each other"] * 2
    assert check.reasons([case, (*GOOD, {})]) == [None, None]


GOOD_FILE = (FOLDER / "unit_length.json").read_bytes()
DATA = json.loads(GOOD_FILE)
FIRST = DATA["claims"][0]
REFUSED_FILES = [
    *(GOOD_FILE.replace(b"\n", end) for end in (b"\r\n", b"")),
    *(b"\xef\xbb\xbf" + GOOD_FILE, GOOD_FILE + b"\xff", GOOD_FILE[:-9], b"", b"[" * 10**5),
    GOOD_FILE.replace(b'"version": 1,', b'"version": 1,\n "version": 1,', 1),
    *(
        canonical(DATA | changed).encode()
        for changed in (
            {"more": 1},
            {"theorem": "another"},
            {"claims": []},
            {"claims": [FIRST, FIRST | {"claim": "empty", "statements": []}]},
            {"claims": [FIRST, FIRST]},
        )
    ),
]


def test_bytes_that_another_writer_would_write_are_no_certificates(tmp_path, monkeypatch, capsys):
    """For the grade as for `proofs.check`: a file is its own canonical form."""
    theorems, path = all_theorems(), tmp_path / "unit_length.json"
    monkeypatch.setattr(check, "FOLDER", tmp_path)
    monkeypatch.setattr(stored, "FOLDER", tmp_path)
    for was, false, why in ((b'"-1"', b'"1"', "two sides differ"), (b'256": "', b'256": "0', "is another statement's")):
        path.write_bytes(GOOD_FILE.replace(was, false, 1))
        assert check.main([]) == 1 and why in capsys.readouterr().out
    for bad in REFUSED_FILES:
        path.write_bytes(bad)
        assert check.main([]) == 1 and "the file: " in capsys.readouterr().out
        with pytest.raises(stored.Stale, match="of its stored certificates"):
            stored.stored(theorems["unit_length"], theorems)
    assert check.main(["nothing"]) == 2 and "nothing" in capsys.readouterr().err


def test_the_schema_is_the_form_that_the_kernel_asks_for():
    """But for what no regular expression says: lowest terms, and names that differ. Every stored file has it."""
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((FOLDER.parent / "certificates.schema.json").read_text("utf-8"))
    validator = jsonschema.Draft202012Validator(schema)

    def has_the_form(statement, certificate):
        pair = {"sha256": "0" * 64, "statement": statement, "certificate": certificate, "point": {}}
        claims = [{"claim": "c", "statements": [pair]}]
        return validator.is_valid({"version": 1, "theorem": "t", "claims": claims})

    for path in FOLDER.glob("*.json"):
        validator.validate(json.loads(path.read_text("utf-8")))
    assert has_the_form(*GOOD)
    formless = [name for name, pair in BROKEN.items() if "'s form" in str(kernel.check(*pair))]
    assert [name for name in formless if has_the_form(*BROKEN[name])] == ["the coefficient '2/2'", "the monomial 'x x'"]


def test_the_kernels_agree_on_what_is_broken_at_random():
    assert campaign(2000, seed=3) < 200
