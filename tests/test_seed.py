"""The page that the chapter came as: kept byte for byte, cut where claims stand, and each claim led to its verdict."""

import ast
import hashlib
import re
import textwrap
from itertools import chain

from book.assembly.stamps import table_in
from book.ledger.entries import FOLDER, load
from book.ledger.seed import RUN, SEED, parts
from verify.benchmark.baselines.seed_loops import seed_cells

CAME_AS = "0b5c75ec28369cf84fd5b42540743ed677db525bb0fef30e5b35abe910c967f4"


def test_it_is_kept_as_it_came():
    assert hashlib.sha256(SEED.read_bytes()).hexdigest() == CAME_AS


def test_its_parts_are_the_whole_in_order():
    pieces = parts()
    assert "".join(pieces.values()) == SEED.read_text("utf-8")
    assert list(pieces) == [*load().places]


def test_the_page_has_every_program_with_one_line_mended_and_what_holds_first(page_of):
    page = page_of("seed")
    assert page.get_text().count(RUN.strip()) == SEED.read_text("utf-8").count(RUN)
    programs = [block.get_text().strip() for block in page.select(".highlight-python3 pre")]
    assert programs == [cell.strip() for cell in seed_cells()]
    for verdicts in page.select("[id^=seed-]"):
        heads = [head.get_text() for head in verdicts.select(":scope > .seed-verdict")]
        assert heads == sorted(heads, key=("Holds", "Corrected here", "Not checked here").index)


HOLE = re.compile(r"\$+[^$]*\$+|\{[^}]*\}|\\n")  # formulas, and what a program puts between its words
NOTE = re.compile(r'"{3}(.*?)"{3}|# ([^\n]*)|"([^"\n]*)"', re.S)  # a program's words
CLAUSE = re.compile(r"[.!?;:]\s|\s--\s|[()—∎]|\n\n")


def fours(text):
    """Every four words in a row."""
    words = re.findall(r"\w+", HOLE.sub("", text))
    return {*re.findall(r"(?=\b(\w+ \w+ \w+ \w+))", " ".join(words))}


def unquoted(texts, claims):
    """The clauses, of four words at least, of which no claim at their place quotes four words in a row."""
    for place, text in texts.items():
        quoted = fours(" _ ".join(claim.words for claim in claims if claim.where == f"seed:{place}"))
        words, _, program = text.partition(RUN)
        for clause in CLAUSE.split(HOLE.sub("", " ".join((words, *map("".join, NOTE.findall(program)))))):
            if (runs := fours(clause)) and not runs & quoted:
                yield " ".join(clause.split())


def test_each_clause_is_quoted_by_a_claim_or_listed():
    claims, lists = load().claims, table_in(FOLDER / "unclaimed.toml")
    assert lists.keys() - {claim.id for claim in claims} == {"nothing"}
    listed = {*chain(*lists.values())}
    assert {*unquoted(parts(), claims)} == listed
    new = "Nobody entered this sentence."
    assert {*unquoted(parts() | {"s8": new}, claims)} ^ listed >= {new, "it was worth the wait"}


def program(cell):
    """The printed program of a cell."""
    return parts()[cell].split(RUN)[1]


def test_what_is_said_of_cells_1_and_7_is_not_in_their_programs():
    assert "math.sqrt(dsc)" in program("cell1") and "plt" not in program("cell7")


def test_the_first_table_of_cell_5_prints_blank_lines_and_run_again_zeros(capsys):
    """The loop is run as printed, in a fresh namespace, on a function of β in place of the image."""
    code = program("cell5")
    loop = code[code.index("prev = None") : code.index("fd_fine =")]
    exec(loop, {"I_of_beta": lambda beta: beta**3})
    assert capsys.readouterr().out == "\n\n\n"
    exec(loop, {"I_of_beta": lambda beta: beta**3, "fd_fine": 3 * 0.35**2})
    assert (
        capsys.readouterr().out.count("previous: 0.0") == 3
    )  # with the reference at hand: this error over the previous one, upside down


def test_the_loop_of_cell_7_draws_one_number_20000_times_and_uses_none():
    code = program("cell7")
    begin = code.index("pole_px = 0")
    loop, rest = code[begin : code.index("import numpy as np")], code[code.index("import numpy as np") :]
    tree = ast.parse(textwrap.dedent(loop))
    assert "range(20000)" in loop and "if False else np.random.default_rng(2).random()" in loop
    assigned = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    used = {node.id for node in ast.walk(ast.parse(rest)) if isinstance(node, ast.Name)}
    assert assigned == {"pole_px", "_", "th"} and not assigned & used
