"""Of what a page says that an extreme is one, counted again; and extremes over every pixel, computed again.

What is read is what a figure or a record keeps of its points, never the number that the page cites.
"""

from fractions import Fraction
from functools import cache
from math import lcm

import numpy as np

from book.assembly.results import load_result, look_up
from book.drawing.save import read_data
from book.figures import certified_bounds, crease
from renderer import Scene, central, exact, render
from renderer.picture.differences import distance_on_a, rounded_up
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


def kept(figure):
    """Return the arrays that a figure's picture shows."""
    name = load_result(BOOK, figure)["data"]
    return read_data(name, (BOOK / "_generated" / name).read_bytes())


@cache
def picture(field="ridges", side=256):
    """Return a frame of the default scene with bounds."""
    return render(Scene(field=field), side, side, bounds=True)


def _of_shares():
    """Return of how many points the shares of a term can be, at each step and of each term."""
    shares = np.concatenate([values for name, values in kept("attribution_shares").items() if name != "step"])
    return lcm(*(Fraction(share).limit_denominator(1000).denominator for share in shares))


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
    "attribution_shares.points": _of_shares,
    "bench:frames.scenes": lambda: SCENES,
    "certified_bounds.whole_side": lambda: len(picture("sine").open),
    "enclosed_pixels.pixels": _of_random_pictures,
    "eps_table.pixels": lambda: picture().open.size,
    "eps_table.pixels_a": lambda: np.count_nonzero((picture().chambers & 3) == 1),
    "frontier_wall.points": lambda: np.transpose(wall.sample()).shape[0],
    "pole.points": lambda: len(kept("pole")["sin_phi"]) * len(crease.AZIMUTHS),
    "reference_pixels.decided": lambda: np.count_nonzero(kept("reference_pixels")["undecided"] == "False"),
    "stability_symmetry.side": lambda: len(symmetry.about_the_axis(picture(side=symmetry.SIZE))[0]),
    "stability_totals.all_points": lambda: sum(sweep(name).errors.size for name in SWEEPS),
    "work_precision.checked": lambda: _checked("exact, reduced argument"),
    "work_precision.fewer": lambda: _checked("numdifftools"),
    "work_precision.fewest": _checked,
    "work_precision.points": lambda: FULL,
    "work_precision_frames.sampled": lambda: len(reference_pixels(Scene(field="sine"), PIXELS)[0]),
}
"""{a number that a page cites: the function that counts it again}"""


ARRAYS = {
    "accuracy_chart.side": "ours",
    "attribution_shares.steps": "step",
    "certified_bounds.side": "error",
    "elementary_ulps.atan2pi_samples": "atan2pi_error",
    "elementary_ulps.cospi_samples": "cospi_error",
    "elementary_ulps.sinpi_samples": "sinpi_error",
    "own_fields.side": "crater_log10_bound",
    "three_pictures.side": "largest_of_a_channel",
}
"""{a number that a page cites: the array of its figure that is so long}"""


STABILITY = ("pole", "silhouette", "near_far", "totals", "wave_numbers", "shading")
COUNTED |= {number: lambda number=number: len(kept(number.partition(".")[0])[ARRAYS[number]]) for number in ARRAYS}
COUNTED |= {
    f"stability_{page}.{name}_points": lambda name=name: sweep(name).errors.size
    for page in STABILITY
    for name in SWEEPS
}


def _bound(name):
    def largest(side):
        scene = certified_bounds.scene_of(name) if name in certified_bounds.TEXTS else Scene(field=name)
        return float(rounded_up(render(scene, side, side, bounds=True).bounds.max(), 2))

    return largest


def _apart(side, eps, field="ridges"):
    """Return the largest difference of two pictures of the default scene."""
    return distance_on_a(render(Scene(field=field), side, side, central(eps)), picture(field, side))[0]


OVER_A_RASTER = {
    "accuracy_image.ours_most": lambda side: maps.summary(maps.over_the_image(size=side)["ours"])[1],
    "bench:frames.image_error": lambda side: max(
        strict.image_error(Scene(), side, exact(form)) for form in ("algebraic", "general")
    ),
    **{f"certified_bounds.{name}_bound": _bound(name) for name in ("sine", "ridges", "rings")},
    **{f"own_fields.{name}_bound": _bound(name) for name in certified_bounds.TEXTS},
    "frontier_angles.metric_largest": lambda side: np.nanmax([*fiction.angle_maps(picture(side=side)).values()][-1]),
    "image_error.sine_largest_to": lambda side: _apart(
        side, look_up(BOOK, "image_error", "sine_largest_eps"), "sine"
    ).outward()[1],
    "three_pictures.largest": lambda side: _apart(side, 1e-2),
    "views.steepest": lambda side: picture(side=side).slope.max(),
}
"""{an extreme that a page cites: the function that computes it again, of every pixel of so many squared}"""
