"""What a page is called, whatever folder it stands in, and its sections' own ids."""

import os
from pathlib import Path, PurePosixPath

import yaml
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.project import Project
from sphinx_external_toc.parsing import parse_toc_data

from book.extension.elements import on


class ByName(Project):
    """Pages are called by their files' names alone: chapter/s1.md is s1, at s1.html, as it always was."""

    def path2doc(self, filename: str) -> str | None:
        """The page's name, or None for what is no page."""
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
        table = yaml.safe_load(contents.read_text(encoding="utf-8"))
        for part in table["parts"]:
            for chapter in part["chapters"]:
                chapter["file"] = PurePosixPath(chapter["file"]).name
        config.external_site_map = parse_toc_data(table)


@on("doctree-read", priority=100)
def put_explicit_ids_first(app: Sphinx, document: nodes.document) -> None:
    """`(s1)=` before a heading gives `<section id="s1">`; Sphinx alone gives the section its title's id."""
    explicit = {document.nameids.get(name) for name, is_explicit in document.nametypes.items() if is_explicit}
    for section in document.findall(nodes.section):
        section["ids"].sort(key=lambda id: id not in explicit)


@on("env-updated")
def write_on_two_cores(app: Sphinx, environment: BuildEnvironment) -> None:
    """Pages are read in one process, where the laboratory's cells run, and written in two."""
    if "BOOK_EXECUTION_CACHE" in os.environ:  # set by book/assembly/website.py, and by no test
        app.parallel = 2
