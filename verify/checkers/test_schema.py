"""The JSON schema of certificates: every stored file has its form, and what the kernels refuse for its form has not."""

import json

import pytest

from proofs.check import FOLDER
from verify.checkers.known_bad import BROKEN, GOOD

jsonschema = pytest.importorskip("jsonschema")
SCHEMA = json.loads((FOLDER.parent / "certificates.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
OF_MEANING = {
    "inverse 'x'",
    "a proof left over",
    "no steps",
    "no show",
    "x > 0, as x ≥ 0",
    "an assumption refuted",
    "a variable twice",
    "the monomial 'x x'",
    "the monomial 'z'",
    "the coefficient '2/2'",
    "the index 1",
    "pi as a coordinate",
    "off the circle",
    "a cosine alone",
    "a name too many",
    "x = n by induction",
    *(f"an induction with {base} and {step} proofs of a claim" for base, step in ((0, 0), (1, 0), (0, 1), (2, 2))),
    "its claim assumed",
    "a set that is not closed",
    "a name to avoid",
    "no counterexample at x = -1",
    "no counterexample at x = 1",
    "no point",
    "0 ≥ 0 refuted",
    "version 1.0",
    "powers of powers, 998",
    "powers of powers, 999",
    "a large power at a point",
    "an induction over large powers",
}


def has_the_form(statement, certificate):
    """Return whether a pair has the schema's form."""
    pair = {"sha256": "0" * 64, "statement": statement, "certificate": certificate, "point": None}
    if isinstance(statement, dict) and statement["kind"] == "induction":
        pair["point"] = {}
    claims = [{"claim": "c", "statements": [pair]}]
    return VALIDATOR.is_valid({"version": 1, "theorem": "t", "claims": claims})


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.json")), ids=lambda path: path.stem)
def test_every_stored_file_has_the_form(path):
    VALIDATOR.validate(json.loads(path.read_text(encoding="utf-8")))


def test_the_schema_refuses_what_is_no_statement_and_no_certificate():
    assert has_the_form(*GOOD)
    assert {name for name, pair in BROKEN.items() if has_the_form(*pair)} <= OF_MEANING
