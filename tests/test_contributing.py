"""CONTRIBUTING: its map, its answers, and two ways in, `tests/examples/*/way_in.sh`, followed in a copy to the end."""

import json
import re
import runpy
import shutil
import sys
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest
from PIL import Image

from book.editions.pages import parsed
from proofs.engine.project import FILE, PROJECT, project_of
from proofs.engine.theorem import all_theorems
from renderer import Scene, render
from renderer.picture.views import image_view
from tests.processes import python, run, settings_without
from verify import conftest
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


# Another book with the same tools, tests/examples/second_book/: proved and built by two commands, and kept apart

EXAMPLE, ID = EXAMPLES / "second_book", "distance_from_focus"


def test_a_second_book_is_proved_and_built_and_writes_nothing_of_this_one(tmp_path):
    folder = shutil.copytree(EXAMPLE, tmp_path / "a book", ignore=shutil.ignore_patterns(".*", "_build", "_generated"))
    shell(folder, f"TOOLS={ROOT} . ./run.sh")
    (entry,) = json.loads((folder / "pages" / "_generated" / "proofs.json").read_text("utf-8"))["theorems"]
    assert [entry[of] for of in ("id", "grade", "statements", "killed")] == [ID, "proved", 1, "2/2"]
    site = folder / "pages" / "_build" / "html"
    page = parsed((site / "index.html").read_text("utf-8"))
    assert [number.get_text() for number in page.select("span.number")] == ["0.4", "0.6"]
    assert (site / page.select_one("#fig-orbit img")["src"]).is_file()
    listing, script = (page.select_one(f"{of} .provenance a")["href"] for of in (f"#theorem-{ID}.proved", "#fig-orbit"))
    assert (site / listing.partition("#")[0]).is_file()
    assert (site / script).read_bytes() == (EXAMPLE / "kepler" / "figures" / "orbit.py").read_bytes()
    ours = [*PROJECT.generated.glob("*.json"), *PROJECT.certificates.iterdir()]
    assert not [path for path in ours if path.stem == "orbit" or ID in path.read_text("utf-8")]


def test_where_no_file_names_a_project_this_one_is_read_and_nothing_is_written(tmp_path, monkeypatch):
    (tmp_path / FILE).write_text("[tool.other]")
    outside = project_of(tmp_path)
    assert outside == PROJECT._replace(writable=False) and project_of(EXAMPLE / "pages").root == EXAMPLE
    entries = [{"id": id, "grade": "proved", "expected": "proved", "uses": []} for id in all_theorems()]
    monkeypatch.setattr(conftest, "EVIDENCE", entries)
    for command in ("proofs.engine.certificate", "renderer.generate", "book"):
        _, refusal = python("-m", command, status=1, cwd=tmp_path, env={"PYTHONPATH": str(ROOT)})
        assert "nothing is written" in refusal
    session = SimpleNamespace(config=SimpleNamespace(getoption=lambda name: None))
    for project in (outside, PROJECT):
        monkeypatch.setattr(conftest, "PROJECT", project._replace(pages=tmp_path))
        conftest.pytest_sessionfinish(session, 0)
        assert conftest.PROJECT.report.is_file() == project.writable
