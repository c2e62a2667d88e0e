"""The seed as a page: quoted as it came, and under each place the verdicts on what is claimed there.

:::{seed}
:::
"""

import re

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

from book.extension.elements import Nodes, directive, filled, raw, section
from book.extension.ledger import Entries
from book.extension.notebooks import links
from book.ledger.seed import RUN, parts
from book.notebooks.laboratory import SIDE, seed_prints
from verify.benchmark.baselines.seed_loops import seed_cells

HEADING = re.compile(r"^(§\d · .+|🐍 .+)$", re.M)
DISPLAYED = re.compile(r" *\$\$(.+?)\$\$ *")
LINES = re.compile(r"(?<=\S)\n(?=\S)")  # lines of one block, as on the front and in the table of §6


@directive("seed")
def seed(here: SphinxDirective) -> Nodes:
    """The whole of it, in sections."""
    book = Entries(here)
    claims = [claim for claim in book.ledger.sorted_by_place() if claim.of_seed]
    found = [nodes.container(classes=["seed"])]
    for place, text in parts().items():
        stand, name = [claim for claim in claims if claim.where == f"seed:{place}"], f"seed-{place.replace('.', '-')}"
        verdicts = [filled("seed_claims", book=book, claims=stand, id=name)]
        for piece in filter(str.strip, HEADING.split(text)):
            if HEADING.match(piece):
                found.append(section(piece, f"seed-part-{len(found)}", classes=["seed"]))
            else:
                found[-1] += [_quoted(here, piece, place), *verdicts]
                verdicts = []  # they stand under the first of its pieces
    return found


def _quoted(here: SphinxDirective, text: str, place: str) -> nodes.block_quote:
    """A piece of the text, its mathematics typeset; a program, mended, stays folded above what it prints."""
    words, run, _ = text.partition(RUN)
    words = DISPLAYED.sub(r"\n\n$$\n\1\n$$\n\n", LINES.sub("\\\\\n", words + run))
    quote = nodes.block_quote()
    here.state.nested_parse(StringList(words.splitlines()), here.content_offset, quote)
    if run:
        number = int(place.removeprefix("cell"))
        program, prints = seed_cells()[number - 1], seed_prints()[number - 1].strip()
        code = nodes.literal_block(program, program, language="python3", ids=[f"seed{number}"])
        quote += [raw("<details><summary>The program</summary>"), code, raw("</details>")]
        quote += links(here, f"seed{number}", f"the seed's Cell {number}", f"#seed{number} pre")
        says = nodes.paragraph("", f"It prints, with pictures of {SIDE}²:")
        quote += [says, nodes.literal_block(prints, prints, language="none")]
    return quote
