"""Whether any figure can have changed at all, found without importing one (which would import the renderer)."""

from book import check, stamps


def state() -> dict[str, str]:
    """The hashes of all code and data in the repository, and of what is drawn."""
    drawn = stamps.files_in(stamps.ROOT / "book" / "_generated")
    return stamps.hashes([*check.sources(), *drawn])


def nothing_changed() -> bool:
    """True when everything is as it was when the figures were last seen to be up to date."""
    return stamps.read("figures") == state()


def remember() -> None:
    """Note that every figure is up to date now."""
    stamps.write("figures", state())
