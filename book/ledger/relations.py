"""What a number has to satisfy: `== 0`, `< 1e-12`, `in [0.45, 0.65]`."""

import operator
import re
from collections.abc import Callable
from typing import NamedTuple

from renderer.picture.differences import Interval

ALLOWED = "one of ==, !=, <, <=, >, >= and a number, or in [a, b]"
HOLDS: dict[str, Callable[..., bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<=": operator.le,
    ">=": operator.ge,
    "<": operator.lt,
    ">": operator.gt,
    "in": lambda value, low, high: low <= value <= high,
}
FORMS = (r"(==|!=|<=|>=|<|>)\s*(\S+)", r"(in)\s*\[\s*([^\s,]+)\s*,\s*([^\s,\]]+)\s*\]")


class Relation(NamedTuple):
    """A comparison with a number, or "in" with the two ends of an interval."""

    sign: str
    numbers: tuple[float, ...]

    def holds(self, value: float | Interval) -> bool:
        """Whether a number satisfies it; of one that is enclosed, whether it certainly does."""
        ends = (value.lower, value.upper) if isinstance(value, Interval) else (value,)
        return all(HOLDS[self.sign](end, *self.numbers) for end in ends)


def relation(text: str) -> Relation:
    """Read a relation; ValueError says what is allowed."""
    for form in FORMS:
        if match := re.fullmatch(form, str(text).strip()):
            sign, *ends = match.groups()
            try:
                numbers = tuple(map(float, ends))
            except ValueError:
                break
            if sorted(numbers) == list(numbers):
                return Relation(sign, numbers)
    raise ValueError(f"{text!r} is not a relation; allowed is {ALLOWED}")
