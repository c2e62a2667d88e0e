"""The package as `pip install .` gives it: in an empty environment it draws and checks, without the repository."""

import os
import re
import sys
import tarfile
import tomllib
import zipfile
from importlib.metadata import packages_distributions, requires
from pathlib import Path
from sysconfig import get_path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from proofs.engine import project
from proofs.engine.theorem import all_theorems
from renderer import Scene, render
from tests.processes import run, settings_without
from verify.evidence.sources import ROOT, imported

SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
PROJECT = SETTINGS["project"]
LOCKS = ("requirements-book.lock", "requirements.lock")
LARGEST = 1.5e6  # bytes
SCRIPT = """
import multiprocessing
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import renderer
from renderer import Frame, HeightField, Light, Scene, central, exact, gradient_at, height_at, pixel, render, stage_of


def drawn(beta: float) -> bytes:
    scene = Scene(beta=beta, lights=(Light((5.0, 5.0, 10.0)),))
    numeric: Frame = render(scene, 200, 150, gradient=central(eps=1e-3), stage=stage_of(scene, 200, 150))
    assert gradient_at(scene, 0.31, 0.47, exact())[0].shape == height_at(scene, 0.31, 0.47).shape
    assert np.array_equal(numeric.rgb[75, 100], pixel(scene, 200, 150, 100, 75, central(eps=1e-3)).rgb)
    return numeric.rgb.tobytes()


if __name__ == "__main__":
    expected = [drawn(0.1), drawn(0.2)]
    for method in multiprocessing.get_all_start_methods():
        with multiprocessing.get_context(method).Pool(2) as pool:
            assert pool.map(drawn, [0.1, 0.2]) == expected, method
    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(drawn, [0.1, 0.2] * 4)) == expected * 4
    hills = Scene(field=HeightField("hills", "a*sin(8*pi*u)", a=0.3))
    assert render(hills, 8, 8, derivatives=("a",)).derivatives["a"].any()
    print(renderer.__version__)
"""


def done(*command, cwd, status=0, **settings):
    """Run a command away from the repository; return what it prints."""
    printed, _ = run(*command, cwd=cwd, status=status, env=settings_without("PYTHON") | settings)
    return printed


