"""The package as `pip install .` gives it: in an empty environment it draws and checks, without the repository."""

import os
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from PIL import Image

from proofs.engine.theorem import all_theorems
from renderer import Scene, render
from renderer.picture.views import to_bytes
from verify.sources import ROOT

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXAMINE = """
from proofs.engine.theorem import all_theorems
from verify.checkers.proof_checker import examine
theorems = all_theorems()
print(len(theorems), examine(theorems["unit_length"], theorems).grade)
"""


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """The folder of the commands of an environment that has the wheel and what it needs, and nothing else."""
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder / "environment"], check=True)
    commands = folder / "environment" / "bin"
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check", "--python", commands / "python"]
    install = ["install", "--no-compile", "symbolic-rendering", "-f", folder]  # Python compiles what is imported
    for arguments in (["wheel", "--no-deps", ROOT, "-w", folder], install):
        done = subprocess.run([*pip, *arguments], cwd=folder, capture_output=True, text=True)
        if done.returncode:
            reason = f"the wheel cannot be installed: {done.stderr.strip().splitlines()[-1]}"
            if os.environ.get("REQUIRE_NOTEBOOKS") == "1":
                pytest.fail(f"{reason}, and REQUIRE_NOTEBOOKS=1")
            pytest.skip(reason)
    return commands


def run(*command, cwd):
    """Run a command away from the repository; return what it prints."""
    settings = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    done = subprocess.run(command, cwd=cwd, env=settings, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_what_it_needs_is_little():
    assert len(PROJECT["dependencies"]) <= 6


def test_it_draws_the_same_bytes(installed, tmp_path):
    run(installed / "symbolic-rendering", "image", "--size", "64", "--out", "a.png", cwd=tmp_path)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "a.png")), to_bytes(render(Scene(), 64, 64).rgb))


def test_it_checks_every_certificate(installed, tmp_path):
    printed = run(installed / "check-proofs", cwd=tmp_path).splitlines()
    accepted, _, total = printed[-1].split()[:3]
    assert accepted == total and len(printed) == 1 + len(list((ROOT / "proofs" / "certificates").glob("*.json")))


def test_it_examines_a_theorem(installed, tmp_path):
    number, grade = run(installed / "python", "-c", EXAMINE, cwd=tmp_path).split(maxsplit=1)
    assert int(number) == len(all_theorems())
    assert grade.strip() == "proved"
