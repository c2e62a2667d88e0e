"""CONTRIBUTING: its map, its answers, and two ways in, `tests/examples/*/way_in.sh`, followed in a copy to the end."""

import re
import runpy
import shutil
import sys
from pathlib import Path
from unittest.mock import Mock

import numpy as np
import pytest
from PIL import Image

from renderer import Scene, render
from renderer.picture.views import image_view
from tests.processes import run, settings_without
from verify.evidence.sources import PACKAGES, ROOT, files_in, is_test

EXAMPLES = ROOT / "tests" / "examples"
DOCUMENTS = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "Makefile")]
RUNS = '\nif __name__ == "__main__":'
CALLED = re.compile(rf"-m\s+((?:{'|'.join(PACKAGES)})\b[\w.]*\b)")


def shell(folder, line):
    """Run a line of a shell in the folder, by this Python; return what it prints."""
    settings = settings_without("PYTEST_")
    settings["PATH"] = f"{Path(sys.executable).parent}:{settings['PATH']}"
    return "".join(run("bash", "-ec", line, cwd=folder, env=settings))


@pytest.fixture
def copied(tmp_path):
    """The folder of a copy of the project, without what is built."""
    built = shutil.ignore_patterns(".*", "__pycache__", "_build", "_generated", "node_modules")
    return shutil.copytree(ROOT, tmp_path, ignore=built, dirs_exist_ok=True)


def walked(folder, example, left_out):
    """Follow a way in but for some lines in a copy of the project; {module: what it printed}."""
    lines = (EXAMPLES / example / "way_in.sh").read_text("utf-8").splitlines()
    lines = filter(None, (line.partition("#")[0].strip() for line in lines))
    return {line.split()[2]: shell(folder, line) for line in lines if not re.search(left_out, line)}


def test_the_map_is_of_the_house_and_every_question_has_its_file():
    text = DOCUMENTS[1].read_text("utf-8")
    paths = [path.relative_to(ROOT).parts for package in PACKAGES for path in files_in(ROOT / package)]
    rooms = {"/".join(parts[:2]) for parts in paths if len(parts) > 2}
    assert sorted(re.findall(r"^    (\S+)/ +\w", text, re.M)) == sorted(rooms)
    assert len(re.findall(r"^- .+\? \[`(\S+)`\]\(\1\)$", text, re.M)) == 10
    assert all((ROOT / path).is_file() for path in re.findall(r"\]\((\S+)\)", text))


def test_every_command_has_a_help_that_does_nothing_else(monkeypatch, capsys):
    """Return the modules that a source or a document calls, and every module that runs by itself."""
    commands = set()
    for path in (*DOCUMENTS, *(path for package in PACKAGES for path in files_in(ROOT / package) if not is_test(path))):
        if path.suffix in (".py", ".md", ""):
            text, module = path.read_text("utf-8"), ".".join(path.relative_to(ROOT).with_suffix("").parts)
            commands.update(CALLED.findall(text), [module] * (RUNS in text))
    for writes in ("os.replace", "pathlib.Path.write_text", "pathlib.Path.write_bytes"):
        monkeypatch.setattr(writes, None)
    monkeypatch.setattr("signal.signal", Mock())  # a command that ends lets no signal hinder it
    monkeypatch.setattr("sys.argv", ["", "--help"])
    for command in commands:
        with pytest.raises(SystemExit, check=lambda end: end.code == 0):
            runpy.run_module(command, run_name="__main__")
        assert capsys.readouterr().out.startswith("usage: "), command


def test_what_ways_in_add_is_a_choice_and_draws(copied):
    """Both in one copy, whose kernels are made once."""
    for example, later in (("height_field", "generate|image|figures"), ("light_model", "certificate")):
        walked(copied, example, f"certificate|pytest|coq|book$|{later}")  # what proves takes long
    walked(copied, "height_field", "certificate|pytest|coq|book$|apply|cp|generate")
    other, drawn = image_view(render(Scene(), 128, 128)), [*copied.glob("*.png")]
    assert len(drawn) == 2
    assert all((np.asarray(Image.open(picture)) != other).any(axis=2).mean() > 0.1 for picture in drawn)


@pytest.mark.long
@pytest.mark.skipif("not config.getoption('long', False)", reason="takes minutes; run with verify and --long")
@pytest.mark.parametrize(
    "example, theorem", [("height_field", "waves_climb_one_way"), ("light_model", "smooth_is_lambert")]
)
def test_a_way_in_ends_with_a_book(copied, example, theorem):
    """The theorem is proved and its false variants are not, by Coq too; only stale certificates are made anew."""
    printed = walked(copied, example, "never" if shutil.which("coqc") else "coq")
    made = {line.partition(":")[0] for line in printed["proofs.engine.certificate"].splitlines()}
    of_models = {"bump_moves_no_boundary", "edges_add_nothing"} if example == "light_model" else set()
    assert made == {theorem, *of_models}
    assert re.search(rf"{theorem} +proved .* mutants 2/2", printed["pytest"])
    if "verify.coq" in printed:
        assert re.search(rf"{theorem} +2 claims +0 mutants +0 statements", printed["verify.coq"])
    site = copied / "book" / "_build" / "html"
    assert f"theorem-{theorem}" in (site / "findings.html").read_text("utf-8")
    assert ('id="fig-waves"' in (site / "s3.html").read_text("utf-8")) is (example == "height_field")
