"""NumPy draws what LLVM draws, in groups of any size, to the last bit; and which of the two a process is given."""

import subprocess
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from renderer import Light, Scene, central, central4, exact, forward, render, stage, stage_of
from renderer.machines import native, numpy_rows

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
MACHINE = """\
import sys
{without}
from renderer import *
from renderer.machines import machine
render(Scene(), 16, 16)
print(machine().NAME)
"""


def drawn(drawer, monkeypatch):
    """Return {name: array} of what the scenes' frames hold, and of one drawn from a stage, by a machine's drawer."""
    monkeypatch.setattr(stage, "machine", lambda: SimpleNamespace(drawer=drawer))
    found = {}
    for name, (scene, method) in SCENES.items():
        frame = render(scene, 96, 64, method)
        found |= {f"{name}.rgb": frame.rgb, f"{name}.chambers": frame.chambers, f"{name}.planes": frame.planes_on_a}
        found[f"{name}.work"] = np.array([count for _, count in sorted(frame.work.items())])
    staged = render(Scene(beta=0.1), 96, 64, central(1e-2), stage=stage_of(Scene(), 96, 64))
    return found | {"staged": staged.rgb}


@pytest.fixture(scope="module")
def by_numpy():
    """What NumPy draws."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        yield drawn(numpy_rows.drawer, monkeypatch)


@pytest.mark.parametrize("lanes", [None, 2, 4, 16])
def test_pictures_by_llvm_are_numpys_to_the_last_bit(lanes, by_numpy, monkeypatch):
    by_llvm = drawn(partial(native.drawer, lanes=lanes), monkeypatch)
    assert by_numpy.keys() == by_llvm.keys()
    for name, array in by_llvm.items():
        np.testing.assert_array_equal(by_numpy[name], array, err_msg=name)


@pytest.mark.parametrize(
    ("without", "name"),
    [
        ("", "llvm"),
        ("sys.modules['llvmlite'] = None", "numpy"),
        ("import llvmlite.binding; del llvmlite.binding.create_pass_builder  # as before 0.44", "numpy"),
    ],
)
def test_numpy_draws_where_llvmlite_is_missing_or_old(without, name):
    command = [sys.executable, "-W", "error", "-c", MACHINE.format(without=without)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == (f"{name}\n", "")
