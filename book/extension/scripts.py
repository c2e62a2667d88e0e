"""Policy and scripts of a page, and HTML as readers need it where Sphinx writes some that they cannot use."""

import os
import re
from functools import partial

from book.extension.elements import Page, on_page

EMPTY_HEADING = re.compile(r'<th class="head[^"]*">(?:<p></p>)?</th>')

# A formula breaks nowhere inside, but would break between it and its punctuation.
PUNCTUATED = re.compile(r"[“‘(\[]*<math [^>]*>(?:(?!</math>).)*</math>(?:[.,;:?!)\]’”]+|[’-]\w+)")
# Of each script that an extension loads on every page, by a part of its name: the text of pages that need it.
NEEDED_BY = {
    "clipboard": "highlight",
    "copybutton": "highlight",
    "toggle": 'class="toggle',
    "sphinx-book-theme.js": "\0",  # frame.js does what it does
    "design-tabs": "sd-tab-set",
    "sphinx-design": "sd-",
    "thebe": "\0",  # it names a foreign server
    "mystnb": 'class="cell',
}
# The browser holds the page to it: nothing is sent or fetched, scripts and pictures are the book's own. A page that is
# watched, `python -m book watch`, asks the server beside it whether it was built anew.
POLICY = (
    "default-src 'none'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; font-src 'self'; worker-src blob:; connect-src 'none'; form-action 'self'; "
    "base-uri 'none'"
)


@on_page
def enforce_policy(page: Page) -> None:
    allowed = POLICY.replace("connect-src 'none'", "connect-src 'self'") if "BOOK_WATCHED" in os.environ else POLICY
    policy = f'<meta http-equiv="Content-Security-Policy" content="{allowed}" />'
    page.context["metatags"] = policy + page.context.get("metatags", "")


@on_page
def name_source(page: Page) -> None:
    """Call a page's source, in the menu of downloads, by the page's name, whatever folder it stands in."""
    if page.context.get("sourcename"):
        page.context.update(sourcename=f"{page.name}.md", page_source_suffix=".md")


@partial(on_page, priority=900)
def name_downloads(page: Page) -> None:
    """Let the menu of downloads say what each of them is, where the theme shows the end of a file's name."""
    for group in page.context.get("header_buttons", []):
        for button in group.get("buttons", []):
            button["text"] = button["tooltip"]


@partial(on_page, priority=900)
def leave_out(page: Page) -> None:
    """Load nothing for what the page does not have."""
    body = page.context.get("body", "")

    def is_needed(file):
        name = f"{file.filename or ''}{file.attributes.get('body', '')}"
        return all(need in body for part, need in NEEDED_BY.items() if part in name)

    for kind in ("script_files", "css_files"):
        page.context[kind] = list(filter(is_needed, page.context[kind]))


@on_page
def mend(page: Page) -> None:
    """Make a bibliography a list, leave no heading cell empty, and keep punctuation at its formula."""
    if body := page.context.get("body"):
        body = body.replace('role="doc-biblioentry"', 'role="listitem"')
        body = PUNCTUATED.sub(r'<span class="unbroken">\g<0></span>', body)
        page.context["body"] = EMPTY_HEADING.sub('<td class="head"></td>', body)
