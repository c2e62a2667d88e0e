"""The chapter as it is read: pictures close to their words, no page longer than it was, numbers that agree."""

import re

import pytest
from bs4 import NavigableString

from book.assembly.results import look_up
from book.extension.listings import printed
from book.extension.worked import worked_lines
from book.ledger import load
from book.notebooks.laboratory import BOOK

READ = ("s1", "s2", "s3", "s4")
PICTURES = "figure, .simulator"
ASIDE = "script, style, pre, .headerlink, .provenance, .theorem details, section[id^=exercises]"
"""What is not read on the way: code, proofs in their cards, exercises after a page's end."""
WORDS_AT_MOST, WAY_AT_MOST = 7250, 350  # the chapter's length before it had these pictures


def ways(page):
    """Return (words of a page, words from picture to picture). Other folds are counted; captions are no way."""
    article = page.select_one(".bd-article")
    for aside in article.select(ASIDE):
        aside.decompose()
    formulas, pictures = article.select("math"), article.select(PICTURES)
    total, found = len(formulas), [0]  # a formula is a word of the page, and not of the way
    for formula in formulas:
        formula.decompose()
    for node in article.descendants:
        if node in pictures:
            found.append(0)
        elif isinstance(node, NavigableString):
            words = len(node.split())
            total += words
            found[-1] += words * (not any(parent in pictures for parent in node.parents))
    return total, found


@pytest.fixture(scope="module")
def measured(page_of):
    return {name: ways(page_of(name)) for name in READ}


def test_a_picture_is_never_far(measured):
    far = {name: way for name, (_, way) in measured.items() if max(way) > WAY_AT_MOST}
    assert not far


def test_the_chapter_is_no_longer_than_it_was(measured):
    assert sum(total for total, _ in measured.values()) <= WORDS_AT_MOST


def test_every_section_begins_with_a_picture_on_its_first_screen(measured):
    assert all(way[0] <= 120 for name, (_, way) in measured.items() if name != "s1")


def test_printed_lines_are_the_kernels():
    assert printed("bumped_normal", ["m_x"]).splitlines()[1] == "m_x = beta * g_x + normal_x"
    with pytest.raises(ValueError, match=r"'bumped_normal' defines no m_q; it defines normal_x"):
        printed("bumped_normal", ["m_q"])
    with pytest.raises(ValueError, match="has no function 'bump'"):
        printed("bump", ["m_x"])
    source = "\n".join((BOOK / "chapter" / f"{name}.md").read_text(encoding="utf-8") for name in READ)
    assert source.count(":::{printed-lines}") == 6


def test_the_worked_pixel_is_three_steps_in_the_text_s_symbols():
    lines = worked_lines()
    assert [line["step"][:2] for line in lines if line["step"]] == ["1.", "2.", "3."]
    formulas = " ".join(node.astext() for line in lines if not line["step"] for node in line["formula"])
    assert r"\omega + \hat v" in formulas and not re.search(r"atan_|2 pi|\|k\|", formulas)


# Pairs of numbers that once disagreed


def merit(id):
    (claim,) = (claim for claim in load().claims if claim.id == id)
    return claim.merit


def test_a_lucky_dip_is_called_one():
    least, near = (look_up(BOOK, "u_curve", key) for key in ("least", "near_best"))
    assert 5 * least < near < look_up(BOOK, "work_precision", "central_error")
    cited = [page for page in BOOK.glob("ch*/*.md") if "u_curve.least" in page.read_text(encoding="utf-8")]
    assert [page.stem for page in cited] == ["s3"] and "is a dip" in cited[0].read_text(encoding="utf-8")


def test_two_numbers_for_one_thing_stand_together():
    for id, pair in {
        "ledger_error_character": ("ridge_law.h_u_slope", "eps_table.rms_slope"),
        "ledger_frontier": ("frontier_wall.sine_bilinear_order", "normal_map.sine_order"),
    }.items():
        assert all(name in merit(id) for name in pair), id
    assert look_up(BOOK, "normal_map", "sine_order") > look_up(BOOK, "frontier_wall", "sine_bilinear_order") + 0.8
    assert abs(look_up(BOOK, "frontier_wall", "as_step") - 0.015) < 5e-4  # not 0.02, to two digits
    assert "frontier_wall.as_step|.2g" in (BOOK / "checked" / "frontiers.md").read_text(encoding="utf-8")


def test_the_pictures_of_the_sweep_s_end_look_alike():
    assert 0.03 < look_up(BOOK, "eps_table", "slope_lost_1e-16") < 0.2
