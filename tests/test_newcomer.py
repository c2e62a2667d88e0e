"""The newcomer's walk: the section "The way in" of CONTRIBUTING.md, followed to the letter in a copy of the project."""

import json
import os
import re
import shutil

import numpy as np
import pytest
from PIL import Image

from book.assembly.contents import page_files
from book.extension.numbers import parse
from book.extension.results import look_up
from book.ledger import load
from book.ledger.check import Run, faults_in
from tests import one_page
from tests.processes import python
from verify.sources import ROOT

FENCE = re.compile(r"```(\w+)\n(.*?)```", re.DOTALL)
FILE = re.compile(r"`([\w/]+\.\w+)`")
LAST_FIELD = '        HeightField("rings"'
CLAIM = "waves_climb_one_way"


def section(title):
    """Return a section of CONTRIBUTING.md."""
    return (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").partition(f"\n## {title}\n")[2].partition("\n## ")[0]


SECTION = section("The way in")


def blocks():
    """Return [(file, text)]: every block to be written, and the file that was named last before it."""
    found, end = [], 0
    for fence in FENCE.finditer(SECTION):
        named = FILE.findall(SECTION[end : fence.start()])
        if fence[1] != "bash":
            found.append((named[-1], fence[2]))
        end = fence.end()
    return found


def commands(text=SECTION):
    """Return the commands of a section, each as a list of words, the remarks after # left out."""
    listed = next(fence[2] for fence in FENCE.finditer(text) if fence[1] == "bash")
    return [line.partition("#")[0].split() for line in listed.splitlines()]


def run(folder, program, *arguments, status=0):
    """Run a command of the section in the folder; return what it prints."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    module = {"python": (), "pytest": ("-m", "pytest")}[program]
    return "".join(python(*module, *arguments, status=status, cwd=folder, env=environment))


def copied(folder):
    """Copy what the commands need of the project."""
    left_out = shutil.ignore_patterns("__pycache__", "_build", "_generated")
    for name in ("proofs", "renderer", "verify", "book"):
        shutil.copytree(ROOT / name, folder / name, ignore=left_out)
    for name in ("pyproject.toml", "requirements.lock"):
        shutil.copy(ROOT / name, folder)


def written(folder, file, text):
    """Write a block where the section says: a new file, the end of a page, or after the last height field."""
    path = folder / file
    if not path.exists():
        path.write_text(text, encoding="utf-8")
        return
    present = path.read_text(encoding="utf-8")
    if file.endswith(".py"):
        lines = present.splitlines(keepends=True)
        last = next(number for number, line in enumerate(lines) if line.startswith(LAST_FIELD))
        path.write_text("".join([*lines[: last + 1], text, *lines[last + 1 :]]), encoding="utf-8")
    else:
        path.write_text(f"{present}\n{text}", encoding="utf-8")


@pytest.fixture(scope="module")
def walked(tmp_path_factory):
    """The folder in which it was all done, and what each command printed."""
    folder = tmp_path_factory.mktemp("newcomer")
    copied(folder)
    for file, text in blocks():
        written(folder, file, text)
    left_out = {"make"} if shutil.which("coqc") else {"make", "verify.formal"}
    return folder, {" ".join(words[:3]): run(folder, *words) for words in commands() if not left_out & {*words}}


def test_it_is_short_and_names_every_file():
    assert [file for file, _ in blocks()] == [
        "proofs/formulas/height_fields.py",
        "proofs/theorems/waves.py",
        "proofs/formal/Waves.v",
        "book/figures/waves.py",
        "book/chapter/s3.md",
        "book/ledger/claims/waves.toml",
    ]
    assert sum(len(text.splitlines()) for file, text in blocks() if not file.endswith(".v")) < 60
    assert all(len(text.splitlines()) < 15 for file, text in blocks() if file.endswith(".v"))
    assert commands()[-1] == ["make", "book"]


def test_coq_accepts_the_theorem(walked):
    _, printed = walked
    if not shutil.which("coqc"):
        pytest.skip("Coq is not installed")
    assert re.search(rf"{CLAIM} +2 statements", printed["python -m verify.formal"])


def test_the_field_draws_and_is_a_choice_everywhere(walked):
    folder, _ = walked
    picture = np.asarray(Image.open(folder / "waves.png"))
    assert picture.shape == (128, 128, 3)
    run(folder, "python", "-m", "renderer", "image", "--field", "rings", "--size", "128", "--out", "rings.png")
    assert (picture != np.asarray(Image.open(folder / "rings.png"))).any(axis=2).mean() > 0.1
    script = run(folder, "python", "-c", "from book.simulator_module import source; print(source())")
    assert '"waves":{"ways":' in script
    assert "'waves'" in run(folder, "python", "-m", "renderer", "image", "--field", "foo", "--out", "x.png", status=2)


def test_the_theorem_is_proved_and_its_mutants_are_refused(walked):
    folder, printed = walked
    assert printed["python -m proofs.engine.certificate"].startswith(f"{CLAIM}: 2 statements")
    assert (folder / "proofs" / "certificates" / f"{CLAIM}.json").is_file()
    assert re.search(rf"{CLAIM} +proved .* mutants 2/2", printed["pytest verify --theorem"])
    path = folder / "proofs" / "theorems" / "waves.py"
    true = path.read_text(encoding="utf-8")
    false = true.replace("equation(k_v * _h_u, k_u * _h_v)", "equation(k_u * _h_u, k_v * _h_v)", 1)
    assert false != true
    path.write_text(false, encoding="utf-8")
    try:
        run(folder, "python", "-m", "proofs.engine.certificate", CLAIM, status=1)
    finally:
        path.write_text(true, encoding="utf-8")


def test_the_figure_is_drawn_and_stands_on_the_page(walked):
    folder, _ = walked
    numbers = json.loads((folder / "book" / "_generated" / "waves.json").read_text(encoding="utf-8"))["numbers"]
    assert 0 < numbers["turned"] < 1e-14
    placed = next(text for file, text in blocks() if file == "book/chapter/s3.md")
    assert (folder / "book" / "chapter" / "s3.md").read_text(encoding="utf-8").endswith(placed)
    small = folder / "small" / "book"  # the whole book would want every theorem and figure
    shutil.copytree(folder / "book" / "_generated", small / "_generated")
    shutil.copytree(folder / "book" / "figures", small / "figures", ignore=shutil.ignore_patterns("__pycache__"))
    html, warnings = one_page.build(small, placed)
    assert warnings == ""
    assert 'id="fig-waves"' in html


def test_the_claim_stands_and_falls_with_the_run(walked):
    book = walked[0] / "book"
    ledger = load(book / "ledger")
    assert ledger.get(CLAIM).words == "Waves climb in one direction alone."
    for grade, wrong in (("proved", []), ("failed", ["grade: proved is expected, the run made it failed"])):
        run = Run(
            {CLAIM: grade},
            {CLAIM: "proved"},
            {*page_files(book)},
            set(),
            lambda name: look_up(book, *parse(name)[:2]),
            bool,
        )
        found = [fault for fault in faults_in(ledger, run) if fault.startswith(CLAIM)]
        assert found == [f"{CLAIM}: evidence {CLAIM}: {fault}" for fault in wrong]
