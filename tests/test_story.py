"""The chapter as it is read: a short main path, pictures close to their words; what a mean is over."""

import re
from copy import copy

import pytest

from book.notebooks.laboratory import BOOK

READ = ("s1", "s2", "s3", "s4", "s6", "s7", "s8", "s9")  # the main path; §5 is a laboratory
PICTURES = "figure, .simulator"
UNREAD = "script, style, :not(details) > noscript, pre, math, .headerlink, .on-paper, [hidden]"  # no prose
RMS = r"\{number\}`(\w+)\.\w*rms"
WORDS_AT_MOST, FOLDED_AT_MOST, FIGURES_AT_MOST = 7000, 18_000, 24
CARDS_AT_MOST, CAPTION_AT_MOST, WAY_AT_MOST = 6, 30, 350  # cards in §3; 30 words are two lines
THEOREM = re.compile(r"(?:Theorem|Claim) (\d+)$")


def words(text):
    return sum(any(map(str.isalnum, word)) for word in text.split())


def fold(article):
    """Cut what is folded out of an article, but for the words that unfold it; return how many words that were."""
    folds = [part for part in article.select("details") if not part.find_parent("details")]
    cut = 0
    for part in folds:
        sign = part.summary.extract()
        cut += words(part.get_text(" "))
        part.replace_with(sign)
    return cut


@pytest.fixture(scope="module")
def read(page_of):
    """Page → (its article as it is seen, how many words are folded in it)."""
    articles = {}
    for name in READ:
        article = page_of(name).select_one(".bd-article")
        for pre in article.select("details pre"):
            pre.name = "code"  # it counts where it is folded
        for simulator in article.select(".simulator"):
            simulator.clear()  # a picture: its labels are no words of the page
            del simulator["hidden"]
        for part in article.select(UNREAD):
            part.decompose()
        articles[name] = article, fold(article)
    return articles


def test_the_main_path_is_short(read):
    assert sum(words(article.get_text(" ")) for article, _ in read.values()) <= WORDS_AT_MOST
    assert sum(folded for _, folded in read.values()) <= FOLDED_AT_MOST
    assert sum(len(article.select("figure")) for article, _ in read.values()) <= FIGURES_AT_MOST
    assert len(read["s3"][0].select(".theorem")) <= CARDS_AT_MOST
    captions = (caption for article, _ in read.values() for caption in article.select("figure .caption-text"))
    assert max(words(caption.get_text(" ")) for caption in captions) <= CAPTION_AT_MOST


def test_pictures_are_near_their_words(read):
    """And every section with pictures begins with one on its first screen."""
    for name in ("s1", "s2", "s3", "s4"):
        article = copy(read[name][0])
        for aside in article.select("section[id^=exercises]"):
            aside.decompose()
        for picture in article.select(PICTURES):
            picture.replace_with("\0")
        ways = [len(way.split()) for way in article.get_text(" ").split("\0")]
        assert max(ways) <= WAY_AT_MOST and (name == "s1" or ways[0] <= 120), (name, ways)


def test_a_caption_holds_where_pictures_stand_below_one_another(read):
    """The panels of a figure stand so on a phone: its caption may not speak of left and right."""
    texts = [
        text.get_text() for article, _ in read.values() for text in article.select("figure:has(.panel) .caption-text")
    ]
    assert len(texts) > 5 and [text for text in texts if re.search("on the (left|right)|left to right", text)] == []


def test_each_section_opens_with_its_bet_and_closes_with_one_line_to_remember(read):
    for name, (article, _) in read.items():
        assert "bet" in article.select_one("section > p.lead").get_text().lower(), name
        assert [words(line.get_text(" ")) <= 30 for line in article.select("p.remember")] == [True], name


def test_numbers_of_theorems_rise_as_one_reads(read):
    """No theorem of the path is named before its card was met; lemmas have numbers of their own."""
    named = [part for article, _ in read.values() for part in article.select("a, .theorem-title strong")]
    numbers = [(part.name, int(match[1])) for part in named if (match := THEOREM.match(part.get_text()))]
    cards, met = [number for kind, number in numbers if kind == "strong"], 0
    assert cards == [*range(1, len(cards) + 1)]
    for kind, number in numbers:
        met = number if kind == "strong" else met
        assert number <= met or number > len(cards)


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
