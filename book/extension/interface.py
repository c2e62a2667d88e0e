"""Docstrings as they stand: plain text in which `code` is code, indented lines are listings, examples are examples.

autodoc reads reStructuredText, to which |k| ≤ 2²⁰ and k_u are markup. So everything else is escaped.
"""

import re

from sphinx.application import Sphinx

from book.extension.elements import on

MARKUP = re.compile(r"([\\*_|<>])")
INDENT = "    "


def _escaped(text: str) -> str:
    """Return a text with `code` between double backticks, and nothing else that reStructuredText would read."""
    parts = text.split("`")
    return "".join(f"``{part}``" if odd % 2 else MARKUP.sub(r"\\\1", part) for odd, part in enumerate(parts))


def restructured(lines: list[str]) -> list[str]:
    result = []
    for paragraph in re.split(r"\n\s*\n", "\n".join(lines)):
        rows = [row for row in paragraph.splitlines() if row.strip()]
        if rows and all(row.startswith(INDENT) for row in rows):
            result += ["::", "", *rows, ""]
        elif rows and rows[0].startswith(">>>"):
            result += [*rows, ""]
        elif rows:
            result += [_escaped(" ".join(row.strip() for row in rows)), ""]
    return result


@on("autodoc-process-docstring")
def read_docstring(app: Sphinx, kind: str, name: str, thing: object, options: object, lines: list[str]) -> None:
    lines[:] = restructured(lines)
