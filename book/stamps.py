"""What a result was made from: hashes of all sources it can reach, never too few, rather too many.

Stamps are small JSON files in `.stamps/`. A result is up to date when its stamp equals what is there now.
"""

import ast
import hashlib
import json
import os
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STAMPS = ROOT / ".stamps"
LOCK_FILE = ROOT / "requirements.lock"
PACKAGES = ("proofs", "renderer", "verify", "book", "tests")
PRODUCTS = {"__pycache__", "_build", "_generated", ".ipynb_checkpoints"}
# A module that imports by computed names can reach anything in its package.
COMPUTED_IMPORTS = {"importlib", "pkgutil", "runpy", "__import__"}
LOOKS_ONLY = ("importlib.util", ["find_spec"])  # and imports nothing


def files_in(folder: Path) -> Iterator[Path]:
    """Every source and data file below a folder, build products left out."""
    for path in sorted(folder.rglob("*")):
        product = PRODUCTS.intersection(path.relative_to(folder).parts)
        if path.is_file() and not product and not path.name.startswith("."):
            yield path


def reachable(source: Path) -> set[Path]:
    """The file, the repository's modules that it imports directly or not, and the data beside those."""
    found: set[Path] = set()
    waiting = [source.resolve()]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            waiting.extend(_direct_imports(path) - found)
    code_only = {ROOT / "book", ROOT / "book" / "figures"}  # what lies beside these is prose
    folders = {path.parent for path in found} - code_only
    data = {other for folder in folders for other in folder.iterdir() if other.is_file() and _is_data(other)}
    return found | data


def hashes(paths: Iterable[Path]) -> dict[str, str]:
    """Path from the root → hash of the bytes, for files that exist; and the Python that runs them."""
    table = {
        path.relative_to(ROOT).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()[:16]
        for path in sorted(set(paths))
        if path.is_file()
    }
    return {"python": ".".join(map(str, sys.version_info[:3])), **table}


def key(table: dict[str, str]) -> str:
    """One hash for a table of hashes."""
    return hashlib.sha256(json.dumps(table, sort_keys=True).encode()).hexdigest()[:16]


def read(name: str) -> dict | None:
    """A stamp's content, or None where there is no readable stamp."""
    try:
        return json.loads((STAMPS / f"{name}.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def write(name: str, content: dict) -> None:
    """Keep a stamp. Call it after the result is in place, never before."""
    write_whole(STAMPS / f"{name}.json", (json.dumps(content, indent=1) + "\n").encode())


def remove(name: str) -> None:
    """Forget a stamp. Call it before a result is touched."""
    (STAMPS / f"{name}.json").unlink(missing_ok=True)


def write_whole(path: Path, content: bytes) -> None:
    """Write a file so that nobody ever sees half of it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    temporary.write_bytes(content)
    temporary.replace(path)


def _is_data(path: Path) -> bool:
    return path.suffix not in {".py", ".pyc", ".nbi", ".nbc"} and not path.name.startswith(".")


@cache
def _direct_imports(path: Path) -> frozenset[Path]:
    if path.suffix != ".py":
        return frozenset()
    tree = ast.parse(path.read_text(encoding="utf-8"), filename=str(path))
    package = path.parent.relative_to(ROOT).parts
    names, computed = set(), False
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = ".".join(package[: len(package) - node.level + 1]) if node.level else ""
            module = ".".join(part for part in (base, node.module) if part)
            if (module, [alias.name for alias in node.names]) == LOOKS_ONLY:
                continue
            names.update([module, *(f"{module}.{alias.name}" for alias in node.names)])
        elif isinstance(node, ast.Name):
            computed |= node.id in COMPUTED_IMPORTS
    found = {file for name in names for file in _module_files(name)}
    if computed or any(name.split(".")[0] in COMPUTED_IMPORTS for name in names):
        found.update(file for file in files_in(ROOT / package[0]) if file.suffix == ".py")
    return frozenset(found)


@cache
def _module_files(name: str) -> frozenset[Path]:
    """The file of a module of this repository and of the packages around it; nothing for other modules."""
    parts = name.split(".")
    if parts[0] not in PACKAGES:
        return frozenset()
    found = set()
    for length in range(1, len(parts) + 1):
        place = ROOT.joinpath(*parts[:length])
        found.update(file for file in (place / "__init__.py", place.with_suffix(".py")) if file.is_file())
    return frozenset(found)
