"""The built site: ids, figures, alternative texts, numbers, and that nothing is loaded from elsewhere."""

import re
from collections import Counter
from pathlib import Path

from book.assembly import contents, stamps, website
from book.drawing import palette
from book.drawing.draw import all_figures
from book.editions.pages import parsed
from verify.evidence.sources import ROOT

PAGES = contents.page_files(ROOT / "book")
ANCHORS = {f"s{n}": f"s{n}" for n in range(1, 10)} | {"lab": "s5"}
ANCHORS |= {f"cell{n}": "s5" for n in range(1, 9)}


def placed():
    """Count how often pages place each figure."""
    first = [id for id, _ in contents.placed(ROOT / "book", "chapter-figure|idea|worked-pixel")]
    texts = (path.read_text("utf-8") for path in contents.page_files(ROOT / "book").values())
    return Counter([*first, *(id for text in texts for id in re.findall(r"^:wiper: (\w+),", text, re.MULTILINE))])


def test_sections_have_their_ids_figures_are_shown_and_every_image_says_what_it_shows(html_of):
    """Of the pages' images alone is HTML read: of all of it that takes long."""
    for id, page in ANCHORS.items():
        assert re.findall(rf'<(\w+)[^>]* id="{id}"', html_of(page)) == ["section"], id
    shown = Counter()
    for name in PAGES:
        images = "".join(re.findall("<img [^>]*>", html_of(name)))
        for image in parsed(images).select("img:not(.logo__image, .panel)"):
            source, alternative = image.get("src", ""), image.get("alt", "").strip()
            assert alternative, f"{name}: {source} has no alternative text"
            assert not re.search(r"_images|\.(svg|png)$", alternative), f"{name}: {alternative} is a file"
            shown[Path(source).stem] += source.startswith("_images/") and not source.endswith(".dark.svg")
    assert placed() and {id: shown[id] for id in placed()} == placed()
    drawn = {path.name.split(".")[0] for path in (ROOT / "book" / "_generated").glob("*.[sp][vn]g")}
    assert drawn == placed().keys() <= all_figures().keys()


def test_stylesheet_has_the_colours_of_the_plots_and_none_of_its_own_and_they_can_be_read():
    assert palette.CSS_FILE.read_text("utf-8") == palette.css(), "run python -m book.drawing.palette"
    style = (ROOT / "book" / "static" / "book.css").read_text("utf-8")
    assert re.findall(r"#[0-9a-fA-F]{3,8}\b|\brgba?\(", style) == []
    for mode, colours in palette.MODES.items():
        texts = [palette.readable(role, mode) for role in palette.ROLE]
        assert min(palette.contrast(text, colours["paper"]) for text in [*texts, colours["muted"]]) >= 4.5, mode


def test_second_build_does_nothing(site):
    index = website.INDEX.stat().st_mtime_ns
    website.build()
    assert website.INDEX.stat().st_mtime_ns == index
    assert stamps.read("site") == website.site_hashes() | website.built()
