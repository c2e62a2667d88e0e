"""Build the site with Jupyter Book: beside the old one, swapped in only when it is whole.

What Sphinx knows of the pages is kept in WORK from one build to the next.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from book.assembly import report, stamps
from book.assembly.contents import page_files

BOOK = stamps.ROOT / "book"
SITE = BOOK / "_build" / "html"
INDEX = SITE / "index.html"
WORK = BOOK / "_build" / "work"
CACHES = stamps.ROOT / ".jupyter_cache"
EPOCH = "1735689600"  # the date that Sphinx is told: 2025-01-01, so that two builds give the same bytes
# What other pages can see of a page: lines with titles, labels, directives and the front matter; what is cited.
STRUCTURE = re.compile(r"^[ \t>]*(?:#|\(|:::|```|---|\w+:).*\n|\{cite[^`]*`[^`]*`", re.MULTILINE)


def site_hashes() -> dict[str, str]:
    """The hashes of everything that the site is made from, drawn figures included."""
    files = [path for folder in (BOOK, BOOK / "_generated") for path in stamps.files_in(folder)]
    tests = (stamps.ROOT / "tests").glob("*.py")  # the ledger names them, and the site shows those
    return stamps.hashes([*report.packages(), *files, *tests, stamps.LOCK_FILE, stamps.ROOT / "pyproject.toml"])


def execution_cache() -> Path:
    """Where executed cells are kept: a folder for each state of the packages that a cell can import.

    Jupyter's own cache looks at the cells alone; this way prose edits run nothing, package edits everything.
    """
    how = [BOOK / "drawing" / "matplotlibrc", BOOK / "extension" / "assets.py"]  # how cells draw, and how they run
    files = [*report.packages(), *how, stamps.LOCK_FILE]
    return CACHES / stamps.key(stamps.hashes(files))


def environment(cache: Path) -> dict[str, str]:
    """The environment of the build: no clock, random hash, time zone, or backend that drops figures."""
    kept = {name: value for name, value in os.environ.items() if name != "MPLBACKEND"}
    return kept | {
        "SOURCE_DATE_EPOCH": EPOCH,
        "PYTHONHASHSEED": "0",
        "TZ": "UTC",
        "MATPLOTLIBRC": str(BOOK / "drawing" / "matplotlibrc"),
        "PYTHONPATH": str(stamps.ROOT),
        "PATH": os.pathsep.join([str(Path(sys.executable).parent), kept.get("PATH", os.defpath)]),
        "BOOK_EXECUTION_CACHE": str(cache),
    }


def foundation(now: dict[str, str]) -> str:
    """One hash of all but the pages' own prose: while it stays, an edited page changes itself and the search alone."""
    pages = {path.relative_to(BOOK.parent).as_posix(): path for path in page_files(BOOK).values()}
    structure = {name: "".join(STRUCTURE.findall(path.read_text(encoding="utf-8"))) for name, path in pages.items()}
    return stamps.key(now | structure | {"place": str(BOOK)})


def build(whole: bool = False) -> None:
    """Build the site if anything that it is made from changed: the pages whose prose did, or all.

    whole: build all, unless that is how the site was made last.
    """
    now, kept = site_hashes(), stamps.read("pages") or {}
    if stamps.read("site") == now and INDEX.is_file() and not (whole and kept.get("edited")):
        print("  skipped: nothing that it is made from has changed")
        return
    stamps.remove("site")
    stamps.remove("pages")
    cache, found = execution_cache(), foundation(now)
    for other in CACHES.iterdir() if CACHES.is_dir() else ():
        if other != cache:
            shutil.rmtree(other, ignore_errors=True)
    edited = WORK.is_dir() and kept.get("foundation") == found and not whole
    # What Sphinx copies, it names by its bytes where it finds it before it writes a page: so a whole build does not.
    shutil.rmtree(WORK / "_build" / "html" / "_static" if edited else WORK, ignore_errors=True)
    build_into(WORK, cache)
    next_site = SITE.with_name("next")
    shutil.rmtree(next_site, ignore_errors=True)
    # .buildinfo depends on where the site was built
    shutil.copytree(WORK / "_build" / "html", next_site, ignore=shutil.ignore_patterns(".buildinfo"))
    shutil.rmtree(SITE, ignore_errors=True)
    next_site.rename(SITE)
    stamps.write("pages", {"foundation": found, "edited": edited})
    stamps.write("site", now)


def build_into(folder: Path, cache: Path) -> None:
    """Run Jupyter Book with every warning an error; the site is then in `folder`/_build/html."""
    folder.mkdir(parents=True, exist_ok=True)
    program = "import sys; from jupyter_book.cli.main import main; sys.exit(main())"
    options = ["-W", "-n", "--keep-going", "-q", "--path-output", str(folder)]
    command = [sys.executable, "-c", program, "build", str(BOOK), *options]
    print("  running Jupyter Book (half a minute when the laboratory's cells have to run)", flush=True)
    done = subprocess.run(command, cwd=stamps.ROOT, env=environment(cache), text=True, capture_output=True)
    if done.returncode:
        lines = filter(str.strip, (done.stdout + done.stderr).splitlines())
        # Greetings, and the kernel's remark on encryption.
        noise = ("Running Jupyter-Book", " Folder:", "Config Path:", "Output Path:", "[IPKernelApp]", "=====")
        print("\n".join(line for line in lines if not any(n in line for n in noise)), file=sys.stderr)
        done.check_returncode()
