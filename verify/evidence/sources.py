"""Sources of a result: hashes of all files that its code can reach, never too few, rather too many."""

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
# The modules of the names, "module:name", that the project gives: what asks pkgutil for a name reaches them all.
NAMED = {text.partition(":")[0] for text in (*PROJECT.printed.values(), PROJECT.tex)}
LAZY = "_HOMES"  # {name: the module that a package imports it from when it is first asked for}


def files_in(folder: Path) -> Iterator[Path]:
    """Yield every source and data file below a folder, build products left out."""
    for path in sorted(folder.rglob("*")):
        product = PRODUCTS.intersection(path.relative_to(folder).parts)
        if path.is_file() and not product and not path.name.startswith("."):
            yield path


def place(path: Path) -> Path:
    """Return a file's path from the root, or from the tools' own."""
    return path.relative_to(ROOT if path.is_relative_to(ROOT) else HOME)


def is_test(path: Path) -> bool:
    """Return whether pytest collects a file or is configured by it."""
    return path.name.startswith("test_") or path.name == "conftest.py"


def reachable(source: Path) -> set[Path]:
    """Return the file, its packages, the modules that these import, directly or not, and the data beside them."""
    source = source.resolve()
    around = place(source).with_suffix("").parts if any(map(source.is_relative_to, (ROOT, HOME))) else ()
    files = followed({source, *_module_files(".".join(around))})
    code_only = {PROJECT.pages, PROJECT.folder(PROJECT.figures), HOME / "book"}  # other files beside these are prose
    folders = {path.parent for path in files} - code_only
    beside = [path for folder in folders for path in folder.iterdir() if path.is_file()]
    return files | {path for path in beside if path.suffix not in {".py", ".pyc"} and not path.name.startswith(".")}


def followed(waiting: set[Path]) -> set[Path]:
    """Return the files and the modules of this repository that they import, directly or not."""
    files: set[Path] = set()
    waiting = set(waiting)
    while waiting:
        path = waiting.pop()
        files.add(path)
        waiting |= _direct_imports(path) - files
    return files


def hashes(paths: Iterable[Path]) -> dict[str, str]:
    """Return {path from the root: hash of the bytes}, for files that exist; and the Python that runs them."""
    return {"python": ".".join(map(str, sys.version_info[:3])), **file_hashes(paths)}


def code_hashes(paths: Iterable[Path]) -> dict[str, str]:
    """Return {path from the root: hash}, for files that exist: of Python without its comments and docstrings."""
    return file_hashes(paths, lambda path: without_prose(path).encode() if path.suffix == ".py" else path.read_bytes())


def file_hashes(
    paths: Iterable[Path], content: Callable[[Path], bytes] = Path.read_bytes, root: Path | None = None
) -> dict[str, str]:
    """Return {path from the root: hash of its content}, for files that exist."""
    names = {path.relative_to(root) if root else place(path): path for path in set(paths) if path.is_file()}
    return {name.as_posix(): hashlib.sha256(content(path)).hexdigest()[:16] for name, path in sorted(names.items())}


@cache
def without_prose(path: Path) -> str:
    """Return a Python source without its comments, its strings that are statements, and its blank lines."""
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
    """Return the difference of two tables of hashes, in a few words; None if there is none."""
    changed = [name for name in sorted(before.keys() | now.keys()) if before.get(name) != now.get(name)]
    more = f" and {len(changed) - 1} more" if len(changed) > 1 else ""
    return f"{changed[0]} {'changed' if changed[0] in now else 'is missing'}{more}" if changed else None


def key(table: dict) -> str:
    """Return one hash for a table of hashes."""
    return hashlib.sha256(json.dumps(table, sort_keys=True).encode()).hexdigest()[:16]


@cache
def _direct_imports(path: Path) -> frozenset[Path]:
    if path.suffix != ".py":
        return frozenset()
    package = place(path.parent).parts
    names, computed = imported(path.read_text(encoding="utf-8"), package)
    names |= NAMED if "pkgutil.resolve_name" in names else set()
    files = {file for name in names for file in _module_files(name)}
    if computed:
        around = files_in(path.parents[len(package) - 1])
        files.update(file for file in around if file.suffix == ".py" and not is_test(file))
    return frozenset(files)


def imported(code: str, package: tuple[str, ...] = ()) -> tuple[set[str], bool]:
    """Return the dotted names, perhaps of modules, that a source in a package imports, whether it computes others."""
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
    """Return the file of a module of this repository and of the packages around it; nothing for other modules."""
    parts = name.split(".")
    if parts[0] not in PACKAGES:
        return frozenset()
    places: set[Path] = set()
    for length in range(1, len(parts) + 1):
        modules = (root.joinpath(*parts[:length]) for root in (ROOT, HOME))
        files = ([path for path in (m / "__init__.py", m.with_suffix(".py")) if path.is_file()] for m in modules)
        places.update(next(filter(None, files), ()))
    return frozenset(places)
