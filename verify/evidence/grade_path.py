"""The modules that a grade passes through, from claim to grade, Coq's included.

Every module of this repository that the checkers of claims, or those that ask Coq, import as they are imported,
directly or not. A module that a function imports, such as the search, decides no grade. The printer of float64's
operations, of which Coq alone proves anything, is counted behind them.
"""

import ast

from proofs.engine.project import PROJECT
from verify.evidence.sources import PACKAGES, ROOT, imported, without_prose

ENTRANCES = (
    "verify/checkers/proof_checker.py",
    "verify/checkers/theorem_files.py",
    "verify/coq/formal.py",
    "proofs/printers/coq.py",
    "proofs/printers/coq_statements.py",
)
PRINTS_FLOAT64 = "proofs/coq_files.py"
CLAIMED = PROJECT.formulas, PROJECT.theorems  # these are graded, and grade nothing


def modules(*more: str) -> dict[str, int]:
    """Return {module's path from the root: its lines of code}; more: further modules to begin with."""
    waiting, lines = {*ENTRANCES, *more}, {}
    while waiting:
        name = waiting.pop()
        path = ROOT / name
        if path.is_file() and not name.replace("/", ".").startswith(CLAIMED):
            lines[name] = len(without_prose(path).splitlines())
            at_once = _WithoutFunctions().visit(ast.parse(path.read_text(encoding="utf-8")))
            names = [name.replace(".", "/") for name in imported(ast.unparse(at_once))[0]]
            ours = {
                f"{name}{end}" for name in names if name.split("/")[0] in PACKAGES for end in (".py", "/__init__.py")
            }
            waiting |= ours - lines.keys()
    return lines


class _WithoutFunctions(ast.NodeTransformer):
    def visit_FunctionDef(self, _):
        return ast.Pass()
