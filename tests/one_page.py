"""Sphinx over a folder of a page or two, for the tests of the extension."""

from io import StringIO
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace

SETTINGS = {
    "extensions": ["myst_parser", "sphinx.ext.mathjax", "book.extension"],
    "myst_enable_extensions": ["colon_fence"],
    "numfig": True,
    "exclude_patterns": ["_generated", "figures"],
}


def build(folder: Path, out: Path, **settings) -> tuple[str, str]:
    """Build `folder` into `out`, and leave nothing registered behind; its index as HTML, and the warnings."""
    warnings = StringIO()
    with docutils_namespace():
        Sphinx(folder, None, out, out / "doctrees", "html", SETTINGS | settings, None, warnings, freshenv=True).build()
    return (out / "index.html").read_text(encoding="utf-8"), warnings.getvalue()
