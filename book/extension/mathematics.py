"""Formulas as MathML, typeset by the packaged MathJax when the book is built: no page loads it; and their font.

What runs it is the Node that Playwright's wheel brings, so that a machine needs none of its own. What a formula has
become is kept with what Sphinx knows of the pages: an edited page typesets its new formulas alone. The font is STIX Two
Math from a package, with no more letters than the formulas have.
"""

import html
import json
import re
import subprocess
import unicodedata
from collections.abc import Iterable
from importlib.resources import as_file, files
from importlib.util import find_spec
from pathlib import Path
from xml.etree import ElementTree

from docutils import nodes
from fontTools import subset
from fontTools.ttLib import TTFont
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.writers.html5 import HTML5Translator

from book.extension.elements import TEMPLATES, Formula, on
from book.extension.presentation import compact

ITALIC = [0x210E, *range(0x1D434, 0x1D468), *range(0x1D6E2, 0x1D71C)]  # where Unicode keeps the slanted letters
# What fraktur, hints for screens of a low resolution and the rest would be for no formula has.
OPTIONS = {"layout_features": ["ssty", "math", "dtls", "flac", "ccmp"], "hinting": False, "flavor": "woff"}
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


@on("doctree-read")
def keep_formulas(app: Sphinx, document: nodes.document) -> None:
    found = document.findall(lambda node: isinstance(node, nodes.math | nodes.math_block | Formula))
    app.env.metadata[app.env.docname]["formulas"] = [*map(read, found)]


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


def write_font(formulas: Iterable[str], place: Path) -> None:
    """Write the font for formulas as MathML, in which a letter that stands alone is slanted."""
    letters = {"√"} | set(html.unescape(re.sub(r"<annotation.*?</annotation>|<[^>]+>", "", "".join(formulas))))
    plain = {unicodedata.normalize("NFKC", letter) for letter in letters}
    slanted = {code for code in ITALIC if unicodedata.normalize("NFKC", chr(code)) in plain}
    options = subset.Options(**OPTIONS)
    options.drop_tables.append("GPOS")
    (package,) = find_spec("ziamath").submodule_search_locations
    font = subset.load_font(Path(package, "fonts", "STIXTwoMath-Regular.ttf"), options)
    narrow_roots(font)
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=[ord(letter) for letter in letters] + [*slanted])
    subsetter.subset(font)
    place.parent.mkdir(parents=True, exist_ok=True)
    subset.save_font(font, place, options)


def narrow_roots(font: TTFont) -> None:
    """Make the signs of tall roots as narrow as that of a low one: Chromium keeps the widest's room beside each."""
    root = font.getBestCmap()[ord("√")]
    table, widths = font["MATH"].table.MathVariants, font["hmtx"]
    tall = table.VertGlyphConstruction[table.VertGlyphCoverage.glyphs.index(root)]
    parts = [part.glyph for part in tall.GlyphAssembly.PartRecords]
    for name in {variant.VariantGlyph for variant in tall.MathGlyphVariantRecord} | {*parts}:
        share = widths[root][0] / widths[name][0]
        glyph = font["glyf"][name]
        glyph.coordinates.scale((share, 1))
        glyph.coordinates.toInt()
        glyph.recalcBounds(font["glyf"])
        widths[name] = (widths[root][0], glyph.xMin)


TEMPLATES.globals.update(formula=lambda tex: Formula(tex=tex))
