"""The way from a scene to a picture, `render`: drawn from nothing, A alone on a stage, or as a mean of samples."""

from collections.abc import Iterable
from functools import lru_cache, reduce
from typing import Any

import numpy as np

from renderer.checks import check_truth, not_allowed
from renderer.machines import compiling
from renderer.operations import UNIT
from renderer.picture.frame import Frame
from renderer.picture.stage import Stage
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Crop, Raster
from renderer.scene.scene import MOVE_NO_BOUNDARY, Scene
from renderer.shader.numbers import EXACT, Shot, slope_planes
from renderer.shader.shader import BOUNDS, COLORS, WORK
from renderer.threads import checked_threads, run_bands

BAND_SAMPLES = 2**18  # of which a band takes 6 MB


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


def _shot(scene, gradient, width, height, crop, samples):
    return Shot(scene, EXACT if gradient is None else gradient, Raster(width, height, crop), samples)


_same_shot = lru_cache(maxsize=64, typed=True)(_shot)


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
    derivatives: Iterable[str] = (),
    samples: int = 1,
) -> Frame:
    """Draw `scene` on a raster of width × height pixels and return the Frame.

    gradient: a method from `exact`, `central`, `forward`, `central4` (default: exact). crop: (left, top, width,
    height), the part of the raster to draw. threads: default, all cores. stage: the Stage of a scene that differs at
    most in field, ku, kv, beta and shading, on the same raster: A alone is drawn, the rest is copied from the stage.
    into: an earlier Frame of that stage, of the same shading: A is drawn over its colours, and nothing is copied; the
    earlier frame has no colours any more. bounds: whether `Frame.bounds` and `Frame.open` are wanted: the same picture,
    drawn whole. derivatives: the numbers of the scene by which `Frame.derivatives` are wanted, by the names that its
    record has, such as "beta", "albedo_a[0]", "lights[1].position[2]": the same picture, by ku and kv that of
    `exact("general")`; on a stage A alone is drawn if none but ku, kv and beta are wanted. samples: each way across
    a pixel, up to 16: colours, bounds and derivatives are means over samples² points, in linear light; chambers and the
    data of A stay those of the pixel's middle. Raises ValueError that names what is not allowed.

    >>> from renderer import Scene, central, render
    >>> symbolic, numeric = (render(Scene(), 16, 16, method) for method in (None, central(1e-3)))
    >>> symbolic.rgb.shape, symbolic.chambers.dtype
    ((16, 16, 3), dtype('uint8'))
    >>> bool((symbolic.chambers == numeric.chambers).all()), bool((symbolic.rgb == numeric.rgb).all())
    (True, False)
    >>> smooth, fine = render(Scene(), 16, 16, samples=2), render(Scene(), 32, 32)
    >>> bool(abs(smooth.rgb - fine.rgb.reshape(16, 2, 16, 2, 3).mean(axis=(1, 3))).max() < 1e-15)
    True
    """
    described = scene, gradient, width, height, crop, samples
    try:
        shot = (_shot if crop else _same_shot)(*described)
    except TypeError:  # something that has no hash
        shot = _shot(*described)
    if shot.scene is not scene:  # an equal one, which may have 0.0 where this has -0.0
        shot = _shot(*described)
    by, bounds, threads = (), check_truth("bounds", bounds), checked_threads(threads)
    changes: dict[str, Any] = {"bounds": True} if bounds else {}
    if not isinstance(derivatives, tuple) or derivatives:
        with compiling:
            from renderer.shader.slopes import asked  # what most pictures never need to import

        shot, slopes = asked(shot, derivatives)
        by, changes = slopes["by"], changes | slopes
    if shot.samples > 1:
        if stage is not None or into is not None:
            raise not_allowed("samples", samples, "1 beside a stage or an earlier frame")
        return _sampled(shot, by, bounds, threads)
    if stage is not None and not (isinstance(stage, Stage) and stage.serves(shot)):
        raise not_allowed("stage", stage, "one made for the same lengths, lights and raster")
    if into is not None and not (
        isinstance(into, Frame)
        and stage is into.stage
        and (shot.shading, shot.samples) == (into.shot.shading, into.shot.samples)
    ):
        raise not_allowed("into", into, "a frame of the stage that is given, shaded as this scene is, without samples")
    complete = bounds or stage is None or not set(by) <= set(MOVE_NO_BOUNDARY)
    stage = Stage(shot) if stage is None else stage
    planes = stage.new_plane(channels=3) if into is None else into.hand_over()
    named, enclosure = dict(zip(COLORS, planes, strict=True)), None
    if bounds:
        enclosure = stage.new_plane(channels=3), stage.new_plane(np.uint8)
        named |= dict(zip((*BOUNDS, "open"), (*enclosure[0], enclosure[1]), strict=True))
    parts = np.empty((2, 0))
    if by:
        moving = stage.new_plane(channels=3 * len(by) * (1 + bounds))
        named |= dict(zip(slope_planes(len(by), bounds), moving, strict=True))
        parts = np.moveaxis(moving.reshape(1 + bounds, len(by), 3, *moving.shape[1:]), 2, -1)
        parts = parts[..., : stage.raster.shape[1], :]
        if not complete:
            moving[...] = 0.0  # off A
    if complete:
        counts = stage.draw(shot, threads, named, **changes)
    else:
        counts = _draw_on(stage, shot, threads, named, None if into else planes, changes)
    return Frame(shot, stage, planes, dict(zip(WORK, counts, strict=True)), enclosure, by, parts)


