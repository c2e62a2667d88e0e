"""Names of entries in the chapter's lists (fields, programs, models): the rules for them, and errors that say which."""

from collections.abc import Iterable
from keyword import iskeyword
from typing import Any

LONGEST_NAME = 60  # characters: a name is part of a message, a kernel's name and a file's
SHOWN = 120  # of a value, in a message


def shown(value: object) -> str:
    """Return how a message shows a value: the beginning of a long one."""
    text = " ".join(repr(value).split("\n"))
    return text if len(text) <= SHOWN else f"{text[:SHOWN]}..."


def not_allowed(name: str, value: object, allowed: str) -> ValueError:
    """Return the ValueError that says so."""
    return ValueError(f"{name} = {shown(value)} is not allowed: {allowed}")


def check_name(name: str) -> None:
    """Raise ValueError unless a function, in Python and in Coq, can be called so, and the name is not too long."""
    if not isinstance(name, str):
        raise not_allowed("name", name, "a text")
    if len(name) > LONGEST_NAME:
        allowed = f"a name of at most {LONGEST_NAME} characters, and it has {len(name)}"
        raise not_allowed("name", f"{name[:LONGEST_NAME]}...", allowed)
    if not (name.isascii() and name.isidentifier()) or iskeyword(name):
        raise not_allowed("name", name, "an identifier of ASCII letters, digits and _, and no keyword of Python")


def by_name(entries: Iterable[Any]) -> dict[str, Any]:
    """Return {name: entry}. Raises ValueError where two have one name."""
    named: dict[str, Any] = {}
    for entry in entries:
        if named.setdefault(entry.name, entry) is not entry:
            raise not_allowed("name", entry.name, "a name that no other entry has")
    return named
