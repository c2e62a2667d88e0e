"""Draw a scene: the chambers first, then band by band the gradient on sphere A and the light everywhere."""

import numpy as np

from renderer.chambers import FLOOR, SPHERE_A, SPHERE_B, SURFACE_BITS, Stage
from renderer.frame import Frame
from renderer.gradients import fill_angles, fill_gradient, scratch_planes, uses_algebraic_form
from renderer.methods import GradientMethod, exact
from renderer.raster import Raster
from renderer.scene import Scene
from renderer.shading import material_of, shade_runs
from renderer.threads import checked_threads, run_bands


def stage_of(scene, width, height, crop=None, threads=None):
    """Return the Stage of a scene on a raster: give it to `render` to draw the same chambers again."""
    threads = checked_threads(threads)
    return Stage(scene, Raster(width, height, crop), lambda work, count: run_bands(work, count, threads))


def render(scene, width, height, gradient=None, crop=None, threads=None, stage=None):
    """Draw `scene` on a raster of width × height pixels and return the Frame.

    gradient: a method from `exact`, `central`, `forward`, `central4` (default: exact). crop: (left, top, width,
    height), the part of the raster to draw. threads: default, all cores. stage: the Stage of a scene that differs at
    most in field, ku, kv, beta and shading, on the same raster. Raises ValueError that names what is not allowed.
    """
    method = gradient if gradient is not None else exact()
    if not isinstance(scene, Scene):
        raise ValueError(f"scene = {scene!r} is not allowed: a Scene")
    if not isinstance(method, GradientMethod):
        raise ValueError(f"gradient = {method!r} is not allowed: exact(), central(eps), forward(eps) or central4(eps)")
    raster, threads = Raster(width, height, crop), checked_threads(threads)
    algebraic = method.name == "exact" and uses_algebraic_form(scene, method)
    stage = stage or stage_of(scene, width, height, crop, threads)
    if not stage.serves(scene, raster):
        raise ValueError(f"stage = {stage!r} is not allowed: one made for the same lengths, lights and raster")
    rgb, material = np.empty((3, *raster.shape)), material_of(scene)

    def work(number):
        band = stage.bands[number]
        planes = scratch_planes(len(band.y), raster.shape[1])
        fill_angles(stage, band, planes)
        if scene.beta != 0.0:
            fill_gradient(scene, method, band, planes)
        else:
            planes.h_u.fill(0.0)
            planes.h_v.fill(0.0)
        rows = slice(band.top, band.top + len(band.y))
        shade_runs(band.runs, stage.x, band.y, stage.geometry, material, planes, rgb[:, rows])

    run_bands(work, len(stage.bands), threads)
    return Frame(scene, raster, method, stage, rgb, work_done(scene, method, stage, algebraic))


def work_done(scene, method, stage, algebraic):
    """Return how many of each kind were computed: pixels by surface, evaluations, shadow tests, specular powers."""
    counts, codes = stage.pixel_counts, np.arange(256)
    pixels = {s: int(counts[(codes & SURFACE_BITS) == s].sum()) for s in (SPHERE_A, SPHERE_B, FLOOR)}
    on = [1 << (2 + number) for number, light in enumerate(scene.lights) if light.color is not None]
    bodies = {SPHERE_A: int(scene.ball), SPHERE_B: 1, FLOOR: 1 + scene.ball}
    bumped = pixels[SPHERE_A] if scene.beta != 0.0 else 0
    return {
        "pixels_a": pixels[SPHERE_A],
        "pixels_b": pixels[SPHERE_B],
        "pixels_floor": pixels[FLOOR],
        "gradient_evaluations": bumped if method.name == "exact" else 0,
        "algebraic_gradients": bumped if algebraic else 0,
        "height_evaluations": bumped * method.height_evaluations,
        "shadow_tests": len(on) * sum(bodies[s] * pixels[s] for s in bodies),
        "specular_powers": sum(int(counts[(codes & bit == 0) & (codes & SURFACE_BITS > 0)].sum()) for bit in on),
    }
