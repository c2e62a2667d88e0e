"""Sphinx over a folder of a page or two, for the tests of the extension."""

import re
from io import StringIO
from unittest.mock import patch

from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace

from book.extension import pages

SETTINGS = {
    "extensions": ["myst_parser", "book.extension"],
    "myst_enable_extensions": ["colon_fence"],
    "numfig": True,
    "exclude_patterns": ["_build", "_generated", "figures"],
    # Said, because Sphinx keeps the parsers of a book built before in this process as its default.
    "source_suffix": {".md": "markdown"},
}


def build(folder, text):
    """Build a page of this text in `folder`, and leave nothing registered behind; its HTML, and the warnings."""
    (folder / "index.md").write_text(f"# Page\n\n{text}\n", "utf-8")
    out, warnings = folder / "_build", StringIO()
    with docutils_namespace(), patch.dict(pages.PROGRAMS, clear=True):  # what the simulator runs takes long to compile
        Sphinx(folder, None, out, out / "doctrees", "html", SETTINGS, None, warnings, freshenv=True).build()
    return (out / "index.html").read_text("utf-8"), warnings.getvalue()


def refused(folder, mistakes, more=""):
    """Build one page of mistakes, {what is written: what is said of it, a pattern}: each must be named by its line.

    more: what else stands on the page. Returns its HTML.
    """
    text = "\n\n".join([*mistakes, more])
    html, warnings = build(folder, text)
    for written, words in mistakes.items():
        line = 3 + text[: text.index(written)].count("\n")
        assert re.search(rf"index\.md:{line}:.*{words}", warnings), warnings
    return html
