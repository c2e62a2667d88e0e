"""Formulas as MathML, set by math-core when the book is built: no page loads anything but their font for them."""

import html
import re

from docutils import nodes
from math_core import LatexError, LatexToMathML
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.util import logging
from sphinx.writers.html5 import HTML5Translator

from book.extension.elements import TEMPLATES, Formula, on

ELLIPSIS = {"ldots": "…", "dots": "…"}  # one sign: three full stops are read out as such
CONVERTER = LatexToMathML(fancy_error=False, macros=ELLIPSIS)
NAME = re.compile(r"<mrow><mspace/>(<mi[^>]*>[^<]*</mi>)</mrow>")  # of letters: what is around it makes no difference
LOGGER = logging.getLogger(__name__)


def typeset(tex: str, displayed: bool = False) -> str:
    """Return a formula as MathML, its TeX beside it for who copies it; raises LatexError for what is no TeX."""
    text = NAME.sub(r"\1", CONVERTER.convert_with_local_state(tex, displaystyle=displayed))
    text = text.replace("&ApplyFunction;", "\N{FUNCTION APPLICATION}")
    return text.replace("<math", f'<math data-tex="{html.escape(tex)}"', 1)


def write(translator: HTML5Translator, node: nodes.Element) -> None:
    """Write a formula, a displayed one in a box that scrolls where it is too wide."""
    tex = (node["tex"] if isinstance(node, Formula) else node.astext()).strip()
    try:
        text = typeset(tex, displayed := isinstance(node, nodes.math_block))
        translator.body.append(f'<div class="math">{text}</div>\n' if displayed else text)
    except LatexError as error:
        LOGGER.warning("%s is no formula: %s", tex, error, location=node)
    raise nodes.SkipNode


@on("config-inited", priority=100)
def use_mathml(app: Sphinx, config: Config) -> None:
    config.html_math_renderer = "mathml"


TEMPLATES.globals.update(formula=lambda tex: Formula(tex=tex))
