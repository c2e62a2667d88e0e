"""The build of the site by Jupyter Book: beside the old one, swapped in only when it is whole.

Where words alone changed since the last build, the work on all other pages is kept.
"""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from book.assembly import report, stamps
from book.assembly.contents import page_files
from proofs.engine.project import PROJECT

BOOK, TOOLS = PROJECT.pages, stamps.HOME / "book"
SITE = BOOK / "_build" / "html"
INDEX = SITE / "index.html"
WORK = BOOK / "_build" / "work"
CACHES = stamps.ROOT / ".jupyter_cache"
MARKS = re.compile(r"^ *(?:#|:{2,}|`{3}|:\w|\(\S+\)=).*|\{[\w-]+\}`[^`]*`|\]\([^)]*\)", re.MULTILINE)
"""Headings, directives and their options, labels, roles, links: by these alone one page speaks of another."""
EPOCH = "1735689600"  # the date that Sphinx is told: 2025-01-01, so that two builds give the same bytes


def site_hashes() -> dict[str, str]:
    """Return the hashes of everything that the site is made from, drawn figures included."""
    files = [path for folder in {BOOK, BOOK / "_generated", TOOLS} for path in stamps.files_in(folder)]
    tests = [*(stamps.ROOT / "tests").glob("*.py"), *stamps.files_in(stamps.ROOT / "tests" / "examples")]  # pages show
    return stamps.hashes([*report.packages(), *files, *tests, stamps.LOCK_FILE, stamps.ROOT / "pyproject.toml"])


def execution_cache() -> Path:
    """Return the folder of executed cells: one for each state of the packages that a cell can import.

    Jupyter's own cache looks at the cells alone; this way prose edits run nothing, package edits everything.
    """
    how = [TOOLS / "drawing" / "matplotlibrc", TOOLS / "extension" / "pages.py"]  # how cells draw, and how they run
    files = [*report.packages(), *how, stamps.LOCK_FILE]
    return CACHES / stamps.key(stamps.hashes(files))


def environment(cache: Path) -> dict[str, str]:
    """Return the environment of the build: no clock, random hash, time zone, or backend that drops figures."""
    inherited = {name: value for name, value in os.environ.items() if name != "MPLBACKEND"}
    return inherited | {
        "SOURCE_DATE_EPOCH": EPOCH,
        "PYTHONHASHSEED": "0",
        "TZ": "UTC",
        "MATPLOTLIBRC": str(TOOLS / "drawing" / "matplotlibrc"),
        "PYTHONPATH": f"{stamps.ROOT}{os.pathsep}{stamps.HOME}",
        "PATH": os.pathsep.join([str(Path(sys.executable).parent), inherited.get("PATH", os.defpath)]),
        "BOOK_EXECUTION_CACHE": str(cache),
    }


def hash_of(folder: Path) -> str:
    """Return one hash of all files of a folder."""
    return stamps.key(stamps.file_hashes(folder.rglob("*"), root=folder))


def built() -> dict[str, str]:
    """Return one hash of all the site's files."""
    return {"site": hash_of(SITE)}


def marks() -> str:
    """Return one hash of what pages say to each other."""
    pages = page_files(BOOK).items()
    return stamps.key({name: MARKS.findall(path.read_text(encoding="utf-8")) for name, path in pages})


def edited(now: dict[str, str]) -> list[str] | None:
    """Return the pages of which words changed since the kept work; None where more did, or the work itself."""
    kept = stamps.read("work")
    if not kept or kept["marks"] != marks() or kept["files"] != hash_of(WORK):
        return None
    changed = {path for path, _ in kept["sources"].items() ^ now.items()}
    pages = {path.relative_to(stamps.ROOT).as_posix(): name for name, path in page_files(BOOK).items()}
    return [pages[path] for path in changed] if changed <= pages.keys() else None


def build() -> None:
    """Build the site if anything that it is made from changed, or a file of its own."""
    now = site_hashes()
    if stamps.read("site") == now | built():
        print("  skipped: nothing that it is made from has changed")
        return
    stamps.remove("site")
    cache = execution_cache()
    for other in {*CACHES.glob("*")} - {cache}:
        shutil.rmtree(other, ignore_errors=True)
    pages = edited(now)
    stamps.remove("work")
    if pages is None:
        shutil.rmtree(WORK, ignore_errors=True)
    (WORK / "_build" / "html" / "_static" / "search-text.js").unlink(missing_ok=True)  # no page has a hash of it
    build_into(WORK, cache, pages)
    shutil.rmtree(SITE, ignore_errors=True)
    shutil.copytree(WORK / "_build" / "html", SITE, ignore=shutil.ignore_patterns(".buildinfo"))  # of the place, too
    stamps.write("work", {"sources": now, "marks": marks(), "files": hash_of(WORK)})
    stamps.write("site", now | built())


def build_into(folder: Path, cache: Path, pages: Iterable[str] | None = None) -> None:
    """Run Jupyter Book with every warning an error; the site is then in `folder`/_build/html.

    pages: those that are read again, where the work on the others is there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    again = {} if pages is None else {"BOOK_EDITED": " ".join(pages)}
    options = ["-W", "-n", "--keep-going", "-q", "--path-output", str(folder)]
    command = ["jupyter-book", "build", str(BOOK), *options]
    print("  running Jupyter Book (half a minute when the laboratory's cells have to run)", flush=True)
    done = subprocess.run(command, cwd=stamps.ROOT, env=environment(cache) | again, text=True, capture_output=True)
    if done.returncode:
        print(done.stdout, done.stderr, sep="\n", file=sys.stderr)
        done.check_returncode()
