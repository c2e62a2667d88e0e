"""What pages have beside their words: formulas as MathML, style sheets without what no page uses, a policy."""

import re
from types import SimpleNamespace

import pytest

from book.editions.document import POLICY as MAILED
from book.editions.pages import parsed
from book.extension import mathematics
from book.extension.scripts import POLICY
from book.extension.styles import NAMED, NESTED, pruned
from verify.sources import ROOT

HEAVIEST = 1_000_000  # bytes: a page, its scripts, style sheets and fonts, as they are before a server compresses them
LIGHT = ["index", *(f"s{n}" for n in range(1, 10))]
BAR = '<mo stretchy="false" lspace="0" rspace="0">|</mo>'
INSIDE = re.compile(
    "<math><semantics>(?:<mrow>)?(.*?)(?:</mrow>)?<annotation[^>]*>(.*)</annotation></semantics></math>"
)
SPACE = '<mspace width="0.167em" />'
SET = {
    r"k\sin x": f"<mi>k</mi>{SPACE}<mi>sin</mi><mo>\u2061</mo>{SPACE}<mi>x</mi>",
    r"\cos(-x)": '<mi>cos</mi><mo>\u2061</mo><mo stretchy="false">(</mo><mo form="prefix">−</mo><mi>x</mi>'
    '<mo stretchy="false">)</mo>',
    "N'_x": '<msub><mrow><mi>N</mi><mpadded width="0"><mo>′</mo></mpadded></mrow><mi>x</mi></msub>',
    "|g|/2": f'{BAR}<mi>g</mi>{BAR}<mo lspace="0" rspace="0">/</mo><mn>2</mn>',
}


def test_formulas_have_the_spaces_of_print_and_carry_their_tex():
    typeset = dict(zip(SET, mathematics.typeset([(tex, False) for tex in SET]), strict=True))
    for tex, said in SET.items():
        inside = INSIDE.fullmatch(typeset[tex])
        assert (inside[1], inside[2]) == (said, tex)


@pytest.mark.parametrize("tex", [r"\frac{1", r"\nosuch", "}"])
def test_what_is_no_tex_is_refused_with_its_complaint(tex):
    with pytest.raises(ValueError, match="could not typeset"):
        mathematics.typeset([("x", False), (tex, True)])


def test_a_formula_is_typeset_once_and_a_new_one_alone(monkeypatch):
    asked, environment = [], SimpleNamespace()
    monkeypatch.setattr(mathematics, "typeset", lambda formulas: asked.append(formulas) or ["<math/>"] * len(formulas))
    x, y = ("x", False), ("y", True)
    for wanted in ([x, x], [x], [y, x]):
        mathematics.mathml(environment, wanted)
    assert asked == [[x], [y]]


def test_every_formula_of_the_site_is_set_and_no_tex_stands_in_the_text(page_of):
    count = 0
    for name in (*LIGHT, "lemmas", "findings", "seed"):
        page = page_of(name).article
        for formula in page.select("math"):
            assert formula.annotation.extract().get_text().strip() and formula.get_text().strip(), name
            count += 1
        for code in page.select("pre, code, script"):
            code.extract()
        assert not re.search(r"\\[(\[a-z]", page.get_text()), name
    assert count > 3000


def test_style_sheets_keep_what_pages_use_and_follow_the_system():
    css = '@charset "x";.a,.b{c:d}.e:not(.f)>p{c:url("{}")}@media print{.b{c:d}.a{c:e}}/* . */'
    css += 'html[data-theme="dark"] .a{c:f}'
    dark = 'html[data-theme="dark"] .a{c:f}@media (prefers-color-scheme:dark){html[data-theme=auto] .a{c:f}}'
    assert pruned(css, {"a", "e"}) == '@charset "x";.a{c:d}.e:not(.f)>p{c:url("{}")}@media print{.a{c:e}}' + dark
    assert pruned(css, {"b"}) == '@charset "x";.b{c:d}@media print{.b{c:d}}'


