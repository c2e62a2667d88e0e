"""What a number has to satisfy: `== 0`, `< 1e-12`, `in [0.45, 0.65]`."""

import operator
import re
from dataclasses import dataclass

ALLOWED = "one of ==, !=, <, <=, >, >= and a number, or in [a, b]"
COMPARISONS = {
    "==": operator.eq,
    "!=": operator.ne,
    "<=": operator.le,
    ">=": operator.ge,
    "<": operator.lt,
    ">": operator.gt,
}
_COMPARISON = re.compile(r"(==|!=|<=|>=|<|>)\s*(\S+)")
_INTERVAL = re.compile(r"in\s*\[\s*([^\s,]+)\s*,\s*([^\s,\]]+)\s*\]")


@dataclass(frozen=True)
class Relation:
    """A comparison with a number, or an interval with its ends."""

    sign: str
    numbers: tuple[float, ...]

    def holds(self, value: float) -> bool:
        """Whether a number satisfies it."""
        if self.sign == "in":
            low, high = self.numbers
            return low <= value <= high
        return COMPARISONS[self.sign](value, self.numbers[0])


def relation(text: str) -> Relation:
    """Read a relation; ValueError says what is allowed."""
    text = text.strip() if isinstance(text, str) else str(text)
    try:
        if match := _COMPARISON.fullmatch(text):
            return Relation(match[1], (float(match[2]),))
        if match := _INTERVAL.fullmatch(text):
            low, high = float(match[1]), float(match[2])
            if low <= high:
                return Relation("in", (low, high))
    except ValueError:
        pass
    raise ValueError(f"{text!r} is not a relation; allowed is {ALLOWED}")
