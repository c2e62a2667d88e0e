"""Sources as pages with numbered lines, certificates and scripts as downloads, files counted and quoted.

{source-lines}`proofs/engine/kernel.py`      how many lines a file has
{trusted-lines}`claims`                      how many lines a grade passes through; `float64`: with its printers
{source-link}`proofs/engine/kernel.py`       a link to its page

:::{printed-lines} bumped_normal
:lines: m_x m_length          the lines of a function of the printed kernels that define these names
:::
"""

import inspect
import re
import shutil
from importlib import import_module
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective, SphinxRole
from sphinx.util.parallel import ParallelTasks, SerialTasks

from book.assembly import report, stamps
from book.assembly.contents import page_files
from book.extension.elements import Nodes, directive, on, role
from book.extension.theorems import certificate, module_and_line, proofs_of
from proofs.engine.project import PROJECT
from proofs.engine.standalone import standalone_script
from verify.evidence import grade_path

DOWNLOADS, KERNELS = "_downloads/theorems", f"{PROJECT.kernels.replace('.', '/')}.py"
LINKED = re.compile(r"\{source-link\}`([^`]+)`")


def listing_address(path: Path) -> str:
    """Return the address of a source's page, from the site's root, where all pages of the book stand."""
    return f"source/{path.relative_to(stamps.ROOT).as_posix()}.html"


def listed(app: Sphinx) -> set[Path]:
    """Return the files that pages link to: by the role, as a theorem's source, as a test that the ledger cites."""
    texts = (path.read_text(encoding="utf-8") for path in page_files(Path(app.srcdir)).values())
    names = {name for text in texts for name in LINKED.findall(text)}
    claims = app.chapter_ledger.claims if hasattr(app, "chapter_ledger") else ()
    names |= {piece.name.partition("::")[0] for claim in claims for piece in claim.evidence if piece.kind == "test"}
    return {stamps.ROOT / name for name in names} | {module_and_line(id)[0] for id in proofs_of(app).theorems}


@on("html-collect-pages")
def write_pages(app: Sphinx) -> tuple:
    """Write the pages of the listed sources that have none yet, and the downloads; nothing is left.

    Sphinx would write what a handler returns in one process.
    """
    if app.builder.name != "html" or not hasattr(app, "chapter_proofs"):
        return ()
    paths = [path for path in sorted(listed(app)) if not Path(app.outdir, listing_address(path)).is_file()]
    if not paths:
        return ()
    write_downloads(app)
    tasks = ParallelTasks(app.parallel) if app.parallel > 1 else SerialTasks()
    for first in range(app.parallel):
        tasks.add_task(lambda chunk: write_listings(app, chunk), paths[first :: app.parallel])
    tasks.join()
    return ()


def write_listings(app: Sphinx, paths: list[Path]) -> None:
    """Write sources as pages: lines with numbers, each with its own id."""
    for path in paths:
        name, text = path.relative_to(stamps.ROOT).as_posix(), path.read_text(encoding="utf-8")
        listing = app.builder.highlighter.highlight_block(text, "python", lineanchors="L", linenos="inline")
        body = f'<h1>{name}</h1>\n<div class="highlight-python listing">{listing}</div>'
        context = {"title": name, "body": body, "parents": [], "html_theme_option": {}}
        app.builder.handle_page(f"source/{name}", context, "page.html")


def write_downloads(app: Sphinx) -> None:
    """Copy every certificate into the site, and write the stand-alone scripts."""
    folder = Path(app.outdir) / DOWNLOADS
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(report.REPORT, folder / "report.json")
    for id in proofs_of(app).theorems:
        if path := certificate(id):
            shutil.copyfile(path, folder / f"{id}.json")
            (folder / f"{id}.py").write_text(standalone_script(id), encoding="utf-8")


@role("source-lines")
def source_lines(here: SphinxRole) -> Nodes:
    lines = (stamps.ROOT / here.text).read_text(encoding="utf-8").splitlines()
    return [nodes.inline("", str(len(lines)), classes=["number"])]


@role("trusted-lines")
def trusted_lines(here: SphinxRole) -> Nodes:
    beside = {"claims": (), "float64": (grade_path.PRINTS_FLOAT64,)}[here.text]
    lines = sum(grade_path.modules(*beside).values())
    return [nodes.inline("", f"{lines:,}", classes=["number"])]


@role("source-link")
def source_link(here: SphinxRole) -> Nodes:
    target = listing_address((stamps.ROOT / here.text).resolve(strict=True))
    return [nodes.reference("", "", nodes.literal("", here.text), refuri=target, internal=True)]


@directive("printed-lines", arguments=1, lines=directives.unchanged_required)
def printed_lines(here: SphinxDirective) -> Nodes:
    (name,) = here.arguments
    body = inspect.getsource(vars(import_module(PROJECT.kernels))[name]).splitlines()
    lines = {line.partition(" = ")[0].strip(): line.strip() for line in body}
    text = "\n".join([f"# {KERNELS}, {name}", *(lines[each] for each in here.options["lines"].split())])
    return [nodes.literal_block(text, text, language="python", classes=["printed-lines"])]
