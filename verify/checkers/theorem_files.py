"""Rules by which a file of theorems is data: its imports, names and calls make claims, and reach no judge of them."""

import ast
import builtins
import re

from proofs.engine.project import PROJECT

FOLDER = PROJECT.folder(PROJECT.theorems)
TRUSTED = ("__init__", "language")
ENGINE = tuple(f"proofs.engine.{name}." for name in ("claim", "half_turns", "vectors"))
IMPORTED = (f"{PROJECT.formulas}.", f"{PROJECT.theorems}.", *ENGINE)
FROM_SYMPY = {"Abs", "Derivative", "Expr", "Max", "Min", "Piecewise", "Rational", "cos", "pi", "sign", "sin", "sqrt"}
READING = {*dir(tuple), *dir(frozenset), "fromkeys", "get", "items", "keys", "values"}
CHANGING = {"diff", "doit", "put", *dir(dict), *dir(list), *dir(set)} - READING
RUNNING = {"evaluate", "import_module", "iter_modules", "lambdify", "mpmathify", "operator", "sympify"}
BUILT_IN = {"dict", "enumerate", "float", "int", "len", "map", "range", "sum", "tuple", "zip"}
BARRED = CHANGING | RUNNING | {"S"} | {*dir(builtins)} - BUILT_IN
INNER = re.compile(r"_|(ag|cr|f|gi|tb)_")  # of an object, and of Python's own frames


def why_no_data(text: str) -> list[str]:
    """Return why a file's text is more than data: [] if it imports by name, changes no other object, runs no text."""
    tree = ast.parse(text)
    of_s = {
        id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Attribute) and node.attr in ("Zero", "One")
    }
    reasons = ((node, _why_not(node)) for node in ast.walk(tree) if id(node) not in of_s)
    return [f"line {getattr(node, 'lineno', 1)}: {why}" for node, why in reasons if why]


def _why_not(node):
    match node:
        case ast.Import() | ast.ClassDef() | ast.Global() | ast.AugAssign():
            return "imports a module, makes a class, or changes a name"
        case ast.Attribute(ctx=ast.Store() | ast.Del()) | ast.Subscript(ctx=ast.Store() | ast.Del()):
            return "assigns an attribute or an entry"
        case ast.ImportFrom(module="sympy"):
            barred = {alias.name for alias in node.names} - FROM_SYMPY
        case ast.ImportFrom(level=0) if f"{node.module}.".startswith(IMPORTED):
            barred = {alias.name for alias in node.names} & BARRED
        case ast.ImportFrom():
            return f"imports from {node.module}"
        case ast.Name(id=name):
            barred = {name} if name in BARRED or "__" in name else ()
        case ast.Attribute(attr=name):
            barred = {name} if name in CHANGING | RUNNING or INNER.match(name) else ()
        case _:
            return ""
    return f"names {', '.join(sorted(barred))}" if barred else ""


def _why_refused(path):
    if path.parent != FOLDER:
        return ["stands in a folder"]
    return [] if path.stem in TRUSTED else why_no_data(path.read_text(encoding="utf-8"))


def refused() -> list[str]:
    """Return why files of theorems are refused, each by its name and line."""
    files = sorted(FOLDER.rglob("*.py"))
    return [f"{path.relative_to(FOLDER)}, {why}" for path in files for why in _why_refused(path)]
