"""The built site: ids, figures, alternative texts, numbers, and that nothing is loaded from elsewhere."""

import json
import os
import re
import subprocess
from collections import Counter
from pathlib import Path

import pytest
from bs4 import BeautifulSoup

from book.assembly import contents, stamps, website
from book.drawing import palette
from book.drawing.draw import all_figures
from verify.sources import ROOT

PAGES = contents.page_files(ROOT / "book")
ANCHORS = {f"s{n}": f"s{n}" for n in range(1, 10)} | {"sim": "s4", "lab": "s5"}
ANCHORS |= {f"cell{n}": "s5" for n in range(1, 9)}


@pytest.fixture(scope="session")
def pages(page_of) -> dict[str, BeautifulSoup]:
    """Every page of the table of contents."""
    return {page: page_of(page) for page in PAGES}


def placed() -> Counter:
    """How often pages place each figure."""
    first = [id for id, _ in contents.placed(ROOT / "book", "chapter-figure|idea|worked-pixel")]
    texts = (path.read_text(encoding="utf-8") for path in contents.page_files(ROOT / "book").values())
    return Counter([*first, *(id for text in texts for id in re.findall(r"^:wiper: (\w+),", text, re.MULTILINE))])


def test_sections_and_cells_carry_their_own_ids(pages):
    for id, page in ANCHORS.items():
        assert [element.name for element in pages[page].find_all(id=id)] == ["section"], id


def test_every_figure_that_pages_place_is_shown(pages):
    light = "img[src^='_images/']:not([src$='.dark.svg'])"
    shown = Counter(Path(image["src"]).stem for page in pages.values() for image in page.select(light))
    assert placed()
    assert {id: shown[id] for id in placed()} == placed()


def test_every_figure_with_a_picture_is_placed_and_registered():
    drawn = {path.name.split(".")[0] for path in (ROOT / "book" / "_generated").glob("*.[sp][vn]g")}
    assert drawn == placed().keys()
    assert drawn <= all_figures().keys()


def test_every_image_says_what_it_shows(pages):
    for name, page in pages.items():
        for image in page.select("img:not(.logo__image)"):
            alternative = image.get("alt", "").strip()
            assert alternative, f"{name}: {image.get('src')} has no alternative text"
            assert not re.search(r"_images|\.(svg|png)$", alternative), f"{name}: {alternative} is a file"


def test_site_names_no_folder_of_the_machine_that_built_it(site):
    for path in site.rglob("*"):
        if path.suffix in {".html", ".js", ".json", ".ipynb", ".svg", ".md"}:
            assert str(ROOT).encode() not in path.read_bytes(), path.name


def test_page_with_cells_offers_its_notebook(site, pages):
    notebook = json.loads((site / "_sources" / "s5.ipynb").read_text(encoding="utf-8"))
    assert [cell["id"] for cell in notebook["cells"]] == [f"cell-{n}" for n in range(len(notebook["cells"]))]
    assert sum(cell["cell_type"] == "code" for cell in notebook["cells"]) >= 8
    assert pages["s5"].select("a[href='_sources/s5.ipynb']") and not pages["s1"].select("a[href$='.ipynb']")


def test_stylesheet_has_the_colours_of_the_plots():
    assert palette.CSS_FILE.read_text(encoding="utf-8") == palette.css(), "run python -m book.drawing.palette"


def test_stylesheet_is_short_and_has_no_colour_of_its_own():
    lines = (ROOT / "book" / "static" / "book.css").read_text(encoding="utf-8").splitlines()
    assert len(lines) < 200
    own = [line for line in lines if re.search(r"#[0-9a-fA-F]{3,8}\b|\brgba?\(", line)]
    assert own == []


def test_text_in_a_role_colour_can_be_read():
    for mode, colours in palette.MODES.items():
        texts = [palette.readable(role, mode) for role in palette.ROLE]
        assert min(palette.contrast(text, colours["paper"]) for text in [*texts, colours["muted"]]) >= 4.5, mode


def test_second_build_does_nothing(site):
    index = website.INDEX.stat().st_mtime_ns
    website.build()
    assert website.INDEX.stat().st_mtime_ns == index
    assert stamps.read("site") == website.site_hashes()


def test_make_help_lists_every_target():
    shown = subprocess.run(["make", "help"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    phony = re.search(r"^\.PHONY: (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)[1].split()
    for target in phony:
        assert re.search(rf"^  make {target} +\S", shown, re.MULTILINE), target


def test_make_says_which_python_is_too_old(tmp_path):
    old = tmp_path / "old-python"
    old.write_text('#!/bin/sh\n[ "$1" = --version ] && echo "Python 3.9.2" && exit 0\nexit 1\n')
    old.chmod(0o755)
    (tmp_path / "Makefile").write_text((ROOT / "Makefile").read_text())
    clean = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    done = subprocess.run(["make", "book", f"PYTHON={old}"], cwd=tmp_path, env=clean, capture_output=True, text=True)
    assert done.returncode != 0
    assert "needs Python 3.11" in done.stderr and "Python 3.9.2" in done.stderr
    assert not (tmp_path / ".venv").exists()


def test_the_front_page_lays_two_pictures_of_one_size_under_a_wiper(site):
    (box,) = re.findall(r"<div[^>]* data-wiper=.*?</div>", (site / "index.html").read_text(encoding="utf-8"), re.DOTALL)
    numeric, symbolic = re.findall(r'src="_images/(\w+)\.png" alt="(\w+)\..*?" .*?(width="\d+" height="\d+")', box)
    assert numeric == ("hero", "Numeric", symbolic[2]) and symbolic[:2] == ("hero_symbolic", "Symbolic")
