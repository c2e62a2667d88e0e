"""The campaign: one operator or sign edited at random in the expressions of proofs/, and the checks must fail.

Each edit is made in a copy of the tree. First the quick part of `pytest verify` is run there (are the kernels still
what is generated, do the stored certificates still belong to the formulas); then, if it passes, all of it. The run
writes verify/results/edited_formulas.json, {"label": …, "numbers": …}: commit it.
"""

import ast
import random
import shutil
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import pytest

from verify.benchmark.label import label, write

ROOT = Path(__file__).resolve().parent.parent
RESULT = ROOT / "verify" / "results" / "edited_formulas.json"
SEED, EDITS = 1978, 30
OTHER = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
         ast.USub: ast.UAdd, ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.Lt, ast.GtE: ast.Gt}  # fmt: skip
QUICK = ["verify/test_kernels_printed.py", "verify/test_theorems.py", "--stored"]


def sites(tree):
    """Return [(node, its operator)] for every operator, sign and comparison of a module that can be edited."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.BinOp | ast.UnaryOp | ast.Compare)]
    found = [(node, node.ops[0] if isinstance(node, ast.Compare) else node.op) for node in nodes]
    return [(node, operator) for node, operator in found if type(operator) in OTHER]


def edited(source, index):
    """Return (the source with its index-th site edited, its line, what was done)."""
    tree = ast.parse(source)
    node, operator = sites(tree)[index]
    other = OTHER[type(operator)]()
    if isinstance(node, ast.Compare):
        node.ops[0] = other
    else:
        node.op = other
    return ast.unparse(tree), node.lineno, f"{type(operator).__name__} → {type(other).__name__}"


def draw(seed=SEED, number=EDITS):
    """Return [(path below the root, index of the site)], the same for the same seed and sources."""
    everywhere = [
        (path.relative_to(ROOT), index)
        for path in sorted((ROOT / "proofs" / "formulas").glob("*.py"))
        for index in range(len(sites(ast.parse(path.read_text(encoding="utf-8")))))
    ]
    return random.Random(seed).sample(everywhere, number)


def passes(folder, arguments, seconds=900):
    """Return whether pytest passes in the folder; an edit that keeps a loop from ending is not a pass."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *arguments]
    try:
        return subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=seconds).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def numbers(survivors, seconds):
    """Return what the book cites of a run, whatever it found."""
    return {"edits": EDITS, "caught": EDITS - len(survivors), "minutes": round(seconds / 60), "seed": SEED}


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of what `pytest verify` reads."""
    folder = tmp_path_factory.mktemp("campaign")
    for name in ("proofs", "renderer", "verify", "book/static", "tests/data"):
        if (ROOT / name).exists():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "_build"))
    for name in ("pyproject.toml", "book/references.bib", "CONTRIBUTING.md"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    return folder


def test_there_is_something_to_edit():
    """Edits are what they say: one place, and another program."""
    source = "a = x + y\nb = -x if x < y else x * y\n"
    assert [edited(source, i)[1:] for i in range(len(sites(ast.parse(source))))] == [
        (1, "Add → Sub"),
        (2, "Lt → Gt"),
        (2, "USub → UAdd"),
        (2, "Mult → Div"),
    ]
    assert edited(source, 0)[0].splitlines()[0] == "a = x - y"
    assert len(draw()) == EDITS
    assert numbers(["one that survives"], 90) == {"edits": 30, "caught": 29, "minutes": 2, "seed": SEED}


@contextmanager
def edit(folder, path, index):
    """Edit a site of the copy, yield what was done as text, and put back what was there."""
    original = (folder / path).read_text(encoding="utf-8")
    changed, line, what = edited(original, index)
    (folder / path).write_text(changed, encoding="utf-8")
    yield f"{path}:{line}: {what}"
    (folder / path).write_text(original, encoding="utf-8")


@pytest.mark.long
def test_no_edit_survives(copy):
    """The quick part has to pass without an edit, and the whole one as well before it is asked about any."""
    everything = ["verify", "-n", "2", "--deselect", "verify/test_campaign.py"]
    start, left, survivors = time.monotonic(), [], []
    assert passes(copy, QUICK), "the copy fails before any edit"
    for place in draw():
        with edit(copy, *place) as what:
            left += [place] if passes(copy, QUICK) else []
            print(f"{what}: {'left for the whole of it' if place in left else 'caught'}", flush=True)
    assert not left or passes(copy, everything), "the copy fails before any edit"
    for place in left:
        with edit(copy, *place) as what:
            survivors += [what] if passes(copy, everything) else []
            print(f"{what}: {'SURVIVES' if what in survivors else 'caught'}", flush=True)
    write(RESULT, {"label": label("sympy", "mpmath"), "numbers": numbers(survivors, time.monotonic() - start)})
    assert survivors == []
