"""The style sheets of the theme and its extensions without what no page uses: three quarters of them."""

import os
import re
from pathlib import Path

from sphinx.application import Sphinx

from book.extension.elements import on

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
RULE = re.compile(r"""([^{};]*)\{((?:"[^"]*"|'[^']*'|[^{}"'])*)\}""")  # a string may hold braces
COMMA = re.compile(r",(?![^(]*\))")  # between selectors, and not within one's parentheses
NAMED = re.compile(r"[.#]([a-zA-Z_-][\w-]*)")
NESTED = re.compile(r":[\w-]+\([^()]*\)")
OF_PAGES = re.compile(r'\s(?:class|id)="([^"]*)"')
WORD = re.compile(r"[\w-]+")
THEME = re.compile(r"""\[data-theme=["']?(dark|light)["']?\]""")
DATA = re.compile("search|compiled")  # scripts that are numbers and words
DONE = "/* Without what no page uses. */\n"
UNUSED = ("vendor/**/*.*", "scripts/*.*", "**/*.map", "*webpack-macros.html", "copybutton_funcs.js")


def pruned(css: str, names: set[str]) -> str:
    """Return a style sheet with the rules alone whose classes and ids are all among the names.

    Those of :not() and its like are not asked for. A rule for one colour of the page is also for who has not chosen
    one: then the system has.
    """

    def schemed(rule: re.Match) -> str:
        asked = {part: NAMED.findall(NESTED.sub("", part).replace("\\", "")) for part in COMMA.split(rule[1].strip())}
        head, body = ",".join(part for part, its in asked.items() if names.issuperset(its)), rule[2]
        if not head or "Font Awesome" in body:
            return ""
        auto = f"{THEME.sub('[data-theme=auto]', head)}{{{body}}}"
        schemes = sorted({*THEME.findall(head)})
        return f"{head}{{{body}}}" + "".join(f"@media (prefers-color-scheme:{scheme}){{{auto}}}" for scheme in schemes)

    return RULE.sub(schemed, COMMENT.sub("", css))


@on("build-finished", priority=900)
def prune(app: Sphinx, error: Exception | None) -> None:
    """Write every style sheet anew, once all pages are there; who watches one of them waits for no other."""
    if error or app.builder.name != "html" or "BOOK_WATCHED" in os.environ:
        return
    site, names = Path(app.outdir), set()
    for unused in UNUSED:
        for path in site.glob(f"_static/{unused}"):
            path.unlink()
    for path in site.rglob("*.html"):
        for text in OF_PAGES.findall(path.read_text(encoding="utf-8")):
            names.update(text.split())
    for path in site.rglob("*.js"):
        if not DATA.search(path.name):
            names.update(WORD.findall(path.read_text(encoding="utf-8")))
    for path in site.rglob("*.css"):
        css = path.read_text(encoding="utf-8")
        if not css.startswith(DONE):
            path.write_text(DONE + pruned(css, names), encoding="utf-8")
