"""The Sphinx extension of a book whose theorems are checked, and of what else a project names as its directives.

`{chapter-figure} ID`      a figure, its caption and its provenance (figures.py)
`{number}` roles           a number from a figure or a benchmark, printed with a format (numbers.py)
`{benchmark-label} NAME`   where and when a benchmark was measured (numbers.py)
`{theorem} ID`             a theorem's card; {theorem-ref}`ID` refers to it (cards.py)
`{all-theorems}` …         every theorem by section, and what the grades mean (cards.py)
`{check-all}`              what checks every certificate in the reader's browser (cards.py, checker.py)
`{dependencies}`           what rests on what (cards.py)
`{ledger-entries}` …       the ledger of claims: entries, tables, figures of merit (ledger.py)
`{source-link}` …          sources as pages, theorems as downloads (listings.py)
section ids                `(s1)=` before a heading puts s1 on the section itself (pages.py)
`{notebook} NAME`          where a cell's notebook is; all of them as downloads (notebooks.py)
docstrings                 autodoc reads them as plain text (interface.py)
a cell's output            joined before it is merged (pages.py)
screen readers             lists and tables that they understand (scripts.py)
a sentence found           shown by the search, with its section (search.py)
formulas                   typeset as MathML when the book is built (mathematics.py)
the theme                  its style sheets without what no page uses (styles.py), what a page may load (scripts.py)
the simulator              compiled into the site (pages.py)
"""

import pkgutil
from importlib import import_module

from sphinx.application import Sphinx

from proofs.engine.project import PROJECT


def setup(app: Sphinx) -> dict[str, str | bool]:
    """Import every part, and give Sphinx what they have registered."""
    from book.extension import elements, mathematics  # what imports a module of this package does not import all

    for name in (*(part.name for part in pkgutil.iter_modules(__path__, f"{__name__}.")), *PROJECT.directives):
        import_module(name)
    app.setup_extension("sphinx.ext.autodoc")
    app.add_node(elements.Filled, html=(lambda translator, node: None, lambda translator, node: None))
    app.add_node(elements.Formula, html=(mathematics.write, None))
    app.add_html_math_renderer("mathml", (mathematics.write, None), (mathematics.write, None))
    for method, *arguments in elements.REGISTERED:
        getattr(app, method)(*arguments)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
