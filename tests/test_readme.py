"""The README's picture is what the renderer draws today, and its four lines end with a file."""

import re
import textwrap

import numpy as np
import pytest
from PIL import Image

from book.figures.certified_bounds import BUMPS, scene_of
from book.figures.three_pictures import hero, hero_symbolic
from renderer import Scene, render
from renderer.files import record
from tests.pictures import shows
from verify.evidence.sources import ROOT


def test_picture_is_the_renderers():
    committed = np.asarray(Image.open(ROOT / "book/static/front.png").convert("RGB")).astype(int)
    drawn = hero().picture.astype(int)
    middle = drawn.shape[1] // 2
    drawn[:, middle:] = hero_symbolic().picture[:, middle:]
    assert committed.shape == drawn.shape
    assert np.abs(committed - drawn).max() <= 1  # a byte may round the other way


def test_a_bump_of_ones_own_is_the_figures(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for lines in re.findall(r"```python\n([\s\S]*?)```", (ROOT / "book/checked/own-fields.md").read_text("utf-8")):
        exec(lines, {})
    assert {path.stem: record.read(path)[0].scene for path in tmp_path.iterdir()} == {n: scene_of(n) for n in BUMPS}


def test_what_the_other_pages_show_runs():
    for path in sorted(ROOT.glob("book/c*/*.md")):
        for lines in re.findall(r"```python\n([\s\S]*?)```", path.read_text("utf-8")) * (path.stem != "own-fields"):
            exec(lines, {})


def test_its_four_lines_end_with_a_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    readme = (ROOT / "README.md").read_text("utf-8")
    lines = readme.split("four lines:\n\n")[1].split("\n\nA frame")[0]
    assert len(lines.split("\n")) == 5  # the import, and a blank line
    exec(textwrap.dedent(lines), {})
    (written,) = tmp_path.iterdir()
    assert shows(written, render(Scene(), 256, 256))


FOLDER = ROOT / "book" / "chapter" / "exercises"
SECTIONS = sorted(path.stem for path in FOLDER.glob("*.md"))
ANSWER = re.compile(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("section", SECTIONS)
def test_answers_print_what_stands_below_them(section, capsys):
    for code, expected in ANSWER.findall((FOLDER / f"{section}.md").read_text("utf-8")):
        assert set(re.findall(r"^(?:from|import) (\w+)", code, re.MULTILINE)) <= {"math", "numpy", "sympy"}
        exec(code, {})
        assert capsys.readouterr().out == expected
