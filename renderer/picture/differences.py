"""The distance of two pictures on sphere A: as computed, and the ends between which the exact one certainly lies."""

import math

import numpy as np

from renderer.checks import check_kind, not_allowed
from renderer.intervals import Interval, rms
from renderer.operations import UNIT, Number, maximum, where
from renderer.picture.frame import Frame

TINY = 1e-100  # a distance that counts as none, or as this: its square would vanish


def _difference(frame, reference):
    """Return the differences of two frames, or raise ValueError unless both are some, of one raster."""
    raster = check_kind("reference", reference, Frame).raster
    if check_kind("frame", frame, Frame).raster != raster:
        raise not_allowed("frame", frame, f"one of the reference's raster, {raster}")
    return frame.rgb - reference.rgb


def difference_on_a(frame: Frame, reference: Frame) -> np.ndarray:
    """Return the differences of two frames of one raster on sphere A, (pixels, 3). Raises ValueError of two rasters."""
    return _difference(frame, reference)[reference.stage.on_a]


def distance_on_a(frame: Frame, reference: Frame) -> tuple[Interval, Interval]:
    """Return (the largest, the RMS) difference of two frames of one raster over A's pixels and channels.

    A frame that was drawn with bounds stands for its exact picture, one without for the float64 numbers that it holds.
    A pixel that one with bounds leaves open may lie on A or not, whatever it is taken for: both choices are covered.
    Of no pixel, either is 0. Raises ValueError of two rasters.
    """
    delta = _difference(frame, reference)
    bounded = [each for each in (frame, reference) if each.bounded]
    on_a, undecided = reference.stage.on_a, np.zeros(reference.raster.shape, bool)
    for each in bounded:
        undecided |= each.open
    return enclosed_distance(delta, sum(each.bounds for each in bounded), on_a, undecided)


def enclosed_distance(
    delta: np.ndarray, within: np.ndarray | float, on_a: np.ndarray, undecided: np.ndarray
) -> tuple[Interval, Interval]:
    """Return (the largest, the RMS) of differences, (height, width, 3), that are off by as much as `within` says.

    on_a: which pixels count. undecided: which of all may be taken for others.
    """
    lower, upper = nearest_and_furthest(np.abs(delta), within)
    certain, possible = on_a & ~undecided, on_a | undecided
    largest = lower[certain].max(initial=0.0), upper[possible].max(initial=0.0)
    least = _root_mean_squares(lower, certain, undecided, 1).min()
    most = _root_mean_squares(upper, certain, undecided, -1).max()
    values = delta[on_a]
    return (
        Interval(float(np.abs(values).max(initial=0.0)), *map(float, largest)),
        Interval(rms(values), float(least), float(most)),
    )


def nearest_and_furthest(apart: Number, within: Number) -> tuple[Number, Number]:
    """Return how far colours are apart at least, and at most, which are computed so far apart, off by `within`.

    The factors are more than the roundings of the subtraction that gave `apart`, and of these lines.
    """
    nearest = apart * (1 - 8 * UNIT) - within * (1 + 8 * UNIT)
    furthest = (apart + within) * (1 + 8 * UNIT)
    return where(nearest < TINY, 0.0, nearest), where(furthest > 0.0, maximum(furthest, TINY), 0.0)


def _root_mean_squares(distances, certain, undecided, order):
    """Return ends of the RMS over the pixels that are certain, then with one that is undecided too, then with two, …

    They join from the least distance (order 1, lower ends) or from the largest (−1, upper ends): no other choice has a
    lesser or larger RMS. A sum of n numbers, none negative, is off by less than n roundings in whatever order.
    """
    squares = np.square(distances).sum(axis=2)
    rows = np.where(certain, squares, 0.0).sum(axis=1)
    joining = np.concatenate([[0.0], np.sort(squares[undecided])[::order]])
    sums = math.fsum(rows) + np.cumsum(joining)
    counts = 3.0 * (np.count_nonzero(certain) + np.arange(len(joining)))
    slack = (squares.shape[1] + len(joining) + 16) * UNIT
    return np.sqrt(sums / np.maximum(counts, 1.0)) * (1 - order * slack)
