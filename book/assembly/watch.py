"""The watch: a process that builds each edited page and shows it, below its errors: `python -m book watch`.

Only pages are watched: after a change of figures, theorems or the extension run `python -m book`.
"""

import html
import io
import os
import re
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

from jupyter_book.config import get_final_config
from sphinx.application import Sphinx
from sphinx.util.console import strip_colors
from sphinx.util.docutils import docutils_namespace, patch_docutils

from book.assembly import website
from book.assembly.contents import page_files

FOLDER = website.BOOK / "_build" / "watched"
ON_TOP = """
<pre class="wrong" style="background: #b00; color: #fff; margin: 0; white-space: pre-wrap">{wrong}</pre>
<script>
setInterval(async () => (await (await fetch("/built")).text()) !== "{built}" && location.reload(), 500);
</script>"""


@contextmanager
def builder(book: Path, folder: Path) -> Iterator[Callable[[], str]]:
    """Give the function that builds in `folder`/html those pages of a book that changed since it was called last.

    It returns what is wrong, and reads an edited page again with each build until nothing is.
    """
    settings, _ = get_final_config(
        user_yaml=book / "_config.yml", sourcedir=book, cli_config={"latex_individualpages": False}
    )
    with patch_docutils(str(book)), docutils_namespace():
        out, trees, warnings, edited = str(folder / "html"), str(folder / ".doctrees"), io.StringIO(), set()
        app = Sphinx(str(book), None, out, trees, "html", settings, status=None, warning=warnings)

        def read_again(app, environment, added, changed, removed):
            edited.update(changed)
            return edited & environment.found_docs

        def build():
            start = time.perf_counter()
            warnings.truncate(warnings.seek(0))
            try:
                app.build()
            except Exception as error:  # whatever an edit has led to: the next one may mend it
                warnings.write(f"{type(error).__name__}: {error}")
            wrong = strip_colors(warnings.getvalue()).strip()
            if not wrong:
                edited.clear()
            print(f"  built in {time.perf_counter() - start:.1f} s", *filter(None, [wrong]), sep="\n", flush=True)
            return wrong

        app.connect("env-get-outdated", read_again)
        yield build


class Site(ThreadingHTTPServer):
    """The built pages on this machine alone, each with what is `wrong` on top; it comes anew with each build."""

    def __init__(self, folder: Path, port: int):
        super().__init__(("127.0.0.1", port), partial(Handler, directory=str(folder)))
        self.wrong, self.built = "", 0
        Thread(target=self.serve_forever, daemon=True).start()


class Handler(SimpleHTTPRequestHandler):
    """Answers for a site."""

    server: Site

    def log_message(self, *_: object) -> None:
        """Say nothing of a request: what is wrong with a page would be lost among them."""

    def do_GET(self) -> None:
        """Send a page with what stands on top of it, the number of the last build, or a file as it is."""
        path = Path(self.translate_path(self.path))
        path = path / "index.html" if path.is_dir() else path
        on_top = ON_TOP.format(wrong=html.escape(self.server.wrong), built=self.server.built)
        if self.path == "/built":
            text = str(self.server.built)
        elif path.suffix == ".html" and path.is_file():
            text = re.sub("<body.*?>", lambda body: body[0] + on_top, path.read_text(encoding="utf-8"), count=1)
        else:
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        self.wfile.write(text.encode())


def watch(port: int) -> None:
    """Serve the site at a port until interrupted; a browser shows an edited page by itself."""
    os.environ.update(website.environment(website.execution_cache()) | {"BOOK_WATCHED": "yes"})  # see scripts.py
    shutil.rmtree(FOLDER, ignore_errors=True)
    shutil.copytree(website.SITE, FOLDER / "html")  # whose sources have their pages
    pages = page_files(website.BOOK).values()
    with builder(website.BOOK, FOLDER) as build, suppress(KeyboardInterrupt):
        site = Site(FOLDER / "html", port)
        times: dict[Path, int] = {}
        print(f"The book is at http://localhost:{port}; Ctrl-C ends this", flush=True)
        while True:
            if times != (times := {page: page.stat().st_mtime_ns for page in pages if page.exists()}):
                site.wrong = build()
                site.built += 1
            time.sleep(0.2)
