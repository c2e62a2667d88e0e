"""The campaign: one operator, sign or number edited in the expressions of proofs/, and the checks must fail.

Each edit is made in a copy of the tree. First it is asked whether the kernels still are what is generated; of what
that lets pass, the rest is asked. Operators are drawn at random; a run that comes to its end writes
verify/results/edited_formulas.json: commit it. Of the numbers a few are drawn, with --long all are changed in turn.
"""

import ast
import random
import shutil
import subprocess
import sys
import time
from contextlib import contextmanager
from functools import cache

import pytest

from verify.evidence.records import Run
from verify.evidence.sources import ROOT

SEED, EDITS = 1978, 100
OTHER = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
         ast.USub: ast.UAdd, ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.Lt, ast.GtE: ast.Gt}  # fmt: skip
PYTEST = ("pytest", "-x", "-q", "-p", "no:cacheprovider")
STAGES = (
    (*PYTEST, "verify/test_kernels_printed.py"),
    (*PYTEST, "verify", "-n", "2", "--ignore", "verify/test_theorems.py", "--ignore", "verify/test_campaign.py"),
    (*PYTEST, "verify/test_theorems.py", "-n", "2"),
)
"""Modules that Python runs: the quick check, all but the theorems, the theorems with samples and false variants."""
OF_NUMBERS = (STAGES[0], ("verify.evidence.stale",), *STAGES[1:])
"""The same of a number: whether all that is stored still says it comes second."""
FEW_NUMBERS = 3
FORMULAS = "formulas/*.py", "engine/half_turns.py", "engine/vectors.py"
"""Of proofs/: the formulas, and what they are written in."""


def is_zero(node):
    """Return whether an operand is 0, or 0 times something: with it a sum is a difference, a product a quotient."""
    return ast.unparse(node).split(" * ")[0] == "0"


def sites(tree):
    """Return every operator, sign and comparison of a module that can be edited."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.BinOp | ast.UnaryOp | ast.Compare)]
    nodes = [node for node in nodes if not (isinstance(node, ast.BinOp) and (is_zero(node) or is_zero(node.right)))]
    return [node for node in nodes if type(node.ops[0] if isinstance(node, ast.Compare) else node.op) in OTHER]


def numbers(tree):
    """Return every number of a module."""
    return [node for node in ast.walk(tree) if isinstance(node, ast.Constant) and type(node.value) in (int, float)]


def edit(source, index, find=sites, by=1):
    """Return (the source with its index-th site edited, what was done); by: what a number is changed by."""
    tree = ast.parse(source)
    node = find(tree)[index]
    before = ast.unparse(node)
    match node:
        case ast.Constant():
            node.value += by
        case ast.Compare():
            node.ops[0] = OTHER[type(node.ops[0])]()
        case _:
            node.op = OTHER[type(node.op)]()
    return ast.unparse(tree), f"{node.lineno}: {before} → {ast.unparse(node)}"


@contextmanager
def edited(folder, path, *how):
    """Edit a site in a copy of the tree, for as long as the context; give the words for it."""
    original = (folder / path).read_text("utf-8")
    changed, words = edit(original, *how)
    (folder / path).write_text(changed, "utf-8")
    try:
        yield f"{path}:{words}"
    finally:
        (folder / path).write_text(original, "utf-8")


def everywhere(find, *patterns):
    """Return [(path below the root, index of the site, find)] of every site in the formulas, or in files of proofs/."""
    return [
        (path.relative_to(ROOT), index, find)
        for pattern in patterns or FORMULAS
        for path in sorted((ROOT / "proofs").glob(pattern))
        for index in range(len(find(ast.parse(path.read_text("utf-8")))))
    ]


def draw(sites, number, config=None):
    """Return so many of the sites, the same for the same sources; all of them with --long."""
    return sites if config and config.getoption("--long") else random.Random(SEED).sample(sites, number)


def passes(folder, stage):
    """Return whether a stage passes in the folder; an edit that keeps a loop from ending is not a pass."""
    command = [sys.executable, "-m", *stage]
    try:
        return subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=900).returncode == 0
    except subprocess.TimeoutExpired:
        return False


passes_as_it_is = cache(passes)  # before any edit


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of the tree, with all that `pytest verify` reads."""
    folder = tmp_path_factory.mktemp("campaign") / "tree"
    left_out = shutil.ignore_patterns("__pycache__", "_build", "_generated", "node_modules", "releases", ".*")
    return shutil.copytree(ROOT, folder, ignore=left_out)


def survives(folder, place, stage):
    """Return whether a stage passes in the copy with a site edited; what was there is put back."""
    with edited(folder, *place) as words:
        passed = passes(folder, stage)
    print(f"\n{words}: {'passes ' + ' '.join(stage) if passed else 'caught'}", flush=True)
    return passed


def survivors(folder, places, stages):
    """Return the places whose edits pass every stage. A stage has to pass without an edit before it is asked of any."""
    tqdm = pytest.importorskip("tqdm").tqdm  # which an environment for the short tests may lack
    for stage in stages:
        assert not places or passes_as_it_is(folder, stage), "the copy fails before any edit"
        places = [p for p in tqdm(places, desc=stage[0], unit="edit", disable=None) if survives(folder, p, stage)]
    return places


@pytest.mark.long
def test_no_edit_survives(copy):
    start, run = time.monotonic(), Run("edited_formulas")
    left = survivors(copy, draw(everywhere(sites), EDITS), STAGES)
    numbers = {"edits": EDITS, "caught": EDITS - len(left), "left": len(left), "stages": len(STAGES)}
    run.write({"numbers": numbers | {"minutes": round((time.monotonic() - start) / 60), "seed": SEED}})
    assert left == []


def test_no_number_of_a_formula_survives(copy, pytestconfig):
    """Nor the sixth of the truncation's bound, where no test once failed with a fifth; a blind check lets it pass."""
    few = draw(everywhere(numbers), FEW_NUMBERS, pytestconfig)
    of_bounds = everywhere(numbers, "formulas/step_bounds.py")
    values = numbers(ast.parse((ROOT / of_bounds[0][0]).read_text("utf-8")))
    fifth = (*of_bounds[[node.value for node in values].index(6)], -1)
    assert survivors(copy, [*few, fifth], OF_NUMBERS) == []
    assert survivors(copy, [fifth], [("proofs.check", "unit_length")]) == [fifth]
