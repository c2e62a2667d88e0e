"""The laboratory's notebooks: each stands alone, finds what its page expects, and draws what the renderer draws."""

import base64
import json
import os
import re
import shutil
import subprocess
import sys
import zlib
from importlib.metadata import PackageNotFoundError, requires
from pathlib import Path

import nbformat
import pytest
from filelock import FileLock
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from book.build import stamps
from book.extension.notebooks import FOLDER, colab_address
from book.notebooks import WHOLE
from book.notebooks.first_cell import closure, first_cell
from book.notebooks.laboratory import cells, plain
from book.notebooks.notebook import notebooks, text_of
from book.notebooks.slices import needed
from tests import one_page

NAMES = [*(f"cell{number}" for number in range(1, 9)), WHOLE]
FOUR = ("numpy", "sympy", "mpmath", "matplotlib")
RUNNERS = ("ipykernel", "nbclient")
UNEXPECTED = "NOT AS EXPECTED"
OFFLINE = '''\
"""Refuse every connection that leaves this machine."""
import socket


class Offline(socket.socket):
    def connect(self, address):
        if self.family in (socket.AF_INET, socket.AF_INET6) and not str(address[0]).startswith("127."):
            raise OSError(f"a notebook asked the network for {address}")
        return super().connect(address)


socket.socket = Offline
'''
RUN = """\
import sys, nbclient, nbformat
notebook = nbformat.read(sys.argv[1], 4)
nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
nbformat.write(notebook, sys.argv[2])
"""


def code_cells(notebook):
    """Return a notebook's code cells."""
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def printed(cell):
    """Return what a code cell wrote."""
    return "".join("".join(output["text"]) for output in cell["outputs"] if output["output_type"] == "stream")


def test_nine_notebooks_are_valid_and_the_same_when_made_again(site):
    made = notebooks()
    assert list(made) == NAMES
    for name, notebook in made.items():
        nbformat.validate(nbformat.from_dict(notebook))
        assert [cell["id"] for cell in notebook["cells"]] == [f"cell-{n}" for n in range(len(notebook["cells"]))], name
        assert not re.search(r"\{[\w-]+\}`|^:::|^\(\w+\)=", "\n".join(c["source"] for c in notebook["cells"]), re.M)
    assert {n: text_of(b) for n, b in notebooks().items()} == {n: text_of(b) for n, b in made.items()}


def test_sources_are_the_projects_own_and_no_more_than_needed():
    sources = closure("from renderer import Scene, render")
    for path, text in sources.items():
        assert (stamps.ROOT / path).read_text(encoding="utf-8") == text, path
    drawing = ("kernels", "drawing", "gradients", "machines/__init__", "machines/native", "machines/numpy_rows")
    assert {f"renderer/{name}.py" for name in drawing} <= sources.keys()
    assert not any(re.match(r"proofs/|renderer/(generate|command_line|grid|stream)", path) for path in sources)
    assert "proofs/formulas/half_turns.py" in closure("from proofs.formulas.height_fields import HEIGHT_FIELDS")


def altered(text, change):
    """Return a first cell's text whose packed sources went through `change`."""
    packed = re.search(r'^SOURCES = "(.*)"$', text, re.M)[1]
    sources = json.loads(zlib.decompress(base64.b64decode(packed)))
    change(sources)
    return text.replace(packed, base64.b64encode(zlib.compress(json.dumps(sources).encode(), 9)).decode())


def test_altered_module_is_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = first_cell(closure("from renderer import Scene"))
    only_write = text[: text.index("FOLDER =")]
    scope = {}
    exec(altered(only_write, lambda sources: None), scope)
    assert (scope["write_sources"]() / "renderer" / "scene.py").is_file()

    def one_sign(sources):
        sources["renderer/scene.py"] = sources["renderer/scene.py"].replace("0.35", "0.36")

    exec(altered(only_write, one_sign), scope)
    with pytest.raises(ValueError, match=r"renderer/scene\.py is not what the book's build wrote"):
        scope["write_sources"]()

    def one_more(sources):
        sources["renderer/more.py"] = ""

    exec(altered(only_write, one_more), scope)
    with pytest.raises(ValueError, match=r"renderer/more\.py is not what"):
        scope["write_sources"]()
    exec(re.sub(r'("renderer/scene\.py": ")....', r"\g<1>0000", only_write), scope)
    with pytest.raises(ValueError, match="HASHES is not what"):
        scope["write_sources"]()


def test_expectation_that_is_not_met_is_said(capsys):
    text = first_cell({})
    scope = {}
    exec(text[text.index("def expect") : text.index("files =")], scope)
    scope["expect"]("no flips", 3, False)
    assert capsys.readouterr().out == f"{UNEXPECTED}: no flips; here 3\n"


