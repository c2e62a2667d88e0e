"""The project that the tools work on: its packages, folders, ids and lists, a table of its pyproject.toml.

    [tool.symbolic-book]
    packages = ["kepler"]
    theorems = "kepler.theorems"
    figures = "kepler.figures"

PROJECT is that of the nearest pyproject.toml, in the working directory or above it. Where this has no such table, the
tools read the chapter that they came with, and write nothing. No SymPy here: `proofs.check` is bare Python.
"""

import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

FILE = "pyproject.toml"
HOME = Path(__file__).resolve().parents[2]  # of the tools, which may be another project's
FOLDERS = {"certificates": "certificates", "pages": "pages", "formal": "formal", "bibliography": "references.bib"}
"""{field that is a path from the project's root: its default}"""

Names = Sequence[str]
Table = Mapping[str, str]
NOTHING: Mapping[str, Any] = MappingProxyType({})


class Project(NamedTuple):
    """A book's project. Modules and packages are named by dots, other files by paths from the root.

    root: the folder of its file; writable: whether the working directory is in it. packages: those that theorems and
    figures may read, beside the tools'; above: those that build upon them. theorems, formulas, figures, measurements:
    packages of these; measuring: those that measurements may call. pages: the folder of the book's pages; page:
    {office: the page that has it}, of findings, legend, graph, trust, seed, times and shell, whose frame an edition
    takes; sections: the pages that come first; laboratory: the page with cells. name: of the editions. printed: {file:
    "module:function" of its text}; kernels: the printed module. programs: {script of the site: the module with its
    `source`}; directives: further modules of the extension. tex: "module:name" of {symbol: TeX}. slowest: the figures
    that take longest. records: {name: the fields of a `verify.evidence.records.Record`}; results, benchmarks: their
    folders. formal: the folder of Coq's files; trusted: {one: its hash}.
    """

    root: Path
    certificates: Path
    pages: Path
    formal: Path
    bibliography: Path
    theorems: str
    figures: str
    writable: bool = True
    packages: Names = ()
    above: Names = ()
    formulas: str = "formulas"
    measurements: str = "measurements"
    measuring: Names = ()
    page: Table = NOTHING
    sections: Names = ()
    laboratory: str = "laboratory.md"
    name: str = "book"
    printed: Table = NOTHING
    kernels: str = ""
    programs: Table = NOTHING
    directives: Names = ()
    tex: str = ""
    slowest: Names = ()
    records: Mapping[str, Mapping[str, Any]] = NOTHING
    results: str = ""
    benchmarks: str = ""
    trusted: Table = NOTHING

    @property
    def generated(self) -> Path:
        """The folder of drawn figures and of the report."""
        return self.pages / "_generated"

    @property
    def report(self) -> Path:
        """The report of a run of the theorems."""
        return self.generated / "proofs.json"

    def require_writable(self) -> None:
        """Raise SystemExit where the working directory is not in it."""
        if not self.writable:
            raise SystemExit(f"no {FILE} here or above has a table [tool.symbolic-book]: nothing is written")

    def folder(self, package: str) -> Path:
        """Return the folder of a package of the project, by its dotted name."""
        return self.root.joinpath(*package.split("."))


def project_of(folder: Path) -> Project:
    """Return the project that tools work on in a folder; raise TypeError where its table has an unknown field."""
    near = next((place for place in (folder, *folder.parents) if (place / FILE).is_file()), folder)
    for root, file in ((near, near / FILE), (HOME, HOME / "proofs" / FILE), (HOME, HOME / FILE)):  # the wheel's, ours
        table = tomllib.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
        if fields := table.get("tool", {}).get("symbolic-book"):
            folders = {field: root / fields.get(field, default) for field, default in FOLDERS.items()}
            return Project(root, **fields | folders, writable=root == near)
    raise ValueError(f"no {FILE} has a table [tool.symbolic-book]")


PROJECT = project_of(Path.cwd())
