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
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FILE, TABLE = "pyproject.toml", "symbolic-book"
HOME = Path(__file__).resolve().parents[2]  # of the tools, which may be another project's
FOLDERS = {"certificates": "certificates", "pages": "pages", "formal": "formal", "bibliography": "pages/references.bib"}
"""{what is a path from the project's root: that by default}"""


@dataclass(frozen=True)
class Project:
    """A book's project. Modules and packages are named by dots, other files by paths from the root.

    name: the editions' file names. packages: those that theorems and figures may read; above: those that build upon
    them. theorems, formulas, figures, measurements: packages of these; measuring: those of what measurements may call.
    pages: the folder of the book's pages; page: {office: the page that has it}, of findings, legend, graph, trust,
    seed, times and shell (whose frame an edition takes); badges: the legend's id; sections: the pages that come first;
    laboratory: the page with cells. printed: {file: "module:function" of its text}. programs: {script of the site: the
    module with its `source`}. kernels: the printed module. tex: "module:name" of {symbol: TeX}. slowest: the figures
    that take longest. results, benchmarks: folders of records; records: {name: the fields of a `Record`}. trusted:
    {Coq's file: its hash}; partly: {theorem: what of its words Coq was not told}. writable: whether the working
    directory is in it.
    """

    root: Path
    certificates: Path
    pages: Path
    formal: Path
    bibliography: Path
    packages: Sequence[str]
    theorems: str
    figures: str = ""
    name: str = "book"
    above: Sequence[str] = ()
    formulas: str = ""
    measurements: str = ""
    measuring: Sequence[str] = ()
    page: Mapping[str, str] = field(default_factory=dict)
    badges: str = "badges"
    sections: Sequence[str] = ()
    laboratory: str = ""
    printed: Mapping[str, str] = field(default_factory=dict)
    programs: Mapping[str, str] = field(default_factory=dict)
    kernels: str = ""
    tex: str = ""
    slowest: Sequence[str] = ()
    results: str = ""
    benchmarks: str = ""
    records: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    trusted: Mapping[str, str] = field(default_factory=dict)
    partly: Mapping[str, str] = field(default_factory=dict)
    writable: bool = True

    @classmethod
    def read(cls, path: Path, **more: Any) -> "Project":
        """Return the project of a file, or of the folder that it is in; raises KeyError where it has no table."""
        path = path / FILE if path.is_dir() else path
        table = {"root": path.parent} | tomllib.loads(path.read_text(encoding="utf-8"))["tool"][TABLE] | more
        return cls(**table | {key: table["root"] / table.get(key, place) for key, place in FOLDERS.items()})

    @property
    def generated(self) -> Path:
        """The folder of drawn figures, and of the report."""
        return self.pages / "_generated"

    @property
    def report(self) -> Path:
        """The report of a run of the theorems."""
        return self.generated / "proofs.json"

    def folder(self, package: str) -> Path:
        """Return the folder of one of its packages."""
        return self.root.joinpath(*package.split("."))


def project_of(folder: Path) -> Project:
    """Return the project that tools work on in a folder."""
    near = next((path for place in (folder, *folder.parents) if (path := place / FILE).is_file()), None)
    if near and TABLE in tomllib.loads(near.read_text(encoding="utf-8")).get("tool", {}):
        return Project.read(near)
    packed = HOME / "proofs" / FILE  # where the wheel has it
    return Project.read(packed if packed.is_file() else HOME / FILE, root=HOME, writable=False)


PROJECT = project_of(Path.cwd())
