"""One command that makes the book: check the theorems, draw the figures, build the site.

Usage: python -m book [all | check | figures | build] [--help]
"""

import argparse
import subprocess
import sys
import time
from collections.abc import Callable, Sequence

from filelock import FileLock

from book import stamps
from book.figures.registry import UnknownFigure


def check() -> None:
    """Run the whole checker, unless nothing that it can reach changed since it last passed."""
    from book import check

    check.check()


def report() -> None:
    """Have the theorems' report, which the site is made from too."""
    from book import report

    report.make()


def figures(ids: Sequence[str] = (), force: bool = False) -> None:
    """Draw the figures that changed."""
    from book.figures import fresh

    if not ids and not force and fresh.nothing_changed():
        print("  all up to date")
        return
    from book.figures.draw import draw

    before = fresh.sources()
    draw(ids, force)
    if not ids:
        fresh.remember(before)


def build() -> None:
    """Build the site, unless nothing changed since it was last built."""
    from book import build

    build.build()


def parser() -> argparse.ArgumentParser:
    """The command line."""
    top = argparse.ArgumentParser(prog="python -m book", description=__doc__.splitlines()[0])
    verbs = top.add_subparsers(dest="verb", metavar="VERB")
    verbs.add_parser("all", help="theorems, figures and the site, then say where the book is (the default)")
    verbs.add_parser("check", help="run the whole checker, pytest verify, if anything that it reaches changed")
    drawing = verbs.add_parser("figures", help="draw the figures that changed")
    drawing.add_argument("ids", nargs="*", metavar="ID", help="only these figures")
    drawing.add_argument("--force", action="store_true", help="draw them even if nothing changed")
    drawing.add_argument("--list", action="store_true", help="list the figures and what each draws")
    verbs.add_parser("build", help="theorems, figures, then the site if anything changed")
    return top


def stage(name: str, work: Callable[[], None]) -> None:
    """Do a stage of the work and say how long it took."""
    print(f"{name}", flush=True)
    start = time.perf_counter()
    work()
    print(f"  {time.perf_counter() - start:.1f} s", flush=True)


def run(options: argparse.Namespace) -> None:
    """Do what the command line asked for."""
    verb = options.verb or "all"
    if verb == "figures" and options.list:
        from book.figures.discover import all_figures

        for id, entry in all_figures().items():
            print(f"{id:24} {' '.join(entry.draw.__doc__.split())}")
        return
    stamps.STAMPS.mkdir(exist_ok=True)
    # Two builds at once would write the same files: the second waits, and then finds its work done.
    with FileLock(stamps.STAMPS / "lock"):
        if verb == "check":
            stage("Checking everything", check)
        if verb == "figures":
            stage("Drawing figures", lambda: figures(options.ids, options.force))
        if verb in ("all", "build"):
            stage("Checking the theorems", report)
        if verb in ("all", "build"):
            stage("Drawing figures", figures)
            stage("Building the site", build)
    if verb in ("all", "build"):
        from book.build import INDEX

        print(f"The book is at {INDEX.relative_to(stamps.ROOT)}: open {INDEX.as_uri()}")


def main(arguments: Sequence[str] | None = None) -> int:
    """The exit status: 0 when all went well, 1 when a stage failed, 2 for a bad command line.

    What a figure raises is not caught: its author needs the whole traceback.
    """
    options = parser().parse_args(arguments)
    try:
        run(options)
    except subprocess.CalledProcessError as error:
        print(f"book: failed with status {error.returncode}; what went wrong is above", file=sys.stderr)
        return 1
    except UnknownFigure as error:
        print(f"book: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
