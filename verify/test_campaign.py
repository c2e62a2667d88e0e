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
from copy import copy as copy_of
from dataclasses import replace
from functools import cache

import pytest
from sympy import Eq, Number

from proofs.engine.theorem import all_theorems
from proofs.formulas.half_turns import ordinary
from verify.checkers.stale import why_stale
from verify.records import Run
from verify.sources import ROOT

SEED, EDITS = 1978, 100
OTHER = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
         ast.USub: ast.UAdd, ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.Lt, ast.GtE: ast.Gt}  # fmt: skip
PYTEST = ("pytest", "-x", "-q", "-p", "no:cacheprovider")
PRINTED = (*PYTEST, "verify/test_kernels_printed.py")
STAGES = (
    PRINTED,
    (*PYTEST, "verify", "-n", "2", "--ignore", "verify/test_theorems.py", "--ignore", "verify/test_campaign.py"),
    (*PYTEST, "verify/test_theorems.py", "-n", "2"),
)
"""What Python runs: the quick check, all but the theorems, the theorems with their samples and false variants."""
OF_NUMBERS = (("verify.checkers.stale",), *STAGES[1:])
"""The same of a number: whether all that is printed or stored still says it comes first."""
FEW_NUMBERS, FEW_RELATIONS = 3, 20


def sites(tree):
    """Return [(node, its operator)] for every operator, sign and comparison of a module that can be edited."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.BinOp | ast.UnaryOp | ast.Compare)]
    found = [(node, node.ops[0] if isinstance(node, ast.Compare) else node.op) for node in nodes]
    return [(node, operator) for node, operator in found if type(operator) in OTHER]


def numbers(tree):
    """Return [(node, the number)] for every number of a module."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Constant)]
    return [(node, node.value) for node in nodes if type(node.value) in (int, float)]


def edit(source, index, find=sites, by=1):
    """Return (the source with its index-th site edited, its line, what was done); by: what a number is changed by."""
    tree = ast.parse(source)
    node, operator = find(tree)[index]
    if isinstance(node, ast.Constant):
        node.value += by
        return ast.unparse(tree), f"{node.lineno}: {operator} → {node.value}"
    other = OTHER[type(operator)]()
    if isinstance(node, ast.Compare):
        node.ops[0] = other
    else:
        node.op = other
    return ast.unparse(tree), f"{node.lineno}: {type(operator).__name__} → {type(other).__name__}"


@contextmanager
def edited(folder, path, *how):
    """Edit a site in a copy of the tree, for as long as the context; give the words for it."""
    original = (folder / path).read_text(encoding="utf-8")
    changed, what = edit(original, *how)
    (folder / path).write_text(changed, encoding="utf-8")
    try:
        yield f"{path}:{what}"
    finally:
        (folder / path).write_text(original, encoding="utf-8")


def everywhere(find):
    """Return [(path below the root, index of the site, find)] of every site in the formulas."""
    return [
        (path.relative_to(ROOT), index, find)
        for path in sorted((ROOT / "proofs" / "formulas").glob("*.py"))
        for index in range(len(find(ast.parse(path.read_text(encoding="utf-8")))))
    ]


def draw(sites, number, config=None):
    """Return so many of the sites, the same for the same sources; all of them with --long."""
    return sites if config and config.getoption("--long") else random.Random(SEED).sample(sites, number)


@cache
def passes_as_it_is(folder, stage):
    """Return whether a stage passes before any edit."""
    return passes(folder, stage)


def passes(folder, stage, seconds=900):
    """Return whether a stage passes in the folder; an edit that keeps a loop from ending is not a pass."""
    command = [sys.executable, "-m", *stage]
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
    assert edit("a = b / 6\n", 0, numbers) == ("a = b / 7", "1: 6 → 7")
    assert edit("a = b / 6\n", 0, numbers, -1)[0] == "a = b / 5"


def survives(folder, place, stage):
    """Return whether a stage passes in the copy with a site edited; what was there is put back."""
    with edited(folder, *place) as what:
        passed = passes(folder, stage)
    print(f"\n{what}: {'passes ' + ' '.join(stage) if passed else 'caught'}", flush=True)
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
    found = {"edits": EDITS, "caught": EDITS - len(left), "left": len(left), "stages": len(STAGES)}
    run.write({"numbers": found | {"minutes": round((time.monotonic() - start) / 60), "seed": SEED}})
    assert left == []


def test_no_number_of_a_formula_survives(copy, pytestconfig):
    assert survivors(copy, draw(everywhere(numbers), FEW_NUMBERS, pytestconfig), OF_NUMBERS) == []


def test_the_sixth_of_the_truncation_bound_is_seen_and_a_blind_check_as_well(copy):
    """Where 5 stood for 6 no test failed once: the checks that looked at other formulas let it pass still."""
    path = ROOT / "proofs" / "formulas" / "step_bounds.py"
    found = numbers(ast.parse(path.read_text(encoding="utf-8")))
    sixth = next(index for index, (_, number) in enumerate(found) if number == 6)
    place = path.relative_to(ROOT), sixth, numbers, -1
    assert survivors(copy, [place], OF_NUMBERS[:1]) == []
    assert survivors(copy, [place], [(*PYTEST, "verify/test_difference_cases.py")]) == [place]


def relations():
    """Return [(theorem, claim, relation, side, number)]: every number in what a claim shows, read from the claims."""
    return [
        (theorem, claim, relation, side, number)
        for theorem in all_theorems().values()
        for claim in theorem.claims
        for relation in getattr(claim, "shows", ())
        for side, part in enumerate(relation.args)
        for number in sorted(part.atoms(Number), key=str)
    ]


def said_otherwise(claim, relation, changed):
    """Return the claim with one relation in the place of another."""
    return replace(claim, shows=tuple(changed if r is relation else r for r in claim.shows))


def _holds_anyway(relation):
    """Return whether an equation is one whatever its names stand for."""
    return isinstance(relation, Eq) and bool(ordinary(relation.lhs - relation.rhs).equals(0))


def test_no_number_of_a_claim_is_said_otherwise(pytestconfig):
    """What is stored of a theorem proves what it shows, and nothing that has another number in it.

    Of what it assumes the stored proof may need less: another number there may be one that it does not need.
    """
    theorems = all_theorems()
    for theorem, claim, relation, side, number in draw(relations(), FEW_RELATIONS, pytestconfig):
        sides = [part.xreplace({number: number + 1} if at == side else {}) for at, part in enumerate(relation.args)]
        other, changed = copy_of(theorem), relation.func(*sides, evaluate=False)
        claims = tuple(said_otherwise(c, relation, changed) if c is claim else c for c in theorem.claims)
        object.__setattr__(other, "claims", claims)  # its words may name the claims that it had
        assert why_stale(other, theorems) or _holds_anyway(changed), (theorem.id, relation, number)
