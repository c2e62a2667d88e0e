"""Docstrings as they stand: plain text in which `code` is code, indented lines are listings, and examples examples.

autodoc reads reStructuredText, to which |k| ≤ 2²⁰ and k_u are markup. So everything else is escaped.
"""

import inspect
import re
from typing import Any

from sphinx.application import Sphinx

from book.extension.elements import on

MARKUP = re.compile(r"([\\*_|<>])")
INDENT = "    "


def _escaped(text: str) -> str:
    """Text with `code` between two backticks each, and nothing else that reStructuredText would read."""
    parts = text.split("`")
    return "".join(f"``{part}``" if odd % 2 else MARKUP.sub(r"\\\1", part) for odd, part in enumerate(parts))


def _arguments_named(text: str, names: set[str]) -> str:
    """The escaped text with `name:` in bold where a sentence begins with one or more of the names."""

    def bold(match):
        found = match[2].replace("\\", "").split(", ")
        return f"{match[1]}**{match[2]}**: " if set(found) <= names else match[0]

    return re.sub(r"(^|[.;)] )([\w\\]+(?:, [\w\\]+)*): ", bold, text)


def restructured(lines: list[str], names: set[str]) -> list[str]:
    found = []
    for paragraph in re.split(r"\n\s*\n", "\n".join(lines)):
        rows = [row for row in paragraph.splitlines() if row.strip()]
        if rows and all(row.startswith(INDENT) for row in rows):
            found += ["::", "", *rows, ""]
        elif rows and rows[0].startswith(">>>"):
            found += [*rows, ""]
        elif rows:
            found += [_arguments_named(_escaped(" ".join(row.strip() for row in rows)), names), ""]
    return found


def names_of(thing: Any) -> set[str]:
    """What a docstring may name: the parameters of a callable, and the attributes of a class."""
    try:
        names = set(inspect.signature(thing).parameters)
    except (TypeError, ValueError):
        names = set()
    return names | set(getattr(thing, "__annotations__", ())) | set(vars(thing) if inspect.isclass(thing) else ())


@on("autodoc-process-docstring")
def read_docstring(app: Sphinx, what: str, name: str, thing: object, options: object, lines: list[str]) -> None:
    lines[:] = restructured(lines, names_of(thing))
