"""How far two pictures are apart on sphere A: the numbers, and the ends between which the truth certainly lies."""

import math
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal

import numpy as np

from renderer.checks import check_kind, not_allowed
from renderer.operations import UNIT, Number, maximum, where
from renderer.picture.frame import Frame

TINY = 1e-100  # a distance that counts as none, or as this: its square would vanish
DIGITS, EVERY_DIGIT = 4, 15  # of a table; as many as every float64 has


@dataclass(frozen=True)
class Interval:
    """A number as it was computed, and the ends between which the true one lies."""

    value: float
    lower: float
    upper: float

    def __format__(self, form: str) -> str:
        """Return what both ends are in a format, or without one the digits that are certain.

        Raises ValueError where the format asks for more than is certain, or no digit is.
        """
        certain = {certain_digits(self.lower, self.upper)}
        ends = {format(end, form) for end in (self.lower, self.upper)} if form else certain
        if len(ends) > 1 or ends == {""}:
            raise ValueError(f"{form or 'a digit'!r} of a number from {self.lower!r} to {self.upper!r} is not certain")
        return ends.pop()

    def outward(self) -> tuple[float, float]:
        """Return numbers of two digits that it certainly lies between."""
        down = Context(prec=2, rounding=ROUND_FLOOR).create_decimal(Decimal(self.lower))
        return float(down), float(rounded_up(self.upper, 2))

    def times(self, factor: float) -> "Interval":
        """Return the interval of so many times the number; factor: 100, say, which is exact."""
        down, up = 1 - 2 * UNIT, 1 + 4 * UNIT
        return Interval(self.value * factor, self.lower * factor * down, self.upper * factor * up)


def certain_digits(lower: float, upper: float, digits: int = DIGITS) -> str:
    """Return the number that both ends are when they are rounded to a count of significant digits.

    The count is the largest, up to `digits`, at which they agree: whatever lies between them is then rounded to the
    same number. "" where they agree at none. The ends are taken as the exact fractions that they are.
    """
    for count in range(digits, 0, -1):
        rounded = {Context(prec=count).create_decimal(Decimal(end)) for end in (lower, upper)}
        if len(rounded) == 1:
            return f"{float(rounded.pop()):.{count}g}"
    return ""


def rounded_up(upper: float, digits: int = 1) -> str:
    """Return a number of so many digits that is not below `upper`, as text: what is certain where no digit is."""
    return f"{float(Context(prec=digits, rounding=ROUND_CEILING).create_decimal(Decimal(upper))):.{digits}g}"


def _difference(frame, reference):
    """Return the differences of two frames, or raise ValueError unless both are some, of one raster."""
    raster = check_kind("reference", reference, Frame).raster
    if check_kind("frame", frame, Frame).raster != raster:
        raise not_allowed("frame", frame, f"one of the reference's raster, {raster}")
    return frame.rgb - reference.rgb


def difference_on_a(frame: Frame, reference: Frame) -> np.ndarray:
    """Return the differences of two frames of one raster on sphere A, (pixels, 3). Raises ValueError of two rasters."""
    return _difference(frame, reference)[reference.stage.on_a]


def rms(values: np.ndarray) -> float:
    """Return the root of the mean square, 0 of nothing."""
    return float(np.sqrt(np.mean(np.square(values)))) if values.size else 0.0


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