def test_no_rule_of_our_own_is_left_out_of_the_site(site):
    """A class that a script puts together from parts is found in no page and no script."""
    sheets = sorted((ROOT / "book" / "static").rglob("*.css"))
    for sheet in sheets:
        css = re.sub(r"/\*.*?\*/", "", sheet.read_text(encoding="utf-8"), flags=re.DOTALL)
        heads = NESTED.sub("", " ".join(re.findall(r"[^{};]+(?=\{)", css)))
        built = (site / "_static" / sheet.relative_to(ROOT / "book" / "static")).read_text(encoding="utf-8")
        assert set(NAMED.findall(heads)) - set(NAMED.findall(built)) == set(), sheet
    assert len(sheets) > 10


def weight(site, name):
    """Bytes of a page with all that it loads to be read and to work: scripts, style sheets and the fonts of these."""
    page = site / f"{name}.html"
    tags = parsed(page.read_text(encoding="utf-8")).select("script[src], link[rel=stylesheet]")
    loaded = {tag.get("src") or tag["href"] for tag in tags}
    files = {page, *(site / address.partition("?")[0] for address in loaded)}
    for path in [path for path in files if path.suffix == ".css"]:
        names = re.findall(r"url\([\"']?([^\"')?#]+\.(?:woff2?|ttf))", path.read_text(encoding="utf-8"))
        files.update((path.parent / name).resolve() for name in names)
    return sum(path.stat().st_size for path in files)


def test_pages_of_the_chapter_are_light(site):
    weights = {name: weight(site, name) for name in LIGHT}
    assert all(100_000 < size <= HEAVIEST for size in weights.values()), weights
    assert weight(site, "lemmas") > HEAVIEST  # it would be seen


def test_every_page_has_the_policy(site, single):
    for path in [*site.glob("*.html"), *site.glob("source/**/*.html"), single]:
        head = path.read_text(encoding="utf-8").partition("</head>")[0]
        policies = re.findall(r'<meta[^>]*Content-Security-Policy"[^>]*>', head)
        own = POLICY if path != single else MAILED
        assert len(policies) == 1 and own in policies[0].replace("&#39;", "'"), path.name
        assert "connect-src 'none'" in own and head.index("Content-Security") < head.index("<script")


@pytest.mark.parametrize("scheme", ["http", "file"])
def test_the_browser_lets_no_page_fetch_or_send(browser, site, server, scheme):
    tab = browser.new_page()
    tab.goto(f"{server if scheme == 'http' else site.as_uri()}/s1.html")
    refused = """() => new Promise(done => {
        addEventListener('securitypolicyviolation', event => done(event.effectiveDirective));
        fetch('index.html').catch(() => 0); })"""
    assert tab.evaluate(refused) == "connect-src"
    tab.close()


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_without_scripts_formulas_stand_and_each_figure_stands_once_in_the_system_s_colours(visit, mode):
    tab = visit("s3", java_script_enabled=False, color_scheme=mode)
    shown = tab.locator(".bd-article img.plot:visible")
    names = [shown.nth(n).get_attribute("src") for n in range(shown.count())]
    assert (
        names
        and all(name.endswith(".dark.svg") == (mode == "dark") for name in names)
        and len(set(names)) == len(names)
    )
    assert tab.locator(".bd-article p > math").first.bounding_box()["width"] > 3


def test_a_formula_is_copied_as_tex(visit):
    tab = visit("s3")
    copied = tab.evaluate("""() => {
        const [formula] = document.querySelectorAll('.bd-article p math'), clipboardData = new DataTransfer();
        getSelection().selectAllChildren(formula.closest('p'));
        document.dispatchEvent(new ClipboardEvent('copy', { clipboardData }));
        return [clipboardData.getData('text/plain'), formula.querySelector('annotation').textContent]; }""")
    assert f"${copied[1]}$" in copied[0] and copied[0].split()[0].isalpha()
