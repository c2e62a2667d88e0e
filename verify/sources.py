"""What a result was made from: hashes of all sources it can reach, never too few, rather too many."""

import ast
import hashlib
import json
import sys
import tokenize
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib.util import resolve_name
from pathlib import Path

from proofs.engine.project import HOME, PROJECT

ROOT = PROJECT.root
TOOLS = ("proofs", "renderer", "verify", "book")
PACKAGES = (*TOOLS, *PROJECT.packages, *PROJECT.above)
PRODUCTS = {"__pycache__", "_build", "_generated", ".ipynb_checkpoints", "node_modules"}
# A module that imports by computed names can reach anything in its package, but for the tests there.
COMPUTED_IMPORTS = {"importlib", "pkgutil", "runpy", "__import__"}
IMPORT_NOTHING = (
    "importlib.metadata",
    "importlib.util.find_spec",
    "importlib.util.resolve_name",
    "pkgutil.resolve_name",
)
# What a module reaches that asks pkgutil for what the project names, "module:name".
NAMED = {text.partition(":")[0] for text in (*PROJECT.printed.values(), PROJECT.tex)}
LAZY = "_HOMES"  # {name: the module that a package imports it from when it is first asked for}


def files_in(folder: Path) -> Iterator[Path]:
    """Every source and data file below a folder, build products left out."""
    for path in sorted(folder.rglob("*")):
        product = PRODUCTS.intersection(path.relative_to(folder).parts)
        if path.is_file() and not product and not path.name.startswith("."):
            yield path


def place(path: Path) -> Path:
    """A file's path from the root, or from the tools' own."""
    return path.relative_to(ROOT if path.is_relative_to(ROOT) else HOME)


def is_test(path: Path) -> bool:
    """Whether a file is one that pytest collects or is configured by."""
    return path.name.startswith("test_") or path.name == "conftest.py"


def reachable(source: Path) -> set[Path]:
    """The file, its packages, the repository's modules that they import directly or not, and the data beside those."""
    source = source.resolve()
    around = place(source).with_suffix("").parts if any(map(source.is_relative_to, (ROOT, HOME))) else ()
    found = followed({source, *_module_files(".".join(around))})
    code_only = {PROJECT.pages, PROJECT.folder(PROJECT.figures), HOME / "book"}  # what lies beside these is prose
    folders = {path.parent for path in found} - code_only
    beside = [path for folder in folders for path in folder.iterdir() if path.is_file()]
    return found | {path for path in beside if path.suffix not in {".py", ".pyc"} and not path.name.startswith(".")}


def followed(waiting: set[Path]) -> set[Path]:
    """The files, and the repository's modules that they import, directly or not."""
    found: set[Path] = set()
    waiting = set(waiting)
    while waiting:
        path = waiting.pop()
        found.add(path)
        waiting |= _direct_imports(path) - found
    return found


def hashes(paths: Iterable[Path]) -> dict[str, str]:
    """Path from the root → hash of the bytes, for files that exist; and the Python that runs them."""
    return {"python": ".".join(map(str, sys.version_info[:3])), **file_hashes(paths)}


def code_hashes(paths: Iterable[Path]) -> dict[str, str]:
    """Path from the root → hash of what it says, for files that exist: of Python without comments and docstrings."""
    return file_hashes(paths, lambda path: without_prose(path).encode() if path.suffix == ".py" else path.read_bytes())


def file_hashes(
    paths: Iterable[Path], content: Callable[[Path], bytes] = Path.read_bytes, root: Path | None = None
) -> dict[str, str]:
    """Path from the root → hash of its content, for files that exist."""
    found = {path.relative_to(root) if root else place(path): path for path in set(paths) if path.is_file()}
    return {name.as_posix(): hashlib.sha256(content(path)).hexdigest()[:16] for name, path in sorted(found.items())}


@cache
def without_prose(path: Path) -> str:
    """A Python source without its comments, its strings that are statements, and its blank lines."""
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    for token in tokenize.generate_tokens(iter(text.splitlines(keepends=True)).__next__):
        if token.type == tokenize.COMMENT:
            row, column = token.start
            lines[row - 1] = lines[row - 1][:column]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            first, last = node.lineno - 1, node.end_lineno or node.lineno
            if not lines[first][: node.col_offset].strip():
                lines[first:last] = [""] * (last - first)
    return "\n".join(line.rstrip() for line in lines if line.strip())


def difference(before: dict[str, str], now: dict[str, str]) -> str | None:
    """What differs between two tables of hashes, in a few words; None if nothing does."""
    changed = [name for name in sorted(before.keys() | now.keys()) if before.get(name) != now.get(name)]
    more = f" and {len(changed) - 1} more" if len(changed) > 1 else ""
    return f"{changed[0]} {'changed' if changed[0] in now else 'is missing'}{more}" if changed else None


def key(table: dict) -> str:
    """One hash for a table of hashes."""
    return hashlib.sha256(json.dumps(table, sort_keys=True).encode()).hexdigest()[:16]


@cache
def _direct_imports(path: Path) -> frozenset[Path]:
    if path.suffix != ".py":
        return frozenset()
    package = place(path.parent).parts
    names, computed = imported(path.read_text(encoding="utf-8"), package)
    names |= NAMED if "pkgutil.resolve_name" in names else set()
    found = {file for name in names for file in _module_files(name)}
    if computed:
        around = files_in(path.parents[len(package) - 1])
        found.update(file for file in around if file.suffix == ".py" and not is_test(file))
    return frozenset(found)


def imported(code: str, package: tuple[str, ...] = ()) -> tuple[set[str], bool]:
    """The dotted names that may be modules which a source in a package imports; and whether it computes others."""
    here, modules, taken, homes, named = ".".join(package), set(), set(), set(), set()
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Import):
            taken |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            module = resolve_name("." * node.level + (node.module or ""), here)
            modules.add(module)
            taken |= {f"{module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == LAZY:
            homes = {f"{here}.{home}" for home in ast.literal_eval(node.value).values()}
        elif isinstance(node, ast.Name):
            named.add(node.id)
    computing = [n for n in taken | named if n.split(".")[0] in COMPUTED_IMPORTS and not n.startswith(IMPORT_NOTHING)]
    return modules | taken | homes, bool(computing and not homes)


@cache
def _module_files(name: str) -> frozenset[Path]:
    """The file of a module of this repository and of the packages around it; nothing for other modules."""
    parts = name.split(".")
    if parts[0] not in PACKAGES:
        return frozenset()
    found: set[Path] = set()
    for length in range(1, len(parts) + 1):
        modules = (root.joinpath(*parts[:length]) for root in (ROOT, HOME))
        files = ([path for path in (m / "__init__.py", m.with_suffix(".py")) if path.is_file()] for m in modules)
        found.update(next(filter(None, files), ()))
    return frozenset(found)
