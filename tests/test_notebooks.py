"""The laboratory's cells: printed from `proofs/`, equal to the renderer, and complete wherever they are pasted."""

import contextlib
import io
import os
import re
from pathlib import Path

import matplotlib
import pytest

from book import seed_page
from book.extension.notebooks import FOLDER
from book.notebooks import WHOLE
from book.notebooks.laboratory import PAGE, cells, notebooks, plain
from book.notebooks.printed import refreshed
from tests.processes import python

ALONE = "The book's renderer is not installed: nothing to compare with.\n"
# The code of each notebook by itself. The page's own build runs the one of all cells, by Jupyter's kernel.
RUN = """\
import json, sys
for path in sys.argv[1:]:
    print("\\0")
    cells = json.load(open(path))["cells"]
    exec("\\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"), {"__name__": "cell"})
"""


def code_of(notebook):
    """Return what the code cells of a notebook say."""
    return [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]


def run(source):
    """Run a cell without windows; return what it printed, and its names."""
    scope, text = {"__name__": "cell"}, io.StringIO()
    matplotlib.use("agg")
    with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stdout(text):
        patch.setattr("matplotlib.pyplot.show", lambda: None)
        exec(source, scope)
    return text.getvalue(), scope


@pytest.fixture(scope="module")
def printed(page_of):
    """Cell → what the page says that it printed, which it did when the page was built."""
    page, selector = page_of("s5"), "#cell{} div.cell_output pre"
    return {n: "".join(block.get_text() for block in page.select(selector.format(n))) for n in range(1, 10)}


def numbers(text, start):
    """Return the numbers of the line of some text that starts so, those behind it."""
    (line,) = (line.strip() for line in text.splitlines() if line.strip().startswith(start))
    digits = re.findall(r"(?<![\w^])[+-]?\d+(?:\.\d+)?(?:e[+-]\d+)?", line.removeprefix(start))
    return [float(number) for number in digits]


# Cells printed from proofs/


def test_cells_have_what_proofs_print():
    page = PAGE.read_text("utf-8")
    assert refreshed(page) == page, "run `python -m book.notebooks`"
    assert page.count("# Printed from proofs/formulas/") >= 30


def test_edited_formula_or_scene_is_printed_anew():
    page = PAGE.read_text("utf-8")
    for good in ("g = e_phi*h_v + e_theta*h_u", "sinpi(P[0]) * sinpi(P[1])", 'SC["ku"] / 2'):
        again = page.rindex(good)
        assert refreshed(page[:again] + page[again:].replace(good, "0")) == page
    with pytest.raises(ValueError, match=r"'bump\.py, nothing' is not allowed"):
        refreshed("# Printed from proofs/formulas/bump.py, nothing\ndef f():\n    pass\n")


# Results of the cells

WITHIN = [
    (2, "(e_θ × e_φ) · N =", 0, -1, -1),
    (3, "1e-06", 0, 0, 1e-8),
    (4, "central:", 0, 4, 4),
    (4, "exact:", 0, 0, 0),
    (5, "complex step:", 0, 0, 1e-13),
    (5, "from the book's renderer by", 1, 0, 1e-13),  # the slope
    (5, "one-sided difference:", 0, 1.65e-5, 1.65e-5),  # as on every page: the seed's own random numbers
    (6, "β = 0, numeric against symbolic:", 0, 0, 0),
    (6, "no height, numeric against plain:", 0, 0, 0),
    (7, "δ = +0e+00  central", 0, 0, 0),
    (7, "with the half-turns taken off first it is", 0, 0, 0),
    (7, "1024²: least sin φ", -1, 0, 0),
    (7, "φ = 1e-04: error of the frame", -1, 1e-9, 1e-7),  # by the seed's own, which loses its digits
    (8, "1024²", 3, 80, 90),  # the crease never gets better: flat there, where the slope stands at 83°
]
"""[(cell, the start of a line, which number of it, at least, at most)]"""


def test_each_cell_finds_what_its_page_says(printed):
    for cell, start, place, least, most in WITHIN:
        assert least <= numbers(printed[cell], start)[place] <= most, (cell, start)
    apart = re.compile("(from the book's renderer (?:at most|by))")
    for cell in (1, 3, 4, 5, 6, 8, 9):
        assert numbers(printed[cell], apart.search(printed[cell])[1])[0] < 1e-11, cell


