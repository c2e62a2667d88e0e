"""The laboratory's cells: printed from `proofs/`, equal to the renderer, and complete wherever they are pasted."""

import contextlib
import functools
import inspect
import io
import os
import re
import shutil
import subprocess
import sys
from base64 import b64decode
from itertools import pairwise
from pathlib import Path

import matplotlib
import nbformat
import numpy as np
import pytest
import yaml

from book.assembly.results import look_up
from book.editions.pages import parsed
from book.extension.notebooks import FOLDER, repeated
from book.notebooks import WHOLE
from book.notebooks.laboratory import BOOK, PAGE, cells, notebooks, plain, text_of
from book.notebooks.printed import FUNCTIONS, SCENE, function, refreshed
from renderer import kernels, render
from renderer.generate.kernels import function_of
from renderer.scene.methods import central
from renderer.scene.scene import Scene
from renderer.shader.gradients import gradient_at
from tests import one_page
from verify.accuracy.orders import fitted_slope
from verify.sources import ROOT

NAMES = [*(f"cell{number}" for number in range(1, 10)), WHOLE]
ALONE = "The book's renderer is not installed: nothing to compare with.\n"
# Put where every Python of a run finds it: no connection leaves the machine, and the project cannot be imported.
ALONE_HERE = """\
import socket
import sys


class Project:
    def find_spec(name, path=None, target=None):
        if name in ("renderer", "proofs", "verify", "book"):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)


class Offline(socket.socket):
    def connect(self, address):
        if self.family in (socket.AF_INET, socket.AF_INET6) and not str(address[0]).startswith("127."):
            raise OSError(f"a notebook asked the network for {address}")
        return super().connect(address)


sys.meta_path.insert(0, Project)
socket.socket = Offline
"""
RUN = """\
import sys, nbclient, nbformat
notebook = nbformat.read(sys.argv[1], 4)
nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
nbformat.write(notebook, sys.argv[2])
"""


def code_of(notebook):
    """Return what the code cells of a notebook say."""
    return [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]


@pytest.fixture(scope="module")
def ran():
    """Run a cell by its number, or a source, once and without windows, and return (what it printed, its names)."""

    @functools.cache
    def run(source):
        source = source if isinstance(source, str) else cells()[source - 1].code
        scope, text = {"__name__": "cell"}, io.StringIO()
        with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stdout(text):
            patch.setattr("matplotlib.pyplot.show", lambda: None)
            exec(source, scope)
        return text.getvalue(), scope

    matplotlib.use("agg")
    return run


def numbers(text):
    """Return the numbers of some text."""
    return [float(number) for number in re.findall(r"(?<![\w^])[+-]?\d+(?:\.\d+)?(?:e[+-]\d+)?", text)]


def line_of(text, start):
    """Return the numbers behind the start of a line."""
    (found,) = (line for line in text.splitlines() if line.strip().startswith(start))
    return numbers(found.strip().removeprefix(start))


# What is printed from proofs/


def test_cells_have_what_proofs_print():
    page = PAGE.read_text(encoding="utf-8")
    assert refreshed(page) == page, "run `python -m book.notebooks`"
    assert page.count("# Printed from proofs/formulas/") >= 30
    assert len({scene[0].strip() for scene in SCENE.finditer(page)}) == 1


def test_edited_formula_or_scene_is_printed_anew():
    page = PAGE.read_text(encoding="utf-8")
    for good, bad in (("g = e_phi*h_v + e_theta*h_u", "g = e_phi*h_v - e_theta*h_u"), ("0.7 * albedo", "0.8 * albedo")):
        first = page.index(good)
        again = page.index(good, first + 1)
        assert refreshed(page[:again] + page[again:].replace(good, bad, 1)) == page
    with pytest.raises(ValueError, match=r"'bump\.py, nothing' is not allowed"):
        refreshed("# Printed from proofs/formulas/bump.py, nothing\ndef f():\n    pass\n")


def rows(outputs):
    """Return one output or several, vectors and numbers, as rows of 50."""
    return np.vstack([part + np.zeros(50) for part in (outputs if isinstance(outputs, tuple) else [outputs])])


