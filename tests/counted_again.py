"""Of what a page says that an extreme is one, counted again; and extremes over every pixel, computed again.

What is read is what a figure or a record keeps of its points, never the number that the page cites.
"""

from fractions import Fraction
from functools import cache
from math import lcm

import numpy as np

from book.assembly.results import load_result
from book.drawing.save import read_data
from book.figures import certified_bounds, crease
from renderer import Scene, central, exact, render
from renderer.picture.differences import Interval, distance_on_a, rounded_up
from renderer.scene.raster import Raster
from verify import enclosed_pixels, strict
from verify.accuracy.frontiers import fiction, wall
from verify.benchmark.__main__ import SCENES
from verify.benchmark.work_precision import FULL, PIXELS, reference_pixels
from verify.records import read
from verify.sources import ROOT
from verify.stability import maps, symmetry
from verify.stability.rows import SWEEPS, sweep

BOOK = ROOT / "book"


def kept(figure: str) -> dict[str, np.ndarray]:
    """Return the arrays that a figure's picture shows."""
    name = load_result(BOOK, figure)["data"]
    return read_data(name, (BOOK / "_generated" / name).read_bytes())


@cache
def picture(field: str = "ridges", side: int = 256, eps: float | None = None):
    """Return a frame of the default scene with bounds."""
    return render(Scene(field=field), side, side, central(eps) if eps else exact(), bounds=True)


def _denominators():
    """Return of how many points the shares of a term can be, at each step and of each term."""
    shares = kept("attribution_shares")
    return [Fraction(s).limit_denominator(1000).denominator for name in shares.keys() - {"step"} for s in shares[name]]


def _checked(name=None):
    """Return on how many points the errors of a method of the gradient's diagram were taken: the fewest."""
    return min(row["points"] for row in read("work_precision")["gradients"] if name in (None, row["method"]))


def _of_random_pictures(first=1000):
    """Return how many pixels of the record's pictures were looked at: of a small picture there may be few."""
    total = 0
    for seed in range(first, first + read("enclosed_pixels")["numbers"]["pictures"]):
        random = np.random.default_rng((24, seed))
        strict.random_scene(random)
        size = np.prod(Raster(*strict.random_raster(random)).shape)
        total += enclosed_pixels.EACH + min(enclosed_pixels.EACH, size)
    return total


COUNTED = {
    "accuracy_chart.side": lambda: len(kept("accuracy_chart")["ours"]),
    "attribution_shares.points": lambda: lcm(*_denominators()),
    "attribution_shares.steps": lambda: len(kept("attribution_shares")["step"]),
    "bench:frames.scenes": lambda: SCENES,
    "certified_bounds.side": lambda: len(kept("certified_bounds")["error"]),
    "certified_bounds.whole_side": lambda: len(picture("sine").open),
    "enclosed_pixels.pixels": _of_random_pictures,
    "eps_table.pixels": lambda: picture().open.size,
    "eps_table.pixels_a": lambda: np.count_nonzero((picture().chambers & 3) == 1),
    "frontier_wall.points": lambda: np.transpose(wall.sample()).shape[0],
    "own_fields.side": lambda: len(kept("own_fields")["crater_log10_bound"]),
    "pole.points": lambda: len(kept("pole")["sin_phi"]) * len(crease.AZIMUTHS),
    "reference_pixels.decided": lambda: np.count_nonzero(kept("reference_pixels")["undecided"] == "False"),
    "stability_symmetry.side": lambda: len(symmetry.about_the_axis(picture(side=symmetry.SIZE))[0]),
    "stability_totals.all_points": lambda: sum(sweep(name).errors.size for name in SWEEPS),
    "stability_totals.values": lambda: sum(len(sweep(name).errors) for name in SWEEPS),
    "three_pictures.side": lambda: len(kept("three_pictures")["largest_of_a_channel"]),
    "work_precision.checked": lambda: _checked("exact, reduced argument"),
    "work_precision.fewer": lambda: _checked("numdifftools"),
    "work_precision.fewest": _checked,
    "work_precision.points": lambda: FULL,
    "work_precision_frames.sampled": lambda: len(reference_pixels(Scene(field="sine"), PIXELS)[0]),
}
"""{a number that a page cites: the function that counts it again}"""


def _of_a_function(name):
    return lambda: kept("elementary_ulps")[f"{name}_error"].size


def _of_a_sweep(name):
    return lambda: sweep(name).errors.size


COUNTED |= {f"elementary_ulps.{name}_samples": _of_a_function(name) for name in ("sinpi", "cospi", "atan2pi")}
COUNTED |= {f"{figure}.{name}_points": _of_a_sweep(name) for figure, name in (
    ("stability_pole", "pole"), ("stability_silhouette", "silhouette"), ("stability_near_far", "near_to_far"),
    ("stability_totals", "hit_of_b"), ("stability_totals", "shadow"), ("stability_wave_numbers", "wave_numbers"),
    ("stability_shading", "opposite_light_phong"), ("stability_shading", "shininess"),
    ("stability_shading", "amplitude"),
)}  # fmt: skip


def _bound(field):
    return lambda side: float(rounded_up(picture(field, side).bounds.max(), 2))


def _own_bound(name):
    scene = certified_bounds.scene_of(name)
    return lambda side: float(rounded_up(render(scene, side, side, bounds=True).bounds.max(), 2))


def _least_largest(side):
    """Return the upper end of the largest error of sine at the step that its page names."""
    eps = load_result(BOOK, "image_error")["numbers"]["sine_largest_eps"]
    frame = render(Scene(field="sine"), side, side, central(eps))
    return distance_on_a(frame, picture("sine", side))[0].outward()[1]


def _largest(side) -> Interval:
    return distance_on_a(picture(side=side, eps=1e-2), picture(side=side))[0]


OVER_A_RASTER = {
    "accuracy_image.ours_most": lambda side: maps.summary(maps.over_the_image(size=side)["ours"])[1],
    "bench:frames.image_error": lambda side: max(
        strict.image_error(Scene(), side, exact(form)) for form in ("algebraic", "general")
    ),
    **{f"certified_bounds.{field}_bound": _bound(field) for field in ("sine", "ridges", "rings")},
    "frontier_angles.metric_largest": lambda side: np.nanmax([*fiction.angle_maps(picture(side=side)).values()][-1]),
    "image_error.sine_largest_to": _least_largest,
    **{f"own_fields.{name}_bound": _own_bound(name) for name in certified_bounds.TEXTS},
    "three_pictures.largest": _largest,
    "views.steepest": lambda side: picture(side=side).slope.max(),
}
"""{an extreme that a page cites: the function that computes it again, of every pixel of so many squared}"""
