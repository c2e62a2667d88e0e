"""The style sheets of the theme and its extensions without what no page uses: nine tenths of them."""

import re
from collections.abc import Iterator
from pathlib import Path

from sphinx.application import Sphinx

from book.extension.elements import on

# Strings and addresses are read whole: they may hold braces.
TOKENS = re.compile(r""""(?:\\.|[^"])*"|'(?:\\.|[^'])*'|url\((?:[^)'"]*)\)|/\*.*?\*/|[{};]|[^{};"'/u]+|.""", re.DOTALL)
GROUPS = ("@media", "@supports", "@container", "@layer")
COMMA = re.compile(r",(?![^(]*\))")  # between selectors, and not within one's parentheses
NAMED = re.compile(r"[.#]((?:[\w-]|\\.)+)")
NESTED = re.compile(r":[\w-]+\([^()]*\)")
OF_PAGES = re.compile(r'\s(?:class|id)="([^"]*)"')
WORD = re.compile(r"[\w-]+")
THEME = re.compile(r"""\[data-theme=["']?(dark|light)["']?\]""")
DATA = re.compile("search|compiled")  # scripts that are numbers and words
DONE = "/* Without what no page uses. */\n"
UNUSED = ("vendor/**/*.*", "scripts/*.*", "**/*.map", "*webpack-macros.html", "copybutton_funcs.js")


def rules(css: str) -> Iterator[tuple[str, str]]:
    """A style sheet's rules in order: what stands before the braces and what is between them, or a statement and ""."""
    head, body, depth = "", "", 0
    for token in TOKENS.findall(css):
        if token.startswith("/*"):
            continue
        depth -= token == "}"
        if depth:
            body += token
        elif token in ("}", ";"):
            yield head.strip(), body
            head, body = "", ""
        elif token != "{":
            head += token
        depth += token == "{"


def pruned(css: str, names: set[str]) -> str:
    """A style sheet with the rules alone whose classes and ids are all among the names."""
    kept = []
    for head, body in rules(css):
        if head.startswith(GROUPS):
            body = pruned(body, names)
        elif not head.startswith("@"):
            head = ",".join(part for part in COMMA.split(head) if is_used(part, names))
        if not body and head.startswith("@") and not head.startswith(GROUPS):
            kept.append(f"{head};")
        elif head and body and "Font Awesome" not in body:
            kept.append(in_system_colours(head, body))
    return "".join(kept)


def is_used(selector: str, names: set[str]) -> bool:
    """Whether the pages have every class and id of a selector; those of :not() and its like are not asked for."""
    plain = NESTED.sub("", selector)
    return all(name.replace("\\", "") in names for name in NAMED.findall(plain))


def in_system_colours(head: str, body: str) -> str:
    """A rule for one colour of the page, also for who has not chosen one: then the system has."""
    chosen = THEME.search(head)
    if not chosen or body.startswith("@"):
        return f"{head}{{{body}}}"
    own = THEME.sub("[data-theme=auto]", head)
    return f"{head}{{{body}}}@media (prefers-color-scheme:{chosen[1]}){{{own}{{{body}}}}}"


@on("build-finished", priority=900)
def prune(app: Sphinx, error: Exception | None) -> None:
    """Write every style sheet anew, once all pages are there."""
    if error or app.builder.name != "html":
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