@pytest.mark.parametrize("key", [key for key in FUNCTIONS if key != "finite_difference.py"])
def test_printed_function_computes_what_its_program_does(key):
    name, program = FUNCTIONS[key]
    random = np.random.default_rng(9)
    values = {s.name: random.uniform(0.1, 0.9, 50) for s in program.inputs}
    values |= {"k_u": 8.0, "k_v": 4.0, "shininess": random.uniform(2, 3, 50)}
    scope = {**vars(np), "np": np, "dot": lambda a, b: (a * b).sum(axis=0), "k_u": 8, "k_v": 4}
    exec(function(name, program), scope)
    arguments = [
        values[given] if given in values else np.array([values[f"{given}_{axis}"] for axis in "xyz"])
        for given in inspect.signature(scope[name]).parameters
    ]
    computed = scope[name](*arguments)
    right = function_of(program)(*(values[s.name] for s in program.inputs))
    np.testing.assert_allclose(rows(computed), rows(right), rtol=1e-11, atol=1e-11)


def test_printed_difference_is_the_renderer_s():
    scope = {**vars(np), "k_u": 8, "k_v": 4}
    exec(function(*FUNCTIONS["height_fields.py, ridges"]) + "\n" + function(*FUNCTIONS["finite_difference.py"]), scope)
    u, v = np.random.default_rng(9).uniform(0, 1, (2, 2000))
    u[:3], v[:3] = (0.0, 0.9999, 0.5), (0.0, 1.0, 0.99999)  # the seam and both poles
    for found, right in zip(scope["central"](u, v, 1e-3), gradient_at(Scene(), u, v, central(1e-3)), strict=True):
        assert found == pytest.approx(right, abs=1e-9)
    assert np.abs(kernels.height_ridges(u, v, 8.0, 4.0) - scope["height"](u, v)).max() < 1e-13


# What the cells find


def test_cells_agree_with_the_renderer(ran):
    for number in (1, 3, 4, 5, 6, 8, 9):
        text, _ = ran(number)
        apart = re.search(r"from the book's renderer (?:at most|by) (\S+)", text)
        assert float(apart[1]) < 1e-11, number


def test_cell_with_a_wrong_sign_does_not_agree(ran):
    code = cells()[0].code.replace("g = e_phi*h_v + e_theta*h_u", "g = e_phi*h_v - e_theta*h_u")
    text, _ = ran(code.replace("600", "64"))
    assert line_of(text, "from the book's renderer at most")[0] > 0.1


def test_first_cell_ripples_and_hides_its_error(ran):
    _, scope = ran(1)
    _, third = ran(3)
    on_a = scope["surface"] == 1
    smooth = scope["draw"](lambda u, v: (0 * u, 0 * v), 600)[0]
    exact = third["draw"](third["exact"], 600)[0]

    def share_unlike(other):
        return (np.abs(scope["numeric"] - other).max(axis=2) >= 8 / 255)[on_a].mean()

    assert share_unlike(smooth) > 0.5
    assert share_unlike(exact) < 0.05


def test_second_cell_draws_the_u(ran):
    text, _ = ran(2)
    for eps, spec in (("1e-03", ".3e"), ("1e-04", ".3e"), ("1e-06", ".0e")):
        error, *_, truncation = line_of(text, f"ε = {eps}")
        assert f"{error:{spec}}" == f"{look_up(BOOK, 'u_curve', f'error_{eps}'):{spec}}"
        assert truncation == pytest.approx(61.16 * float(eps) ** 2, rel=1e-3)
    assert line_of(text, "(e_φ × e_θ) · N =") == [1]
    assert line_of(text, "(e_θ × e_φ) · N =") == [-1]
    assert text.count("True") == 2
    assert 10 < line_of(text, "ε = 1e-10")[0] / line_of(text, "ε = 1e-08")[0] < 1000


def test_third_cell_sweeps(ran):
    text, scope = ran(3)
    rows = np.array([line_of(text, f"1e-0{decade}") for decade in range(1, 7)])
    assert not rows[:, 2].any()
    slope = fitted_slope(10.0 ** -np.arange(2, 6), rows[1:5, 1])
    assert f"{slope:.2f}" == f"{look_up(BOOK, 'eps_table', 'rms_slope'):.2f}"
    assert rows[5, 0] < 1e-8
    assert 3.5 < np.log10(line_of(text, "beside a crease")[0] / line_of(text, "elsewhere on A")[0]) < 4
    assert scope["v"].min() > 0 and scope["v"].max() < 1
    # What it draws is what it compares, and the middle of the three pictures is the renderer's.
    assert scope["three"].shape == (256, 3 * 256, 3)
    assert np.abs(scope["three"][:, 256:512] - render(Scene(), 256, 256).rgb).max() < 1e-11
    turned = 8 * scope["u"]
    assert np.abs(turned - np.rint(turned)).min() > 1e-6  # so no rounding decides a crease


