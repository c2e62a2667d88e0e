"""The strict reference: the whole pixel's program at every pixel, in float64, with nothing skipped and nothing cached.

It is the program of `proofs.formulas.pixel`, printed as the kernels are, one line after another: what the renderer's
boxes, forms and shortcuts have to reproduce.
"""

from functools import cache

import numpy as np

from proofs.formulas.camera import surface
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import dark_square, occlusion, pixel, rgb
from renderer import Light, Scene
from renderer.generate.kernels import function_of
from verify.reference import scene_values


@cache
def _program(field, model, lights, outputs):
    whole = pixel(HEIGHT_FIELDS[field], model, lights)
    program = whole.keep(*outputs(lights))
    return function_of(program), [s.name for s in program.inputs]


def _chamber_outputs(lights):
    return surface, dark_square, *(occlusion(number) for number in range(lights))


def _color_outputs(lights):
    return rgb


def _run(scene, width, height, outputs):
    """Return the outputs at every pixel, (height, width) each."""
    lights = [light for light in scene.lights if light.color is not None]
    function, names = _program(scene.field, scene.model, len(lights), outputs)
    values = scene_values(scene, lights) | {"width": float(width), "height": float(height)}
    values |= {"column": np.arange(width, dtype=np.float64), "row": np.arange(height, dtype=np.float64)[:, None]}
    with np.errstate(all="ignore"):
        results = function(*(values[name] for name in names))
    return [np.broadcast_to(result, (height, width)) for result in results]


def strict_rgb(scene, width, height):
    """Return the picture by the exact gradient in its general form, (height, width, 3)."""
    return np.stack(_run(scene, width, height, _color_outputs), axis=-1)


def strict_chambers(scene, width, height):
    """Return the chamber codes, (height, width) uint8, as `renderer.stage.Stage` defines them."""
    seen, dark, *occluded = _run(scene, width, height, _chamber_outputs)
    codes = seen.astype(np.uint8) | (dark.astype(np.uint8) << 7)
    on = [number for number, light in enumerate(scene.lights) if light.color is not None]
    for number, flag in zip(on, occluded, strict=True):
        codes |= flag.astype(np.uint8) << np.uint8(2 + number)
    return codes


def random_scene(rng):
    """Return (a random accepted scene, width, height): spheres that touch, contain and hide each other or lie behind
    the eye; lights above, beside and below; with and without B and the floor; odd sides too.
    """
    while True:
        eye = float(rng.choice([1.2, 2.0, 4.0, 50.0]))
        try:
            scene = Scene(
                eye=eye,
                ball=bool(rng.random() < 0.9),
                floor=bool(rng.random() < 0.8),
                ball_center=(*rng.uniform(-1.5, 1.5, 2), rng.uniform(-1.5, eye + 1.5)),
                ball_radius=rng.choice([0.05, 0.32, 0.9, 2.0]),
                lights=[Light(rng.uniform(-8, 8, 3)) for _ in range(2)],
            )
        except ValueError:  # B around the eye, a light inside a sphere
            continue
        return scene, int(rng.integers(1, 40)), int(rng.integers(1, 30))
