"""Pixels of random pictures with bounds, against 256-bit balls: python -m verify.enclosed_pixels

Truth is the pixel's program in balls, whose radius is below 1e-50. Scenes of every field, model and gradient method,
from the common to the extreme; of each picture some pixels at random, and as many of the largest bounds and of each
kind that is hard. Writes verify/results/enclosed_pixels.json: commit it.
"""

from collections import Counter, defaultdict
from collections.abc import Iterator
from copy import copy
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
from flint import arb, ctx
from tqdm import tqdm

from proofs.formulas.finite_difference import METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.shading import LIGHT_MODELS
from renderer import Light, Scene, exact, render
from renderer.picture.frame import Frame
from renderer.scene.methods import GradientMethod
from renderer.scene.scene import BUMPS
from verify.coq.recorded_pixel import ANY, MODELS, MOVED, PLACES, SPREAD, WIDE
from verify.evidence.records import command
from verify.reference import COLORS, chamber_code, lines_of

BITS = 256
RANGE_BOUND = 1e-12  # pixel_accuracy__computed
IN_RANGE = 20  # scenes of the range that Coq certifies, at each of its places
EACH = 6  # pixels of a picture at random, and as many of each kind
KINDS = (*HEIGHT_FIELDS, *LIGHT_MODELS, *BUMPS, "exact", *METHODS)


