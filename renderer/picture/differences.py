"""The distance of two pictures on sphere A: as computed, and the ends between which the exact one certainly lies."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from renderer.checks import check_kind, not_allowed
from renderer.intervals import Interval
from renderer.machines import at_points
from renderer.operations import UNIT, Number, maximum, where
from renderer.picture.frame import Frame
from renderer.threads import run_bands

BAND, SUMMED = 2**15, 256  # numbers of a band; those that are added before the rest is summed exactly
TINY = 1e-100  # a distance that counts as none, or as this: its square would vanish


def _checked(frame, reference):
    """Raise ValueError unless both are frames, of one raster."""
    raster = check_kind("reference", reference, Frame).raster
    if check_kind("frame", frame, Frame).raster != raster:
        raise not_allowed("frame", frame, f"one of the reference's raster, {raster}")


def difference_on_a(frame: Frame, reference: Frame) -> np.ndarray:
    """Return the differences of two frames of one raster on sphere A, (pixels, 3). Raises ValueError of two rasters."""
    _checked(frame, reference)
    return (frame.rgb - reference.rgb)[reference.stage.on_a]


def distance_on_a(frame: Frame, reference: Frame) -> tuple[Interval, Interval]:
    """Return (the largest, the RMS) difference of two frames of one raster over A's pixels and channels.

    A frame that was drawn with bounds stands for its exact picture, one without for the float64 numbers that it holds.
    A pixel that one with bounds leaves open may lie on A or not, whatever it is taken for: both choices are covered.
    Of no pixel, either is 0. Raises ValueError of two rasters.
    """
    _checked(frame, reference)
    return distance_from(reference, [each for each in (reference, frame) if each.bounded])(frame)


def distance_from(
    reference: Frame, bounded: Sequence[Frame], threads: int = 1
) -> Callable[[Frame], tuple[Interval, Interval]]:
    """Return the function from a frame of the raster to what `distance_on_a` returns.

    bounded: those of the two frames that have bounds. The reference's pixels are gathered here, once for all frames.
    """
    undecided, within = np.zeros(reference.raster.shape, bool), np.zeros(3)
    for each in bounded:
        undecided, within = undecided | each.open, within + each.bounds
    places, on_a, sure = _pixels(reference.stage.on_a, undecided)
    others = _taken(reference.rgb, places), _taken(np.broadcast_to(within, reference.rgb.shape), places)
    return lambda frame: _enclosed(_taken(frame.rgb, places), *others, on_a, sure, threads)


def enclosed_distance(
    delta: np.ndarray, within: np.ndarray, on_a: np.ndarray, undecided: np.ndarray
) -> tuple[Interval, Interval]:
    """Return (the largest, the RMS) of differences, (height, width, 3), that are off by as much as `within` says.

    on_a: which pixels count. undecided: which of all may be taken for others.
    """
    places, *masks = _pixels(on_a, undecided)
    return _enclosed(_taken(delta, places), np.zeros((3, len(places))), _taken(within, places), *masks)


def _pixels(on_a, undecided):
    """Return (the places of pixels that may count; which of these are on A as drawn, and which certainly are)."""
    places = np.flatnonzero(on_a | undecided)
    return places, on_a.ravel()[places], ~undecided.ravel()[places]


def _taken(picture, places):
    """Return a picture's numbers at places, (3, places)."""
    return np.array([plane.ravel().take(places) for plane in np.moveaxis(picture, -1, 0)])


def _enclosed(colors, others, within, on_a, sure, threads=1):
    """Return (the largest, the RMS) of differences of colours, (3, pixels), that are off by as much as `within` says.

    Numbers are taken in bands that a processor's cache holds.
    """
    if not len(sure):
        return (Interval(0.0, 0.0, 0.0),) * 2
    each_number = [part.ravel() for part in (colors, others, within)]
    masks = [np.tile(mask, 3) for mask in (on_a, sure, sure)]

    def of_band(band):
        sizes = at_points(distances, *(part[band] for part in each_number))
        kept = [e if m[band].all() else e * m[band] for e, m in zip(sizes, masks, strict=True)]
        sums = [np.add.reduceat(np.square(each), np.arange(0, each.size, SUMMED)) for each in kept]
        return [each.max() for each in (*kept[:2], sizes[2])], sums

    largest, sums = zip(*run_bands(of_band, 3 * len(sure), BAND, threads), strict=True)
    values, *ends = (math.fsum(np.concatenate(each).tolist()) for each in zip(*sums, strict=True))
    _, *joining = at_points(distances, *(part[:, ~sure].ravel() for part in (colors, others, within)))
    squares = [np.sort(np.square(end).reshape(3, -1).sum(axis=0)) for end in joining]
    lower = _root_mean_squares(ends[0], np.count_nonzero(sure), squares[0], 1).min()
    upper = _root_mean_squares(ends[1], np.count_nonzero(sure), squares[1][::-1], -1).max()
    mean = math.sqrt(values / max(1.0, 3.0 * np.count_nonzero(on_a)))
    return Interval(*map(float, np.max(largest, axis=0))), Interval(mean, float(lower), float(upper))


def distances(one: Number, other: Number, within: Number) -> tuple[Number, ...]:
    """Return how far two colours are apart as computed, at least, and at most, where they are off by `within`."""
    apart = abs(one - other)
    return apart, *nearest_and_furthest(apart, within)


def nearest_and_furthest(apart: Number, within: Number) -> tuple[Number, Number]:
    """Return how far colours are apart at least, and at most, which are computed so far apart, off by `within`.

    The factors are more than the roundings of the subtraction that gave `apart`, and of these lines.
    """
    nearest = apart * (1 - 8 * UNIT) - within * (1 + 8 * UNIT)
    furthest = (apart + within) * (1 + 8 * UNIT)
    return where(nearest < TINY, 0.0, nearest), where(furthest > 0.0, maximum(furthest, TINY), 0.0)


def _root_mean_squares(certain, count, joining, order):
    """Return ends of the RMS over `count` pixels that are certain, then with one that is undecided too, then with two.

    certain: the sum of their squares. joining: those of the others, from the least on (order 1, lower ends) or from the
    largest (−1, upper ends): no other choice has a lesser or larger RMS. A sum of n numbers, none negative, is off by
    less than n roundings in whatever order.
    """
    sums = certain + np.cumsum([0.0, *joining])
    counts = 3.0 * (count + np.arange(len(sums)))
    slack = (min(SUMMED, 3 * count) + len(sums) + 16) * UNIT
    return np.sqrt(sums / np.maximum(counts, 1.0)) * (1 - order * slack)
