"""The frame of pages: formulas as MathML, style sheets without what no page uses, a policy."""

import re
from html import escape, unescape

import pytest
from fontTools.ttLib import TTFont
from math_core import LatexError

from book.editions.document import POLICY as MAILED
from book.extension.mathematics import typeset
from book.extension.scripts import POLICY
from book.extension.styles import NAMED, NESTED, pruned
from tests.tabs import PHONE
from verify.evidence.sources import ROOT

HEAVIEST = 1_000_000  # bytes: a page, its scripts, style sheets and fonts, as they are before a server compresses them
LIGHT = ["index", *(f"s{n}" for n in range(1, 10))]
FORMULA = re.compile("(?s)<math .*?</math>")
BAR = '<mo stretchy="false" lspace="0" rspace="0">|</mo>'
SET = {
    r"k\sin x": '<mi>k</mi><mspace width="0.1667em"/><mrow><mi>sin</mi><mo lspace="0.1667em">\u2061</mo><mi>x</mi>'
    "</mrow>",
    r"2^{-40}": '<msup><mn>2</mn><mrow><mo lspace="0" rspace="0">−</mo><mn>40</mn></mrow></msup>',
    r"\mathrm{a\_b} + \mathrm{c}": '<mi>a_b</mi><mo>+</mo><mi mathvariant="normal">c</mi>',
    "N'_x": "<msubsup><mi>N</mi><mi>x</mi><mo>′</mo></msubsup>",
    "|g|/2": f'{BAR}<mi>g</mi>{BAR}<mo lspace="0" rspace="0">/</mo><mn>2</mn>',
    r"0.1\ldots < t": "<mn>0.1</mn><mi>…</mi><mo>&lt;</mo><mi>t</mi>",
}


def test_formulas_have_the_spaces_of_print_and_carry_their_tex():
    for tex, mathml in SET.items():
        assert typeset(tex) == f'<math data-tex="{escape(tex)}">{mathml}</math>'
    for wrong in (r"\foo", "{x", r"\frac{1}", "x^1^2"):
        with pytest.raises(LatexError):
            typeset(wrong)


def test_the_font_has_every_letter_of_the_formulas(site):
    letters = TTFont(ROOT / "book" / "static" / "formulas.woff").getBestCmap()
    needed = {letter for page in site.rglob("*.html") for formula in FORMULA.findall(page.read_text("utf-8"))
              for letter in unescape(re.sub("<[^>]*>", "", formula))}  # fmt: skip
    assert len(needed) > 100 and [letter for letter in needed if ord(letter) not in letters] == []


def test_every_formula_of_the_site_is_set_and_no_tex_stands_in_the_text(html_of):
    count = 0
    for name in (*LIGHT, "lemmas", "findings", "seed"):
        article = re.search(r"(?s)<article.*</article>", html_of(name))[0]
        count += article.count("<math")
        text = re.sub(r"(?s)<(pre|code|script)\b.*?</\1>|<[^>]*>", "", article)
        assert not re.search(r"\\[(\[a-z]", text), name
    assert count > 3000


def test_style_sheets_keep_what_pages_use_and_follow_the_system():
    css = '@charset "x";.a,.b{c:d}.e:not(.f)>p{c:url("{}")}@media print{.b{c:d}.a{c:e}}/* . */'
    css += 'html[data-theme="dark"] .a{c:f}'
    dark = 'html[data-theme="dark"] .a{c:f}@media (prefers-color-scheme:dark){html[data-theme=auto] .a{c:f}}'
    assert pruned(css, {"a", "e"}) == '@charset "x";.a{c:d}.e:not(.f)>p{c:url("{}")}@media print{.a{c:e}}' + dark
    assert pruned(css, {"b"}) == '@charset "x";.b{c:d}@media print{.b{c:d}}'


def test_no_rule_of_our_own_is_left_out_of_the_site(site):
    """A class that a script puts together from parts is found in no page and no script."""
    ours = ROOT / "book" / "static"
    for sheet in ours.rglob("*.css"):
        css = re.sub(r"(?s)/\*.*?\*/", "", sheet.read_text("utf-8"))
        heads = NESTED.sub("", " ".join(re.findall(r"[^{};]+(?=\{)", css)))
        built = (site / "_static" / sheet.relative_to(ours)).read_text("utf-8")
        assert set(NAMED.findall(heads)) <= set(NAMED.findall(built)), sheet


def weight(site, name):
    """Bytes of a page with all that it loads to be read and to work: scripts, style sheets and the fonts of these."""
    page = site / f"{name}.html"
    loaded = re.findall(r'(?:src|href)="(_static/[^"?]+\.(?:js|css))', page.read_text("utf-8"))
    files = {page, *(site / address for address in loaded)}
    for sheet in [path for path in files if path.suffix == ".css"]:
        fonts = re.findall(r"url\([\"']?([^\"')?#]+\.(?:woff2?|ttf))", sheet.read_text("utf-8"))
        files |= {(sheet.parent / name).resolve() for name in fonts}
    return sum(path.stat().st_size for path in files)


