"""NumPy draws what the compiled kernels draw, to the last bit; and which of the two a command is given."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from renderer import Light, Scene, back_end, central, central4, exact, forward, render, stage_of

ROOT = Path(__file__).resolve().parent.parent
SCENES = {
    "ridges": (Scene(), exact()),
    "general": (Scene(field="rings"), exact("general")),
    "central": (Scene(field="sine"), central(1e-3)),
    "forward": (Scene(ku=7.0, kv=3.5), forward(1e-2)),
    "central4": (Scene(field="rings"), central4(1e-2)),
    "phong": (Scene(model="phong", ku=6.0, kv=3.0), exact()),
    "odd": (Scene(shininess=7.0), exact()),
    "dull": (Scene(ks=0.0, field="sine"), exact()),
    "flat": (Scene(beta=0.0), exact()),
    "no_ball": (Scene(ball=False), exact()),
    "no_floor": (Scene(floor=False), central(1e-2)),
    "fractional": (Scene(shininess=7.5), exact()),
    "fractional_phong": (Scene(shininess=0.7, model="phong"), central(1e-2)),
    "five_lights": (Scene(lights=tuple(Light((3.0 * n - 6, 4, 9), (0.3, 0.4, 0.2)) for n in range(5))), exact()),
    "dark": (Scene(lights=()), exact()),
    "one_black": (Scene(lights=(Light((5, 5, 10), (0, 0, 0)), Light((-6, 2, 8)))), exact()),
}
DRAW = """\
import sys
sys.modules["numba"] = None
import numpy as np
from renderer import *
from tests.test_arrays import SCENES, drawn
np.savez(sys.argv[1], **drawn())
"""


def drawn():
    """Return {name: array} of what the scenes' frames hold, and of one drawn from a stage."""
    found = {}
    for name, (scene, method) in SCENES.items():
        frame = render(scene, 96, 64, method)
        found |= {f"{name}.rgb": frame.rgb, f"{name}.chambers": frame.chambers, f"{name}.planes": frame.planes_on_a}
        found[f"{name}.work"] = np.array([count for kind, count in sorted(frame.work.items()) if kind != "pixels"])
    staged = render(Scene(beta=0.1), 96, 64, central(1e-2), stage=stage_of(Scene(), 96, 64))
    return found | {"staged": staged.rgb}


def process(*arguments, **environment):
    """Run Python in the project's folder, with more in its environment."""
    return subprocess.run(
        [sys.executable, *map(str, arguments)], cwd=ROOT, env=os.environ | environment, capture_output=True, text=True
    )


def test_pictures_by_numpy_are_the_compiled_ones_to_the_last_bit(tmp_path):
    done = process("-W", "error", "-c", DRAW, tmp_path / "drawn.npz", RENDERER_KERNELS="numpy")
    assert (done.returncode, done.stderr) == (0, "")
    by_numpy, compiled = np.load(tmp_path / "drawn.npz"), drawn()
    assert sorted(by_numpy) == sorted(compiled)
    for name, array in compiled.items():
        np.testing.assert_array_equal(by_numpy[name], array, err_msg=name)


@pytest.mark.parametrize(
    ("command", "little"),
    [
        ("-m image --out a.png", True),
        ("-m views --out a --size=1024", True),
        ("-m image --size 1025 --out a.png", False),
        ("-m image --size 1025 --crop 5,5,1025,900 --out a.png", True),
        ("-m image --width 2048 --height 512", True),
        ("-m image --width 8192 --out a.png", False),
        ("-m image --size many", True),
        ("-m image --crop 1,2,x,4", True),
        ("-m sweep --size 16", False),
        ("-m --help", False),
        ("-m", False),
        ("-c image", False),
        ("script.py -m renderer image", False),
        ("", False),
    ],
)
def test_single_small_pictures_are_numpys(command, little):
    assert back_end.draws_little(command.split()) is little


@pytest.mark.parametrize("verb", ["image", "views"])
def test_command_for_a_small_picture_loads_no_compiler_and_draws_the_same(verb, tmp_path):
    files = {}
    for kernels in ("", "numba"):
        out = tmp_path / (f"a{kernels}.png" if verb == "image" else f"a{kernels}")
        choice = {"RENDERER_KERNELS": kernels} if kernels else {}
        done = process("-X", "importtime", "-m", "renderer", verb, "--size", 48, "--out", out, **choice)
        assert done.returncode == 0
        assert ("| numba\n" in done.stderr.replace("  ", "")) is bool(kernels)
        files[kernels] = [path.read_bytes() for path in sorted([out] if out.is_file() else out.iterdir())]
    assert files[""] == files["numba"]


def test_unknown_kernels_are_refused():
    done = process("-c", "import renderer", RENDERER_KERNELS="fortran")
    assert "ValueError: RENDERER_KERNELS = 'fortran' is not allowed: numba or numpy" in done.stderr
