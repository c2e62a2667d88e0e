"""One command that makes the book: check the theorems, draw the figures, build the site.

Usage: python -m book [VERB] [--help]; without a verb, all of it.
"""

import argparse
import subprocess
import sys
import time
from collections.abc import Callable, Sequence

from filelock import FileLock

from book.assembly import check, report, stamps, website
from book.drawing import keys
from book.editions import files
from verify import evidence
from verify.records import RECORDS

EDITIONS = {
    "single": ("Joining the pages in one file", files.SINGLE, files.single_file),
    "pdf": ("Printing the chapter", files.PDF, files.printed),
}
BUILDING = ("all", "build", "watch", *EDITIONS)
RELEASES = ("release-notes", "release", "same-bytes")  # what they need is made first


def figures(ids: Sequence[str] = (), force: bool = False) -> None:
    if not ids and not force and keys.nothing_changed():
        print("  all up to date")
        return
    from book.drawing.draw import draw

    before = keys.all_sources()
    draw(ids, force)
    if not ids:
        keys.remember(before)


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(prog="python -m book", description=__doc__.splitlines()[0])
    top.add_argument("--all", action="store_true", help="build every page anew, not only those whose prose changed")
    verbs = top.add_subparsers(dest="verb", metavar="VERB")
    verbs.add_parser("all", help="theorems, figures and the site, then say where the book is (the default)")
    verbs.add_parser("check", help="run the whole checker, pytest verify, if anything that it reaches changed")
    drawing = verbs.add_parser("figures", help="draw the figures that changed")
    drawing.add_argument("ids", nargs="*", metavar="ID", help="only these figures")
    drawing.add_argument("--force", action="store_true", help="draw them even if nothing changed")
    drawing.add_argument("--list", action="store_true", help="list the figures and what each draws")
    verbs.add_parser("build", help="theorems, figures, then the site if anything changed")
    watching = verbs.add_parser("watch", help="after that, build an edited page as soon as it is saved, and show it")
    watching.add_argument("--port", type=int, default=8000, metavar="N", help="where it is shown (default: 8000)")
    verbs.add_parser("single", help="after that, the chapter as one HTML file that can be mailed")
    verbs.add_parser("pdf", help="after that, the chapter as a PDF, printed by the installed Chromium")
    comparing = verbs.add_parser("release-notes", help="what moved since the last release; fails if left unsaid")
    comparing.add_argument("--against", metavar="VERSION", help="compare with this release instead of the last")
    verbs.add_parser("release", help="write releases/VERSION.json and its pictures, if nothing was left unsaid")
    verbs.add_parser("same-bytes", help="build from a clean clone in another folder and compare every byte")
    return top


def stage(name: str, work: Callable[[], None]) -> None:
    """Do a stage of the work and say how long it took."""
    print(f"{name}", flush=True)
    start = time.perf_counter()
    work()
    print(f"  {time.perf_counter() - start:.1f} s", flush=True)


def require_evidence() -> None:
    """Refuse a release while the code has changed since a record was measured; say of each which command renews it."""
    if old := evidence.stale():
        renewed_by = [f"  {name}: {why}: python {RECORDS[name].command}" for name, why in old.items()]
        told = "\n".join(["these records are stale (make evidence renews them all):", *renewed_by])
        raise stamps.Refused(told)


def run(options: argparse.Namespace) -> int:
    verb = options.verb or "all"
    if verb == "figures" and options.list:
        from book.drawing.draw import all_figures

        for id, entry in all_figures().items():
            print(f"{id:24} {' '.join(entry.draw.__doc__.split())}")
        return 0
    if verb == "release":
        require_evidence()
    stamps.STAMPS.mkdir(exist_ok=True)
    # Two builds at once would write the same files: the second waits, and then finds its work done.
    with FileLock(stamps.STAMPS / "lock"):
        if verb == "check":
            stage("Checking everything", check.run)
        if verb == "figures":
            stage("Drawing figures", lambda: figures(options.ids, options.force))
        if verb in (*BUILDING, *RELEASES):
            stage("Checking the theorems", report.make)
            stage("Drawing figures", figures)
        if verb in (*BUILDING, "same-bytes"):
            stage("Building the site", lambda: website.build(options.all or verb == "same-bytes"))
        if verb in EDITIONS:
            words, place, content = EDITIONS[verb]
            stage(words, lambda: files.make(verb, place, content))
        if verb in RELEASES:
            from book.releases import command, same_bytes

            if verb == "release-notes":
                return command.release_notes(against=options.against)
            return command.release() if verb == "release" else same_bytes.same_bytes()
    if verb == "watch":
        from book.assembly.watch import watch

        watch(options.port)
    elif verb in BUILDING:
        place = EDITIONS[verb][1] if verb in EDITIONS else website.INDEX
        print(f"The book is at {place.relative_to(stamps.ROOT)}: open {place.as_uri()}")
    return 0


def main(arguments: Sequence[str] | None = None) -> int:
    """The exit status: 0 when all went well, 1 when a stage or a comparison failed, 2 for a bad command line.

    What a figure raises is not caught: its author needs the whole traceback.
    """
    options = parser().parse_args(arguments)
    try:
        return run(options)
    except subprocess.CalledProcessError as error:
        print(f"book: failed with status {error.returncode}; what went wrong is above", file=sys.stderr)
        return 1
    except stamps.Refused as error:
        print(f"book: {error}", file=sys.stderr)
        return error.status


if __name__ == "__main__":
    sys.exit(main())
