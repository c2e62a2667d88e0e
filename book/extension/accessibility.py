"""HTML as readers need it, where Sphinx writes some that screen readers do not understand, or that breaks badly."""

import re

from book.extension.elements import Page, on_page

EMPTY_HEADING = re.compile(r'<th class="head[^"]*">(?:<p></p>)?</th>')

# A formula breaks nowhere inside, but would break between it and its punctuation.
PUNCTUATED = re.compile(r"[“‘(\[]*<math>(?:(?!</math>).)*</math>(?:[.,;:?!)\]’”]+|[’-]\w+)")


@on_page
def mend(page: Page) -> None:
    """Make a bibliography a list, leave no heading cell empty, and keep punctuation at its formula."""
    if body := page.context.get("body"):
        body = body.replace('role="doc-biblioentry"', 'role="listitem"')
        body = PUNCTUATED.sub(r'<span class="unbroken">\g<0></span>', body)
        page.context["body"] = EMPTY_HEADING.sub('<td class="head"></td>', body)
