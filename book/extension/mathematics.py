"""Formulas as MathML, typeset by the packaged MathJax when the book is built: no page loads it.

What runs it is the Node that Playwright's wheel brings, so that a machine needs none of its own. What a formula has
become is kept with what Sphinx knows of the pages: an edited page typesets its new formulas alone.
"""

import json
import subprocess
from collections.abc import Iterable
from importlib.resources import as_file, files
from pathlib import Path
from xml.etree import ElementTree

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.writers.html5 import HTML5Translator

from book.extension.elements import TEMPLATES, Formula, on
from book.extension.font import write_font
from book.extension.presentation import compact

Set = tuple[str, bool]  # a formula in TeX, and whether it is displayed


def typeset(formulas: list[Set]) -> list[str]:
    """Each formula as MathML, with its TeX beside it for who copies it; raises ValueError for what is no TeX."""
    from playwright._impl._driver import compute_driver_executable

    node, _ = compute_driver_executable()
    with as_file(files("mathjax") / "static" / "mathjax" / "es5") as folder:
        command = [node, str(Path(__file__).with_suffix(".js")), str(folder)]
        done = subprocess.run(command, input=json.dumps(formulas), capture_output=True, text=True, encoding="utf-8")
    if done.returncode:
        raise ValueError(f"MathJax could not typeset a formula: {done.stderr.strip()}")
    found = json.loads(done.stdout)
    return [compact(ElementTree.fromstring(text), tex) for text, (tex, _) in zip(found, formulas, strict=True)]


def mathml(environment: BuildEnvironment, wanted: Iterable[Set]) -> dict[Set, str]:
    """What is kept of formulas, with those that are wanted, typeset together where they are new."""
    kept = environment.__dict__.setdefault("chapter_formulas", {})
    if new := [*dict.fromkeys(formula for formula in wanted if formula not in kept)]:
        kept.update(zip(new, typeset(new), strict=True))
    return kept


def read(node: nodes.Element) -> Set:
    """A node's formula."""
    tex = node["tex"] if isinstance(node, Formula) else node.astext()
    return tex.strip(), isinstance(node, nodes.math_block)


def formulas_of(document: nodes.document) -> Iterable[Set]:
    return map(read, document.findall(lambda node: isinstance(node, nodes.math | nodes.math_block | Formula)))


@on("doctree-read")
def keep_formulas(app: Sphinx, document: nodes.document) -> None:
    app.env.metadata[app.env.docname]["formulas"] = list(formulas_of(document))


@on("env-updated", priority=100)
def typeset_all(app: Sphinx, environment: BuildEnvironment) -> None:
    """Typeset every formula of the book in one run, before pages are written side by side, and write their font."""
    if app.builder.format == "html":
        pages = [environment.metadata[name]["formulas"] for name in sorted(environment.found_docs)]
        wanted = dict.fromkeys(formula for page in pages for formula in page)
        kept = mathml(environment, wanted)
        write_font([kept[formula] for formula in wanted], Path(app.outdir) / "_static" / "formulas.woff")


def write(translator: HTML5Translator, node: nodes.Element) -> None:
    """Write a formula, a displayed one in a box that scrolls where it is too wide."""
    formula = read(node)
    text = mathml(translator.builder.env, [formula])[formula]
    translator.body.append(f'<div class="math">{text}</div>\n' if formula[1] else text)
    raise nodes.SkipNode


@on("config-inited", priority=100)
def use_mathml(app: Sphinx, config: Config) -> None:
    config.html_math_renderer = "mathml"


TEMPLATES.globals.update(formula=lambda tex: Formula(tex=tex))
