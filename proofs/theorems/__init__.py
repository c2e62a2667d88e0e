"""The theorems, one module a topic: every `Theorem` at the top level of a module is found.

All are run here under `evaluate(False)`, the formulas before them: a claim is what its file says, and what SymPy would
cancel, take the root of or decide arrives at the translation as it is written. Nor does SymPy read text, as in
`cos("x")`: it would run it as Python.
"""

from importlib import import_module
from pkgutil import iter_modules
from unittest.mock import patch

from sympy import evaluate
from sympy.parsing import sympy_parser

from proofs import formulas


def run_all() -> None:
    """Run the formulas, which SymPy evaluates, and then the theorems, in which it evaluates nothing."""
    for package, path, is_evaluated in ((formulas.__name__, formulas.__path__, True), (__name__, __path__, False)):
        with evaluate(is_evaluated), patch.object(sympy_parser, "parse_expr", None):
            for module in sorted(m.name for m in iter_modules(path)):
                import_module(f"{package}.{module}")


run_all()
