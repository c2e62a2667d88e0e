"""Evidence that is no certificate: what was sampled, or enclosed in balls.

    @measures("theorem_id", false={"half the bound": {"bound": 5}})
    def bound_holds(bound=10):
        ...
        return Measurement(samples=1000, seed=7, worst=worst, bound=bound, what="…")

The function takes its claim as parameters, with the true one as their defaults; `false` names variants of the claim
that the same function has to reject, at least one. A run calls both. With certified=True, `worst` and `bound` are
balls of python-flint (or integers), and the run compares them again.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from verify.optional import arb

DIGITS = 6
REGISTERED: dict[str, list[tuple[Callable, dict]]] = {}
"""{theorem's id: [(function, {text: keyword arguments of a false variant})]}, once `measured` has asked for all"""


@dataclass(frozen=True)
class Measurement:
    """One measurement: of `samples` cases drawn with `seed` (None: nothing is random), the worst and its bound.

    holds: whether what else is claimed does, beside worst ≤ bound. certified: every number is a ball that encloses the
    true value, for all cases and not for samples. numbers: {name: number or text} that a page may print.
    """

    samples: int
    worst: Any
    bound: Any
    what: str
    seed: int | None = None
    holds: bool = True
    numbers: dict = field(default_factory=dict)
    certified: bool = False

    def __post_init__(self):
        if not self.what or self.samples < 1:
            raise ValueError("a measurement says what it measured, at least once")
        if self.certified and not all(isinstance(n, arb | int | Fraction) for n in (self.worst, self.bound)):
            raise ValueError(f"{self.what}: what is certified is enclosed in balls")

    @property
    def accepted(self) -> bool:
        """Whether the claim holds, and what was seen is finite and within its bound (balls: certainly)."""
        if self.certified:
            worst, bound = (arb(n.numerator) / n.denominator if isinstance(n, Fraction) else arb(n)
                            for n in (self.worst, self.bound))  # fmt: skip
            return bool(self.holds) and bool(worst <= bound)
        return bool(self.holds) and bool(self.worst <= self.bound) and math.isfinite(self.worst)

    def record(self) -> dict[str, Any]:
        """Return what the report keeps, with numbers rounded so that they do not depend on the machine's last bits."""
        numbers = {name: rounded(value) for name, value in sorted(self.numbers.items())}
        seen = {"samples": self.samples, "seed": self.seed, "certified": self.certified, "what": self.what}
        return seen | {"worst": rounded(self.worst), "bound": rounded(self.bound), "numbers": numbers}


def rounded(value: Any) -> Any:
    """Return a number to DIGITS significant digits, as an int or float; texts and booleans as they are.

    A ball is rounded from its upper end.
    """
    if isinstance(value, str | bool | int):
        return value
    value = value.upper() if isinstance(value, arb) else value
    return float(f"{float(value):.{DIGITS}g}")


def measures(theorem_id: str, false: dict[str, dict[str, Any]]) -> Callable[[Callable], Callable]:
    """Register a function as evidence of a theorem. false: {text: keyword arguments} of claims it has to reject."""
    if not false:
        raise ValueError(f"{theorem_id}: a measurement needs a false variant that it rejects")

    def register(function):
        REGISTERED.setdefault(theorem_id, []).append((function, dict(false)))
        return function

    return register
