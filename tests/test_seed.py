"""The page that the chapter came as: kept byte for byte, cut where claims stand, and each claim led to its verdict."""

import hashlib

import pytest

from book.ledger import BadLedger, load
from book.ledger.seed import SEED, parts

CAME_AS = "0b5c75ec28369cf84fd5b42540743ed677db525bb0fef30e5b35abe910c967f4"


def test_it_is_kept_as_it_came():
    assert hashlib.sha256(SEED.read_bytes()).hexdigest() == CAME_AS


def test_its_parts_are_the_whole_in_order_and_have_a_claim_each():
    found = parts()
    assert "".join(found.values()) == SEED.read_text(encoding="utf-8")
    assert list(found) == ["", *load().places]
    assert {f"seed:{place}" for place in found if place} == {claim.where for claim in load().claims if claim.of_seed}


def test_a_beginning_that_is_not_there_is_named(tmp_path):
    (tmp_path / "seed.txt").write_text("One. Two.")
    (tmp_path / "places.toml").write_text('[begins]\ns1 = "One"\ns2 = "Three"\n')
    with pytest.raises(BadLedger, match=r"s2: seed.txt has no 'Three' after s1"):
        parts(tmp_path)
