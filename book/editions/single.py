"""Write the file, unless it is up to date."""

from pathlib import Path

from book.build import stamps, website

NAME = "bump-mapping.html"
PLACE = website.BOOK / "_build" / "single" / NAME
LARGEST = 12_000_000  # bytes; what is larger, many mail servers refuse


class TooLarge(ValueError):
    """The file cannot be mailed."""


def content(site: Path = website.SITE) -> bytes:
    """The file's bytes, from the built site; TooLarge if they are too many."""
    from book.editions.document import document

    made = document(site).encode()
    if len(made) > LARGEST:
        raise TooLarge(f"{NAME} would have {len(made):,} bytes; at most {LARGEST:,} are allowed")
    return made


def make() -> None:
    """Join the built site's pages into the file, which appears whole or not at all."""
    site = stamps.read("site")
    if site is not None and stamps.read("single") == site and PLACE.is_file():
        print("  skipped: the site has not changed")
        return
    stamps.remove("single")
    made = content()
    stamps.write_whole(PLACE, made)
    stamps.write("single", site)
    print(f"  {len(made) / 1e6:.1f} MB")
