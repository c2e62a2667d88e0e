"""The pages made from docstrings: everything public is on them, and docstrings are read as plain text."""

import ast
from pathlib import Path

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
    places = {
        name: entry[2].partition("#")[0]
        for kind in found
        if kind.startswith("py:")
        for name, entry in found[kind].items()
    }
    public = {f"{getattr(renderer, name).__module__}.{name}" for name in renderer.__all__}
    assert public | OTHERS <= places.keys()
    assert set(places.values()) == PLACES


def test_type_checkers_are_told_the_same_names():
    tree = ast.parse(Path(renderer.__file__).read_text(encoding="utf-8"))
    (told,) = (node for node in tree.body if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING")
    homes = {alias.asname: f"{line.module}.{alias.name}" for line in told.body for alias in line.names}
    assert homes == {name: f"renderer.{home}.{name}" for name, home in renderer._HOMES.items()}


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
