"""The editions of the built site: one file that can be mailed, and the print; each is made when the site changed."""

from collections.abc import Callable
from pathlib import Path

from book.assembly import stamps, website
from proofs.engine.project import PROJECT

SINGLE = website.BOOK / "_build" / "single" / f"{PROJECT.name}.html"
PDF = website.BOOK / "_build" / "pdf" / f"{PROJECT.name}.pdf"
LARGEST = 12_000_000  # bytes of the file; what is larger, many mail servers refuse


class TooLarge(stamps.Refused):
    """The file cannot be mailed."""

    status = 1


def single_file(site: Path = website.SITE) -> bytes:
    """Return the one file's bytes, from the built site; TooLarge if they are too many."""
    from book.editions.document import document

    made = document(site).encode()
    if len(made) > LARGEST:
        raise TooLarge(f"{SINGLE.name} would have {len(made):,} bytes; at most {LARGEST:,} are allowed")
    return made


def printed(site: Path = website.SITE) -> bytes:
    """Return the chapter as PDF, from the built site; raises NoBrowser."""
    from book.editions.chromium import print_chapter

    print("  Chromium lays out every page", flush=True)
    return print_chapter(single_file(site).decode())


def make(name: str, place: Path, content: Callable[[], bytes]) -> None:
    """Write an edition, which appears whole or not at all, unless it is up to date."""
    site = stamps.read("site")
    if site is not None and stamps.read(name) == site | stamps.file_hashes([place], root=place.parent):
        print("  skipped: the site has not changed")
        return
    stamps.remove(name)
    made = content()
    stamps.write_whole(place, made)
    stamps.write(name, site | stamps.file_hashes([place], root=place.parent))
    print(f"  {len(made) / 1e6:.1f} MB")
