"""The page that the chapter came as: kept byte for byte, cut where claims stand, and each claim led to its verdict."""

import ast
import hashlib
import textwrap

from book.ledger.entries import load
from book.ledger.seed import SEED, parts

CAME_AS = "0b5c75ec28369cf84fd5b42540743ed677db525bb0fef30e5b35abe910c967f4"


def test_it_is_kept_as_it_came():
    assert hashlib.sha256(SEED.read_bytes()).hexdigest() == CAME_AS


def test_the_front_page_and_the_citation_name_its_authors():
    front, citation = ((SEED.parents[1] / name).read_text("utf-8") for name in ("index.md", "../CITATION.cff"))
    for name in ("Dr. L. Van Warren", "Kimi K3"):
        (role,) = (line.split(" — ")[1] for line in parts()[""].splitlines() if line.startswith(f"{name} — "))
        assert f"**{name}**, {role}" in front and f"- name: {name}\n" in citation
        assert f"{name}: {role}" in " ".join(citation.split())


def test_its_parts_are_the_whole_in_order_and_have_a_claim_each():
    found = parts()
    assert "".join(found.values()) == SEED.read_text("utf-8")
    assert list(found) == ["", *load().places]
    assert {f"seed:{place}" for place in found if place} == {claim.where for claim in load().claims if claim.of_seed}


def program(cell):
    """The printed program of a cell."""
    return parts()[cell].split("paste into colab.new → Run\n")[1]


def test_the_first_table_of_cell_5_prints_three_blank_lines(capsys):
    """The loop is run as printed, in a fresh namespace, on a function of β in place of the image."""
    code = program("cell5")
    loop = code[code.index("prev = None") : code.index("fd_fine =")]
    exec(loop, {"I_of_beta": lambda beta: beta**3})
    assert capsys.readouterr().out == "\n\n\n"
    exec(loop, {"I_of_beta": lambda beta: beta**3, "fd_fine": 3 * 0.35**2})
    assert capsys.readouterr().out.count("error ratio") == 3  # with the reference at hand there would be a table


def test_the_loop_of_cell_7_draws_one_number_20000_times_and_uses_none():
    code = program("cell7")
    begin = code.index("pole_px = 0")
    loop, rest = code[begin : code.index("import numpy as np")], code[code.index("import numpy as np") :]
    tree = ast.parse(textwrap.dedent(loop))
    assert "range(20000)" in loop and "if False else np.random.default_rng(2).random()" in loop
    kept = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    used = {node.id for node in ast.walk(ast.parse(rest)) if isinstance(node, ast.Name)}
    assert kept == {"pole_px", "_", "th"} and not kept & used
