"""`render`, the way from a scene to a picture: everything from nothing, or sphere A alone on a stage."""

import numpy as np

from renderer.checks import check_truth, not_allowed
from renderer.picture.frame import Frame
from renderer.picture.stage import Stage
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Crop, Raster
from renderer.scene.scene import Scene
from renderer.shader.numbers import EXACT, Shot
from renderer.shader.shader import BOUNDS, COLORS, WORK
from renderer.threads import checked_threads


def stage_of(scene: Scene, width: int, height: int, crop: Crop | None = None, threads: int | None = None) -> Stage:
    """Return the Stage of a scene on a raster: give it to `render` to draw sphere A alone, again and again.

    Raises ValueError that names what is not allowed.

    >>> from renderer import Scene, render, stage_of
    >>> stage = stage_of(Scene(), 16, 16)
    >>> flat, bumped = (render(Scene(beta=beta), 16, 16, stage=stage) for beta in (0.0, 0.35))
    >>> bool((flat.rgb == bumped.rgb)[~stage.on_a].all()), int(stage.on_a.sum())
    (True, 115)
    """
    shot = Shot(scene, raster=Raster(width, height, crop))
    stage = Stage(shot)
    stage.draw(shot, checked_threads(threads), {}, colors=False)
    return stage


def render(
    scene: Scene,
    width: int,
    height: int,
    gradient: GradientMethod | None = None,
    crop: Crop | None = None,
    threads: int | None = None,
    stage: Stage | None = None,
    into: Frame | None = None,
    bounds: bool = False,
) -> Frame:
    """Draw `scene` on a raster of width × height pixels and return the Frame.

    gradient: a method from `exact`, `central`, `forward`, `central4` (default: exact). crop: (left, top, width,
    height), the part of the raster to draw. threads: default, all cores. stage: the Stage of a scene that differs at
    most in field, ku, kv, beta and shading, on the same raster: A alone is drawn, the rest is copied from the stage.
    into: an earlier Frame of that stage, of the same shading: A is drawn over its colours, and nothing is copied; the
    earlier frame has no colours any more. bounds: whether `Frame.bounds` and `Frame.open` are wanted: the same picture,
    drawn whole. Raises ValueError that names what is not allowed.

    >>> from renderer import Scene, central, render
    >>> symbolic, numeric = (render(Scene(), 16, 16, method) for method in (None, central(1e-3)))
    >>> symbolic.rgb.shape, symbolic.chambers.dtype
    ((16, 16, 3), dtype('uint8'))
    >>> bool((symbolic.chambers == numeric.chambers).all()), bool((symbolic.rgb == numeric.rgb).all())
    (True, False)
    """
    shot = Shot(scene, EXACT if gradient is None else gradient, Raster(width, height, crop))
    bounds, threads = check_truth("bounds", bounds), checked_threads(threads)
    if stage is not None and not (isinstance(stage, Stage) and stage.serves(shot)):
        raise not_allowed("stage", stage, "one made for the same lengths, lights and raster")
    fits = isinstance(into, Frame) and stage is into.stage and shot.shading == into.shot.shading
    if into is not None and not fits:
        raise not_allowed("into", into, "a frame of the stage that is given, shaded as this scene is")
    complete = bounds or stage is None
    stage = Stage(shot) if stage is None else stage
    planes = stage.new_plane(channels=3) if into is None else into.hand_over()
    named, enclosure = dict(zip(COLORS, planes, strict=True)), None
    if bounds:
        enclosure = stage.new_plane(channels=3), stage.new_plane(np.uint8)
        named |= dict(zip((*BOUNDS, "open"), (*enclosure[0], enclosure[1]), strict=True))
    if complete:
        counts = stage.draw(shot, threads, named, bounds=bounds)
    else:
        counts = _draw_on(stage, shot, threads, named, None if into else planes)
    return Frame(shot, stage, planes, dict(zip(WORK, counts.tolist(), strict=True)), enclosure)


def _draw_on(stage, shot, threads, named, fresh):
    """Draw sphere A, and into planes that are fresh copy the rest from the stage first; return the counts."""
    copy, counts = None, 0
    if fresh is not None:
        rest, counts = stage.elsewhere(shot, threads)

        def copy(rows):
            fresh[:, rows] = rest[:, rows]

    return counts + stage.draw(shot, threads, named, copy, chambers_known=True, surfaces="a")
