"""The strict reference: the whole pixel's program at every pixel, in float64, with nothing skipped and nothing cached.

It is the program of `proofs.formulas.pixel`, printed as the kernels are, one line after another: what the renderer's
boxes, forms and shortcuts have to reproduce.
"""

from functools import cache

import numpy as np

from proofs.formulas.camera import surface
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import dark_square, occlusion, pixel, rgb
from renderer import Light, Scene, render, stage_of
from renderer.scene.methods import GradientMethod
from verify.evaluate.arrays import in_float64
from verify.reference import chamber_code, lights_on, scene_values


@cache
def _program(field, model, lights, outputs):
    return pixel(HEIGHT_FIELDS[field], model, lights).keep(*outputs)


def _run(scene, width, height, *outputs):
    """Return {output: at every pixel, (height, width)}."""
    program = _program(scene.field, scene.model, len(lights_on(scene)), outputs)
    place = {"column": np.arange(width), "row": np.arange(height)[:, None]}
    return in_float64(program, scene_values(scene, width=width, height=height, **place))


def strict_rgb(scene: Scene, width: int, height: int) -> np.ndarray:
    """Return the picture by the exact gradient in its general form, (height, width, 3)."""
    return np.stack([*_run(scene, width, height, *rgb).values()], axis=-1)


def strict_chambers(scene: Scene, width: int, height: int) -> np.ndarray:
    """Return the chamber codes, (height, width) uint8."""
    occlusions = map(occlusion, range(len(lights_on(scene))))
    lines = _run(scene, width, height, surface, dark_square, *occlusions)
    return chamber_code(scene, lambda name: lines[name].astype(np.uint8))


def random_scene(random: np.random.Generator) -> Scene:
    """Return a scene of scales far apart: B may contain, cut, touch or miss everything, lights may be low or below."""
    while True:
        radius = 10.0 ** random.uniform(-2, 2)
        center = tuple(random.normal(size=3) * radius * 10.0 ** random.uniform(-1, 1, 3))
        positions = random.normal(size=(random.integers(0, 6), 3)) * radius * 10.0 ** random.uniform(-0.5, 2, 3)
        try:
            return Scene(
                radius=radius,
                eye=radius * 10.0 ** random.uniform(0.01, 2),
                ball=bool(random.uniform() < 0.9),
                floor=bool(random.uniform() < 0.9),
                ball_radius=radius * 10.0 ** random.uniform(-2, 1),
                ball_center=center,
                lights=tuple(Light(tuple(p), None if random.uniform() < 0.1 else (1, 1, 1)) for p in positions),
            )
        except ValueError:
            continue  # B around the eye, or a light inside a body


def random_raster(random: np.random.Generator) -> tuple[int, int, tuple[int, int, int, int] | None]:
    """Return (width, height, crop): odd and even sizes, one in three cropped."""
    width, height = (int(n) for n in random.integers(1, 90, 2))
    if random.uniform() < 2 / 3:
        return width, height, None
    left, top = int(random.integers(0, width)), int(random.integers(0, height))
    wide, high = (int(random.integers(1, n + 1)) for n in (width - left, height - top))
    return width, height, (left, top, wide, high)


def differing_pixels(scene: Scene, width: int, height: int, crop: tuple[int, int, int, int] | None = None) -> int:
    """Return how many pixels' codes differ between the renderer and the strict reference."""
    left, top, wide, high = crop or (0, 0, width, height)
    strict = strict_chambers(scene, width, height)[top : top + high, left : left + wide]
    return int(np.count_nonzero(stage_of(scene, width, height, crop, threads=1).chambers != strict))


def image_error(scene: Scene, side: int, method: GradientMethod) -> float:
    """Return the largest difference of a channel of a square picture from the strict one."""
    return float(np.abs(render(scene, side, side, method).rgb - strict_rgb(scene, side, side)).max())
