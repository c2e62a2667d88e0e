"""CONTRIBUTING's two ways in, `tests/examples/*/way_in.sh`: each followed in a copy of the project, and to the end."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from renderer import Scene, render
from renderer.picture.views import to_bytes
from verify.sources import ROOT

EXAMPLES = Path("tests", "examples")
CLAIM = "waves_climb_one_way"
# Draws with the new model; "numpy" hides LLVM.
DRAW = """
import sys
if sys.argv[1] == "numpy":
    sys.modules["llvmlite"] = None
import numpy as np
from renderer import Scene, render
from renderer.machines import machine
np.save(sys.argv[1], render(Scene(model="oren_nayar"), 128, 128).rgb)
print(machine().NAME)
"""
# Oren and Nayar's own formula, by angles, against what the renderer says of some pixels: the largest error of a number.
COMPARE = """
import numpy as np
from renderer import Scene, pixel
scene, sigma, errors, roughened = Scene(model="oren_nayar"), {sigma}, [], 0
a, b = 1 - 0.5 * sigma**2 / (sigma**2 + 0.33), 0.45 * sigma**2 / (sigma**2 + 0.09)

def towards(place, point):
    return (place - point) / np.linalg.norm(place - point)

def scattered(n, w, v):
    angles = np.arccos([n @ w, n @ v])
    azimuth_w, azimuth_v = (d - (n @ d) * n for d in (w, v))
    turned = azimuth_w @ azimuth_v / np.linalg.norm(azimuth_w) / np.linalg.norm(azimuth_v)
    return np.cos(angles[0]) * (a + b * max(0, turned) * np.sin(angles.max()) * np.tan(angles.min()))

for column, row in [(column, row) for column in range(2, 96, 7) for row in range(2, 64, 5)]:
    seen = pixel(scene, 96, 64, column, row)
    point, n, color = np.array(seen.point), np.array(seen.normal), scene.ka * np.array(scene.ambient)
    v = towards(np.array([0, 0, scene.eye]), point)
    for light in seen.lights:
        w = towards(np.array(scene.lights[light.number].position), point)
        if n @ w > 0 and n @ v > 0:
            mu, base = scattered(n, w, v), max(0, 2 * (n @ w) * (n @ v) - w @ v)
            errors += [mu - light.mu, base**scene.shininess - light.specular]
            roughened += mu > 1.01 * a * (n @ w)
        elif n @ w <= 0:
            assert light.mu <= 0
        color = color + light.adds
    errors += list(np.clip(color, 0, 1) - seen.rgb)
print(len(errors), roughened, np.abs(errors).max())
"""


def run(folder, command, status=0):
    """Run a line of a shell in the folder, by this Python; return what it prints."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    environment["PATH"] = f"{Path(sys.executable).parent}:{environment['PATH']}"
    shell = {"cwd": folder, "env": environment, "capture_output": True, "encoding": "utf-8"}
    done = subprocess.run(["bash", "-ec", command], **shell)
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout + done.stderr


def copied(folder):
    """Copy the project as it is, without what is built and installed."""
    left_out = shutil.ignore_patterns(".*", "__pycache__", "_build", "_generated", "node_modules")
    shutil.copytree(ROOT, folder, ignore=left_out, dirs_exist_ok=True)


def commands(example):
    """Return the lines of a way in; Coq's only where it is installed."""
    lines = (ROOT / EXAMPLES / example / "way_in.sh").read_text(encoding="utf-8").splitlines()
    lines = filter(None, (line.partition("#")[0].strip() for line in lines))
    return [line for line in lines if "verify.formal" not in line or shutil.which("coqc")]


def walked(folder, example):
    """Follow a way in but for what proves; return the folder."""
    copied(folder)
    *lines, book = commands(example)
    assert book == "python -m book"
    for line in lines:
        if not re.search("certificate|pytest|formal", line):
            run(folder, line)
    return folder


@pytest.fixture(scope="module")
def waves(tmp_path_factory):
    """The folder in which the field was added."""
    return walked(tmp_path_factory.mktemp("field"), "height_field")