def test_slice_takes_what_a_cell_needs_and_leaves_the_rest():
    before = [
        "import a, b\nx = a.one()\ny = 2\nprint(x)",
        "def f(t):\n    y = t\n    return x + y + z\nz = 1\nz += 1\nw = [y for y in (1, 2)]",
    ]
    assert needed("x = 3\nprint(x)", before) == []
    assert needed("print(y)", before) == ["y = 2"]
    assert needed("z = z * 2", before) == ["z = 1", "z += 1"]
    assert needed("def g():\n    return f(1)", before)[:2] == ["import a, b", "x = a.one()"]
    assert "y = 2" not in needed("f(1)", before)


def test_every_cell_of_the_page_has_an_expectation_and_a_link():
    page = (stamps.ROOT / "book" / "chapter" / "s5.md").read_text(encoding="utf-8")
    assert [cell.name for cell in cells()] == NAMES[:-1]
    for cell in cells():
        assert any("**Expect**" in part.text for part in cell.parts), cell.name
        assert any("expect" in part.tags and "expect(" in part.text for part in cell.parts), cell.name
    for name in NAMES:
        assert page.count(f":::{{notebook}} {name}\n") == 1


def test_prose_becomes_plain_markdown(site):
    said = plain("(cell9)=\nSee [§3](#s3), {number}`eps_table.flips_1e-1` flips {cite}`Lyness1967,Squire1998`.")
    assert said == "See §3, 0 flips (Lyness and Moler 1967; Squire and Trapp 1998)."
    assert plain("{number}`u_curve.error_1e-03|.0e`") == r"$6 \times 10^{-5}$"
    with pytest.raises(ValueError, match="the role 'theorem-ref' of"):
        plain("{theorem-ref}`normal`")


def with_dependencies(names):
    """Return the names of packages and of all that they need here, as the lock spells them."""
    found, waiting = set(), [canonicalize_name(name) for name in names]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        try:
            needs = [Requirement(text) for text in requires(name) or ()]
        except PackageNotFoundError:  # needed on other systems alone
            continue
        found.add(name)
        waiting += [canonicalize_name(n.name) for n in needs if n.marker is None or n.marker.evaluate({"extra": ""})]
    return found


def part_of_the_lock(names):
    """Return the lock's lines of some packages, versions and hashes included."""
    entries = re.split(r"\n(?=\S)", stamps.LOCK_FILE.read_text(encoding="utf-8").strip())
    return "\n".join(e for e in entries if canonicalize_name(re.match(r"[\w.-]+", e)[0]) in names) + "\n"


def give_up(reason):
    """Skip, or fail where REQUIRE_NOTEBOOKS=1 forbids that."""
    if os.environ.get("REQUIRE_NOTEBOOKS") == "1":
        pytest.fail(f"{reason}, and REQUIRE_NOTEBOOKS=1")
    pytest.skip(reason)


@pytest.fixture(scope="session")
def clean_python(tmp_path_factory, request):
    """A Python with the four packages and what executes a notebook, at the lock's versions, and no network."""
    base = tmp_path_factory.getbasetemp()
    shared = base.parent if hasattr(request.config, "workerinput") else base
    folder = shared / "clean_environment"
    python = folder / "bin" / "python"
    with FileLock(shared / "clean_environment.lock"):
        if not (folder / "whole").exists():
            shutil.rmtree(folder, ignore_errors=True)
            subprocess.run([sys.executable, "-m", "venv", folder], check=True)
            (folder / "lock.txt").write_text(part_of_the_lock(with_dependencies(FOUR + RUNNERS)), encoding="utf-8")
            install = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--require-hashes"]
            done = subprocess.run([*install, "-r", folder / "lock.txt"], capture_output=True, text=True)
            if done.returncode:
                give_up(f"the four packages cannot be installed: {done.stderr.strip().splitlines()[-1]}")
            (site_packages,) = folder.glob("lib/python*/site-packages")
            (site_packages / "offline.py").write_text(OFFLINE, encoding="utf-8")
            (site_packages / "offline.pth").write_text("import offline\n", encoding="utf-8")
            (folder / "whole").touch()
    return python


def in_empty_folder(python, arguments, folder):
    """Run the clean Python in a folder, with nothing of this environment's."""
    home = {name: str(folder.parent / "home") for name in ("HOME", "IPYTHONDIR", "MPLCONFIGDIR", "JUPYTER_CONFIG_DIR")}
    settings = {"PATH": os.environ.get("PATH", os.defpath), "LANG": "C.UTF-8", **home}
    return subprocess.run([python, *arguments], cwd=folder, env=settings, capture_output=True, text=True)


def test_clean_environment_has_neither_llvmlite_nor_a_network(clean_python, tmp_path):
    for name in ("llvmlite", "renderer"):
        done = in_empty_folder(clean_python, ["-c", f"import {name}"], tmp_path)
        assert f"No module named '{name}'" in done.stderr
    ask = "import urllib.request; urllib.request.urlopen('http://192.0.2.1', timeout=5)"
    assert "a notebook asked the network" in in_empty_folder(clean_python, ["-c", ask], tmp_path).stderr