@pytest.mark.parametrize(
    "knobs",
    [
        '"ridges", "blinn", 1e-3, 600, 1, 1, (1, 2)',  # with centres of pixels on creases
        '"ridges", "phong", 1e-3, 1000, 1, 1, (1,)',
        '"sine", "phong", 1e-2, 199, 0, 1, (2, 1)',
        '"rings", "blinn", 1e-4, 220, 1, 0, ()',
    ],
)
def test_third_cell_draws_the_renderer_s_picture_at_every_size_and_knob(knobs):
    code = next(part.text for part in cells()[2].parts if part.is_code).replace("1e-2, 1e-3, 1e-4, 1e-5, 1e-6", "")
    code, replaced = re.subn("(?<=lights = ).*", knobs, code, count=1)
    text, _ = run(code)
    assert replaced and numbers(text, "from the book's renderer at most")[0] < 1e-11


def test_ninth_cell_draws_what_is_typed():
    """One's own drawing is the renderer's, as near as that certifies."""
    code = re.sub(r'(?<=formula = ").*?(?=")', "max(0, cospi(k_v*v))*3/2", cells()[8].code)
    text, scope = run(code)
    assert (scope["off"] <= scope["bound"] + 1e-12)[scope["closed"]].all()
    assert numbers(text, "what the book's renderer certifies:")[0] < 1e-6


# The notebooks


def test_the_notebooks_are_the_cells():
    made = notebooks()
    for notebook in made.values():
        text = "\n".join(c["source"] for c in notebook["cells"] if c["cell_type"] == "markdown")
        assert not re.search(r"\{[\w-]+\}`|^:::|^\(\w+\)=", text, re.M)
    codes = {name: "\n".join(code_of(notebook)) for name, notebook in made.items()}
    alone = {cell.name: cell.code for cell in cells()}
    assert codes == {**alone, WHOLE: "\n".join(alone.values())}


def test_prose_becomes_plain_markdown():
    text = plain("(cell9)=\nSee [§3](#s3), {number}`u_curve.error_1e-03|.0e`.")
    assert text == r"See §3, $6 \times 10^{-5}$."
    with pytest.raises(ValueError, match="the role 'theorem-ref' of"):
        plain("{theorem-ref}`normal`")


def test_notebooks_run_alone_and_print_what_the_page_does(site, printed, tmp_path):
    """In an empty folder, from which the project cannot be imported; what they import asks no network."""
    empty = tmp_path / "empty"
    empty.mkdir()
    settings = {"PATH": os.environ["PATH"], "MPLBACKEND": "agg", "MPLCONFIGDIR": str(tmp_path), "PYTHONUTF8": "1"}
    paths = [site / FOLDER / f"{cell.name}.ipynb" for cell in cells()]
    output, complaints = python("-W", "ignore:FigureCanvasAgg", "-c", RUN, *paths, cwd=empty, env=settings)
    assert (complaints, [*empty.iterdir()]) == ("", [])
    timed = re.compile(r"(?:a slope, |a frame at ).*\n")  # the page times nothing
    compared = re.compile(r".*the book's renderer.*\n", re.IGNORECASE)
    for cell, text in zip(cells(), output.split("\0\n")[1:], strict=True):
        assert text.count(ALONE) == 1
        assert compared.sub("", timed.sub("", text)) == compared.sub("", printed[cell.number]) != ""


def test_the_seed_s_cells_run_and_print_what_its_page_says(page_of):
    says = [block.get_text().split() for block in page_of("seed").select(".highlight-none pre")]
    for words, notebook in zip(says, seed_page.notebooks().values(), strict=True):
        text, _ = run(seed_page.DRAWN.sub("48, 48", "\n".join(code_of(notebook))))
        assert seed_page.TIME.sub("…", text).split()[-len(words) :] == words != []


def test_a_cell_shows_its_knobs_and_what_decides_and_folds_the_rest(page_of):
    for cell in page_of("s5").select("[id^=cell] .cell_input pre"):
        for fold in cell("details"):
            fold.extract()
        shown = cell.get_text()
        assert "# Here:" in shown and "import" not in shown and len(shown.strip().splitlines()) <= 16


def test_links_save_notebooks_from_a_disk_and_a_copied_cell_is_complete_though_folded(site, visit):
    page = visit("s5", "file")
    links = page.locator(".notebook-links a[download]")
    assert links.count() == len(cells()) + 1
    with page.expect_download() as saved:
        links.first.click()
    name = saved.value.suggested_filename
    assert Path(saved.value.path()).read_bytes() == (site / FOLDER / name).read_bytes()
    page.evaluate("document.body.prepend(Object.assign(document.createElement('textarea'), { id: 'pasted' }))")
    page.get_by_role("button", name="Copy: Cell 3").click()
    page.press("#pasted", "Control+V")
    assert page.locator("#pasted").input_value().strip() == code_of(notebooks()[WHOLE])[2].strip()
