"""Names of pages in whatever folder, ids of their sections, the execution of cells; and the compiled code."""

import os
from functools import partial
from importlib import import_module
from pathlib import Path, PurePosixPath

import nbclient
from docutils import nodes
from jupyter_cache.executors import utils
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.project import Project
from sphinx_external_toc.parsing import parse_toc_data

from book.assembly import stamps
from book.extension.elements import on
from proofs.engine.project import HOME, PROJECT

PROGRAMS = dict(PROJECT.programs)
LENT = ("html_css_files", "html_js_files", "html_theme_options", "html_context")


class ByName(Project):
    """Pages are called by their files' names alone: chapter/s1.md is s1, at s1.html, as it always was."""

    def path2doc(self, filename: str) -> str | None:
        """Return the page's name, or None for what is no page."""
        name = super().path2doc(filename)
        return name and PurePosixPath(name).name


@on("builder-inited", priority=100)
def call_pages_by_name(app: Sphinx) -> None:
    """Put the rule in the project's place, before any page is looked for."""
    app.project.__class__ = ByName


@on("config-inited", priority=950)
def name_contents(app: Sphinx, config: Config) -> None:
    """Give the contents, which name folders too, the pages' names."""
    contents = Path(app.srcdir) / "_toc.yml"
    if hasattr(config, "external_site_map") and contents.is_file():
        table = stamps.table_in(contents)
        for part in table.get("parts", [table]):
            for chapter in part.get("chapters", ()):
                chapter["file"] = PurePosixPath(chapter["file"]).name
        config.external_site_map = parse_toc_data(table)


@on("config-inited", priority=100)
def lend_frame(app: Sphinx, config: Config) -> None:
    """Lend another project's book what cards, figures and pages need of this one's: templates, styles, scripts."""
    if PROJECT.root != HOME:
        lent = stamps.table_in(HOME / "book" / "_config.yml")["sphinx"]["config"]
        for name in LENT:
            config[name] = lent[name]
        for name in ("templates_path", "html_static_path"):
            config[name] = [str(HOME / "book" / folder) for folder in lent[name]]


@on("doctree-read", priority=100)
def put_explicit_ids_first(app: Sphinx, document: nodes.document) -> None:
    """Let `(s1)=` before a heading give `<section id="s1">`; Sphinx alone gives the section its title's id."""
    explicit = {document.nameids.get(name) for name, is_explicit in document.nametypes.items() if is_explicit}
    for section in document.findall(nodes.section):
        section["ids"].sort(key=lambda id: id not in explicit)


@on("env-updated")
def write_on_two_cores(app: Sphinx, environment: BuildEnvironment) -> None:
    """Let Sphinx write pages in two processes; one reads them, and runs the laboratory's cells."""
    if "BOOK_EXECUTION_CACHE" in os.environ:  # set by book/assembly/website.py, and by no test
        app.parallel = 2


@on("env-get-outdated")
def read_edited(app: Sphinx, environment: BuildEnvironment, *_: set[str]) -> list[str]:
    """Return the pages whose words changed, where the work on the others is kept: a file's time may lie."""
    return os.environ.get("BOOK_EDITED", "").split()


@on("builder-inited")
def write_simulator(app: Sphinx) -> None:
    """Compile what the simulator and the small interactives run."""
    for name, module in PROGRAMS.items() if "BOOK_EDITED" not in os.environ else ():
        stamps.write_whole(Path(app.outdir) / "_static" / name, import_module(module).source().encode())


@on("config-inited", priority=100)
def use_execution_cache(app: Sphinx, config: Config) -> None:
    """Keep outputs of cells where the build says: a cache of its packages too; MyST-NB's own knows the cells alone."""
    if cache := os.environ.get("BOOK_EXECUTION_CACHE"):
        config.nb_execution_cache_path = cache


@on("builder-inited")
def join_streams(app: Sphinx) -> None:
    """Join a cell's printed text to one message: MyST-NB ends each of several with a line end, wherever it was cut."""
    utils.executenb = partial(nbclient.execute, coalesce_streams=True)
