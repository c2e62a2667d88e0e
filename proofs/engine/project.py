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
    `source`}. tex: "module:name" of {symbol: TeX}. slowest: the figures that take longest. records: {name: the fields
    of a `verify.records.Record`}; results, benchmarks: their folders. formal: the folder of Coq's files; trusted: {one:
    its hash}; partly: {theorem: what of its words Coq was not told}.
    """

    root: Path
    certificates: Path
    pages: Path
    formal: Path
    bibliography: Path
    theorems: str
    writable: bool = True
    packages: Names = ()
    above: Names = ()
    formulas: str = ""
    figures: str = ""
    measurements: str = ""
    measuring: Names = ()
    page: Table = NOTHING
    sections: Names = ()
    laboratory: str = ""
    name: str = "book"
    printed: Table = NOTHING
    kernels: str = ""
    programs: Table = NOTHING
    tex: str = ""
    slowest: Names = ()
    records: Mapping[str, Mapping[str, Any]] = NOTHING
    results: str = ""
    benchmarks: str = ""
    trusted: Table = NOTHING
    partly: Table = NOTHING

    @property
    def generated(self) -> Path:
        """The folder of drawn figures and of the report."""
        return self.pages / "_generated"

    @property
    def report(self) -> Path:
        """The report of a run of the theorems."""
        return self.generated / "proofs.json"

    def folder(self, package: str) -> Path:
        """Return the folder of one of its packages."""
        return self.root.joinpath(*package.split("."))


def read(file: Path, root: Path, **more: Any) -> Project | None:
    """Return the project that a file describes, None where it has no table; raise TypeError on an unknown field."""
    if (table := tomllib.loads(file.read_text(encoding="utf-8")).get("tool", {}).get("symbolic-book")) is None:
        return None
    folders = {field: root / table.get(field, default) for field, default in FOLDERS.items()}
    return Project(root, **table | folders | more)


def project_of(folder: Path) -> Project:
    """Return the project that tools work on in a folder."""
    near = next((place for place in (folder, *folder.parents) if (place / FILE).is_file()), None)
    packed = HOME / "proofs" / FILE  # where the wheel has it
    project = near and read(near / FILE, near)
    return project or read(packed if packed.is_file() else HOME / FILE, HOME, writable=False)


PROJECT = project_of(Path.cwd())
