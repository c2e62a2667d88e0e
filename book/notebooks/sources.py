"""The project's sources that some code needs: the modules it imports, directly or not."""

import ast
import hashlib
import json
import tomllib
from functools import cache

from book import stamps


@cache
def project():
    """Return (the project's version, the least Numba that it works with), both text, from `pyproject.toml`."""
    settings = tomllib.loads((stamps.ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    numba = next(need for need in settings["dependencies"] if need.startswith("numba>="))
    return settings["version"], numba.removeprefix("numba>=")


@cache
def modules():
    """Return {path from the root: text} of every module of `proofs/` and `renderer/`."""
    paths = [path for name in ("proofs", "renderer") for path in sorted((stamps.ROOT / name).rglob("*.py"))]
    return {path.relative_to(stamps.ROOT).as_posix(): path.read_text(encoding="utf-8") for path in paths}


def imported(code, package=()):
    """Return the dotted names of modules that a source may import; `package`: the names of the package it stands in."""
    names = set()
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            module = ".".join((*base, *([node.module] if node.module else [])))
            names.update([module, *(f"{module}.{alias.name}" for alias in node.names)])
    return names


def closure(code):
    """Return {path: text} of the modules that some code needs, the packages around them included."""
    texts, found, waiting = modules(), {}, imported(code)
    while waiting:
        parts = waiting.pop().split(".")
        for length in range(1, len(parts) + 1):
            stem = "/".join(parts[:length])
            for path in (f"{stem}/__init__.py", f"{stem}.py"):
                if path in texts and path not in found:
                    found[path] = texts[path]
                    waiting |= imported(texts[path], tuple(path.split("/")[:-1]))
    return dict(sorted(found.items()))


def hashes(sources):
    """Return {path: SHA-256} of a closure."""
    return {path: hashlib.sha256(text.encode()).hexdigest() for path, text in sources.items()}


def digest(sources):
    """Return one SHA-256 for a closure: that of its hashes as JSON."""
    return hashlib.sha256(json.dumps(hashes(sources)).encode()).hexdigest()
