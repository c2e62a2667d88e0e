"""The pages made from docstrings: everything public is on them, and docstrings are read as plain text."""

from sphinx.util.inventory import InventoryFile

import renderer

PLACES = {"api-renderer.html", "api-proofs.html", "api-verify.html"}
OTHERS = {
    "proofs.engine.program.Program",
    "proofs.formulas.height_fields.HeightField",
    "proofs.engine.claim.Claim",
    "proofs.engine.theorem.Theorem",
    "verify.checkers.proof_checker.examine",
    "verify.evaluate.Reference",
    "verify.evaluate.balls.Balls",
}


def test_everything_public_has_an_entry_made_of_plain_text(site, html_of):
    with (site / "objects.inv").open("rb") as stream:
        found = InventoryFile.load(stream, "", lambda base, name: name)
    entries = {name: entry for kind in found if kind.startswith("py:") for name, entry in found[kind].items()}
    public = {f"{getattr(renderer, name).__module__}.{name}" for name in renderer.__all__}
    assert public | OTHERS <= entries.keys()
    assert {entry[2].partition("#")[0] for entry in entries.values()} == PLACES
    page = html_of("api-renderer")
    assert "<p>Return |∇h| on sphere A" in page and "crop: (left, top, width, height)" in page
