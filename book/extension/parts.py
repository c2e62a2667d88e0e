"""Every part of the extension, imported, and what they have registered given to Sphinx."""

import pkgutil
from importlib import import_module

from sphinx.application import Sphinx

import book.extension
from book.extension import elements, mathematics


def setup(app: Sphinx) -> dict[str, str | bool]:
    """Register everything with Sphinx."""
    for part in pkgutil.iter_modules(book.extension.__path__, "book.extension."):
        import_module(part.name)
    app.setup_extension("sphinx.ext.autodoc")
    app.add_node(elements.Filled, html=(lambda translator, node: None, lambda translator, node: None))
    app.add_node(elements.Formula, html=(mathematics.write, None))
    app.add_html_math_renderer("mathml", (mathematics.write, None), (mathematics.write, None))
    for method, *given in elements.REGISTERED:
        getattr(app, method)(*given)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
