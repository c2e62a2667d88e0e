"""Print the chapter, unless the print is up to date."""

from book.build import stamps, website

PLACE = website.BOOK / "_build" / "pdf" / "bump-mapping.pdf"


def make() -> None:
    """Print the built site's pages into one PDF, which appears whole or not at all; raises NoBrowser."""
    from book.editions.chromium import print_document
    from book.editions.paper import document

    site = stamps.read("site")
    if site is not None and stamps.read("pdf") == site and PLACE.is_file():
        print("  skipped: the site has not changed")
        return
    stamps.remove("pdf")
    print("  Chromium typesets every page (a minute)", flush=True)
    made = print_document(document(website.SITE))
    stamps.write_whole(PLACE, made)
    stamps.write("pdf", site)
    print(f"  {len(made) / 1e6:.1f} MB")
