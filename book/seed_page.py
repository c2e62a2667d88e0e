"""The seed as a page: quoted as it came, and under each place the verdicts on what is claimed there.

:::{seed}
:::
"""

import os
import re
import subprocess
import sys
from functools import cache

from docutils import nodes
from docutils.statemachine import StringList
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell
from sphinx.util.docutils import SphinxDirective

from book.extension.elements import Nodes, directive, filled, raw, section
from book.extension.ledger import Entries
from book.extension.notebooks import ways_to_run
from book.ledger.seed import RUN, parts
from book.notebooks.laboratory import a_notebook
from verify.benchmark.baselines.seed_loops import seed_cells

HEADING = re.compile(r"^(§\d · .+|🐍 .+)$", re.M)
DISPLAYED = re.compile(r" *\$\$(.+?)\$\$ *")
LINES = re.compile(r"(?<=\S)\n(?=\S)")  # lines of one block, as on the front and in the table of §6

SIDE = 48  # pixels of the pictures that the page's run draws
DRAWN = re.compile(r"\b(256|128), \1\b")
TIME = re.compile(r"\d+\.\d+(?= ?s$)", re.M)


def notebooks() -> dict[str, NotebookNode]:
    """Return the eight cells with the one line mended, each after Cells 1 and 3, on which it builds."""
    cells = dict(enumerate(map(new_code_cell, seed_cells()), 1))
    before = {n: sorted({1, min(n, 3), n}) for n in cells}
    return {f"seed{n}": a_notebook(f"The seed's Cell {n}", [cells[k] for k in before[n]]) for n in cells}


@cache
def printed() -> list[str]:
    """Return the output of the cells when they are run in order, their pictures small and their times left out."""
    program = 'print("\\0")\n'.join(DRAWN.sub(f"{SIDE}, {SIDE}", f"{cell}\n") for cell in seed_cells())
    command = [sys.executable, "-X", "utf8", "-W", "ignore", "-c", program]
    run = subprocess.run(command, env=os.environ | {"MPLBACKEND": "agg"}, check=True, capture_output=True, text=True)
    return TIME.sub("…", run.stdout).split("\0\n")


@directive("seed")
def seed(here: SphinxDirective) -> Nodes:
    """Return the whole of it, in sections."""
    book = Entries(here)
    claims = [claim for claim in book.ledger.sorted_by_place() if claim.of_seed]
    children = [nodes.container(classes=["seed"])]
    for place, text in parts().items():
        stand, name = [claim for claim in claims if claim.where == f"seed:{place}"], f"seed-{place.replace('.', '-')}"
        verdicts = [filled("seed_claims", book=book, claims=stand, id=name)]
        for piece in filter(str.strip, HEADING.split(text)):
            if HEADING.match(piece):
                children.append(section(piece, f"seed-part-{len(children)}", classes=["seed"]))
            else:
                children[-1] += [_quoted(here, piece, place), *verdicts]
                verdicts = []  # they stand under the first of its pieces
    return children


def _quoted(here: SphinxDirective, text: str, place: str) -> nodes.block_quote:
    """Return a piece of the text, its mathematics typeset; a program, mended, stays folded above what it prints."""
    words, run, _ = text.partition(RUN)
    words = DISPLAYED.sub(r"\n\n$$\n\1\n$$\n\n", LINES.sub("\\\\\n", words + run))
    quote = nodes.block_quote()
    here.state.nested_parse(StringList(words.splitlines()), here.content_offset, quote)
    if run:
        number = int(place.removeprefix("cell"))
        program, prints = seed_cells()[number - 1], printed()[number - 1].strip()
        code = nodes.literal_block(program, program, language="python3", ids=[f"seed{number}"])
        quote += [raw("<details><summary>The program</summary>"), code, raw("</details>")]
        name = f"seed{number}"
        quote += ways_to_run(here, name, f"the seed's Cell {number}", notebooks()[name], f"#{name} pre")
        says = nodes.paragraph("", f"It prints, with pictures of {SIDE}²:")
        quote += [says, nodes.literal_block(prints, prints, language="none")]
    return quote
