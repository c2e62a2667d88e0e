"""The worked theorem and the light model of CONTRIBUTING.md, followed to the letter in a copy of the tree."""

import re

import numpy as np
import pytest
from PIL import Image

from renderer import Scene, render
from renderer.picture.views import to_bytes
from tests.test_newcomer import FENCE, commands, copied, run, section


def blocks(text):
    """Return the blocks of Python in a section."""
    return [fence[2] for fence in FENCE.finditer(text) if fence[1] == "python"]


SECTION = section("A theorem")
(EXAMPLE,) = blocks(SECTION)
LIGHT = section("A light model in one sitting")
MODEL, ENTRY, CLAIM = blocks(LIGHT)
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


def test_the_example_is_proved(tmp_path):
    copied(tmp_path)
    (tmp_path / "proofs" / "theorems" / "worked_example.py").write_text(EXAMPLE, encoding="utf-8")
    id = re.search(r'id="(\w+)"', EXAMPLE)[1]
    assert run(tmp_path, "python", "-m", "proofs.engine.certificate", id).startswith(f"{id}: ")
    examined = run(tmp_path, "pytest", "verify", "--theorem", id, "-q")
    assert re.search(rf"{id} +proved .* mutants 2/2", examined)
    script = run(tmp_path, "python", "-m", "proofs.engine.standalone", id)
    (tmp_path / "theorem.py").write_text(script, encoding="utf-8")
    proved = run(tmp_path, "python", "-I", "-S", "-X", "utf8", "theorem.py")
    assert f"{id}: PROVED, given unit_length/length." in proved


def test_the_example_is_short():
    assert len(EXAMPLE.splitlines()) <= 25
    assert all(id in EXAMPLE for id in re.findall(r"python -m proofs\.engine\.certificate (\w+)", SECTION))


@pytest.fixture(scope="module")
def lit(tmp_path_factory):
    """The folder in which the light model was added, and what each command of the section printed."""
    folder = tmp_path_factory.mktemp("light")
    copied(folder)
    shading = folder / "proofs" / "formulas" / "shading.py"
    text = shading.read_text(encoding="utf-8")
    for mark, block in (("@dataclass(frozen=True)\nclass LightModel:", f"{MODEL}\n\n"), (")}  # fmt: skip\n", ENTRY)):
        assert text.count(mark) == 1
        text = text.replace(mark, block + mark)
    shading.write_text(text, encoding="utf-8")
    (folder / "proofs" / "theorems" / "oren_nayar.py").write_text(CLAIM, encoding="utf-8")
    return folder, {words[2] if words[0] == "python" else words[0]: run(folder, *words) for words in commands(LIGHT)}


def test_the_light_model_is_short():
    assert len((MODEL + ENTRY).splitlines()) < 30
    assert len(CLAIM.splitlines()) <= 25


def test_the_claim_about_the_light_model_is_proved(lit):
    _, printed = lit
    assert printed["proofs.engine.certificate"].startswith("smooth_is_lambert: 1 statements")
    assert re.search(r"smooth_is_lambert +proved .* mutants 2/2", printed["pytest"])


def test_the_light_model_draws_the_same_bits_by_both_machines(lit):
    folder, _ = lit
    assert [run(folder, "python", "-c", DRAW, name).strip() for name in ("llvm", "numpy")] == ["llvm", "numpy"]
    by_llvm, by_numpy = (np.load(folder / f"{name}.npy") for name in ("llvm", "numpy"))
    assert np.array_equal(by_llvm.view(np.int64), by_numpy.view(np.int64))
    assert np.array_equal(np.asarray(Image.open(folder / "rough.png")), to_bytes(by_llvm))
    assert np.abs(by_llvm - render(Scene(model="phong"), 128, 128).rgb).max() > 0.05


def test_the_light_model_is_oren_and_nayars(lit):
    folder, _ = lit
    numbers, roughened, error = run(folder, "python", "-c", COMPARE.format(sigma=0.5)).split()
    assert int(numbers) > 500 and int(roughened) > 50
    assert float(error) < 1e-12
    assert float(run(folder, "python", "-c", COMPARE.format(sigma=0.4)).split()[2]) > 0.01