@pytest.mark.parametrize("name", NAMES)
def test_notebook_runs_alone_and_prints_what_the_page_does(name, site, clean_python, tmp_path, record_property):
    empty = tmp_path / "empty"
    empty.mkdir()
    shutil.copy(site / FOLDER / f"{name}.ipynb", empty)
    done = in_empty_folder(clean_python, ["-c", RUN, f"{name}.ipynb", tmp_path / "done.ipynb"], empty)
    assert done.returncode == 0, done.stderr
    assert sorted(p.name.split("-")[0] for p in empty.iterdir()) == sorted([f"{name}.ipynb", "symbolic"])
    on_page, here = (code_cells(json.loads(path.read_text(encoding="utf-8"))) for path in
                     (site / FOLDER / f"{name}.ipynb", tmp_path / "done.ipynb"))  # fmt: skip
    text = "".join(printed(cell) for cell in here)
    assert not [o for cell in here for o in cell["outputs"] if o["output_type"] == "error" or o.get("name") == "stderr"]
    assert UNEXPECTED not in text
    assert "as expected: " in text
    assert "drawn by numpy" in text
    assert text.count(" ms a frame") == (3 if name in ("cell4", WHOLE) else 0)  # the page times nothing
    compared = [(printed(page), printed(run)) for page, run in zip(on_page, here, strict=True) if page["outputs"]]
    assert compared
    for page, run in compared:
        assert run == page
    seconds = re.search(r"([\d.]+) s since the first cell", text)[1]
    record_property("seconds", seconds)
    print(f"{name}: {seconds} s without llvmlite")


def test_notebook_draws_by_llvm_where_it_is(site, tmp_path):
    notebook = json.loads((site / FOLDER / "cell6.ipynb").read_text(encoding="utf-8"))
    lines = ["import matplotlib", "matplotlib.use('agg')", *(cell["source"] for cell in code_cells(notebook))]
    done = subprocess.run([sys.executable, "-I", "-c", "\n".join(lines)], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "drawn by llvm" in done.stdout
    assert UNEXPECTED not in done.stdout


@pytest.mark.parametrize(("url", "links"), [("", 1), ("https://example.org/a/b", 1), ("https://github.com/a/b", 2)])
def test_colab_is_offered_where_a_repository_is_configured(url, links, tmp_path):
    (tmp_path / "_config.yml").write_text(f"repository: {{url: '{url}', branch: pages}}\n")
    (tmp_path / "index.md").write_text("# A\n\n:::{notebook} cell3\n:::\n")
    parts = [f"book.extension.{name}" for name in ("elements", "notebooks")]
    html, _ = one_page.build(tmp_path, tmp_path / "out", extensions=["myst_parser", *parts])
    found = re.findall(r'<p class="notebook-links">.*?</p>', html, re.S)
    assert len(found) == 1
    assert found[0].count("<a ") == links
    assert f'href="{FOLDER}/cell3.ipynb"' in found[0]
    colab = f"https://colab.research.google.com/github/a/b/blob/pages/{FOLDER}/cell3.ipynb"
    assert (f'href="{colab}"' in found[0]) == (links == 2)


def test_colab_address_needs_a_repository_of_githubs():
    assert colab_address({}, "cell1") is None
    assert colab_address({"repository": {"url": "https://github.com/only-owner"}}, "cell1") is None
    assert colab_address({"repository": {"url": "https://github.com/o/n.git"}}, "cell1").startswith(
        "https://colab.research.google.com/github/o/n/blob/gh-pages/"
    )


@pytest.mark.browser
def test_links_save_notebooks_from_a_disk_and_buttons_copy_code(site, browser):
    page = browser.new_page(accept_downloads=True)
    page.goto((site / "s5.html").as_uri())
    links = page.locator(".notebook-links a[download]")
    assert links.count() == len(NAMES)
    for number in range(links.count()):
        with page.expect_download() as saved:
            links.nth(number).click()
        name = Path(links.nth(number).get_attribute("href")).name
        assert saved.value.suggested_filename == name
        assert Path(saved.value.path()).read_bytes() == (site / FOLDER / name).read_bytes()
    cell = page.locator("div.cell_input").first
    assert page.locator("div.cell_input button.copybtn").count() == page.locator("div.cell_input").count()
    cell.locator("button.copybtn").click()
    page.evaluate("document.body.prepend(Object.assign(document.createElement('textarea'), { id: 'pasted' }))")
    page.locator("#pasted").focus()
    page.keyboard.press("Control+V")
    assert page.locator("#pasted").input_value().strip() == cell.locator("pre").inner_text().strip()
    page.close()
