"""A picture's float64 pixels against balls of the same program: random pixels, and the places that are hard.

Truth is the pixel's program in balls of 256 bits, whose radius is below 1e-50; what rounding may do to it is the bound
that the frame has of it. A pixel whose chamber or side of a crease is open there is counted apart.
"""

from collections.abc import Iterable
from copy import copy
from dataclasses import replace
from itertools import cycle, product
from typing import NamedTuple

import numpy as np
from flint import arb, ctx

from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.shading import LIGHT_MODELS
from renderer import Scene, render
from renderer.picture.frame import Frame
from verify.reference import COLORS, chamber_code, lines_of

SIZE, EACH, SEED, BITS = 255, 46, 5, 256  # an odd size: a column of pixels lies on x = 0, on a crease
WIDEST = 1e-40
SCENES = [Scene(field=field, model=model) for field, model in product(HEIGHT_FIELDS, LIGHT_MODELS)]
SHININESSES = [
    Scene(model=model, shininess=p) for p, model in zip((0.5, 7.3, 1000.0, 1e6), cycle(LIGHT_MODELS), strict=False)
]


class Checked(NamedTuple):
    """One pixel. error, bound: the largest of its channels; undecided: by the frame's bounds, or by the balls."""

    error: float
    bound: float
    undecided: bool
    same_chamber: bool


def _edges(codes):
    """Return where a code differs from that of the pixel to the right, to the left, above or below."""
    around = np.lib.stride_tricks.sliding_window_view(np.pad(codes, 1, "edge"), (3, 3))
    return (around[..., (0, 2, 1, 1), (1, 1, 0, 2)] != codes[..., None]).any(axis=-1)


def _kinds(frame):
    """Yield a plane for each kind of pixels, in which they have the smallest numbers."""
    scene = frame.scene
    surface, shadows = frame.chambers & 3, frame.chambers >> 2 & 31
    u, v = frame.surface_data["u"], frame.surface_data["v"]
    waves = [w - np.rint(w) for w in (scene.ku * u, scene.kv * v)]
    flat = copy(frame)
    flat.shot = replace(flat.shot, scene=replace(scene, beta=0.0))  # cosines there without the bump

    def least_cosine(frame):
        return np.min([np.abs(frame.light_cosines(number)) for number in range(len(scene.lights))], axis=0)

    yield np.zeros(surface.shape)  # at random
    yield np.where(_edges(surface), 0.0, np.inf)  # on the silhouette
    yield np.where(_edges(shadows) & ~_edges(surface), 0.0, np.inf)  # at a shadow's edge
    yield v  # next to the pole,
    yield np.minimum(u, 1 - u)  # to the seam,
    yield np.minimum(*np.abs(waves))  # to a crease
    yield least_cosine(frame)  # on the terminator
    yield least_cosine(flat)  # where light grazes


def chosen(frame: Frame, each: int = EACH) -> list[tuple[int, int]]:
    """Return [(column, row)]: `each` pixels of every kind; among equals at random."""
    rng = np.random.default_rng(SEED)
    pixels: list[tuple[int, int]] = []
    for plane in _kinds(frame):
        order = np.lexsort((rng.random(plane.size), plane.ravel()))[:each]
        rows, columns = np.unravel_index(order[np.isfinite(plane.ravel()[order])], plane.shape)
        pixels += zip(columns.tolist(), rows.tolist(), strict=True)
    return pixels


def truth_of(frame: Frame, column: int, row: int, bits: int = BITS, **others: arb) -> dict[str, arb]:
    """Return the balls of every line of a frame's pixel; others: what stands in place of the scene's numbers."""
    scene, raster, method = frame.scene, frame.raster, frame.method
    left, top, *_ = raster.crop  # type: ignore[misc]  # checked when it was made
    place = {"column": left + column, "row": top + row, "width": raster.width, "height": raster.height}
    return lines_of(scene, method.name, bits, **place, epsilon=method.eps or 0.0, **others)


def compared(frame: Frame, column: int, row: int) -> tuple[dict[str, arb], list[arb], bool]:
    """Return (the truth of a pixel, how far each channel is from it, whether the chamber is the true one)."""
    truth = truth_of(frame, column, row)
    with ctx.workprec(BITS):
        errors = [abs(arb(c) - truth[name]) for c, name in zip(frame.rgb[row, column], COLORS, strict=True)]
    code = chamber_code(frame.scene, lambda name: int(truth[name].unique_fmpz() or 0))
    return truth, errors, bool(code == frame.chambers[row, column])


def checked_pixel(frame: Frame, column: int, row: int) -> Checked:
    """Return a pixel of a frame with bounds, Checked."""
    truth, errors, same_chamber = compared(frame, column, row)
    undecided = bool(frame.open[row, column]) or any(float(truth[name].rad()) > WIDEST for name in COLORS)
    error, bound = max(float(error.upper()) for error in errors), frame.bounds[row, column].max()
    return Checked(error, bound, undecided, same_chamber)


def checked_pixels(scenes: Iterable[Scene], each: int = EACH) -> list[Checked]:
    """Return every chosen pixel of the scenes, Checked."""
    frames = (render(scene, SIZE, SIZE, bounds=True) for scene in scenes)
    return [checked_pixel(frame, *place) for frame in frames for place in chosen(frame, each)]