def _draw_on(stage, shot, threads, named, fresh, changes):
    """Draw sphere A, and into planes that are fresh copy the rest from the stage first; return the counts."""
    copy, counts = None, [0] * len(WORK)
    if fresh is not None:
        rest, counts = stage.elsewhere(shot, threads)

        def copy(rows):
            fresh[:, rows] = rest[:, rows]

    on_a = stage.draw(shot, threads, named, copy, chambers_known=True, surfaces="a", **changes)
    return map(sum, zip(counts, on_a, strict=True))


def _sampled(shot, by, bounds, threads):
    """Return the Frame of means over each pixel's samples, by bands; its chambers are those of the pixels' middles.

    A mean keeps the mean of the bounds (theorem mean_keeps_the_bound); `lost` is more than its own roundings.
    """
    count, stage, raster = shot.samples, Stage(shot), shot.raster
    (left, top, wide, high), lost = raster.crop, 4 * count * UNIT
    opened = stage.new_plane(np.uint8)
    stage.draw(shot, threads, {"open": opened} if bounds else {}, colors=False, bounds=bounds)
    memory = stage.new_plane(channels=3 * (1 + bounds) * (1 + len(by)))
    means = memory.reshape(1 + bounds, 1 + len(by), 3, *memory.shape[1:])

    def band(rows):
        crop = tuple(count * number for number in (left, top + rows.start, wide, rows.stop - rows.start))
        size = count * raster.width, count * raster.height
        drawn = render(shot.scene, *size, shot.method, crop, 1, bounds=bounds, derivatives=by)
        parts = [(drawn.rgb, *drawn.derivatives.values())]
        if bounds:
            parts.append((drawn.bounds, *drawn.derivative_bounds.values()))
            opened[rows, :wide] |= drawn.open.reshape(-1, count, wide, count).any(axis=(1, 3))
        for into, (plane, *bound) in zip(means.swapaxes(0, 1), zip(*parts, strict=True), strict=True):
            into[0, :, rows, :wide] = _mean(plane, count)
            for each in bound:
                into[1, :, rows, :wide] = _mean(each, count) * (1 + lost) + _mean(abs(plane), count) * lost
        return [*drawn._counts.values()]

    counts = run_bands(band, high, max(1, BAND_SAMPLES // (count**2 * wide)), threads)
    work = dict(zip(WORK, np.sum(counts, axis=0).tolist(), strict=True))
    slopes = np.moveaxis(means[:, 1:, ..., :wide], 2, -1)
    return Frame(shot, stage, means[0, 0], work, (means[1, 0], opened) if bounds else None, by, slopes)


def _mean(plane, count):
    """Return the mean of each count × count pixels by channel, added in an order that no band changes."""
    plane = np.moveaxis(plane, -1, 0)
    rows = reduce(np.add, (plane[:, row::count] for row in range(count)))
    return reduce(np.add, (rows[..., column::count] for column in range(count))) / count**2
