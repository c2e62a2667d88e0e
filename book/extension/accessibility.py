"""HTML that screen readers understand, where Sphinx writes some that they do not."""

import re

EMPTY_HEADING = re.compile(r'<th class="head[^"]*">(?:<p></p>)?</th>')


def readable(body: str) -> str:
    """A page's HTML with a bibliography's entries as items of its list, and no heading cell that is empty."""
    body = body.replace('role="doc-biblioentry"', 'role="listitem"')
    return EMPTY_HEADING.sub('<td class="head"></td>', body)


def mend(app, pagename, templatename, context, doctree) -> None:
    """Put the mended body in the page's place."""
    if "body" in context:
        context["body"] = readable(context["body"])


def setup(app) -> None:
    """Connect to Sphinx."""
    app.connect("html-page-context", mend)
