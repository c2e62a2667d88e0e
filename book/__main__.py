"""One command that makes the book: check the theorems, draw the figures, build the site.

Usage: python -m book [VERB] [--help]; without a verb, all of it.
"""

import argparse
import subprocess
import sys
import time
from collections.abc import Callable, Sequence

from filelock import FileLock

from book.assembly import report, stamps, website
from book.editions import files
from proofs.engine.project import PROJECT
from renderer.command_line.signals import first_signal_stops, say_stopped
from verify.evidence import __main__ as evidence
from verify.evidence.records import RECORDS

VERBS = {  # those of BUILDING build the site; what RELEASES need is made first
    "build": "theorems, figures and the site, then say where the book is (the default)",
    "figures": "draw the figures that changed",
    "watch": "build, then build an edited page as soon as it is saved, and show it",
    "single": "build, and make of it the chapter as one HTML file that can be mailed",
    "pdf": "build, and make of it the chapter as a PDF, printed by the installed Chromium",
    "release-notes": "what moved since the last release; fails if left unsaid",
    "release": "write releases/VERSION.json and its pictures, if nothing was left unsaid",
    "same-bytes": "build from a clean clone in another folder and compare every byte",
}
EDITIONS = {
    "single": ("Joining the pages in one file", files.SINGLE, files.single_file),
    "pdf": ("Printing the chapter", files.PDF, files.printed),
}
BUILDING = ("build", "watch", "same-bytes", *EDITIONS)


def figures(ids: Sequence[str] = (), force: bool = False) -> None:
    from book.drawing.draw import draw

    draw(ids, force)


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(prog="python -m book", description=__doc__.splitlines()[0])
    verbs = top.add_subparsers(dest="verb", metavar="[VERB]")
    made = {verb: verbs.add_parser(verb, help=words, description=words) for verb, words in VERBS.items()}
    made["figures"].add_argument("ids", nargs="*", metavar="ID", help="only these figures")
    made["figures"].add_argument("--force", action="store_true", help="draw them even if nothing changed")
    made["figures"].add_argument("--list", action="store_true", help="list the figures and what each draws")
    made["watch"].add_argument("--port", type=int, default=8000, metavar="N", help="where it is shown (default: 8000)")
    against = "compare with this release instead of the last"
    made["release-notes"].add_argument("--against", metavar="VERSION", help=against)
    return top


def stage(name: str, work: Callable[[], None]) -> None:
    """Do a stage of the work and say how long it took."""
    print(name, flush=True)
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
    PROJECT.require_writable()
    verb = options.verb or "build"
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
        if verb == "figures":
            stage("Drawing figures", lambda: figures(options.ids, options.force))
            return 0
        stage("Checking the theorems", report.make)
        stage("Drawing figures", figures)
        if verb in BUILDING:
            stage("Building the site", website.build)
        if verb in EDITIONS:
            words, place, content = EDITIONS[verb]
            stage(words, lambda: files.make(verb, place, content))
        if verb not in BUILDING or verb == "same-bytes":
            from book.releases import command, same_bytes

            if verb == "release-notes":
                return command.release_notes(against=options.against)
            return command.release() if verb == "release" else same_bytes.same_bytes()
    if verb == "watch":
        from book.assembly.watch import watch

        watch(options.port)
    else:
        place = EDITIONS[verb][1] if verb in EDITIONS else website.INDEX
        print(f"The book is at {place.relative_to(stamps.ROOT)}: open {place.as_uri()}")
    return 0


def main(arguments: Sequence[str] | None = None) -> int:
    """Return the exit status: 0 when all went well, 1 when a stage or a comparison failed, 2 for a bad command line,
    130 after Ctrl-C, 143 after SIGTERM.

    An error of a figure is not caught: its author needs the whole traceback.
    """
    options = parser().parse_args(arguments)
    try:
        with first_signal_stops():
            return run(options)
    except subprocess.CalledProcessError as error:
        print(f"book: failed with status {error.returncode}; what went wrong is above", file=sys.stderr)
        return 1
    except stamps.Refused as error:
        print(f"book: {error}", file=sys.stderr)
        return error.status
    except KeyboardInterrupt as stop:
        return say_stopped("book", stop)


if __name__ == "__main__":
    sys.exit(main())
