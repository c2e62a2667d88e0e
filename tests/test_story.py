"""The chapter as it is read: pictures close to their words, no page longer than it was; what a mean is over."""

import re

from book.notebooks.laboratory import BOOK

READ = ("s1", "s2", "s3", "s4")
PICTURES = "figure, .simulator"
ASIDE = "script, style, pre, .headerlink, .provenance, .theorem details, section[id^=exercises]"
"""What is not read on the way: code, proofs in their cards, exercises after a page's end."""
RMS = r"\{number\}`(\w+)\.\w*rms"
WORDS_AT_MOST, WAY_AT_MOST = 7250, 350  # the chapter's length before it had these pictures


def ways(page):
    """Return (words of a page, words from picture to picture). Other folds are counted; captions are no way."""
    article = page.select_one(".bd-article")
    for aside in article.select(ASIDE):
        aside.decompose()
    formulas = article.select("math")
    for formula in formulas:
        formula.decompose()
    total = len(formulas) + len(article.get_text(" ").split())  # a formula is a word of the page, and not of the way
    for picture in article.select(PICTURES):
        picture.replace_with("\0")
    return total, [len(way.split()) for way in article.get_text(" ").split("\0")]


def test_pictures_are_near_their_words_and_the_chapter_no_longer_than_it_was(page_of):
    """And every section begins with a picture on its first screen."""
    totals, found = zip(*(ways(page_of(name)) for name in READ), strict=True)
    assert sum(totals) <= WORDS_AT_MOST
    assert max(map(max, found)) <= WAY_AT_MOST and all(way[0] <= 120 for way in found[1:])


OVER = {"frontier_wall": "points"}
"""{figure: over what its root mean squares are}, but for pictures, which have channels"""


def unnamed(text):
    """Return the figures whose root mean squares a page cites, and its paragraph has no word for what they are over."""
    cited = ((id, re.sub("`.*?`", "", block)) for block in text.split("\n\n") for id in re.findall(RMS, block))
    return [id for id, words in cited if OVER.get(id, "channels") not in words]


def test_a_root_mean_square_says_over_what_it_is():
    wrong = (
        "Of the channel that differs most {number}`three_pictures.rms_channels`, of points {number}`stacking.a_rms`."
    )
    assert unnamed(f"{wrong}\n\nOver the channels: {{number}}`stacking.b_rms`.") == ["three_pictures", "stacking"]
    assert not any(unnamed(page.read_text("utf-8")) for page in BOOK.glob("ch*/*.md"))
