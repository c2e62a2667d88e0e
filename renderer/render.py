"""Draw a scene, band by band: the chambers, sphere A with its gradient, and everything else."""

import numpy as np

from renderer.frame import Frame
from renderer.material import material_of
from renderer.methods import GradientMethod, exact
from renderer.raster import Raster
from renderer.scene import Scene
from renderer.shading import WORK, copy_runs, shade_elsewhere
from renderer.sphere_a import bump_of
from renderer.stage import Stage
from renderer.threads import checked_threads, run_bands
from renderer.work import work_done


def stage_of(scene, width, height, crop=None, threads=None):
    """Return the Stage of a scene on a raster: give it to `render` to draw sphere A alone, again and again."""
    stage = Stage(scene, Raster(width, height, crop))
    run_bands(stage.fill, len(stage.bands), checked_threads(threads))
    return stage


def render(scene, width, height, gradient=None, crop=None, threads=None, stage=None, into=None, count=False):
    """Draw `scene` on a raster of width × height pixels and return the Frame.

    gradient: a method from `exact`, `central`, `forward`, `central4` (default: exact). crop: (left, top, width,
    height), the part of the raster to draw. threads: default, all cores. stage: the Stage of a scene that differs at
    most in field, ku, kv, beta and shading, on the same raster: A alone is drawn, the rest is copied from the stage.
    into: an earlier Frame of that stage, of the same shading: A is drawn over its colours, and nothing is copied; the
    earlier frame has no colours any more.
    count: add up the frame's `work` now; else that waits until it is asked for. Raises ValueError that names what is
    not allowed.
    """
    method = gradient if gradient is not None else exact()
    if not isinstance(scene, Scene):
        raise ValueError(f"scene = {scene!r} is not allowed: a Scene")
    if not isinstance(method, GradientMethod):
        raise ValueError(f"gradient = {method!r} is not allowed: exact(), central(eps), forward(eps) or central4(eps)")
    raster, threads = Raster(width, height, crop), checked_threads(threads)
    bump = bump_of(scene, method, flat=scene.beta == 0.0)
    if stage is not None and not stage.serves(scene, raster):
        raise ValueError(f"stage = {stage!r} is not allowed: one made for the same lengths, lights and raster")
    if into is not None and not (isinstance(into, Frame) and stage is into.stage and into.shaded_as(scene)):
        raise ValueError(f"into = {into!r} is not allowed: a frame of the stage that is given, shaded as this scene is")
    rgb, counts = np.empty((3, *raster.shape)) if into is None else into.give_away(), None
    if stage is None:
        stage, counts = _draw_all(scene, bump, raster, rgb, threads)
        tests = stage.shadow_tests
    else:
        counts, tests = _draw_on(stage, scene, bump, rgb, threads, rest=into is None), 0
    frame = Frame(scene, raster, method, stage, rgb, lambda: work_done(stage, bump, counts, tests))
    if count:
        _ = frame.work
    return frame


def _draw_all(scene, bump, raster, rgb, threads):
    """Draw everything, each band's chambers first; return the Stage and the counts."""
    stage, material = Stage(scene, raster), material_of(scene)
    counts = np.zeros((len(stage.bands), len(WORK)), np.int64)

    def draw(number):
        band = stage.fill(number)
        bump.draw(stage, band, counts[number], rgb)
        shade_elsewhere(band.runs_elsewhere, *stage.place(band), *material, rgb, counts[number], stage.chambers)

    run_bands(draw, len(stage.bands), threads)
    return stage, counts


def _draw_on(stage, scene, bump, rgb, threads, rest):
    """Draw sphere A, and if the rest is not there, copy it from the stage; return the counts."""
    counts = np.zeros((len(stage.bands), len(WORK)), np.int64)
    elsewhere = stage.elsewhere(scene, threads, counts) if rest else None

    def draw(number):
        band = stage.bands[number]
        bump.draw(stage, band, counts[number], rgb)
        if rest:
            copy_runs(band.runs_elsewhere, band.top, elsewhere, rgb)

    run_bands(draw, len(stage.bands), threads)
    return counts
