"""Whole frames that are timed: every renderer, ours of sizes from 64² on, one thread and two, and steps of a sweep.

A case's name is renderer_side_threads. No frame is kept: two of 8192² at once would not fit everywhere.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import cycle, product
from unittest.mock import patch

from renderer import Scene, central, exact, render, stage_of
from renderer.machines import numpy_rows
from renderer.picture import stage as picture
from renderer.picture.frame import Frame
from renderer.scene.methods import GradientMethod
from verify.benchmark.baselines.seed_loops import seed_loops
from verify.benchmark.timing import Case
from verify.evidence.sources import ROOT

SCENE = Scene()
A_ALONE = Scene(ball=False, floor=False)
EPS = 1e-3
THREADS = (1, 2)
METHODS = {"algebraic": exact("algebraic"), "central": central(EPS)}
FITTED = (256, 512, 1024, 2048, 4096, 8192)
PIXELS_A_VISIT = 2**23
STEP = 1024


def calls(side: int) -> int:
    """Return how many frames of that side a visit times: two at least, so that one before them touches the memory."""
    return max(2, min(40, PIXELS_A_VISIT // side**2))


def on_numpy(scene: Scene, width: int, height: int, threads: int) -> Frame:
    """Return a frame as NumPy draws it, where there is no LLVM."""
    with patch.object(picture, "machine", lambda: numpy_rows):
        return render(scene, width, height, threads=threads)


def frame_cases(largest: int) -> list[Case]:
    """Return every case of a whole frame, from nothing, up to a side of `largest`; the slow ones get fewer visits."""
    cases = [Case(f"numpy_{STEP}_2", partial(on_numpy, SCENE, STEP, STEP, 2), 1, 5)]
    for side, (name, eps) in product((128, 256), {"exact": None, "central": EPS}.items()):
        cases.append(Case(f"seed_{name}_{side}_1", partial(seed_loops, SCENE, side, side, eps), 1, 3))
    sizes = [("algebraic", *size) for size in product((64, *FITTED), THREADS) if size[0] <= largest]
    for name, side, threads in (("central", STEP, 2), *sizes):
        draw = partial(render, SCENE, side, side, METHODS[name], threads=threads)
        cases.append(Case(f"{name}_{side}_{threads}", draw, calls(side)))
    return cases


def stepping(scene: Scene, frames: Sequence[tuple[Scene, GradientMethod]], threads: int) -> Callable[[], None]:
    """Return a function that draws the next of `frames`, (scene, method), over the one before, its chambers given."""
    stage = stage_of(scene, STEP, STEP, threads=threads)
    frame = render(scene, STEP, STEP, threads=threads, stage=stage)
    following = cycle(frames)

    def step():
        nonlocal frame
        changed, method = next(following)
        frame = render(changed, STEP, STEP, method, threads=threads, stage=stage, into=frame)

    for _ in frames:  # whatever is to be compiled, is
        step()
    return step


def step_cases() -> list[Case]:
    """Return the cases with given chambers: steps of ε and β, and sphere A alone on one thread."""
    sequences = {
        f"eps_step_exact_{STEP}_2": [(SCENE, exact())],
        f"eps_step_central_{STEP}_2": [(SCENE, central(10.0**-n)) for n in range(2, 7)],
        f"beta_step_{STEP}_2": [(replace(SCENE, beta=beta), exact()) for beta in (0.1, 0.2, 0.35, 0.5)],
        **{f"a_alone_{name}_{STEP}_1": [(A_ALONE, method)] for name, method in METHODS.items()},
    }
    return [Case(n, stepping(f[0][0], f, int(n[-1])), calls(STEP)) for n, f in sequences.items()]


START = {
    "start_two_pictures": """
from renderer import Scene, central, exact, render
numeric = render(Scene(), 256, 256, gradient=central(eps=1e-3))
symbolic = render(Scene(), 256, 256, gradient=exact())
difference = numeric.rgb - symbolic.rgb
""",  # README's
    "start_one_picture": "from renderer import Scene, render; render(Scene(), 256, 256)",
    "start_image_2048": """
import sys
from renderer.command_line.verbs import main
main(["image", "--size", "2048", "--out", f"{sys.argv[1]}/a.png"])
""",
}
"""{case: what a fresh interpreter runs, its imports and LLVM's compiling included; it is given a folder}"""


def _from_nothing(program):
    with tempfile.TemporaryDirectory() as folder:
        command, settings = [sys.executable, "-c", program, folder], os.environ | {"SYMBOLIC_RENDERING_CODE": "off"}
        subprocess.run(command, cwd=ROOT, env=settings, capture_output=True, check=True)


def start_cases() -> list[Case]:
    """Return the cases of a fresh interpreter."""
    return [Case(name, partial(_from_nothing, program), 1, 3, "s") for name, program in START.items()]
