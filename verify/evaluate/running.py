"""Running error analysis: float64 arithmetic that carries, beside every number, a bound on its distance from the truth.

Each operation adds its own rounding, at most U = 2⁻⁵³ of the result (and half the least denormal), to what it inherits
from its operands (Wilkinson; Higham, Accuracy and Stability of Numerical Algorithms, §3.3). The bound is a fact about
this very evaluation: no constant is fitted. A comparison that the bounds cannot decide counts both branches.
The elementary functions add what verify/accuracy/test_certified_ulps.py allows them, in units in the last place.
"""

from functools import partialmethod
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from renderer import kernels
from verify.evaluate import ANY_NUMBERS

U = 2.0**-53
TINY = 2.0**-1074
SLACK = 1 + 1e-12  # the bounds are rounded too
ULPS = {"sinpi": 2.0, "cospi": 2.0, "atan2pi": 2.5, "exp": 1.0, "log": 0.52, "power": 1.5, "small power": 11.03}
SMALLEST = 4e-308  # below it exp and power may be 0


class Running:
    """An array of float64 numbers and, for each, a bound on |number − exact value|."""

    __array_ufunc__ = None  # NumPy leaves mixed operations to the methods below

    def __init__(self, value: ArrayLike, bound: ArrayLike = 0.0):
        self.value = np.asarray(value, np.float64)
        self.bound = np.broadcast_to(np.asarray(bound, np.float64), self.value.shape)

    def spread(self, shape: tuple[int, ...]) -> "Running":
        """Return the same numbers as arrays of a larger shape."""
        return Running(np.broadcast_to(self.value, shape), np.broadcast_to(self.bound, shape))

    def _rounded(self, value, inherited, ulps=0.5):
        """Return the result of one operation: what it inherits, and its own rounding."""
        own = 2 * ulps * U * np.abs(value) + TINY
        with np.errstate(all="ignore"):
            return Running(value, np.where(np.isfinite(value), (inherited + own) * SLACK, np.inf))

    def __neg__(self):
        return Running(-self.value, self.bound)

    def __abs__(self):
        return Running(np.abs(self.value), self.bound)

    def __add__(self, other):
        other = running(other)
        return self._rounded(self.value + other.value, self.bound + other.bound)

    def __sub__(self, other):
        return self + (-running(other))

    def __mul__(self, other):
        other = running(other)
        inherited = np.abs(self.value) * other.bound + np.abs(other.value) * self.bound + self.bound * other.bound
        scaling = _scales(self) | _scales(other)
        return self._rounded(self.value * other.value, inherited, np.where(scaling, 0.0, 0.5))

    def __truediv__(self, other):
        other = running(other)
        value = self.value / other.value
        least = np.abs(other.value) - other.bound  # of the exact divisor
        inherited = (self.bound + np.abs(value) * other.bound) / least
        return self._rounded(value, np.where(least > 0, inherited, np.inf))

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, other):
        return -self + other

    def __rtruediv__(self, other):
        return running(other) / self

    def _compare(self, other, decide):
        other, exact = running(other), self.bound == 0
        near = np.abs(self.value - other.value) <= self.bound + other.bound
        return Comparison(decide(self.value, other.value), near & ~(exact & (other.bound == 0)))

    __lt__, __le__ = partialmethod(_compare, decide=np.less), partialmethod(_compare, decide=np.less_equal)
    __gt__, __ge__ = partialmethod(_compare, decide=np.greater), partialmethod(_compare, decide=np.greater_equal)


class Comparison(NamedTuple):
    """Truth values, and where the bounds leave them open (never where both sides are exact)."""

    holds: np.ndarray
    open: np.ndarray


def _scales(a):
    """Return whether a factor is exactly a power of two, so that a product with it is not rounded."""
    return (a.bound == 0) & (np.abs(np.frexp(a.value)[0]) == 0.5)


Number = Running | ArrayLike


def running(value: Number) -> Running:
    """Return a number or an array as an exact Running, a Running as it is."""
    return value if isinstance(value, Running) else Running(value)


def rational(p: int, q: int) -> Running:
    """Return p/q: exact where float64 holds it, else a quotient that rounds."""
    exact = (p / q).as_integer_ratio() == (p, q)
    return Running(p / q) if exact else Running(p) / Running(q)


