"""What a figure is: a registered function that returns a `Drawing`.

    @figure
    def eps_sweep() -> Drawing:
        \"\"\"RMS of the difference on A against the step.\"\"\"
        ...
        return Drawing(fig, numbers={"rms_1e-3": 0.0121}, data={"step": steps, "rms": curve})

A picture is a Matplotlib figure (drawn twice, for the light page and the dark one: take colours from
`book.drawing.style.palette()`), or a uint8 array (height, width, 3 or 4), or None where only the numbers are wanted.
`data` is what the picture shows, by name: every curve that is drawn has to be in it (`book/drawing/data.py`).
Both may be nested: {"sine": {"rms": 0.1}} is the number sine_rms. A number that is an `Interval` is kept with its ends,
rms_lower and rms_upper, and a page prints what is certain of it. `shown` are the frames with bounds whose colours one
sees: the line of provenance says what is certain of them.
"""

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from renderer.picture.differences import Interval, rounded_up
from renderer.picture.frame import Frame

DATA_FOLDERS = ("proofs/", "renderer/", "verify/", "book/", "tests/data/")  # those that are hashed


@dataclass(frozen=True)
class Drawing:
    """A picture, the numbers that its caption and the prose cite, the arrays and the frames that it shows."""

    picture: Any = None
    numbers: Mapping[str, Any] = field(default_factory=dict)
    data: Mapping[str, Any] = field(default_factory=dict)
    shown: Sequence[Frame] = ()


@dataclass(frozen=True)
class Registered:
    """A figure's id, the function that draws it, and files that it reads (paths from the root)."""

    id: str
    draw: Callable[[], Drawing]
    data: tuple[str, ...] = ()


FIGURES: dict[str, Registered] = {}


def figure(id: str | Callable[[], Drawing], data: tuple[str, ...] | list[str] = ()) -> Callable:
    """Register the decorated function under its own name or, as @figure("id"), under an id.

    `data`: files that it reads, by path from the root.
    """
    if callable(id):
        return figure(id.__name__)(id)
    if not re.fullmatch(r"[a-z0-9_]+", id):
        raise ValueError(f"figure id {id!r}: an id is made of a-z, 0-9 and _")
    if any(not name.startswith(DATA_FOLDERS) for name in data):
        raise ValueError(f"figure {id!r}: its data must lie in one of {', '.join(DATA_FOLDERS)}")

    def register(draw: Callable[[], Drawing]) -> Callable[[], Drawing]:
        if id in FIGURES:
            other = FIGURES[id].draw
            raise ValueError(f"figure id {id!r} is taken by {other.__module__}.{other.__qualname__}")
        if not (draw.__doc__ or "").strip():
            raise ValueError(f"figure {id!r}: its function needs a docstring that says what it draws")
        FIGURES[id] = Registered(id, draw, tuple(data))
        return draw

    return register


def flat(values: Mapping[str, Any], front: str = "") -> Iterator[tuple[str, Any]]:
    """Yield (name, value) of a mapping, the names of nested ones joined by _."""
    for name, value in values.items():
        if isinstance(value, Mapping):
            yield from flat(value, f"{front}{name}_")
        else:
            yield f"{front}{name}", value


def plain_numbers(id: str, numbers: Mapping[str, Any]) -> dict[str, int | float | str | bool]:
    """The numbers as plain Python values; an error names the figure and the key."""
    plain: dict[str, int | float | str | bool] = {}
    for key, value in flat(numbers):
        if isinstance(value, Interval):
            ends = {f"{key}_lower": value.lower, f"{key}_upper": value.upper}
            plain |= plain_numbers(id, {key: value.value} | ends)
            continue
        if not re.fullmatch(r"[^\s|`]+", key):
            raise ValueError(f"figure {id!r}: number key {key!r} must be a string without blanks, | and `")
        value = value.item() if isinstance(value, np.generic | np.ndarray) and np.ndim(value) == 0 else value
        if not isinstance(value, bool | int | float | str) or (isinstance(value, float) and not math.isfinite(value)):
            raise ValueError(f"figure {id!r}: number {key!r} is {value!r}; give a finite number, a str or a bool")
        plain[key] = value
    return plain


def certified(shown: Sequence[Frame]) -> dict[str, float | int] | None:
    """Return how far a colour of frames is at most from exact arithmetic, two digits, and the pixels without a bound.

    A pixel that is open, or whose bound is the whole scale, is one of the latter. None where no frame is shown.
    """
    if not shown:
        return None
    limited = [(frame.bounds.max(axis=2) < 1.0) & ~frame.open for frame in shown]
    within = max(float(frame.bounds[flags].max()) for frame, flags in zip(shown, limited, strict=True))
    return {
        "within": float(rounded_up(within, 2)),
        "undecided": int(sum(np.count_nonzero(~flags) for flags in limited)),
    }
