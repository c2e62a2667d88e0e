"""Measure a field of one's own, from its formula to its picture, and a picture from the frame to its file:

    python -m verify.benchmark.own                       (a minute, on a machine that does nothing else)

The first picture of a field that no process has drawn: its kernels printed, compiled and run; then a second one. A PNG
of 2048², from the frame to the closed file, in times of the drawing; and of the same with noise. Compiled code is not
kept. Writes verify/benchmark/results/own.json: commit it.
"""

import itertools
import os
import tempfile
from functools import partial
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from renderer import Scene, render
from renderer.files.pictures import png_of
from renderer.files.srgb import to_bytes
from renderer.machines.kept_code import VARIABLE
from renderer.picture.frame import Frame
from verify.benchmark.timing import Case, numbers_by_rounds
from verify.records import command

SCENE, SIDE, SMALL, ROUNDS = Scene(), 2048, 256, 7
NOISE = 0.05  # of linear light
RATIOS = {"png_to_drawing": ("png", "drawing"), "noisy_png_to_drawing": ("noisy_png", "drawing")}
_numbers = itertools.count(1)


def _own_scene(number: int) -> Scene:
    field = {"name": f"measured_{number}", "expression": f"v*(1 + sinpi(k_u*u + {number}/100*sinpi(2*v)))**2/2"}
    return Scene.from_record({"field": field})


def _noisy(frame: Frame) -> Frame:
    """Return the frame with noise of NOISE over its colours."""
    planes = np.random.default_rng(28).normal(frame.planes, NOISE).clip(0, 1)
    return Frame(frame.scene, frame.method, frame.stage, planes, {})


def cases(rounds: int, folder: Path) -> list[Case]:
    """Return the cases; files are written to a folder, each a new one."""
    frame, known = render(SCENE, SIDE, SIDE), _own_scene(0)
    noisy, picture = _noisy(frame), to_bytes(frame.rgb)
    works = {
        "first_picture": (lambda: render(_own_scene(next(_numbers)), SMALL, SMALL), 1),
        "second_picture": (lambda: render(known, SMALL, SMALL), 8),
        "drawing": (lambda: render(SCENE, SIDE, SIDE), 3),
        "png": (lambda: frame.save(folder / f"{next(_numbers)}.png"), 3),
        "noisy_png": (lambda: noisy.save(folder / f"{next(_numbers)}.png"), 3),
        "conversion": (lambda: to_bytes(frame.rgb), 3),
        "encoding": (lambda: png_of(picture), 3),
    }
    return [Case(name, work, repeats, rounds) for name, (work, repeats) in works.items()]


def measure(rounds: int) -> dict[str, Any]:
    """Return the milliseconds of each case, and their ratios."""
    with mock.patch.dict(os.environ, {VARIABLE: "off"}), tempfile.TemporaryDirectory() as folder:
        return {"numbers": numbers_by_rounds(cases(rounds, Path(folder)), "own", RATIOS) | {"side": SIDE}}


main = partial(command, "own", __doc__, measure, rounds=ROUNDS)

if __name__ == "__main__":
    main()
