"""Build the site with Jupyter Book: beside the old one, swapped in only when it is whole."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from book.assembly import report, stamps
from proofs.engine.project import PROJECT

BOOK, TOOLS = PROJECT.pages, stamps.HOME / "book"
SITE = BOOK / "_build" / "html"
INDEX = SITE / "index.html"
WORK = BOOK / "_build" / "work"
CACHES = stamps.ROOT / ".jupyter_cache"
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


def built() -> dict[str, str]:
    """Return one hash of all the site's files."""
    return {"site": stamps.key(stamps.file_hashes(SITE.rglob("*"), root=SITE))}


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
    shutil.rmtree(WORK, ignore_errors=True)
    build_into(WORK, cache)
    made = WORK / "_build" / "html"
    (made / ".buildinfo").unlink()  # it depends on where the site was built
    shutil.rmtree(SITE, ignore_errors=True)
    made.rename(SITE)
    shutil.rmtree(WORK)
    stamps.write("site", now | built())


def build_into(folder: Path, cache: Path) -> None:
    """Run Jupyter Book with every warning an error; the site is then in `folder`/_build/html."""
    folder.mkdir(parents=True)
    options = ["-W", "-n", "--keep-going", "-q", "--path-output", str(folder)]
    command = ["jupyter-book", "build", str(BOOK), *options]
    print("  running Jupyter Book (half a minute when the laboratory's cells have to run)", flush=True)
    done = subprocess.run(command, cwd=stamps.ROOT, env=environment(cache), text=True, capture_output=True)
    if done.returncode:
        print(done.stdout, done.stderr, sep="\n", file=sys.stderr)
        done.check_returncode()
