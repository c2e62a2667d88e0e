"""Numbers as a page says them: the ends between which the true one lies, and the digits that are certain."""

from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal

import numpy as np

from renderer.operations import UNIT

DIGITS, EVERY_DIGIT = 4, 15  # of a table; as many as every float64 has


@dataclass(frozen=True)
class Interval:
    """A number as it was computed, and the ends between which the true one lies."""

    value: float
    lower: float
    upper: float

    def __format__(self, form: str) -> str:
        """Return the number in a format, in which both ends have the same text; without one, its certain digits.

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
    """Return a number of so many digits that is not below `upper`, as text, for where no digit is certain."""
    return f"{float(Context(prec=digits, rounding=ROUND_CEILING).create_decimal(Decimal(upper))):.{digits}g}"


def rms(values: np.ndarray) -> float:
    """Return the root of the mean square, 0 of nothing."""
    return float(np.sqrt(np.mean(np.square(values)))) if values.size else 0.0
