"""Build an edited page anew in a process that stays, and show it: `python -m book watch`.

Only pages are watched. What else a page is made from (figures, theorems, the extension) wants `python -m book`.
"""

import logging
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from jupyter_book.config import get_final_config
from livereload import Server
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils

from book.assembly import website
from book.assembly.contents import page_files

FOLDER = website.BOOK / "_build" / "watched"


@contextmanager
def builder(book: Path, folder: Path) -> Iterator[Callable[[], None]]:
    """Give the function that builds in `folder`/html those pages of a book that changed since it was called last."""
    settings, _ = get_final_config(
        user_yaml=book / "_config.yml", sourcedir=book, cli_config={"latex_individualpages": False}
    )
    with patch_docutils(str(book)), docutils_namespace():
        out, trees = str(folder / "html"), str(folder / ".doctrees")
        app = Sphinx(str(book), None, out, trees, "html", settings, status=None, warning=sys.stderr)

        def build():
            start = time.perf_counter()
            app.build()
            print(f"  built in {time.perf_counter() - start:.1f} s", flush=True)

        yield build


def watch(port: int) -> None:
    """Serve the site on this machine alone, at a port, until interrupted; a browser shows an edited page by itself."""
    for name in ("livereload", "tornado.access"):  # which tell of each request
        logging.getLogger(name).setLevel(logging.WARNING)
    os.environ.update(website.environment(website.execution_cache()) | {"BOOK_WATCHED": "yes"})  # see scripts.py
    shutil.rmtree(FOLDER, ignore_errors=True)
    shutil.copytree(website.SITE, FOLDER / "html")  # whose sources have their pages
    with builder(website.BOOK, FOLDER) as build:
        build()
        print(f"The book is at http://localhost:{port}; Ctrl-C ends this", flush=True)
        server = Server()
        for page in page_files(website.BOOK).values():
            server.watch(str(page), build)
        server.serve(port=port, root=str(FOLDER / "html"))
