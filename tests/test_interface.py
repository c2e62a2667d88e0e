"""The pages made from docstrings: everything public is on them, and docstrings are read as plain text."""

import runpy

from sphinx.util.inventory import InventoryFile

import renderer
from book.extension.interface import names_of, restructured

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


def test_everything_public_has_an_entry(site):
    with (site / "objects.inv").open("rb") as stream:
        found = InventoryFile.load(stream, "", lambda base, name: name)
    entries = {name: entry for kind in found if kind.startswith("py:") for name, entry in found[kind].items()}
    public = {f"{getattr(renderer, name).__module__}.{name}" for name in renderer.__all__}
    assert public | OTHERS <= entries.keys()
    assert {entry[2].partition("#")[0] for entry in entries.values()} == PLACES


def test_type_checkers_are_told_the_same_names(monkeypatch):
    monkeypatch.setattr("typing.TYPE_CHECKING", True)
    told = runpy.run_path(renderer.__file__)
    assert all(told[name] is getattr(renderer, name) for name in renderer._HOMES)


def test_a_docstring_is_plain_text_with_listings_and_named_arguments():
    def drawn(size, step_u):
        pass

    text = "|k_u| ≤ 2²⁰, a * b and `a * b`.\n\n    python -m x\n\nDraw. size, step_u: pixels. Note: none. size: again."
    assert restructured(text.splitlines(), names_of(drawn)) == [
        "\\|k\\_u\\| ≤ 2²⁰, a \\* b and ``a * b``.",
        *("", "::", "", "    python -m x", ""),
        "Draw. **size, step\\_u**: pixels. Note: none. **size**: again.",
        "",
    ]