def test_what_repeats_is_folded_and_nothing_else():
    first, second = "a = 1\n\ndef f():\n    pass\n\nb = 2", "c = 3\n\ndef f():\n    pass\n\nb = 2\n\na = 2"
    assert repeated([first]) == [[(6, False, ["f"])]]
    assert repeated([first, second])[1] == [(2, False, []), (5, True, ["f"]), (1, False, [])]


def test_fourth_cell_counts_and_times(ran):
    text, _ = ran(4)
    assert line_of(text, "central:")[0] == 4
    assert line_of(text, "exact:")[0] == 0
    assert min(line_of(text, "ns a point: central")) > 0


def test_fifth_cell_differentiates(ran):
    text, _ = ran(5)
    assert line_of(text, "complex step:")[0] < 1e-13
    assert line_of(text, "one-sided difference:")[0] == 1.65e-5  # as on every page: the seed's own random numbers
    errors = [line_of(text, f"Δβ = 1e-0{decade}")[-1] for decade in range(1, 5)]
    assert [a / b for a, b in pairwise(errors[1:])] == pytest.approx([100, 100], rel=0.02)


def test_sixth_cell_goes_back(ran):
    text, _ = ran(6)
    for line in (
        "β = 0, numeric against symbolic:",
        "no height, symbolic against plain:",
        "no height, numeric against plain:",
    ):
        assert line_of(text, line) == [0]
    assert line_of(text, "β = 1.5 against β = 0, mean:")[0] > 0.01
    share = line_of(text, "β = 1e-04:")[-1] / line_of(text, "β = 1e-06:")[-1]
    assert share == pytest.approx(100, rel=0.05)


def test_seventh_cell_goes_wrong(ran):
    text, scope = ran(7)
    lost = [line_of(text, f"ε = 1e-{decade}")[-1] for decade in ("08", "10", "12", "14")]
    assert lost == sorted(lost)
    assert re.findall(r"δ = (\S+) .*(flagged|no flag)", text) == [
        ("-1e-02", "no flag"), ("-1e-06", "flagged"), ("+0e+00", "flagged"), ("+1e-06", "flagged"),
    ]  # fmt: skip
    beside = line_of(text, "δ = +1e-06  central")
    assert f"{beside[1]:.2f}" == f"{look_up(BOOK, 'crease', 'exact_beside'):.2f}"
    assert abs(beside[0] / beside[1]) < 0.02
    assert line_of(text, "δ = +0e+00  central")[0] == 0
    assert scope["sinpi"](np.arange(-4, 5)).any() == False  # noqa: E712
    assert scope["sinpi"](0.5) == 1 and scope["sinpi"](1.5) == -1
    for size in (256, 1024):
        assert line_of(text, f"{size}²: least sin φ")[-1] == 0


def test_eighth_cell_meets_the_wall(ran):
    text, scope = ran(8)
    rows = np.array([line_of(text, f"{texels}²") for texels in (64, 256, 1024)])
    angles = [int(angle) for angle in re.findall(r"to N'.*?(\d+)°", text)]
    factors = [numbers(line)[-1] for line in text.splitlines() if "times less than before" in line]
    assert factors == pytest.approx([a / b for a, b in pairwise(rows[:, 0])], abs=0.1)
    assert 8 < factors[0] < factors[1] < 16  # on their way to 16, for a quarter of the texel
    assert scope["down"].max() <= 0.5  # the outline is above the floor
    assert (rows[:, 2] < rows[:, 0] / 10).all()
    assert rows[2, 3] > 100
    assert angles[0] > 90 > angles[1] > 5 and len(angles) == 2
    moved = [line_of(text, f"β = {beta}:")[-1] for beta in ("0.100", "0.010", "0.001")]
    assert [a / b for a, b in pairwise(moved)] == pytest.approx([10, 10], rel=0.15)


