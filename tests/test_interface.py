"""Docstrings: everything public has an example that runs, and an entry on the pages made of them, as plain text."""

import doctest
import gc

import pytest
from sphinx.util.inventory import InventoryFile

import renderer
from proofs.engine.certificate import prove
from proofs.formulas.height_fields import HeightField
from proofs.theorems import language
from renderer.scene import methods

OF_ENGINE = [part for part in vars(language).values() if callable(part) and part.__module__.startswith("proofs.engine")]
PUBLIC = [*(getattr(renderer, name) for name in (*renderer.__all__, "HeightField")), HeightField]
PUBLIC += [prove, methods, *OF_ENGINE]

PLACES = {"api-renderer.html", "api-proofs.html", "api-verify.html"}
OTHERS = {
    "proofs.engine.program.Program",
    "proofs.formulas.height_fields.HeightField",
    "proofs.engine.claim.Claim",
    "proofs.engine.theorem.Theorem",
    "verify.checkers.proof_checker.examine",
    "verify.evaluate.balls.Balls",
}


def test_everything_public_has_an_entry_made_of_plain_text(site, html_of):
    with (site / "objects.inv").open("rb") as stream:
        inventory = InventoryFile.load(stream, "", lambda base, name: name)
    entries = {name: entry for kind in inventory if kind.startswith("py:") for name, entry in inventory[kind].items()}
    public = {f"{getattr(renderer, name).__module__}.{name}" for name in renderer.__all__}
    assert public | OTHERS <= entries.keys()
    assert {entry[2].partition("#")[0] for entry in entries.values()} == PLACES
    page = html_of("api-renderer")
    assert "<p>Return |∇h| on sphere A" in page and "crop: (left, top, width, height)" in page


@pytest.mark.parametrize("public", PUBLIC, ids=lambda public: public.__name__)
def test_the_examples_of_everything_public_run(public):
    (examples,) = doctest.DocTestFinder(recurse=False).find(public, public.__name__)
    assert examples.examples
    gc.collect()  # Python's checkcache walks over the sources that lambdify removes when its functions are collected
    assert doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(examples).failed == 0
