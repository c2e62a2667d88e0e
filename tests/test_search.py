"""The search, offline: the index is a script beside the pages, so it works from a folder as from a server."""

import pytest

from tests.test_browser import address, is_local, settled

pytestmark = pytest.mark.browser
# A word of the prose, of a caption, of a theorem's card, a Greek letter, two words; and where each has to be found.
FOUND = {
    "silhouette": "s2.html",
    "trace": "s2.html",
    "Lagrange": "lemmas.html",
    "ε": "s7.html",
    "perturbed normal": "s3.html",
}


def search(tab, words: str) -> list[str]:
    """Type the words into the page's search field; the addresses of what it finds."""
    tab.keyboard.press("Control+KeyK")
    field = tab.locator("#pst-search-dialog input[type=search]")
    field.fill(words)
    field.press("Enter")
    tab.wait_for_url("**/search.html?q=*")
    tab.wait_for_function("Search.title && Search.title.innerText === 'Search Results'")
    return tab.evaluate(
        "[...document.querySelectorAll('#search-results li > a')].map(link => link.getAttribute('href'))"
    )


@pytest.fixture(params=["http", "file"])
def visit(request, browser, site, server):
    """Go to a page of the site by either scheme; in the end look at what it asked for and complained of."""
    context = browser.new_context()
    tab = context.new_page()
    requests, complaints = [], []
    tab.on("request", lambda asked: requests.append(asked.url))
    tab.on("console", lambda message: complaints.append(message.text) if message.type == "error" else None)
    tab.on("pageerror", lambda error: complaints.append(str(error)))

    def go(page):
        settled(tab, address(site, server, request.param, page))
        return tab

    yield go
    context.close()
    assert requests
    assert [url for url in requests if not is_local(url, server)] == []
    assert complaints == []


@pytest.mark.parametrize("words", FOUND)
def test_words_are_found(visit, words):
    assert FOUND[words] in {link.partition("#")[0] for link in search(visit("index"), words)}


def test_each_page_found_shows_its_sentence_and_leads_to_the_section(visit):
    tab = visit("index")
    search(tab, "Lagrange")
    item = tab.locator("#search-results li:has(a[href^='lemmas.html#lemmas-'])")
    shown = item.locator(".search-sentence")
    assert "lagrange" in shown.locator("mark").first.inner_text().lower() and shown.inner_text().count(". ") <= 1


def test_nothing_is_found_where_there_is_nothing(visit):
    tab = visit("s9")
    assert search(tab, "xylophone") == []
    assert "did not match any" in tab.locator("#search-results").inner_text()


def test_search_from_a_source_page_leads_to_the_page_found(visit):
    tab = visit("source/proofs/formulas/bump.py")
    assert search(tab, "silhouette")
    tab.locator("#search-results li > a[href^='s2.html']").first.click()
    tab.wait_for_url("**/s2.html*")
    assert tab.locator(".bd-article h1").is_visible()