@pytest.mark.parametrize("formula", [None, "exp(-8*(v-1/2)**2)*sinpi(k_u*u)", "max(0, cospi(k_v*v))*3/2", "0.3"])
def test_ninth_cell_draws_what_is_typed(ran, formula):
    """One's own drawing is the renderer's, as near as that certifies; with another slope it is not."""
    code = cells()[8].code
    code = code if formula is None else re.sub(r'(?<=formula = ").*?(?=")', formula, code)
    text, scope = ran(code)
    assert (scope["off"] <= scope["bound"] + 1e-12)[scope["closed"]].all()
    assert line_of(text, "what the book's renderer certifies:")[0] < 1e-6
    if formula is None:
        _, wrong = ran(code.replace("h.diff(u), h.diff(v)", "h.diff(v), h.diff(u)"))
        assert not (wrong["off"] <= wrong["bound"] + 1e-12).all()


# The notebooks


def test_the_notebooks_are_the_cells():
    made = notebooks()
    assert list(made) == NAMES
    for name, notebook in made.items():
        nbformat.validate(nbformat.from_dict(notebook))
        assert [cell["id"] for cell in notebook["cells"]] == [f"cell-{n}" for n in range(len(notebook["cells"]))], name
        said = "\n".join(c["source"] for c in notebook["cells"] if c["cell_type"] == "markdown")
        assert not re.search(r"\{[\w-]+\}`|^:::|^\(\w+\)=", said, re.M)
        assert "**Expect**" in said
    for cell in cells():
        assert "\n".join(code_of(made[cell.name])) == cell.code
    assert code_of(made[WHOLE]) == [source for cell in cells() for source in code_of(made[cell.name])]


def test_prose_becomes_plain_markdown():
    said = plain("(cell9)=\nSee [§3](#s3), {number}`eps_table.flips_1e-1` flips {cite}`Lyness1967,Squire1998`.")
    assert said == "See §3, 0 flips (Lyness and Moler 1967; Squire and Trapp 1998)."
    assert plain("{number}`u_curve.error_1e-03|.0e`") == r"$6 \times 10^{-5}$"
    with pytest.raises(ValueError, match="the role 'theorem-ref' of"):
        plain("{theorem-ref}`normal`")


def test_cells_import_the_four_packages_and_the_library_alone():
    allowed = sys.stdlib_module_names | {"numpy", "sympy", "mpmath", "matplotlib", "renderer"}
    imported = re.findall(r"^\s*(?:from|import) (\w+)", "\n".join(cell.code for cell in cells()), re.MULTILINE)
    assert len(imported) > 30 and set(imported) <= allowed


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """Run this Python in a folder, without the project and without a network."""
    place = tmp_path_factory.mktemp("alone")
    (place / "sitecustomize.py").write_text(ALONE_HERE, encoding="utf-8")
    home = {name: str(place) for name in ("HOME", "IPYTHONDIR", "MPLCONFIGDIR", "JUPYTER_CONFIG_DIR", "PYTHONPATH")}
    settings = {"PATH": os.environ.get("PATH", os.defpath), "LANG": "C.UTF-8", **home}

    def run(arguments, folder):
        return subprocess.run([sys.executable, *arguments], cwd=folder, env=settings, capture_output=True, text=True)

    return run


def test_the_project_is_not_there_and_no_network(alone, tmp_path):
    assert "No module named 'renderer'" in alone(["-c", "import renderer"], tmp_path).stderr
    ask = "import urllib.request; urllib.request.urlopen('http://192.0.2.1', timeout=5)"
    assert "a notebook asked the network" in alone(["-c", ask], tmp_path).stderr


def compared(text):
    """Return what a cell printed of its own, the comparison with the renderer left out."""
    return "".join(line for line in text.splitlines(keepends=True) if "the book's renderer" not in line.lower())


