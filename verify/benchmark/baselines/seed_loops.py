"""The seed chapter's own programs: its eight cells, with the one line mended that draws another scene.

The line is the constant of B's quadratic (finding F1), printed in both cells.
"""

import math
from functools import cache
from types import SimpleNamespace

import numpy as np

from renderer import Scene
from verify.evidence.sources import ROOT

SEED = ROOT / "book" / "ledger" / "seed.txt"
RUN, DRAWS = "paste into colab.new → Run\n", "\nt0 = "  # before a program, and where it begins to draw
PRINTED = "cB = float(Cb @ Cb) - R2*R2"
NAMES = {
    "R": "radius", "e": "eye", "Cb": "ball_center", "R2": "ball_radius", "b_on": "ball", "floor_on": "floor",
    "ambient": "ambient", "matA": "albedo_a", "matB": "albedo_b", "ka": "ka", "kd": "kd", "ks": "ks",
    "shin": "shininess", "model": "model", "alpha": "floor_tint", "hf": "field", "ku": "ku", "kv": "kv", "beta": "beta",
}  # fmt: skip
"""{the seed's name: the scene's}"""
MENDED = f"oc = np.array([0., 0., e]) - Cb; cB = float(oc @ oc) - R2*R2  # as printed: {PRINTED}"


def seed_cells(quadratic: str = MENDED) -> list[str]:
    """Return the programs of Cells 1 to 8; quadratic: the line in the place of PRINTED."""
    text = SEED.read_text(encoding="utf-8").replace(PRINTED, quadratic)
    return [cell.partition("\nExpect: ")[0] for cell in text.split(RUN)[1:]]


@cache
def seed_program(quadratic: str = MENDED) -> SimpleNamespace:
    """Return the functions of Cells 1 and 3; quadratic: as in `seed_cells`."""
    cells = seed_cells(quadratic)
    names = {"np": np, "math": math}
    for cell in (cells[0], cells[2]):
        program = cell.partition(DRAWS)[0]
        exec("\n".join(line for line in program.splitlines() if not line.startswith("import ")), names)
    return SimpleNamespace(**names)


def seed_scene(scene: Scene, eps: float = 1e-3) -> dict:
    """Return a scene as the seed's cells take it."""
    lights = [(light.position, light.color) for light in scene.lights]
    named = {theirs: getattr(scene, ours) for theirs, ours in NAMES.items()}
    return named | {"lights": lights, "eps": eps}


def seed_loops(
    scene: Scene, width: int, height: int, eps: float | None = None, quadratic: str = MENDED
) -> tuple[np.ndarray, ...]:
    """Return (rgb in [0, 1], surface, kink, |h_u| + |h_v|), (height, width) each: the exact pipeline, or of step eps.

    On a raster that is not square the seed's pixels are not square either.
    """
    program = seed_program(quadratic)
    draw = program.render_symbolic_bump if eps is None else program.render_numeric_bump
    return draw(width, height, seed_scene(scene, eps or 1e-3))