def pip(*arguments, cwd):
    """Run pip, which needs a package index; where there is none, the tests are skipped or fail."""
    try:
        done(sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check", *arguments, cwd=cwd)
    except AssertionError as error:
        refuse = pytest.fail if os.environ.get("REQUIRE_NOTEBOOKS") == "1" else pytest.skip
        refuse(f"the wheel cannot be installed: {error}")


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The folder of the sources' archive, and of the wheel that the build's own program makes from what it holds."""
    folder = tmp_path_factory.mktemp("built")
    pip("install", "--target", folder / "hatchling", *SETTINGS["build-system"]["requires"], cwd=folder)
    build = [sys.executable, "-m", "hatchling", "build", "-d", folder / "built", "-t"]
    done(*build, "sdist", cwd=ROOT, PYTHONPATH=str(folder / "hatchling"))
    with tarfile.open(next(folder.glob("built/*"))) as sources:
        sources.extractall(folder, filter="data")
    done(*build, "wheel", cwd=next(folder.glob("symbolic*")), PYTHONPATH=str(folder / "hatchling"))
    return folder / "built"


@pytest.fixture(scope="module")
def installed(built, tmp_path_factory):
    """The folder of the commands of an environment that has the wheel, what it needs, pytest, and nothing else."""
    folder = tmp_path_factory.mktemp("wheel")
    done(sys.executable, "-m", "venv", "--without-pip", "environment", cwd=folder)
    commands = Path(get_path("scripts", "venv", {"base": str(folder / "environment")}))
    wanted = ["--no-compile", next(built.glob("*.whl")), "pytest"]  # Python compiles what is imported
    pip("--python", commands / "python", "install", *wanted, cwd=folder)
    return commands


def test_it_draws_the_same_bytes(installed, tmp_path):
    done(installed / "symbolic-rendering", "image", "--size", "64", "--out", "a.png", cwd=tmp_path)
    assert (tmp_path / "a.png").read_bytes() == render(Scene(), 64, 64)._repr_png_()


def test_it_checks_theorems_in_an_empty_folder(installed, tmp_path):
    """Two of them here, one and the one that it uses; and every certificate."""
    two = ["-k", "unit_length or tangent_frame", "-p", "no:cacheprovider"]
    printed = done(installed / "python", "-m", "pytest", "--pyargs", "verify", "-q", *two, cwd=tmp_path)
    assert f"2 passed, {len(all_theorems()) - 1} deselected" in printed  # with the second checker
    certificates = [*project.PROJECT.certificates.glob("*.json")]
    assert len(done(installed / "check-proofs", cwd=tmp_path).splitlines()) == 1 + len(certificates)
    assert list(tmp_path.iterdir()) == []


def test_a_strangers_script(installed, tmp_path):
    """It forks, spawns and draws from threads, and its types are checked from outside."""
    (tmp_path / "script.py").write_text(SCRIPT)
    assert done(installed / "python", "script.py", cwd=tmp_path) == f"{PROJECT['version']}\n"
    mypy = [sys.executable, "-m", "mypy", "--strict", "--python-executable", installed / "python", "script.py"]
    (tmp_path / "script.py").write_text(SCRIPT.replace("Scene(beta=beta", "Scene(field=beta"))
    told = done(*mypy, cwd=tmp_path, status=1)
    assert 'Argument "field" to "Scene" has incompatible type "float"' in told and "Found 1 error " in told


def test_what_is_in_the_wheel_and_in_the_archive(built):
    (wheel,), (archive,) = built.glob("*.whl"), built.glob("*.tar.gz")
    assert max(wheel.stat().st_size, archive.stat().st_size) < LARGEST
    with zipfile.ZipFile(wheel) as packed, tarfile.open(archive) as sources:
        held = {name for name in packed.namelist() if ".dist-info/" not in name}
        of_sources = {name.partition("/")[2] for name in sources.getnames()}
        (metadata,) = (packed.read(name).decode() for name in packed.namelist() if name.endswith("/METADATA"))
    assert held - of_sources == {"verify/references.bib", "verify/checkers/kernel.js", "proofs/pyproject.toml"}
    assert {name for name in held if "/test_" in name} == {"verify/test_theorems.py"}
    assert "\nClassifier: Private :: Do Not Upload" in metadata and "\nLicense" not in metadata  # none has been chosen
    assert "# Bump Mapping" in metadata and "](" not in metadata  # no repository is named that a link could lead to


def needed(requirements):
    """Return the names of the distributions that requirements bring along, themselves included."""
    waiting, names = [Requirement(text) for text in requirements], set()
    while waiting:
        one = waiting.pop()
        name = canonicalize_name(one.name)
        if name == PROJECT["name"]:
            waiting += [Requirement(text) for extra in one.extras for text in PROJECT["optional-dependencies"][extra]]
        elif name not in names and (one.marker is None or one.marker.evaluate({"extra": ""})):
            names.add(name)
            waiting += [Requirement(text) for text in requires(name) or ()]
    return names


def test_the_book_s_lock_is_a_part_of_the_other_and_has_all_that_the_book_needs():
    pins = [set(re.findall(r"^([\w.-]+)==([^\s;]+)", (ROOT / name).read_text("utf-8"), re.MULTILINE)) for name in LOCKS]
    assert pins[0] < pins[1]
    for extra, pinned in zip(("book", "test"), pins, strict=True):
        wanted = needed([*PROJECT["dependencies"], f"{PROJECT['name']}[{extra}]"])
        assert wanted <= {name for name, _ in pinned}


def test_the_extra_of_the_book_has_all_that_the_book_imports():
    names = {
        name.split(".")[0] for path in (ROOT / "book").rglob("*.py") for name in imported(path.read_text("utf-8"))[0]
    }
    homes = packages_distributions()
    book = {PROJECT["name"]} | needed([*PROJECT["dependencies"], f"{PROJECT['name']}[book]"])
    lacking = {n for n in names & homes.keys() if not book & set(map(canonicalize_name, homes[n]))}
    assert "filelock" in names and "sphinx" in names
    assert lacking == set()