def test_notebooks_run_alone_and_print_what_the_page_does(site, page_of, alone, tmp_path):
    """The page's own build runs the one of all cells: the same code, as another test compares."""
    printed = []
    for name in NAMES[:-1]:
        empty, done = tmp_path / name, tmp_path / f"{name}.done.ipynb"
        empty.mkdir()
        shutil.copy(site / FOLDER / f"{name}.ipynb", empty)
        run = alone(["-c", RUN, f"{name}.ipynb", done], empty)
        assert run.returncode == 0, run.stderr
        assert os.listdir(empty) == [f"{name}.ipynb"]
        outputs = [output for cell in nbformat.read(done, 4).cells for output in cell.get("outputs", ())]
        assert not [o for o in outputs if o["output_type"] == "error" or o.get("name") == "stderr"]
        text = "".join(output["text"] for output in outputs if output["output_type"] == "stream")
        assert text.count(ALONE) == 1
        timed = re.compile(r"(?:ns a point: |the difference takes |a frame at ).*\n")  # the page times nothing
        assert len(timed.findall(text)) == {"cell3": 2, "cell4": 4}.get(name, 0)
        printed.append(compared(timed.sub("", text)))
    blocks = page_of("s5").select("div.cell_output pre")
    assert all(printed) and "".join(printed) == "".join(compared(block.get_text()) for block in blocks)


@pytest.mark.parametrize(
    ("url", "links"),
    [("", 1), ("https://example.org/a/b", 1), ("https://github.com/a", 1), ("https://github.com/a/b.git", 3)],
)
def test_colab_and_binder_are_offered_where_a_repository_is_configured(url, links, tmp_path):
    (tmp_path / "_config.yml").write_text(f"repository: {{url: '{url}', branch: pages}}\n")
    html, _ = one_page.build(tmp_path, ":::{notebook} cell3\n:::")
    (paragraph,) = parsed(html).select("p.notebook-links")
    saved, *others = [link["href"] for link in paragraph.select("a")]
    assert paragraph.a["download"] == "cell3.ipynb"
    content = b64decode(saved.removeprefix("data:application/x-ipynb+json;base64,"))
    assert content.decode() == text_of(notebooks()["cell3"])
    services = [
        f"https://colab.research.google.com/github/a/b/blob/pages/{FOLDER}/cell3.ipynb",
        f"https://mybinder.org/v2/gh/a/b/pages?urlpath=lab/tree/{FOLDER}/cell3.ipynb",
    ]
    assert others == services[: links - 1]


def test_what_they_open_is_published_on_that_branch(site):
    """The site's own folder is pushed there, with what Binder installs."""
    repository = yaml.safe_load((ROOT / "book" / "_config.yml").read_text(encoding="utf-8"))["repository"]
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / "publish.yml").read_text(encoding="utf-8"))
    steps = "\n".join(step.get("run", "") for step in workflow["jobs"]["publish"]["steps"])
    assert (
        f"initial-branch={repository['branch']}\n" in steps
        and f"{repository['branch']}\n" in steps.split("git push")[1]
    )
    pinned = (site / "requirements.txt").read_text(encoding="utf-8").splitlines()
    assert {line.split("==")[0] for line in pinned} == {"matplotlib", "mpmath", "numpy", "sympy"}


def test_links_save_notebooks_from_a_disk_and_addresses_of_cells_are_their_headings(site, visit):
    page = visit("s5", "file")
    links = page.locator(".notebook-links a[download]")
    assert links.count() == len(NAMES)
    for number in range(links.count()):
        with page.expect_download() as saved:
            links.nth(number).click()
        name = links.nth(number).get_attribute("download")
        assert saved.value.suggested_filename == name
        assert Path(saved.value.path()).read_bytes() == (site / FOLDER / name).read_bytes()
    for number in (1, 9):
        assert page.locator(f"#cell{number} > :is(h2, h3)").first.inner_text().startswith(f"Cell {number}.")


def test_copied_cell_is_complete_though_its_scene_is_folded(visit):
    page = visit("s5", "file")
    page.evaluate("document.body.prepend(Object.assign(document.createElement('textarea'), { id: 'pasted' }))")
    inputs, sources = page.locator("div.cell_input"), code_of(notebooks()[WHOLE])
    assert inputs.count() == page.locator("div.cell_input button.copybtn").count() == len(sources)
    shown = [cell.inner_text().count("\n") for cell in inputs.all()]
    assert shown[2] < sources[2].count("\n") / 2  # of the third cell two thirds are as before, and folded
    assert page.locator("div.cell_input .new-lines").first.is_visible()
    for number, source in enumerate(sources):
        inputs.nth(number).locator("button.copybtn").click()
        page.locator("#pasted").fill("")
        page.keyboard.press("Control+V")
        assert page.locator("#pasted").input_value().strip() == source.strip()
