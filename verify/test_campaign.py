"""The campaign: one operator or sign edited at random in the expressions of proofs/, and the checks must fail.

Each edit is made in a copy of the tree. First it is asked whether the kernels still are what is generated; of what
that lets pass, the rest is asked. A run that comes to its end writes verify/results/edited_formulas.json: commit it.
"""

import ast
import random
import shutil
import subprocess
import sys
import time
from contextlib import contextmanager

import pytest

from verify.records import Run
from verify.sources import ROOT

SEED, EDITS = 1978, 100
OTHER = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
         ast.USub: ast.UAdd, ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.Lt, ast.GtE: ast.Gt}  # fmt: skip
STAGES = (
    ["verify/test_kernels_printed.py"],
    ["verify", "-n", "2", "--ignore", "verify/test_theorems.py", "--ignore", "verify/test_campaign.py"],
    ["verify/test_theorems.py", "-n", "2"],
)
"""What pytest is told: the quick check, all but the theorems, the theorems with their samples and false variants."""


def sites(tree):
    """Return [(node, its operator)] for every operator, sign and comparison of a module that can be edited."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.BinOp | ast.UnaryOp | ast.Compare)]
    found = [(node, node.ops[0] if isinstance(node, ast.Compare) else node.op) for node in nodes]
    return [(node, operator) for node, operator in found if type(operator) in OTHER]


def edit(source, index):
    """Return (the source with its index-th site edited, its line, what was done)."""
    tree = ast.parse(source)
    node, operator = sites(tree)[index]
    other = OTHER[type(operator)]()
    if isinstance(node, ast.Compare):
        node.ops[0] = other
    else:
        node.op = other
    return ast.unparse(tree), f"{node.lineno}: {type(operator).__name__} → {type(other).__name__}"


@contextmanager
def edited(folder, path, index):
    """Edit a site in a copy of the tree, for as long as the context; give the words for it."""
    original = (folder / path).read_text(encoding="utf-8")
    changed, what = edit(original, index)
    (folder / path).write_text(changed, encoding="utf-8")
    try:
        yield f"{path}:{what}"
    finally:
        (folder / path).write_text(original, encoding="utf-8")


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


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of what `pytest verify` reads."""
    folder = tmp_path_factory.mktemp("campaign")
    for name in ("proofs", "renderer", "verify", "book/static", "tests/data"):
        if (ROOT / name).exists():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "_build"))
    for name in ("pyproject.toml", "requirements.lock", "book/references.bib"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    return folder


def test_there_is_something_to_edit():
    """Edits are what they say: one place, and another program."""
    source = "a = x + y\nb = -x if x < y else x * y\n"
    edits = [edit(source, i) for i in range(len(sites(ast.parse(source))))]
    assert [what for _, what in edits] == ["1: Add → Sub", "2: Lt → Gt", "2: USub → UAdd", "2: Mult → Div"]
    assert edits[0][0].splitlines()[0] == "a = x - y"
    assert len(draw()) == EDITS


def survives(folder, path, index, stage):
    """Return whether a stage passes in the copy with a site edited; what was there is put back."""
    with edited(folder, path, index) as what:
        passed = passes(folder, stage)
    print(f"\n{what}: {'passes ' + stage[0] if passed else 'caught'}", flush=True)
    return passed


@pytest.mark.long
def test_no_edit_survives(copy):
    """A stage has to pass without an edit before it is asked about those that the stages before it left."""
    from tqdm import tqdm  # which an environment for the short tests may lack

    left, start, run = draw(), time.monotonic(), Run("edited_formulas")
    for stage in STAGES:
        assert not left or passes(copy, stage), "the copy fails before any edit"
        left = [place for place in tqdm(left, desc=stage[0], unit="edit") if survives(copy, *place, stage)]
    numbers = {"edits": EDITS, "caught": EDITS - len(left), "left": len(left), "stages": len(STAGES)}
    run.write({"numbers": numbers | {"minutes": round((time.monotonic() - start) / 60), "seed": SEED}})
    assert left == []
