"""Checks of arguments: an error names the argument, its value and what is allowed."""

import math
from collections.abc import Hashable, Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from numbers import Integral
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")


def not_allowed(name: str, value: object, allowed: str) -> ValueError:
    """Return the ValueError that says so, in one line."""
    shown = repr(value)
    if "\n" in shown:  # an array
        shown = " ".join(shown.split())
    return ValueError(f"{name} = {shown} is not allowed: {allowed}")


@contextmanager
def extra(name: str) -> Iterator[None]:
    """Raise ModuleNotFoundError that names the extra of this project, where an import within it finds no package."""
    try:
        yield
    except ModuleNotFoundError as error:
        wanted = f"{error.name} is not installed: pip install 'symbolic-rendering[{name}]'"
        raise ModuleNotFoundError(wanted, name=error.name) from None


def check_number(name: str, value: Any, low: float = -math.inf, high: float = math.inf) -> float:
    """Return `value` as a float, or raise ValueError unless it is a finite number in [low, high].

    A truth value, a complex number, a text and a buffer of bytes are none, in an array without axes neither.
    """
    try:
        array = np.asarray(value)
        kinds = "iuf" if array is value else "iufO"  # O: a fraction, say
        number = math.nan if array.ndim or array.dtype.kind not in kinds else float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number) or not low <= number <= high:
        limits = f" from {low:g} to {high:g}" if low > -math.inf else ""
        raise not_allowed(name, value, f"a finite number{limits}")
    return number


def check_items(name: str, value: Any, allowed: str) -> tuple:
    """Return a sequence as a tuple, or raise ValueError, which says what is `allowed`, on sets, mappings and text."""
    try:
        ordered = None if isinstance(value, (str, bytes, bytearray, memoryview, Mapping, Set)) else value
        return tuple(ordered)  # type: ignore[arg-type]  # a TypeError
    except TypeError:
        raise not_allowed(name, value, allowed) from None


def check_triple(name: str, value: Any, low: float = -math.inf, high: float = math.inf) -> tuple[float, ...]:
    """Return `value` as a tuple of three floats, or raise ValueError."""
    allowed = f"three finite numbers from {low:g} to {high:g}"
    if len(items := check_items(name, value, allowed)) != 3:
        raise not_allowed(name, value, allowed)
    return tuple(check_number(f"{name}[{i}]", item, low, high) for i, item in enumerate(items))


def check_whole(name: str, value: Any, high: int, low: int = 1) -> int:
    """Return `value` as an int, or raise ValueError unless it is a whole number from `low` to `high`."""
    if not isinstance(value, Integral) or isinstance(value, bool) or not low <= int(value) <= high:
        raise not_allowed(name, value, f"a whole number from {low} to {high}")
    return int(value)


def check_choice(name: str, value: T, choices: Iterable[T]) -> T:
    """Return `value`, or raise ValueError unless it is one of `choices`."""
    if not isinstance(value, Hashable) or value not in tuple(choices):  # an array is neither, nor can it say which
        raise not_allowed(name, value, "one of " + ", ".join(map(repr, choices)))
    return value


def check_truth(name: str, value: Any) -> bool:
    """Return `value` as a bool, or raise ValueError unless it is True or False, Python's or NumPy's."""
    if not isinstance(value, bool | np.bool_):
        raise not_allowed(name, value, "True or False")
    return bool(value)


def check_kind(name: str, value: Any, kind: type[T], allowed: str = "") -> T:
    """Return `value`, or raise ValueError unless it is of a class; allowed: for the message, by default "a CLASS"."""
    if not isinstance(value, kind):
        raise not_allowed(name, value, allowed or f"a {kind.__name__}")
    return value