def test_pages_of_the_chapter_are_light(site):
    weights = {name: weight(site, name) for name in LIGHT}
    assert all(100_000 < size <= HEAVIEST for size in weights.values()), weights


def test_every_page_has_the_policy(site, single):
    for path in [*site.glob("*.html"), *site.glob("source/**/*.html"), single]:
        head = path.read_text("utf-8").partition("</head>")[0].replace("&#39;", "'")
        (policy,) = re.findall(r'<meta[^>]*Content-Security-Policy"[^>]*>', head)
        assert (MAILED if path == single else POLICY) in policy, path.name
        assert "connect-src 'none'" in policy and head.index(policy) < head.index("<script"), path.name


def test_the_browser_lets_no_page_fetch_or_send(browser, base):
    tab = browser.new_page()
    tab.goto(f"{base}/s1.html")
    refused = """() => new Promise(done => {
        addEventListener('securitypolicyviolation', event => done(event.effectiveDirective));
        fetch('index.html').catch(() => 0); })"""
    assert tab.evaluate(refused) == "connect-src"
    tab.close()


def test_folds_are_open_on_paper(visit):
    tab = visit("s6")
    folded = "document.querySelectorAll('.bd-article details:not([open]) > :not(summary)')"
    for medium, seen in (("screen", False), ("print", True)):
        tab.emulate_media(media=medium)
        assert set(tab.evaluate(f"Array.from({folded}, part => part.checkVisibility())")) == {seen}


def test_a_reader_who_denies_storage_has_the_page(visit):
    """It complains of nothing, and its buttons work."""
    denied = "{ configurable: true, get() { throw new DOMException('denied', 'SecurityError'); } }"
    tab = visit("s3", prepare=f"Object.defineProperty(window, 'localStorage', {denied})")
    tab.click(".theme-switch-button")
    assert tab.get_attribute("html", "data-mode") == "dark"


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_without_scripts_formulas_stand_and_each_figure_stands_once_in_the_system_s_colours(visit, mode):
    tab = visit("s3", java_script_enabled=False, color_scheme=mode)
    shown = [plot.get_attribute("src") for plot in tab.locator(".bd-article img.plot:visible").all()]
    assert {name.endswith(".dark.svg") for name in shown} == {mode == "dark"} and len(set(shown)) == len(shown)
    assert tab.locator(".bd-article section > p > math").first.bounding_box()["width"] > 3


def test_a_proof_comes_when_it_is_opened_or_words_are_looked_for_and_stands_where_no_script_runs(visit, html_of):
    """No link leads into one, so none has to be opened by its address."""
    folded = re.findall("(?s)<noscript>(.*?)</noscript>", html_of("lemmas"))
    assert len(folded) > 40 and not any(re.search("<noscript|<[^>]* id=", part) for part in folded)
    counts = []
    for scripts in (True, False):
        tab = visit("lemmas", java_script_enabled=scripts)
        counts.append(tab.locator("*").count())
        tab.click("#theorem-unit_length summary >> nth=0")
        tab.locator("#theorem-unit_length .part").first.wait_for()
        tab.keyboard.press("Control+KeyF")
        counts.append(tab.locator("*").count())
    assert counts[0] < 6000 and min(counts[1:]) > 60_000


def test_a_link_to_a_theorem_shows_its_statement(visit):
    """To the pointer, the Tab key and a finger, of this page and of others; a second tap follows."""
    tab, phone = visit("s7"), visit("s7", **PHONE)
    find = "main a[href$='#theorem-{}']".format
    first = find("crease_contrast")
    note, other = (each.locator(".theorem-note") for each in (tab, phone))
    tab.hover(first)
    words = note.inner_text()
    assert "where the kink flag is set" in words and tab.get_attribute(first, "aria-description") == words
    tab.keyboard.press("Escape")
    assert note.count() == 0
    tab.focus(find("clamped_difference"))
    assert "first order" in note.inner_text()
    phone.tap(first)
    assert other.inner_text() == words and other.bounding_box()["x"] >= 0
    phone.tap(first)
    phone.wait_for_url("**#theorem-crease_contrast")


def test_a_formula_is_copied_as_tex(visit):
    tab = visit("s3")
    copied = tab.evaluate("""() => {
        const [formula] = document.querySelectorAll('.bd-article p math'), clipboardData = new DataTransfer();
        getSelection().selectAllChildren(formula.closest('p'));
        document.dispatchEvent(new ClipboardEvent('copy', { clipboardData }));
        return [clipboardData.getData('text/plain'), formula.dataset.tex]; }""")
    assert f"${copied[1]}$" in copied[0] and copied[0].split()[0].isalpha()