@pytest.fixture(scope="module")
def lit(tmp_path_factory):
    """The folder in which the light model was added."""
    return walked(tmp_path_factory.mktemp("light"), "light_model")


@pytest.mark.long
@pytest.mark.skipif("not config.getoption('long', False)", reason="takes minutes; run with verify and --long")
@pytest.mark.parametrize(
    ("example", "theorem", "true", "false"),
    [
        ("height_field", CLAIM, "equation(k_v * h_u, k_u * h_v)", "equation(k_u * h_u, k_v * h_v)"),
        ("light_model", "smooth_is_lambert", "oren_nayar(0)", "oren_nayar(Pow(2, -1))"),
    ],
)
def test_a_way_in_ends_with_a_book(tmp_path, example, theorem, true, false):
    """The theorem is proved, by Coq too, a false one is not, and no certificates are made but those that are stale."""
    copied(tmp_path)
    printed = {line.split()[2]: run(tmp_path, line) for line in commands(example)}
    made = {line.partition(":")[0] for line in printed["proofs.engine.certificate"].splitlines()}
    assert made == {"bump_moves_no_boundary", theorem}
    assert re.search(rf"{theorem} +proved .* mutants 2/2", printed["pytest"])
    page = (tmp_path / "book" / "_build" / "html" / "s3.html").read_text(encoding="utf-8")
    assert ('id="fig-waves"' in page) is (example == "height_field")
    if "verify.formal" in printed:
        assert re.search(rf"{theorem} +2 claims +0 mutants +0 statements", printed["verify.formal"])
    (path,) = (tmp_path / EXAMPLES / example / "proofs" / "theorems").iterdir()
    place = tmp_path / "proofs" / "theorems" / path.name
    text = place.read_text(encoding="utf-8")
    assert true in text
    place.write_text(text.replace(true, false, 1), encoding="utf-8")
    run(tmp_path, f"python -m proofs.engine.certificate {theorem}", status=1)


def test_the_ways_in_are_short():
    texts = {path: path.read_text(encoding="utf-8") for path in (ROOT / EXAMPLES).rglob("*.*")}
    for example in (ROOT / EXAMPLES).iterdir():
        written = [p for p in texts if example in p.parents and p.suffix in (".patch", ".py", ".toml")]
        assert sum(len(texts[path].splitlines()) for path in written) < 80
    assert all(len(text.splitlines()) < 15 for path, text in texts.items() if path.suffix == ".v")


def test_the_field_draws_and_is_a_choice_everywhere(waves):
    picture = np.asarray(Image.open(waves / "waves.png"))
    assert picture.shape == (128, 128, 3)
    run(waves, "python -m renderer image --field rings --size 128 --out rings.png")
    assert (picture != np.asarray(Image.open(waves / "rings.png"))).any(axis=2).mean() > 0.1
    script = run(waves, "python -c 'from book.simulator_module import source; print(source())'")
    assert '"waves":{"ways":' in script
    assert "'waves'" in run(waves, "python -m renderer image --field foo --out x.png", status=2)


def test_the_light_model_draws_the_same_bits_by_both_machines(lit):
    assert [run(lit, f"python -c '{DRAW}' {name}").strip() for name in ("llvm", "numpy")] == ["llvm", "numpy"]
    by_llvm, by_numpy = (np.load(lit / f"{name}.npy") for name in ("llvm", "numpy"))
    assert np.array_equal(by_llvm.view(np.int64), by_numpy.view(np.int64))
    assert np.array_equal(np.asarray(Image.open(lit / "rough.png")), to_bytes(by_llvm))
    assert np.abs(by_llvm - render(Scene(model="phong"), 128, 128).rgb).max() > 0.05


def test_the_light_model_is_oren_and_nayars(lit):
    numbers, roughened, error = run(lit, f"python -c '{COMPARE.format(sigma=0.5)}'").split()
    assert int(numbers) > 500 and int(roughened) > 50
    assert float(error) < 1e-12
    assert float(run(lit, f"python -c '{COMPARE.format(sigma=0.4)}'").split()[2]) > 0.01
