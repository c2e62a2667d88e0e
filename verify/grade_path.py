"""The lines that a grade passes through, from claim to grade, Coq's included:  python -m verify.grade_path [FOLDER]

Every module of this repository that the checkers of claims import, or what asks Coq, directly or not, as soon as they
are imported; lines without comments, docstrings and blanks. What a function imports, such as the search, decides no
grade. What prints float64's operations, of which Coq alone proves something, is counted behind it. FOLDER is another
checkout, to compare with.
"""

import argparse
import ast
from pathlib import Path

from verify.sources import PACKAGES, ROOT, imported, without_prose

ENTRANCES = (
    "verify/checkers/proof_checker.py",
    "verify/checkers/theorem_files.py",
    "verify/formal.py",
    "renderer/generate/coq.py",
)
PRINTS_CLAIMS = "renderer/generate/statements.py"  # since there are printed claims
PRINTS_FLOAT64 = "renderer/generate/float64.py"
CLAIMED = ("proofs/formulas/", "proofs/theorems/")  # what is graded, and no part of how


def modules(root: Path, *more: str) -> dict[str, int]:
    """Return {module's path from the root: its lines} of a checkout; more: further modules to begin with."""
    waiting, found = {*ENTRANCES, PRINTS_CLAIMS, *more}, {}
    while waiting:
        name = waiting.pop()
        if name.startswith(CLAIMED) or not (root / name).is_file():
            continue
        found[name] = len(without_prose(root / name).splitlines())
        waiting |= {path for path in _imported(root, name) if path not in found}
    return found


class _WithoutFunctions(ast.NodeTransformer):
    def visit_FunctionDef(self, _):
        return ast.Pass()


def _imported(root, name):
    at_once = _WithoutFunctions().visit(ast.parse((root / name).read_text(encoding="utf-8")))
    paths = (name.replace(".", "/") for name in imported(ast.unparse(at_once))[0] if name.split(".")[0] in PACKAGES)
    return {file for path in paths for file in (f"{path}.py", f"{path}/__init__.py") if (root / file).is_file()}


def main() -> None:
    """Print the modules, each with its lines, and their sum."""
    parser = argparse.ArgumentParser(prog="python -m verify.grade_path", description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT, help="another checkout")
    folder = parser.parse_args().folder
    found, more = modules(folder), modules(folder, PRINTS_FLOAT64)
    for name, lines in sorted(found.items()):
        print(f"{lines:6} {name}")
    print(f"{sum(found.values()):6} lines in {len(found)} modules")
    print(f"{sum(more.values()):6} with those that print float64's operations")


if __name__ == "__main__":
    main()
