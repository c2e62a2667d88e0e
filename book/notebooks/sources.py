"""The project's sources that some code needs, with and without Numba: the modules it imports, directly or not."""

import ast
import hashlib
import json
import tomllib
from functools import cache

from book import stamps
from book.notebooks.array_kernels import without_compiler

BOTH, NUMBA, NUMPY = "both", "numba", "numpy"
TAKES_OVER = "import renderer.arrays"


@cache
def project():
    """Return (the project's version, the least Numba that it works with), both text, from `pyproject.toml`."""
    settings = tomllib.loads((stamps.ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    numba = next(need for need in settings["dependencies"] if need.startswith("numba>="))
    return settings["version"], numba.removeprefix("numba>=")


@cache
def modules(back_end):
    """Return {path from the root: text} of every module of `proofs/` and `renderer/` with a back end."""
    paths = [path for name in ("proofs", "renderer") for path in sorted((stamps.ROOT / name).rglob("*.py"))]
    texts = {path.relative_to(stamps.ROOT).as_posix(): path.read_text(encoding="utf-8") for path in paths}
    return texts | (without_compiler() if back_end == NUMPY else {})


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


def closure(code, back_end):
    """Return {path: text} of the modules that some code needs with a back end, the packages around them included."""
    texts, found, waiting = modules(back_end), {}, imported(code + (f"\n{TAKES_OVER}" if back_end == NUMPY else ""))
    while waiting:
        parts = waiting.pop().split(".")
        for length in range(1, len(parts) + 1):
            stem = "/".join(parts[:length])
            for path in (f"{stem}/__init__.py", f"{stem}.py"):
                if path in texts and path not in found:
                    found[path] = texts[path]
                    waiting |= imported(texts[path], tuple(path.split("/")[:-1]))
    return found


def bundle(code):
    """Return {"both" | "numba" | "numpy": {path: text}}: what some code needs in any case, and what with each."""
    numba, numpy = closure(code, NUMBA), closure(code, NUMPY)
    both = {path: text for path, text in numba.items() if numpy.get(path) == text}

    def rest(texts):
        return {path: texts[path] for path in sorted(texts) if path not in both}

    return {BOTH: dict(sorted(both.items())), NUMBA: rest(numba), NUMPY: rest(numpy)}


def hashes(sources):
    """Return {part/path: SHA-256} of a bundle."""
    return {
        f"{part}/{path}": hashlib.sha256(text.encode()).hexdigest()
        for part, texts in sources.items()
        for path, text in texts.items()
    }


def digest(sources):
    """Return one SHA-256 for a bundle: that of its hashes as JSON."""
    return hashlib.sha256(json.dumps(hashes(sources)).encode()).hexdigest()
