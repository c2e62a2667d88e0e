"""The search, offline: the index is a script beside the pages, so it works from a folder as from a server."""

import re
from urllib.parse import quote_plus
from xml.etree import ElementTree

import pytest

from book.extension.mathematics import typeset
from book.extension.search import in_a_line
from book.extension.theorems import load
from book.notebooks.laboratory import BOOK

# Two words, one of the prose, of a caption, a Greek letter, one of a theorem's card; and where each has to be found.
FOUND = {
    "perturbed normal": "s3.html",
    "silhouette": "s2.html",
    "trace": "s2.html",
    "ε": "s7.html",
    "Lagrange": "lemmas.html",
}


def search(tab, words):
    """Type the words into the page's search field; the addresses of what it finds."""
    tab.keyboard.press("Control+KeyK")
    field = tab.locator("input[type=search]:visible")  # in a dialog, or on the page of what was found
    field.fill(words)
    field.press("Enter")
    tab.wait_for_url(f"**/search.html?q={quote_plus(words)}*")
    tab.wait_for_function(
        "typeof Search !== 'undefined' && Search.title && Search.title.innerText === 'Search Results'"
    )
    return tab.evaluate(
        "[...document.querySelectorAll('#search-results li > a')].map(link => link.getAttribute('href'))"
    )


def test_words_and_theorems_are_found_each_page_shows_its_sentence_and_is_led_to(visit, scheme):
    theorems = load(BOOK)
    tab = visit("source/proofs/formulas/bump.py", scheme)
    for words, page in FOUND.items():
        assert page in {link.partition("#")[0] for link in search(tab, words)}
    shown = tab.locator("#search-results li:has(a[href^='lemmas.html#']) .search-sentence")
    assert "lagrange" in shown.locator("mark").first.inner_text().lower() and shown.inner_text().count(". ") <= 1
    for id in ("seam", "hit_of_b"):
        label = theorems.label(id)
        assert {search(tab, words)[0].split("#")[1] for words in (label, label.split()[-1])} == {f"theorem-{id}"}
    assert search(tab, "xylophone") == []
    assert "did not match any" in tab.inner_text("#search-results")
    assert search(tab, "silhouette")
    tab.click("#search-results li > a[href^='s2.html']")
    tab.wait_for_url("**/s2.html*")
    assert tab.is_visible(".bd-article h1")


@pytest.mark.parametrize(
    ("tex", "text"),
    [
        (r"2^{-40} \le x^2", "2⁻⁴⁰≤x²"),
        (r"N'_x + f''", "N_x′+f″"),
        (r"\frac{1}{1 - x}", "1/(1−x)"),
        (r"\sqrt{a + b}\, e^{i\theta}", "√(a+b) e^(iθ)"),
        (r"\sin x = 0.5\ldots", "sin x=0.5…"),
        (r"\varepsilon_{\mathrm{mach}}", "ε_mach"),
    ],
)
def test_a_formula_that_is_found_stands_in_the_line(tex, text):
    assert in_a_line(ElementTree.fromstring(typeset(tex))) == text


def test_no_markup_no_small_print_of_a_figure_and_no_key_is_sent_to_search_in(site):
    text = (site / "_static" / "search-text.js").read_text("utf-8")
    assert "ε" in text and "Blinn 1978" in text
    assert not re.search(r"<m[a-z]+[ >]|\\\\\(|python -m book figures|Blinn1978", text)