def where(condition: Comparison, value: Number, otherwise: Number) -> Running:
    """Return `value` where the condition holds, else `otherwise`; where it is open the bound covers both."""
    value, otherwise = running(value), running(otherwise)
    chosen = np.where(condition.holds, value.value, otherwise.value)
    bound = np.where(condition.holds, value.bound, otherwise.bound)
    gap = np.abs(value.value - otherwise.value) + value.bound + otherwise.bound
    return Running(chosen, np.where(condition.open, np.maximum(bound, gap), bound))


def sqrt(a: Number) -> Running:
    """√a: the root's error is at most e/√a, and at most √e."""
    a = running(a)
    root = np.sqrt(a.value)
    with np.errstate(all="ignore"):
        inherited = np.minimum(np.sqrt(a.bound), np.where(root > 0, a.bound / root, np.inf))
    return a._rounded(root, np.where(a.bound == 0, 0.0, inherited))


def maximum(a: Number, b: Number) -> Running:
    """The larger one: no further from the truth than the worse of the two."""
    a, b = running(a), running(b)
    return Running(np.maximum(a.value, b.value), np.maximum(a.bound, b.bound))


def sign(a: Number) -> Running:
    """−1, 0 or 1; open where the bound reaches across zero."""
    a = running(a)
    return Running(np.sign(a.value), np.where((np.abs(a.value) <= a.bound) & (a.bound > 0), 2.0, 0.0))


def _rising(function, ulps, least=-np.inf):
    """Return a function that rises: its ends bound what is inherited; 2 ulp more, for they are rounded as well."""

    def rising(a, *others):
        a, others = running(a), [running(other).value for other in others]
        with np.errstate(all="ignore"):
            low, value, high = (
                function(np.maximum(least, end), *others) for end in (a.value - a.bound, a.value, a.value + a.bound)
            )
            ends = np.maximum(high - value, value - low) + 4 * ulps(value) * U * np.maximum(np.abs(high), np.abs(low))
        return a._rounded(value, np.where(a.bound == 0, 0.0, ends) + SMALLEST * (value == 0), ulps(value))

    return rising


exp = _rising(kernels.exp, lambda value: ULPS["exp"])
log = _rising(kernels.log, lambda value: ULPS["log"], least=0)
power = _rising(kernels.power, lambda value: np.where(value < np.exp(-50), ULPS["small power"], ULPS["power"]), least=0)
"""a^p for a ≥ 0 and an exact p > 0."""


def _of_half_turns(function, ulps):
    def of_half_turns(a, b=1.0):
        a, b = running(a), running(b)
        with np.errstate(all="ignore"):
            argument = np.abs(a.value) * b.bound + np.abs(b.value) * a.bound + a.bound * b.bound
            value = function(*kernels.two_product(a.value, b.value))
        return a._rounded(value, np.minimum(2.0, np.pi * SLACK * argument), ulps)

    return of_half_turns


sinpi = _of_half_turns(kernels.sinpi, ULPS["sinpi"])  # sin πab
cospi = _of_half_turns(kernels.cospi, ULPS["cospi"])


def atan2pi(y: Number, x: Number) -> Running:
    """atan2(y, x)/π: the sine of the turn is |x Δy − y Δx|/(r r'); open where the cut is in reach."""
    y, x = running(y), running(x)
    moved, length = np.hypot(y.bound, x.bound), np.hypot(y.value, x.value)
    with np.errstate(all="ignore"):
        sine = (np.abs(x.value) / length * y.bound + np.abs(y.value) / length * x.bound) / (length - moved)
        turned = np.where(moved < length, np.arcsin(np.minimum(1, sine)) / np.pi, 2.0)
    across = (x.value < 0) & (np.abs(y.value) <= y.bound) & (y.bound > 0)
    turned = np.where(moved == 0, 0.0, np.where(across, 2.0, turned))
    return y._rounded(kernels.atan2pi(y.value, x.value), turned, ULPS["atan2pi"])


RUNNING = ANY_NUMBERS | {
    **{f.__name__: f for f in (rational, sqrt, maximum, sign, atan2pi)},
    "pi": Running(np.pi, 2 * U),
    "inf": np.inf,
    **{"sinpi": sinpi, "cospi": cospi, "exp": exp, "log": log, "power": power},
    "where": lambda condition, value, otherwise: where(condition, value(), otherwise()),
    "two_product": lambda a, b: (a, b),  # sinpi and cospi take both factors, and their product with its error
}
"""What the text of `verify.evaluate` calls."""
