"""The font of the formulas: STIX Two Math from a package, with no more letters than the book's formulas have."""

import html
import re
import unicodedata
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

ITALIC = [0x210E, *range(0x1D434, 0x1D468), *range(0x1D6E2, 0x1D71C)]  # where Unicode keeps the slanted letters
# What fraktur, hints for screens of a low resolution and the rest would be for no formula has.
OPTIONS = {"layout_features": ["ssty", "math", "dtls", "flac", "ccmp"], "hinting": False, "flavor": "woff"}


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
