"""What CHANGELOG.md names under a version's heading."""

import re
from pathlib import Path

from book.build import stamps

CHANGELOG = stamps.ROOT / "CHANGELOG.md"


class NoHeading(ValueError):
    """The changelog does not speak of a version."""


def section(version: str, path: Path = CHANGELOG) -> str:
    """The text under "## VERSION", to the next heading of that level; NoHeading if there is no such heading."""
    text = path.read_text(encoding="utf-8")
    match = re.search(rf"^## {re.escape(version)}(?![\w.]).*?$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    if match is None:
        raise NoHeading(f"{path.name} has no heading ## {version}")
    return match[1]


def names(id: str, text: str) -> bool:
    """Whether a text names an id as a whole: u_curve.least is not named by u_curve.least_at or by u_curve."""
    return re.search(rf"(?<![\w:-]){re.escape(id)}(?![\w-]|\.\w)", text) is not None