def random_scene(random: np.random.Generator) -> Scene:
    """Return a scene of scales far apart: B may contain, cut, touch or miss everything, lights may be low or below."""
    while True:
        radius = 10.0 ** random.uniform(-2, 2)
        center = tuple(random.normal(size=3) * radius * 10.0 ** random.uniform(-1, 1, 3))
        positions = random.normal(size=(random.integers(0, 6), 3)) * radius * 10.0 ** random.uniform(-0.5, 2, 3)
        colors = [None if random.uniform() < 0.1 else tuple(random.uniform(0, 1, 3)) for _ in positions]
        try:
            return Scene(
                radius=radius,
                eye=radius * 10.0 ** random.uniform(0.01, 2),
                ball=bool(random.uniform() < 0.9),
                floor=bool(random.uniform() < 0.9),
                ball_radius=radius * 10.0 ** random.uniform(-2, 1),
                ball_center=center,
                lights=tuple(map(Light, map(tuple, positions), colors)),
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


def truth_of(frame: Frame, column: int, row: int, bits: int = BITS, **others: arb) -> dict[str, arb]:
    """Return the balls of every line of a frame's pixel; others: numbers in place of the scene's."""
    scene, raster, method = frame.scene, frame.raster, frame.method
    left, top, *_ = raster.crop  # type: ignore[misc]  # checked when it was made
    place = {"column": left + column, "row": top + row, "width": raster.width, "height": raster.height}
    return lines_of(scene, method.name, bits, **place, epsilon=method.eps or 0.0, **others)


def compared(frame: Frame, column: int, row: int) -> tuple[list[arb], bool]:
    """Return how far each channel of a pixel is from the truth, and whether the chamber is the true one."""
    truth = truth_of(frame, column, row)
    with ctx.workprec(BITS):
        off = [abs(arb(c) - truth[name]) for c, name in zip(frame.rgb[row, column], COLORS, strict=True)]
    code = chamber_code(frame.scene, lambda name: int(truth[name].unique_fmpz() or 0))
    return off, bool(code == frame.chambers[row, column])


def errors(frame: Frame, column: int, row: int) -> tuple[np.ndarray, np.ndarray, bool]:
    """Return the certain error of each channel of a pixel, NaN where it is on an edge at any digits; its bound; and
    whether the chamber is another than the true one, and not open.
    """
    enclosures, same_chamber = compared(frame, column, row)
    off = np.array([float(error.abs_lower()) for error in enclosures])
    return off, frame.bounds[row, column], not (same_chamber or frame.open[row, column])


def wrong(frame: Frame, column: int, row: int) -> bool:
    """Return whether an error of a pixel is above its bound, or its chamber missed."""
    off, bounds, missed = errors(frame, column, row)
    return bool((off > bounds).any()) or missed


def random_picture(seed: int) -> Frame:
    """Return a frame with bounds: a random scene of any field, model, shininess and method, β from nothing to 1e100."""
    random = np.random.default_rng((24, seed))
    scene, (width, height, crop) = random_scene(random), random_raster(random)
    waves: list[Any] = [
        (8, 4),
        random.integers(-64, 64, 2),
        random.uniform(-20, 20, 2),
        2.0 ** random.uniform(6, 20, 2),
    ]
    ku, kv = (float(k) for k in waves[seed % 4])
    method = [exact(), exact("general"), *(GradientMethod(m, 10.0 ** random.uniform(-8, -1)) for m in METHODS)]
    scene = replace(
        scene,
        field=list(HEIGHT_FIELDS)[seed % len(HEIGHT_FIELDS)],
        model=list(LIGHT_MODELS)[seed // 3 % len(LIGHT_MODELS)],
        shininess=float(random.choice([32.0, 1.0, 7.3, 0.5, 1000.0, 12345.6])),
        beta=float(random.choice([0.35, 0.0, -20.0, 10.0 ** random.uniform(-3, 100)])),
        ku=ku,
        kv=kv,
        horizon=seed % 5 == 0,
    )
    if seed % 2 and abs(scene.beta) < 1e78:
        scene = replace(scene, bump="surface")
    return render(scene, width, height, method[seed // 4 % len(method)], crop, bounds=True)


def _edges(codes):
    """Return where a code differs from that of the pixel to the right, to the left, above or below."""
    around = np.lib.stride_tricks.sliding_window_view(np.pad(codes, 1, "edge"), (3, 3))
    return (around[..., (0, 2, 1, 1), (1, 1, 0, 2)] != codes[..., None]).any(axis=-1)


def hard_kinds(frame: Frame) -> Iterator[np.ndarray]:
    """Yield a plane for each kind of hard pixel: the smaller its number there, the harder a pixel."""
    scene = frame.scene
    surface, shadows = frame.chambers & 3, frame.chambers >> 2 & 31
    u, v = frame.surface_data["u"], frame.surface_data["v"]
    flat = copy(frame)
    flat.shot = replace(flat.shot, scene=replace(scene, beta=0.0))  # cosines there without the bump
    yield -frame.bounds.max(axis=2)
    yield np.where(_edges(surface), 0.0, np.inf)  # on the silhouette
    yield np.where(_edges(shadows) & ~_edges(surface), 0.0, np.inf)  # at a shadow's edge
    yield v  # next to the pole,
    yield np.minimum(u, 1 - u)  # to the seam,
    yield np.min([np.abs(w - np.rint(w)) for w in (scene.ku * u, scene.kv * v)], axis=0)  # to a crease
    for each in (frame, flat) if scene.lights else ():  # on the terminator; where light grazes
        yield np.min([np.abs(each.light_cosines(number)) for number in range(len(scene.lights))], axis=0)


def places(frame: Frame, random: np.random.Generator, each: int) -> list[tuple[int, int]]:
    """Return `each` pixels at random, then as many of each hard kind, as (column, row); among equals at random."""
    flat = [*random.integers(0, frame.open.size, each)]
    for plane in map(np.ravel, hard_kinds(frame)):
        order = np.lexsort((random.random(plane.size), plane))[:each]
        flat += [*order[np.isfinite(plane[order])]]
    rows, columns = np.unravel_index(flat, frame.open.shape)
    return list(zip(columns.tolist(), rows.tolist(), strict=True))


def pixels_in_range(scenes: int) -> Iterator[Frame]:
    """Yield frames of one pixel: at each place where Coq certifies a range of scenes, so many of them at random."""
    random, default = np.random.default_rng(55), Scene()
    each: list = [(default, exact(), pixel) for pixel in SPREAD]
    for field, (model, number) in product(PLACES, MODELS.items()):
        squared = ANY.lights[number][1] == "squared"  # the recorded power is 16, of the highlight's square or of itself
        scene = replace(default, field=field, model=model, shininess=32.0 if squared else 16.0)
        each += [(scene, exact("general"), pixel) for pixel in PLACES[field]]
    for (scene, method, pixel), _ in product(each, range(scenes)):
        ka, kd, ks, tint, *rest = random.uniform(*WIDE["kd"], 4 + 5 * 3).tolist()
        albedo_a, albedo_b, ambient, *colors = zip(*[iter(rest)] * 3, strict=True)
        moved = [np.add(random.uniform(-1, 1, 3) * MOVED["light_position"], light.position) for light in scene.lights]
        lights = tuple(map(Light, map(tuple, moved), colors))
        beta = random.uniform(*WIDE["beta"])
        colored = {"albedo_a": albedo_a, "albedo_b": albedo_b, "ambient": ambient, "floor_tint": tint, "lights": lights}
        scene = replace(scene, ka=ka, kd=kd, ks=ks, beta=beta, **colored)
        yield render(scene, 256, 256, method, (*pixel, 1, 1), bounds=True)


def measure(pictures: int, first: int = 1000) -> dict:
    """Return a record's numbers: counts and shares over the pixels of so many random pictures.

    pixels, decided (those of which no channel is on an edge at 256 bits), above_bound (channels), chambers_missed;
    largest_share of a bound; open_share of the pictures, median_ratio, bound by error, of all and of each of KINDS.
    """
    ratios: dict[str, list[float]] = defaultdict(list)
    counts, opened, drawn = Counter[str](), Counter[str](), Counter[str]()
    for seed in tqdm(range(first, first + pictures), desc="pictures", unit="picture", disable=None):
        frame, random = random_picture(seed), np.random.default_rng(seed)
        kinds = ("all", str(frame.scene.field), str(frame.scene.model), frame.scene.bump, frame.method.name)
        opened.update(dict.fromkeys(kinds, int(frame.open.sum())))
        drawn.update(dict.fromkeys(kinds, frame.open.size))
        for number, place in enumerate(places(frame, random, EACH)):
            off, bounds, missed = errors(frame, *place)
            inexact, above = off > 0, int((off > bounds).sum())
            counts.update(pixels=1, decided=int(np.isfinite(off).all()), above_bound=above, chambers_missed=missed)
            for kind in ("largest", *(kinds if number < EACH else ())):
                ratios[kind] += (bounds[inexact] / off[inexact]).tolist()
    shares = {"largest_share": 1 / min(ratios.pop("largest"))}
    shares |= {f"open_share_{kind}": opened[kind] / total for kind, total in sorted(drawn.items())}
    medians = {f"median_ratio_{kind}": float(np.median(numbers)) for kind, numbers in sorted(ratios.items())}
    in_range = [errors(frame, 0, 0)[0] for frame in pixels_in_range(IN_RANGE)]
    largest = float(np.max(in_range))
    ranges = {"range_colours": np.size(in_range), "range_largest_error": largest, "range_ratio": RANGE_BOUND / largest}
    return {"numbers": {"pictures": pictures} | counts | shares | medians | ranges}


if __name__ == "__main__":
    command("enclosed_pixels", __doc__, measure, pictures=840)
