"""The release notes in Markdown, and whether CHANGELOG.md names what has to be named."""

import re
from collections.abc import Sequence
from fnmatch import fnmatchcase

from book.assembly import stamps
from book.releases.compare import Change

CHANGELOG = stamps.ROOT / "CHANGELOG.md"
THEOREMS = ("weakened", "removed", "strengthened", "restated", "added")
NUMBERS = ("out of tolerance", "moved", "removed", "added")
PICTURES = ("changed", "removed", "added")


def section(version: str) -> str:
    """Return the text under "## VERSION", to the next heading of that level; Refused if there is no such heading."""
    text = CHANGELOG.read_text(encoding="utf-8")
    match = re.search(rf"^## {re.escape(version)}(?![\w.]).*?$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    if match is None:
        raise stamps.Refused(f"{CHANGELOG.name} has no heading ## {version}")
    return match[1]


def names(id: str, text: str) -> bool:
    """Return whether a text names an id whole (u_curve.least_at does not), or its family in backticks: `u_curve.*`."""
    if any(fnmatchcase(id, family) for family in re.findall(r"`([\w:]+\.[\w.]*\*[\w.*]*)`", text)):
        return True
    return re.search(rf"(?<![\w:-]){re.escape(id)}(?![\w-]|\.\w)", text) is not None


def unnamed(changes: Sequence[Change], changelog: str) -> list[Change]:
    """Return the changes that have to be named in the changelog's section and are not."""
    return [change for change in changes if change.must_be_named and not names(change.id, changelog)]


def written(
    title: str, mathematics: Sequence[Change], numbers: Sequence[Change], pictures: Sequence[Change], missing: Sequence
) -> str:
    """Return the notes: the mathematics, the numbers, the pictures; at the end what the changelog has to name."""
    parts = [f"# {title}"]
    changed = {"Theorems": (mathematics, THEOREMS), "Numbers": (numbers, NUMBERS), "Pictures": (pictures, PICTURES)}
    for heading, (changes, kinds) in changed.items():
        if changes:
            parts += [f"## {heading}", *filter(None, (_list(changes, kind) for kind in kinds))]
    if len(parts) == 1:
        parts.append("Nothing moved.")
    if missing:
        items = "\n".join(f"- `{change.id}` ({change.kind})" for change in missing)
        parts += ["## Not named in CHANGELOG.md", items]
    return "\n\n".join(parts) + "\n"


def _list(changes: Sequence[Change], kind: str) -> str:
    some = [change for change in changes if change.kind == kind]
    if not some:
        return ""
    head = f"{kind.capitalize()}: {len(some)}"
    lines = (f"- `{change.id}`" + (f": {change.words}" if change.words else "") for change in some)
    return f"{head}\n\n" + "\n".join(lines)
