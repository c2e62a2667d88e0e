"""Whether any figure can have changed at all, found without importing one (which would import the renderer)."""

from book.build import check, stamps


def sources() -> dict[str, str]:
    """The hashes of all code and data in the repository that a figure could reach."""
    return stamps.hashes(check.sources())


def nothing_changed() -> bool:
    """True when everything is as it was when the figures were last seen to be up to date."""
    return stamps.read("figures") == {"sources": sources(), "drawn": _drawn()}


def remember(before: dict[str, str]) -> None:
    """Note that the figures agree with these sources, hashed before any figure was drawn."""
    stamps.write("figures", {"sources": before, "drawn": _drawn()})


def _drawn() -> dict[str, str]:
    return stamps.hashes(stamps.files_in(stamps.ROOT / "book" / "_generated"))
